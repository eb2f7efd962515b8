"""What a shape says about itself, to hold a mesh against."""
from __future__ import annotations

import numpy as np

from freecad_part import FreeCAD

Vector = FreeCAD.Vector
ON_SURFACE = 1e-6  # [mm]


def euler_number(shape) -> int:
    """Of the union of the shape's faces, each a disc with holes; seams count."""
    edges = [edge for edge in shape.Edges if not edge.Degenerated]
    vertices = {vertex.hashCode() for edge in edges for vertex in edge.Vertexes}
    vertices |= {vertex.hashCode() for vertex in shape.Vertexes}
    discs = sum(2 - max(1, len(face.Wires)) for face in shape.Faces)
    return len(vertices) - len(edges) + discs


def most_curved_edge(shape) -> float:
    """The largest curvature of an edge, sampled [1/mm]."""
    worst = 0.0
    for edge in shape.Edges:
        if edge.Degenerated:
            continue
        low, high = edge.ParameterRange
        for i in range(1, 16):
            worst = max(worst, edge.curvatureAt(low + (high - low) * i / 16.0))
    return worst


def worst_tolerance(shape) -> float:
    """[mm]"""
    return max(part.Tolerance for part in shape.Edges + shape.Vertexes)


def point_and_normal(face):
    """A point of the face and the normal to its outer side there."""
    u, v = face.Surface.parameter(face.Vertexes[0].Point)
    point, normal = face.valueAt(u, v), face.normalAt(u, v)
    return np.array(point), np.array(normal)


def tips(shape) -> np.ndarray:
    """Points of degenerate edges: cone tips and poles, (n, 3)."""
    points = [edge.Vertexes[0].Point for edge in shape.Edges if edge.Degenerated]
    return np.array(points, float).reshape(-1, 3)


def _parameters(surface, points) -> np.ndarray:
    """(n, 2), of points on the surface. The kernel's search may end beside a point where sheets lie
    close together: Newton's from the others' feet goes on, or the point is left out."""
    feet = [surface.parameter(Vector(*point)) for point in points]
    sure = [uv for uv, point in zip(feet, points) if _miss(surface, uv, point) < ON_SURFACE]
    for uv, point in zip(feet, points):
        if _miss(surface, uv, point) >= ON_SURFACE:
            found = (_newton(surface, start, point) for start in sure)
            sure += [uv for uv in found if _miss(surface, uv, point) < ON_SURFACE][:1]
    return np.array(sure)


def _miss(surface, uv, point) -> float:
    return (surface.value(*uv) - Vector(*point)).Length


def _newton(surface, uv, point):
    for _ in range(50):
        away = np.array(Vector(*point) - surface.value(*uv))
        slopes = np.array([surface.getDN(*uv, 1, 0), surface.getDN(*uv, 0, 1)]).T
        uv = tuple(np.array(uv) + np.linalg.lstsq(slopes, away, rcond=None)[0])
    return uv


def turn_under(face, points) -> float:
    """The largest angle [deg] between two of the surface's normals under some points on the face,
    sampled over their box of parameters."""
    surface = face.Surface
    uv = _parameters(surface, points)
    if not len(uv):
        return 0.0
    for k, period in enumerate((surface.UPeriod() if surface.isUPeriodic() else 0.0,
                                surface.VPeriod() if surface.isVPeriodic() else 0.0)):
        if period:
            uv[:, k] -= period * np.round((uv[:, k] - uv[0, k]) / period)
    low, high = uv.min(axis=0), uv.max(axis=0)
    normals = np.array([surface.normal(u, v) for u in np.linspace(low[0], high[0], 13)
                        for v in np.linspace(low[1], high[1], 13)])
    return float(np.degrees(np.arccos(np.clip((normals @ normals.T).min(), -1.0, 1.0))))

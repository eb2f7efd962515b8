"""What a shape says about itself, to hold a mesh against."""
from __future__ import annotations

import numpy as np


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

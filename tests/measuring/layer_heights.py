"""Heights, growth and directions of the layers, measured on a finished mesh against its CAD."""
from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np

from freecad_part import FreeCAD, Part
from mesh_checks import Elements

REGULAR_TURN = 20.0  # [deg] more than this makes a front vertex a corner
KEPT_LAYERS = 5  # directions are judged in these


class Curve:
    """A CAD edge, to measure distances from."""

    def __init__(self, edge) -> None:
        self.curve, self.range = edge.Curve, edge.ParameterRange

    def distance(self, point: np.ndarray) -> float:
        """[mm], from the nearest point found by projection, or from the nearer end."""
        at = FreeCAD.Vector(*point)
        low, high = self.range
        try:
            nearest = self.curve.parameter(at)
        except Part.OCCError:  # no foot of a perpendicular: an end is nearest
            return min((self.curve.value(end) - at).Length for end in self.range)
        if self.curve.isPeriodic():
            period = self.curve.period()
            nearest += period * np.ceil((low - nearest) / period)
        return (self.curve.value(min(max(nearest, low), high)) - at).Length


def columns(mesh) -> List[List[int]]:
    """The columns of the layers, wall node first, where each node has one kid on its face."""
    parent = np.asarray(mesh.node_parent)
    faces: Dict[int, int] = {}  # of nodes inside faces
    for elements, numbers in ((mesh.quads, mesh.face_of_quad),
                              (mesh.triangles, mesh.face_of_triangle)):
        for corners, face in zip(np.asarray(elements).tolist(), np.asarray(numbers).tolist()):
            faces.update((node, face) for node in corners if parent[node] >= 0)
    kids: Dict[Tuple[int, int], List[int]] = {}
    for node, origin in enumerate(parent.tolist()):
        if origin >= 0:
            kids.setdefault((origin, faces[node]), []).append(node)
    found = []
    for (start, face), first in kids.items():
        if parent[start] >= 0 or len(first) != 1:
            continue
        column = [start]
        while len(kids.get((column[-1], face), ())) == 1:
            column.append(kids[column[-1], face][0])
        found.append(column)
    return found


def regular_wall_nodes(mesh) -> Dict[int, int]:
    """Wall node -> CAD edge, for nodes on edges that are not within two segments of an end."""
    on_edge: Dict[int, int] = {}
    for edge, segments in mesh.edge_segments.items():
        nodes = [int(segments[0][0])] + [int(pair[1]) for pair in segments] if len(segments) else []
        closed = bool(nodes) and nodes[0] == nodes[-1]
        for node in nodes if closed else nodes[2:-2]:
            on_edge[node] = edge
    return on_edge


def measure(shape, mesh, first_height: float, growth: float) -> Dict[str, Any]:
    """Deviations of regular columns from what was asked.

    height: share within 2 % and largest deviation [%] of the first height, the distance of a first
    kid from its wall's curve; growth: deviation of the mean ratio of heights [%]; direction: mean
    angle [deg] between extrusions and the front's normal in the first five layers.
    """
    edges = regular_wall_nodes(mesh)
    position = np.asarray(mesh.nodes)
    heights, ratios = [], []
    curves = {}
    for column in columns(mesh):
        edge = edges.get(column[0])
        if edge is None:
            continue
        curve = curves.setdefault(edge, Curve(shape.Edges[edge - 1]))
        heights.append(curve.distance(position[column[1]]))
        steps = np.linalg.norm(np.diff(position[column], axis=0), axis=1)[:KEPT_LAYERS]
        if len(steps) > 1:
            ratios.append((steps[-1] / steps[0]) ** (1.0 / (len(steps) - 1)))
    off = 100.0 * np.abs(np.array(heights) / first_height - 1.0)
    turned = _directions(mesh, set(edges))
    return {
        "columns": len(heights),
        "height_within_2": 100.0 * float((off <= 2.0).mean()) if len(off) else 0.0,
        "height_off": float(off.max(initial=0.0)),
        "growth_off": 100.0 * abs(float(np.mean(ratios)) / growth - 1.0) if ratios else 0.0,
        "direction": float(np.mean(turned)) if len(turned) else 0.0,
    }


def _directions(mesh, roots) -> List[float]:
    """[deg] between each extrusion and the normal of its front, where that runs straight."""
    parent, layer = np.asarray(mesh.node_parent), np.asarray(mesh.node_layer)
    position = np.asarray(mesh.nodes)
    after, before = {}, {}  # the extrusion's kid -> its parent's neighbour on the front
    for quad, level in zip(np.asarray(mesh.quads).tolist(),
                           np.asarray(mesh.layer_of_quad).tolist()):
        for k in range(4):
            a, b, c, d = quad[k], quad[(k + 1) % 4], quad[(k + 2) % 4], quad[(k + 3) % 4]
            if level and parent[d] == a and parent[c] == b and layer[d] == level:
                after[d], before[c] = b, a
    root: Dict[int, int] = {}
    found = []
    for node in np.argsort(layer, kind="stable").tolist():
        origin = int(parent[node])
        root[node] = node if origin < 0 else root[origin]
        if origin < 0 or layer[node] > KEPT_LAYERS or root[node] not in roots:
            continue
        if node not in after or node not in before:
            continue
        ahead = position[after[node]] - position[origin]
        back = position[origin] - position[before[node]]
        ahead, back = ahead / np.linalg.norm(ahead), back / np.linalg.norm(back)
        if ahead @ back < np.cos(np.radians(REGULAR_TURN)):
            continue
        along, out = ahead + back, position[node] - position[origin]
        sine = along @ out / np.linalg.norm(along) / np.linalg.norm(out)
        found.append(abs(float(np.degrees(np.arcsin(np.clip(sine, -1.0, 1.0))))))
    return found


def first_rows(elements: Elements, shape) -> np.ndarray:
    """Distances [mm] from the shape's edges of the nodes joined to a node on them, of any mesh."""
    edges, _ = elements.directed_edges()
    curves = [Curve(edge) for edge in shape.Edges if not edge.Degenerated]
    used = np.unique(elements.corners)
    near = np.full(len(elements.nodes), np.inf)
    for node in used.tolist():
        near[node] = min(curve.distance(elements.nodes[node]) for curve in curves)
    on_wall = near < 1e-6 * shape.BoundBox.DiagonalLength
    beside = np.zeros(len(elements.nodes), bool)
    beside[edges[on_wall[edges[:, 0]], 1]] = True
    return near[beside & ~on_wall]

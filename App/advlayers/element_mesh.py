"""The elements of a mesh as arrays, and what they are judged by."""
from __future__ import annotations

import re
from dataclasses import dataclass, field
from itertools import chain
from typing import Any, Callable, Dict, Generator, List, TypeVar

import numpy as np

_GROUP = re.compile(r"(Layer|Face|Edge)([0-9]+)")
_BLOCK = 10_000  # elements
_Result = TypeVar("_Result")


@dataclass(frozen=True)
class ElementMesh:
    """Quads first, then triangles; element i is number i + 1 of the FemMesh."""

    nodes: Any  # (n, 3) float64 [mm]
    quads: Any  # (q, 4) indices into nodes
    triangles: Any  # (t, 3)
    layers: Any  # (q + t,) 0: core
    faces: Any  # (q + t,) number of the CAD face, from 1
    edge_nodes: Dict[int, Any] = field(default_factory=dict)  # number of the CAD edge -> nodes
    # Of second order, else without a row: numbered on from len(nodes); mid node k lies between
    # corners k and k + 1.
    mid_nodes: Any = field(default_factory=lambda: np.zeros((0, 3)))
    mids_of_quad: Any = field(default_factory=lambda: np.zeros((0, 4), np.int64))
    mids_of_triangle: Any = field(default_factory=lambda: np.zeros((0, 3), np.int64))

    @property
    def count(self) -> int:
        return len(self.quads) + len(self.triangles)

    def corners(self, element: int):
        """Indices of the element's nodes."""
        quads = len(self.quads)
        return self.quads[element] if element < quads else self.triangles[element - quads]


def of_core(mesh) -> ElementMesh:
    """Of a finished mesh or a snapshot of the core."""
    return ElementMesh(mesh.nodes, mesh.quads, mesh.triangles,
                       np.concatenate([mesh.layer_of_quad, mesh.layer_of_triangle]),
                       np.concatenate([mesh.face_of_quad, mesh.face_of_triangle]),
                       mesh.edge_segments, mesh.mid_nodes, mesh.mids_of_quad,
                       mesh.mids_of_triangle)


def of_object(mesh_object) -> ElementMesh:
    """Of a mesh object of this add-on; the groups of its mesh tell faces and edges."""
    return finish(reading(mesh_object))


def reading(mesh_object) -> Generator[None, None, ElementMesh]:
    """of_object() in steps of some 20 ms; a mesh of 100 000 nodes takes one longer step."""
    fem = mesh_object.FemMesh
    nodes = fem.Nodes
    ids = np.fromiter(nodes.keys(), np.int64, len(nodes))
    index = np.zeros(int(ids.max(initial=0)) + 1, np.int64)
    index[ids] = np.arange(len(ids))
    yield
    points = np.fromiter(chain.from_iterable(nodes.values()), float, 3 * len(nodes))
    yield
    faces = fem.Faces
    cells: List[Any] = []
    for start in range(0, len(faces), _BLOCK):
        cells += map(fem.getElementNodes, faces[start:start + _BLOCK])
        yield
    quads = index[_table([cell for cell in cells if len(cell) in (4, 8)], 4)]
    triangles = index[_table([cell for cell in cells if len(cell) in (3, 6)], 3)]
    yield
    corners = len(points) // 3
    if quads.shape[1] == 8 or triangles.shape[1] == 6:  # mid nodes come after all corners
        corners = 1 + max(quads[:, :4].max(initial=-1), triangles[:, :3].max(initial=-1))
    # The layers are groups where that was asked for, and in meshes of older versions.
    numbers = {"Layer": np.zeros(len(cells), np.int32), "Face": np.zeros(len(cells), np.int32)}
    edge_nodes = {}
    for group in fem.Groups:
        match = _GROUP.fullmatch(fem.getGroupName(group))
        if match is None:
            continue
        kind, number = match.group(1), int(match.group(2))
        members = np.array(fem.getGroupElements(group), np.int64)
        if kind == "Edge":
            edge_nodes[number] = index[members]
        else:
            numbers[kind][members - 1] = number
        yield
    layers = numbers["Layer"]
    if len(mesh_object.ElementLayers) == len(layers):
        layers = np.array(mesh_object.ElementLayers, np.int32)
    points = points.reshape(-1, 3)
    return ElementMesh(points[:corners], quads[:, :4], triangles[:, :3], layers,
                       numbers["Face"], edge_nodes, points[corners:],
                       quads[:, 4:].reshape(-1, 4), triangles[:, 3:].reshape(-1, 3))


def finish(steps: Generator[None, None, _Result]) -> _Result:
    """Makes all steps at once."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


def _table(cells, corners: int):
    """(n, corners), or twice as wide with mid nodes; several times faster than numpy's way with a
    list of tuples."""
    width = len(cells[0]) if cells else corners
    return np.fromiter(chain.from_iterable(cells), np.int64, width * len(cells)).reshape(-1, width)


def angles_of(mesh: ElementMesh, element: int):
    """Corner angles [deg] of one element, counted from 0."""
    return _corner_angles(mesh.nodes, mesh.corners(element)[np.newaxis])[0]


def quality(mesh: ElementMesh, check: Callable[[], None] = lambda: None):
    """(q + t,) from 0 (flat or turned over) to 1 (every angle is the ideal one, 90 or 60 deg).
    `check` is called every few milliseconds, and may raise."""
    parts = [np.zeros(0)]
    for cells, ideal in ((mesh.quads, 90.0), (mesh.triangles, 60.0)):
        for start in range(0, len(cells), _BLOCK):
            check()
            corners = _corner_angles(mesh.nodes, cells[start:start + _BLOCK])
            parts.append(_equiangular(corners, ideal))
    return np.concatenate(parts)


def aspect_ratio(mesh: ElementMesh):
    """(q + t,) longest side over shortest side."""
    return np.concatenate([_side_ratio(mesh.nodes, cells)
                           for cells in (mesh.quads, mesh.triangles)])


def centres(mesh: ElementMesh):
    """(q + t, 3) [mm]"""
    return np.concatenate([mesh.nodes[cells].mean(axis=1).reshape(-1, 3)
                           for cells in (mesh.quads, mesh.triangles)])


def _corner_angles(nodes, cells):
    points = nodes[cells]
    ahead = np.roll(points, -1, axis=1) - points
    back = np.roll(points, 1, axis=1) - points
    sine = np.linalg.norm(np.cross(ahead, back), axis=2)
    return np.degrees(np.arctan2(sine, np.einsum("ijk,ijk->ij", ahead, back)))


def _equiangular(corner_angles, ideal: float):
    widest, narrowest = corner_angles.max(axis=1), corner_angles.min(axis=1)
    return 1.0 - np.maximum((widest - ideal) / (180.0 - ideal), (ideal - narrowest) / ideal)


def _side_ratio(nodes, cells):
    if not len(cells):
        return np.zeros(0)
    points = nodes[cells]
    sides = np.linalg.norm(np.roll(points, -1, axis=1) - points, axis=2)
    return sides.max(axis=1) / np.maximum(sides.min(axis=1), np.finfo(float).tiny)

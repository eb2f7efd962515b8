"""Edges that belong together, for picking them at once: tangent chains and whole loops."""
from __future__ import annotations

import math
from typing import Any, Dict, Iterable, List, Set, Tuple

from advlayers.face_edges import FaceEdges

# Edges that meet within this go on as one: between what drawing leaves open and a real corner.
_TANGENT = math.cos(math.radians(5.0))


class EdgeChains:
    """Looks chains up in one shape; names are FreeCAD's."""

    def __init__(self, shape) -> None:
        self._shape = shape
        self._edges = shape.Edges
        self._face_edges = FaceEdges(shape)
        self._at_vertex: Dict[int, List[Tuple[Any, int]]] = {}
        for number, edge in enumerate(self._edges, 1):
            for vertex in edge.Vertexes:
                self._at_vertex.setdefault(vertex.hashCode(), []).append((vertex, number))

    def tangent(self, names: Iterable[str]) -> List[str]:
        """The edges, and those that go on from their ends without a corner, and so on."""
        found = {_number(name) for name in names}
        waiting = list(found)
        while waiting:
            number = waiting.pop()
            for other in self._smooth_neighbours(number) - found:
                found.add(other)
                waiting.append(other)
        return _names(found)

    def loop(self, names: Iterable[str], faces: Iterable[str] = ()) -> List[str]:
        """The edges of the wires that hold all the edges named; with faces, of their wires only.
        Where several do, as on both sides of a single edge, the shortest one."""
        wanted = {_number(name) for name in names}
        on = ([self._shape.Faces[_number(name) - 1] for name in faces]
              or self._faces_beside(wanted))
        loops = []
        for face in on:
            for wire in face.Wires:
                numbers = {self._face_edges.number(edge) for edge in wire.Edges
                           if not edge.Degenerated and not edge.isSeam(face)}
                if wanted <= numbers:
                    loops.append((wire.Length, sorted(numbers)))
        return _names(min(loops)[1] if loops else wanted)

    def of_faces(self, faces: Iterable[str]) -> List[str]:
        """All edges around the faces but seams and poles."""
        return self._face_edges.boundary(faces)

    def _smooth_neighbours(self, number: int) -> Set[int]:
        edge = self._edges[number - 1]
        if edge.Degenerated:
            return set()
        found = set()
        for vertex in edge.Vertexes:
            own = _direction_at(edge, vertex)
            for same, other in self._at_vertex[vertex.hashCode()]:
                beside = self._edges[other - 1]
                if other == number or beside.Degenerated or not same.isSame(vertex):
                    continue
                if abs(own.dot(_direction_at(beside, vertex))) > _TANGENT:
                    found.add(other)
        return found

    def _faces_beside(self, numbers: Set[int]) -> List[Any]:
        edges = [self._edges[number - 1] for number in numbers]
        return [face for face in self._shape.Faces
                if any(edge.isSame(other) for edge in edges for other in face.Edges)]


def _direction_at(edge, vertex):
    """The unit tangent where the edge ends at the vertex."""
    first, last = edge.ParameterRange
    near_first = (edge.valueAt(first) - vertex.Point).Length
    near_last = (edge.valueAt(last) - vertex.Point).Length
    return edge.tangentAt(first if near_first <= near_last else last).normalize()


def _number(name: str) -> int:
    return int(name[4:])


def _names(numbers: Iterable[int]) -> List[str]:
    return [f"Edge{number}" for number in sorted(numbers)]

"""Edges of a shape by what they have in common: holes, inner loops, sharp edges, lengths, radii."""
from __future__ import annotations

from typing import Any, Iterable, List, Optional, Set, Tuple

from advlayers import features
from advlayers.core_access import load_core
from advlayers.face_edges import FaceEdges

# Lengths and radii that differ by less than this share count as similar; diameters as one.
_SIMILAR, _SAME = 0.05, 1e-6


class EdgeSets:
    """Of one shape; names are FreeCAD's, and come in its order."""

    def __init__(self, shape) -> None:
        self._shape = shape
        self._known: Any = None

    def feature(self, words: str) -> List[str]:
        """The edges that "holes", "holes 4 10" or "sharp" stand for in a list of edges."""
        return _ordered(features.find(words, self._model))

    def hole_diameters(self) -> List[Tuple[float, int]]:
        """The least first [mm], with the number of loops that have it."""
        found: List[Tuple[float, int]] = []
        for diameter in sorted(diameter for _face, _edges, diameter in self._model.holes):
            if found and diameter - found[-1][0] <= _SAME * diameter:
                found[-1] = (found[-1][0], found[-1][1] + 1)
            else:
                found.append((diameter, 1))
        return found

    def holes_of(self, diameter: float) -> List[str]:
        return _ordered(edge for _face, edges, other in self._model.holes
                        if abs(other - diameter) <= 2 * _SAME * diameter for edge in edges)

    def inner_loops(self, faces: Iterable[str]) -> List[str]:
        """The edges of all loops of the faces but the longest of each; without faces, of all."""
        table = FaceEdges(self._shape)
        wanted = set(faces)
        return _ordered(
            f"Edge{table.number(edge)}"
            for number, face in enumerate(self._shape.Faces, 1)
            if not wanted or f"Face{number}" in wanted
            for wire in sorted(face.Wires, key=lambda wire: wire.Length)[:-1]
            for edge in wire.Edges if not edge.Degenerated and not edge.isSeam(face))

    def similar_length(self, names: Iterable[str]) -> List[str]:
        """Edges as long as one of those named."""
        edges = self._shape.Edges
        wanted = [edges[_index(name)].Length for name in names]
        return [f"Edge{number}" for number, edge in enumerate(edges, 1)
                if any(abs(edge.Length - length) <= _SIMILAR * length for length in wanted)]

    def similar_radius(self, names: Iterable[str]) -> List[str]:
        """Edges that are arcs of circles with the radius of one of those named."""
        radii = [_radius(edge) for edge in self._shape.Edges]
        wanted = [radii[_index(name)] for name in names if radii[_index(name)] is not None]
        return [f"Edge{number}" for number, radius in enumerate(radii, 1) if radius is not None
                and any(abs(radius - other) <= _SIMILAR * other for other in wanted)]

    def inverted(self, names: Iterable[str]) -> List[str]:
        """All faces, or all edges that bound one, but those named."""
        without: Set[str] = set(names)
        if any(name.startswith("Face") for name in without):
            every = [f"Face{number}" for number in range(1, len(self._shape.Faces) + 1)]
        else:
            every = FaceEdges(self._shape).boundary(
                f"Face{number}" for number in range(1, len(self._shape.Faces) + 1))
        return [name for name in every if name not in without]

    @property
    def _model(self):
        if self._known is None:
            self._known = load_core().read_brep(self._shape.exportBrepToString())
        return self._known


def _radius(edge) -> Optional[float]:
    if edge.Degenerated:
        return None
    return getattr(edge.Curve, "Radius", None)


def _index(name: str) -> int:
    return int(name[len("Edge"):]) - 1


def _ordered(names: Iterable[str]) -> List[str]:
    return sorted(set(names), key=_index)

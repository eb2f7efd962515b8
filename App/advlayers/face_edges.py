"""Which edges of a shape bound which of its faces, by FreeCAD's names."""
from __future__ import annotations

from typing import Dict, Iterable, List, Set


class FaceEdges:
    def __init__(self, shape) -> None:
        self._shape = shape
        self._numbers: Dict[int, list] = {}
        for number, edge in enumerate(shape.Edges, 1):
            self._numbers.setdefault(edge.hashCode(), []).append((edge, number))

    def boundary(self, faces: Iterable[str]) -> List[str]:
        """The edges around the faces, but no seam, no pole, and none that the shape lacks."""
        found: Set[int] = set()
        for name in faces:
            number = name[len("Face"):]
            if number.isdigit() and int(number) <= len(self._shape.Faces):
                face = self._shape.Faces[int(number) - 1]
                found.update(self.number(edge) for edge in face.Edges
                             if not edge.Degenerated and not edge.isSeam(face))
        return [f"Edge{number}" for number in sorted(found)]

    def beside(self, edge_name: str) -> List[str]:
        """The faces that the edge bounds."""
        edge = self._shape.Edges[int(edge_name[len("Edge"):]) - 1]
        return [f"Face{number}" for number, face in enumerate(self._shape.Faces, 1)
                if any(edge.isSame(other) for other in face.Edges)]

    def number(self, edge) -> int:
        return next(number for other, number in self._numbers[edge.hashCode()]
                    if other.isSame(edge))

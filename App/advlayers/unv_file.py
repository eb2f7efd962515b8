"""I-DEAS universal files: datasets 2411 (nodes), 2412 (elements), 2467 (groups; written only)."""
from __future__ import annotations

from typing import Any, Dict, Iterator, List, Tuple

import numpy as np

from advlayers.mesh_groups import Group

# Thin-shell types as FreeCAD's own reader and writer use them.
_QUAD, _TRIANGLE = 44, 41
_ELEMENT_ENTITY, _NODE_ENTITY = 8, 7
# By type, the places of the corners: in elements of second order they take turns with the nodes on
# the edges between them.
_CORNERS = {
    **{kind: ("triangle", (0, 1, 2)) for kind in (41, 51, 61, 74, 81, 91)},
    **{kind: ("triangle", (0, 2, 4)) for kind in (42, 52, 62, 72, 82, 92)},
    **{kind: ("quad", (0, 1, 2, 3)) for kind in (44, 54, 64, 71, 84, 94)},
    **{kind: ("quad", (0, 2, 4, 6)) for kind in (45, 55, 65, 75, 85, 95)},
    111: ("tetra", (0, 1, 2, 3)), 118: ("tetra", (0, 2, 4, 9)),
    112: ("wedge", (0, 1, 2, 3, 4, 5)), 113: ("wedge", (0, 2, 4, 9, 11, 13)),
    115: ("hexahedron", tuple(range(8))), 116: ("hexahedron", (0, 2, 4, 6, 12, 14, 16, 18)),
}
_BEAMS = (11, 21, 22, 23, 24)  # with a record more


def write_unv(path: str, mesh, groups: List[Group]) -> None:
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write("    -1\n  2411\n")
        for i, point in enumerate(mesh.nodes.tolist(), 1):
            # 17 significant digits: a double comes back as it was.
            file.write("%10d%10d%10d%10d\n%25.16E%25.16E%25.16E\n" % (i, 1, 1, 11, *point))
        file.write("    -1\n    -1\n  2412\n")
        number = 0
        for kind, cells in ((_QUAD, mesh.quads), (_TRIANGLE, mesh.triangles)):
            size = cells.shape[1]
            for cell in (cells + 1).tolist():
                number += 1
                file.write("%10d%10d%10d%10d%10d%10d\n" % (number, kind, 2, 1, 7, size))
                file.write("%10d" * size % tuple(cell) + "\n")
        file.write("    -1\n    -1\n  2467\n")
        for i, group in enumerate(groups, 1):
            file.write("%10d" * 8 % (i, 0, 0, 0, 0, 0, 0, len(group.ids)) + f"\n{group.name}\n")
            entity = _NODE_ENTITY if group.of_nodes else _ELEMENT_ENTITY
            records = ["%10d%10d%10d%10d" % (entity, entry, 0, 0) for entry in group.ids.tolist()]
            for j in range(0, len(records), 2):
                file.write("".join(records[j:j + 2]) + "\n")
        file.write("    -1\n")


def read_unv(path: str) -> Tuple[Any, Dict[str, Any]]:
    """Points (n, 3) and cells by kind, (k, corners) each, of the first two datasets: elements with
    nodes on their edges are read by their corners. Raises ValueError naming the line, and OSError.
    """
    points: Dict[int, List[float]] = {}
    cells: Dict[str, List[List[int]]] = {}
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = _Lines(file.read().splitlines())
    try:
        for line in lines:
            if line.strip() == "2411":
                _read_nodes(lines, points)
            elif line.strip() == "2412":
                _read_elements(lines, cells)
    except (ValueError, IndexError) as error:
        raise ValueError(f"line {lines.number}: {error}") from error
    index = {number: place for place, number in enumerate(points)}
    try:
        found = {kind: np.array([[index[number] for number in row] for row in rows], np.int64)
                 for kind, rows in cells.items()}
    except KeyError as error:
        raise ValueError(f"an element has node {error}, which is not there") from error
    return np.array(list(points.values()), float).reshape(-1, 3), found


class _Lines:
    """The lines of a file one after the other, and how many have been taken."""

    def __init__(self, lines: List[str]) -> None:
        self._lines, self.number = lines, 0

    def __iter__(self) -> Iterator[str]:
        while self.number < len(self._lines):
            self.number += 1
            yield self._lines[self.number - 1]

    def words(self) -> List[str]:
        """Of the next line, within a dataset."""
        if self.number == len(self._lines):
            raise ValueError("the file ends within a dataset")
        self.number += 1
        return self._lines[self.number - 1].split()

    def numbers(self, least: int) -> List[int]:
        words = self.words()
        if len(words) < least and words != ["-1"]:
            raise ValueError(f"{least} numbers are due, got {len(words)}")
        return [int(word) for word in words]


def _read_nodes(lines: _Lines, points: Dict[int, List[float]]) -> None:
    while True:
        number = lines.numbers(1)[0]
        if number == -1:
            return
        points[number] = [float(word.replace("D", "E")) for word in lines.words()]
        if len(points[number]) != 3:
            raise ValueError(f"3 coordinates are due, got {len(points[number])}")


def _read_elements(lines: _Lines, cells: Dict[str, List[List[int]]]) -> None:
    while True:
        words = lines.numbers(6)
        if words[0] == -1:
            return
        kind, count = words[1], words[5]
        if kind in _BEAMS:
            lines.words()
        numbers: List[int] = []
        while len(numbers) < count:
            numbers += lines.numbers(1)
        if kind in _CORNERS:
            name, places = _CORNERS[kind]
            cells.setdefault(name, []).append([numbers[place] for place in places])

"""Reads I-DEAS universal files: datasets 2411 (nodes) and 2412 (elements)."""
from __future__ import annotations

from typing import Any, Dict, Iterator, List, Tuple

import numpy as np

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

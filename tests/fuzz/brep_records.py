"""The topology in BREP text as records that can be changed, moved and added to."""
from __future__ import annotations

import re
from typing import List, Optional, Tuple

_REFERENCE = re.compile(r"([+\-ie])(\d+) (\d+)")


class Record:
    """A vertex, edge, wire, face, shell or solid: its own lines, and what it is made of."""

    def __init__(self, kind: str, lines: List[str], parts: "List[Part]") -> None:
        self.kind, self.lines, self.parts = kind, lines, parts

    def set_tolerance(self, value: float) -> None:
        """Of a vertex or an edge; never lowered."""
        words = self.lines[0].split()
        words[0] = repr(max(value, float(words[0])))
        self.lines[0] = " ".join(words)

    def set_flags(self, same_parameter: bool, same_range: bool) -> None:
        """Of an edge: what its curves are said to have in common."""
        words = self.lines[0].split()
        words[1:3] = [str(int(same_parameter)), str(int(same_range))]
        self.lines[0] = " ".join(words)

    def point(self) -> List[float]:
        """Where a vertex lies."""
        return [float(word) for word in self.lines[1].split()]

    def move(self, by: List[float]) -> None:
        """Of a vertex."""
        self.lines[1] = " ".join(repr(x + d) for x, d in zip(self.point(), by))

    def curve_ranges(self) -> List[int]:
        """Lines of an edge that hold the range of its curve in space, or in (u, v) of one side."""
        return [i for i, line in enumerate(self.lines) if i > 0 and
                line.split()[:1] in (["1"], ["2"]) and len(line.split()) in (5, 6)]


Part = Tuple[str, Record, str]  # orientation, what, location


class BrepText:
    """BREP text as FreeCAD exports it, taken apart."""

    def __init__(self, text: str) -> None:
        start = text.index("\nTShapes ") + 1
        self._head = text[:start]
        lines = text[start:].split("\n")
        count = int(lines[0].split()[1])
        self.records: List[Record] = []
        at = 1
        while len(self.records) < count:
            end = at
            while not lines[end].rstrip().endswith("*"):
                end += 1
            references = lines[end]
            kind, own = lines[at].strip(), lines[at + 1:end]
            # A record without parts has its star alone on the last line.
            parts = [(sign, self.records[count - int(index)], location)
                     for sign, index, location in _REFERENCE.findall(references)]
            self.records.append(Record(kind, own, parts))
            at = end + 1
        self._root = [(sign, self.records[count - int(index)], location)
                      for sign, index, location in _REFERENCE.findall("\n".join(lines[at:]))]

    def of_kind(self, kind: str) -> List[Record]:
        return [record for record in self.records if record.kind == kind]

    def add_before(self, user: Record, record: Record) -> None:
        self.records.insert(self.records.index(user), record)

    def users(self, record: Record, kind: Optional[str] = None) -> List[Record]:
        return [other for other in self.records if any(part[1] is record for part in other.parts)
                and kind in (None, other.kind)]

    def curves_in_uv(self) -> List[str]:
        """A line for each; of straight ones alone."""
        found = re.search(r"^Curve2ds (\d+)\n", self._head, re.M)
        return self._head[found.end():].split("\n")[:int(found.group(1))]

    def add_curve_in_uv(self, line: str) -> int:
        """The new one's number."""
        found = re.search(r"^Curve2ds (\d+)\n", self._head, re.M)
        count = int(found.group(1))
        at = self._head.index("Curves ", found.end())
        self._head = (f"{self._head[:found.start()]}Curve2ds {count + 1}\n"
                      f"{self._head[found.end():at]}{line}\n{self._head[at:]}")
        return count + 1

    def text(self) -> str:
        number = {id(record): len(self.records) - i for i, record in enumerate(self.records)}

        def named(parts: List[Part]) -> str:
            return "".join(f"{sign}{number[id(record)]} {location} "
                           for sign, record, location in parts)

        body = "".join("\n".join([record.kind, *record.lines, named(record.parts) + "*"]) + "\n"
                       for record in self.records)
        return f"{self._head}TShapes {len(self.records)}\n{body}\n{named(self._root)}"

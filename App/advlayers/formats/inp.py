"""Decks of Abaqus and CalculiX: nodes, elements, sets and surfaces, nothing of the analysis.

CalculiX takes no more than 20 characters a number. Where there are volume elements, the faces are
surfaces and sets of nodes: a shell there would make the solid stiffer.
"""
from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np

from advlayers.formats import sides
from advlayers.formats.mesh_parts import KINDS as ALL_KINDS
from advlayers.formats.mesh_parts import MeshParts
from advlayers.formats.plain_names import plain_names
from advlayers.formats.text_file import TextFile

_SOLIDS = {"tet4": "C3D4", "tet10": "C3D10", "prism6": "C3D6", "prism15": "C3D15",
           "hex8": "C3D8", "hex20": "C3D20"}
# By the choice of element: what stands before the number of nodes, and behind it.
ELEMENTS: Dict[str, Tuple[str, str]] = {
    "shell": ("S", ""), "reduced shell": ("S", "R"), "plane stress": ("CPS", ""),
    "plane strain": ("CPE", ""), "axisymmetric": ("CAX", ""), "membrane": ("M3D", ""),
}
_FLAT = ("tri3", "tri6", "quad4", "quad8")
KINDS = frozenset(_SOLIDS) | frozenset(_FLAT) | {"line2", "line3"}
_NAME_SIZE = 60  # of at most 80
_NUMBERS = 8  # of a set, in a row
_PER_LINE = 16
# Which side of a volume element stands where among CalculiX's S1, S2, …
_SIDE_LABELS = {"tet": (1, 2, 3, 4), "prism": (1, 2, 3, 4, 5), "hex": (1, 2, 3, 4, 5, 6)}
_FIRST_SHELL_SIDE = 3  # S1 and S2 are its faces


def write(path: str, parts: MeshParts, elements: str = "shell") -> None:
    solid = parts.dimension == 3
    with TextFile(path) as file:
        file.text("*NODE, NSET=Nall\n")
        file.numbered("%d, %20w, %20w, %20w\n", 1, parts.nodes)
        for start, block in zip(parts.starts, parts.blocks):
            if block.dimension == max(parts.dimension, 2):
                name = _SOLIDS[block.kind] if solid else _flat_type(block.kind, elements)
                count = block.cells.shape[1]
                file.text(f"*ELEMENT, TYPE={name}, ELSET=Eall\n")
                file.numbered(_row(count), start + 1, block.cells + 1)
        element_sets = parts.element_sets(3 if solid else 2)
        node_sets = parts.node_sets(2) if solid else []
        node_sets += parts.node_sets(1)
        plain = plain_names([name for name, *_rest in element_sets + node_sets], _NAME_SIZE, True)
        for name, _dimension, members in element_sets:
            file.text(f"*ELSET, ELSET={plain[name]}\n")
            file.listed(members, "%d", _NUMBERS, ", ")
        for name, members in node_sets:
            file.text(f"*NSET, NSET={plain[name]}\n")
            file.listed(members + 1, "%d", _NUMBERS, ", ")
        _write_surfaces(file, parts, plain, elements)


def _row(count: int) -> str:
    """A line holds 16 numbers; one that goes on ends with a comma."""
    first = min(count, _PER_LINE - 1)
    more = count - first
    return "%d" + ", %d" * first + (",\n" + ", ".join(["%d"] * more) if more else "") + "\n"


def _flat_type(kind: str, elements: str) -> str:
    before, behind = ELEMENTS[elements]
    whole = ALL_KINDS[kind].corners == 3  # no triangle has a reduced integration
    return f"{before}{ALL_KINDS[kind].nodes}{'' if whole else behind}"


def _write_surfaces(file: TextFile, parts: MeshParts, plain: Dict[str, str],
                    elements: str) -> None:
    """Of what bounds the elements: faces of a solid, edges of a surface. One that nothing bounds on
    both sides is the side of its first element."""
    dimension = max(parts.dimension, 2) - 1
    runs: Dict[int, List[Tuple[str, Any]]] = {}
    for run in parts.by_part(dimension):
        runs.setdefault(run.part, []).append((run.kind, run.cells))
    wanted = {number: [number] for number in runs} if dimension == 2 else {
        number: [number] for number in parts.grouped(1)}
    surfaces = [(parts.name(dimension, number), members) for number, members in wanted.items()]
    surfaces += [(group.name, [number for number in group.parts if number in runs])
                 for group in parts.groups if group.dimension == dimension]
    labels = _labels(parts, elements)
    for name, members in surfaces:
        cells = [cell for number in members for cell in runs[number]]
        if cells:
            found, place, _count = sides.find(parts, cells)
            file.text(f"*SURFACE, NAME=S_{plain[name]}, TYPE=ELEMENT\n")
            known = found > 0
            file.rows("%d, S%d\n", found[known], labels(found[known], place[known]))


def _labels(parts: MeshParts, elements: str):
    """Number of a side as CalculiX counts, of elements and places in sides.SIDES."""
    if parts.dimension < 3:
        first = _FIRST_SHELL_SIDE if "shell" in elements or elements == "membrane" else 1
        return lambda _found, place: place + first
    ends = np.array([*parts.starts[1:], sum(len(block) for block in parts.blocks)])
    table = np.zeros((len(parts.blocks), 6), np.int64)
    for row, block in zip(table, parts.blocks):
        label = next((labels for stem, labels in _SIDE_LABELS.items()
                      if block.kind.startswith(stem)), ())
        row[:len(label)] = label
    return lambda found, place: table[np.searchsorted(ends, found), place]

"""Nastran's bulk data: GRID* in fields of 16 characters, elements with a property per CAD face.

PSHELL and MAT1 hold place for the analysis. Names stand in the comments that HyperMesh and OpenFOAM
read, the groups are sets. Where there are volume elements, the faces are sets of nodes.
"""
from __future__ import annotations

from typing import Any, List, Tuple

import numpy as np

from advlayers.formats.mesh_parts import Block, MeshParts, upright_first
from advlayers.formats.text_file import TextFile

_ELEMENTS = {
    "line2": "PLOTEL", "tri3": "CTRIA3", "tri6": "CTRIA6", "quad4": "CQUAD4", "quad8": "CQUAD8",
    "tet4": "CTETRA", "tet10": "CTETRA", "pyramid5": "CPYRAM", "pyramid13": "CPYRAM",
    "prism6": "CPENTA", "prism15": "CPENTA", "hex8": "CHEXA", "hex20": "CHEXA",
}
KINDS = frozenset(_ELEMENTS) | {"line3"}
_FIELDS = 8  # of eight characters, after the name of a card
_NODES, _CELLS = 1, 2  # kinds of a set


def write(path: str, parts: MeshParts) -> None:
    dimension = max(parts.dimension, 2)
    grouped = set(parts.grouped(1))
    with TextFile(path) as file:
        file.text("$ Advancing Layers\nBEGIN BULK\n")
        file.numbered("GRID*   %16d                %16w%16w*       \n*       %16w\n", 1,
                      parts.nodes)
        for start, block in zip(parts.starts, parts.blocks):
            if block.dimension == dimension:
                _write_cells(file, start, block)
            elif block.dimension == 1:
                _write_lines(file, start, block, grouped)
        _write_properties(file, parts, dimension)
        _write_sets(file, parts, dimension)
        file.text("ENDDATA\n")


def _write_cells(file: TextFile, start: int, block: Block) -> None:
    fields = ["%8d"] * (2 + block.cells.shape[1])
    lines = ["".join(fields[i:i + _FIELDS]) for i in range(0, len(fields), _FIELDS)]
    form = f"{_ELEMENTS[block.kind]:<8}" + "+       \n+       ".join(lines) + "\n"
    file.numbered(form, start + 1, block.part, block.cells[:, upright_first(block.kind)] + 1)


def _write_lines(file: TextFile, start: int, block: Block, grouped) -> None:
    """Of the edges in groups, and only for the eye: a beam would make the surface stiffer."""
    for run_start, cells in _runs_of(block, grouped):
        file.numbered("PLOTEL  %8d%8d%8d\n", start + 1 + run_start, cells[:, :2] + 1)


def _runs_of(block: Block, wanted) -> List[Tuple[int, Any]]:
    """Lines of these edges; those of one edge lie one behind the other."""
    kept = np.flatnonzero(np.isin(block.part, sorted(wanted)))
    pieces = np.split(kept, np.flatnonzero(np.diff(kept) > 1) + 1) if len(kept) else []
    return [(int(piece[0]), block.cells[piece]) for piece in pieces]


def _write_properties(file: TextFile, parts: MeshParts, dimension: int) -> None:
    for number in parts.part_numbers(dimension):
        file.text(f'$HMNAME COMP{number:20d}"{_one_line(parts.name(dimension, number))}"\n')
        if dimension == 3:
            file.text(f"PSOLID  {number:8d}{1:8d}\n")
        else:
            file.text(f"PSHELL  {number:8d}{1:8d}      1.{1:8d}        {1:8d}\n")
    # Steel, in N and mm.
    file.text(f"MAT1    {1:8d} 210000.              .3\n")


def _write_sets(file: TextFile, parts: MeshParts, dimension: int) -> None:
    own = {parts.name(dimension, number) for number in parts.part_numbers(dimension)}
    sets: List[Tuple[str, int, Any]] = [
        (name, _CELLS, elements) for name, _dimension, elements in parts.element_sets(dimension)
        if name not in own]
    nodes = parts.node_sets(2) if dimension == 3 else []
    sets += [(name, _NODES, members + 1) for name, members in nodes + parts.node_sets(1)]
    for number, (name, kind, members) in enumerate(sets, 1):
        file.text(f'$HMSET {number:8d}{kind:8d} "{_one_line(name)}"\n')
        first = members[:_FIELDS - 1]
        more = len(members) > len(first)
        file.text(f"SET1    {number:8d}" + "".join(f"{member:8d}" for member in first.tolist())
                  + ("+       " if more else "") + "\n")
        _write_rest(file, members[_FIELDS - 1:])


def _write_rest(file: TextFile, members: Any) -> None:
    full = (max(len(members) - 1, 0)) // _FIELDS * _FIELDS
    if full:
        file.rows("+       " + "%8d" * _FIELDS + "+       \n", members[:full].reshape(-1, _FIELDS))
    last = members[full:]
    if len(last):
        file.text("+       " + "".join(f"{member:8d}" for member in last.tolist()) + "\n")


def _one_line(name: str) -> str:
    return name.replace('"', "'")

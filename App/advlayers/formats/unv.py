"""I-DEAS universal files: datasets 164 (units), 2411 (nodes), 2412 (elements), 2467 (groups)."""
from __future__ import annotations

import re
from typing import Any, Dict, List, Tuple

import numpy as np

from advlayers.formats.mesh_parts import Block, MeshParts
from advlayers.formats.text_file import TextFile

# By kind the descriptor of the element and the order of its nodes, in which corners take turns with
# the nodes between them.
_ELEMENTS: Dict[str, Tuple[int, Tuple[int, ...]]] = {
    "line2": (21, (0, 1)), "line3": (24, (0, 2, 1)),
    "tri3": (41, (0, 1, 2)), "tri6": (42, (0, 3, 1, 4, 2, 5)),
    "quad4": (44, (0, 1, 2, 3)), "quad8": (45, (0, 4, 1, 5, 2, 6, 3, 7)),
    "tet4": (111, (0, 1, 2, 3)), "tet10": (118, (0, 4, 1, 5, 2, 6, 7, 8, 9, 3)),
    "prism6": (112, tuple(range(6))), "hex8": (115, tuple(range(8))),
    "prism15": (113, (0, 6, 1, 7, 2, 8, 12, 13, 14, 3, 9, 4, 10, 5, 11)),
    "hex20": (116, (0, 8, 1, 9, 2, 10, 3, 11, 16, 17, 18, 19, 4, 12, 5, 13, 6, 14, 7, 15)),
}
KINDS = frozenset(_ELEMENTS)
_ELEMENT_ENTITY, _NODE_ENTITY = 8, 7
_PER_LINE = 8
# Record of dataset 164: code and name of the unit of length.
_UNITS = {1.0: (1, "SI: Meter (newton)")}
_OTHER_UNIT = 9  # as the user has defined it


def write(path: str, parts: MeshParts, lines: bool = True) -> None:
    """Without `lines` edges are groups of nodes only."""
    elements = parts if lines else parts.only(2, 3)
    with TextFile(path) as file:
        _write_units(file, parts.metre)
        file.text("    -1\n  2411\n")
        # 17 significant digits: a double comes back as it was.
        file.numbered("%10d         1         1        11\n%25.16E%25.16E%25.16E\n", 1, parts.nodes)
        file.text("    -1\n    -1\n  2412\n")
        for start, block in zip(elements.starts, elements.blocks):
            _write_block(file, start, block)
        file.text("    -1\n    -1\n  2467\n")
        _write_groups(file, elements, parts.node_sets(1))
        file.text("    -1\n")


def _write_units(file: TextFile, metre: float) -> None:
    """Readers differ on what to do with the factor of the unit: OpenFOAM divides by it, as the
    format says, FreeCAD multiplies. With a factor of one all take the coordinates as they are."""
    code, name = _UNITS.get(metre, (_OTHER_UNIT, f"{metre:g} m"))
    lengths, forces, temperatures, zero = 1.0, 1.0, 1.0, 273.15
    factors = "".join(f"{value:25.17E}" for value in (lengths, forces, temperatures))
    file.text(f"    -1\n   164\n{code:10d}{name:<20.20s}{2:10d}\n"
              f"{factors}\n{zero:25.17E}\n    -1\n")


def _write_block(file: TextFile, start: int, block: Block) -> None:
    descriptor, order = _ELEMENTS[block.kind]
    head = "%10d" + "".join(f"{value:10d}" for value in (descriptor, 2, 1, 7, len(order))) + "\n"
    if block.dimension == 1:
        head += f"{0:10d}{1:10d}{1:10d}\n"  # orientation and cross-sections of a beam
    fields = ["%10d"] * len(order)
    lines = ["".join(fields[i:i + _PER_LINE]) for i in range(0, len(order), _PER_LINE)]
    file.numbered(head + "\n".join(lines) + "\n", start + 1, block.cells[:, order] + 1)


def _write_groups(file: TextFile, parts: MeshParts, of_nodes: List[Tuple[str, Any]]) -> None:
    groups: List[Tuple[str, int, np.ndarray]] = [
        (name, _ELEMENT_ENTITY, elements) for name, elements in _element_groups(parts)]
    groups += [(name, _NODE_ENTITY, nodes + 1) for name, nodes in of_nodes]
    for number, (name, entity, members) in enumerate(groups, 1):
        file.text(f"{number:10d}" + "         0" * 6 + f"{len(members):10d}\n{name}\n")
        file.listed(members, f"{entity:10d}%10d         0         0", 2)


def _element_groups(parts: MeshParts):
    """OpenFOAM's reader makes patches of them. It stops at a side that lies in two, and cuts names
    at a blank: where there is a volume, each side is in one group, of one word."""
    if parts.dimension < 3:
        return [(name, elements) for name, _dimension, elements in parts.element_sets(1, 2)]
    by_owner: Dict[str, List[np.ndarray]] = {}
    for number, owner in parts.owners(2).items():
        by_owner.setdefault(re.sub(r"\s", "_", owner), []).append(parts.elements_by_part(2)[number])
    return [(name, np.sort(np.concatenate(members))) for name, members in by_owner.items()] + [
        (name, elements) for name, _dimension, elements in parts.element_sets(3)]

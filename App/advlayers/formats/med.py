"""MED files of Salome: HDF5, laid out as version 4 of the format says.

The mesh has the name of the file: FreeCAD looks for it by that name.
"""
from __future__ import annotations

import os
from typing import Any, Dict, List, Tuple

import numpy as np

from advlayers.formats.hdf5 import folder, open_new
from advlayers.formats.mesh_parts import Block, MeshParts, order_of

# Name of the geometry, and MED's order of the nodes: a volume's first side is clockwise from inside
# it.
_TYPES: Dict[str, Tuple[str, Tuple[int, ...]]] = {
    "line2": ("SE2", (0, 1)), "line3": ("SE3", (0, 1, 2)),
    "tri3": ("TR3", (0, 1, 2)), "tri6": ("TR6", tuple(range(6))),
    "quad4": ("QU4", (0, 1, 2, 3)), "quad8": ("QU8", tuple(range(8))),
    "quad9": ("QU9", tuple(range(9))),
    "tet4": ("TE4", (0, 2, 1, 3)), "tet10": ("T10", (0, 2, 1, 3, 6, 5, 4, 7, 9, 8)),
    "pyramid5": ("PY5", (0, 3, 2, 1, 4)),
    "prism6": ("PE6", (0, 2, 1, 3, 5, 4)), "hex8": ("HE8", (0, 3, 2, 1, 4, 7, 6, 5)),
    "pyramid13": ("P13", order_of("pyramid13", (0, 3, 2, 1, 4))),
    "prism15": ("P15", order_of("prism15", (0, 2, 1, 3, 5, 4))),
    "hex20": ("H20", order_of("hex20", (0, 3, 2, 1, 4, 7, 6, 5))),
}
KINDS = frozenset(_TYPES)
_NAME_SIZE = 64  # of a mesh and of a family
_GROUP_SIZE = 80
_STEP = "-0000000000000000001-0000000000000000001"  # the mesh does not change in time
_UNITS = {1.0: "m", 0.001: "mm", 0.01: "cm", 0.0254: "in", 0.3048: "ft"}


def write(path: str, parts: MeshParts, lines: bool = True) -> None:
    """Without `lines` edges are groups of nodes only."""
    name = os.path.splitext(os.path.basename(path))[0].encode("utf-8")[:_NAME_SIZE]
    families = _Families()
    with open_new(path) as file:
        info = folder(file, "INFOS_GENERALES")
        _ints(info, MAJ=4, MIN=0, REL=0)
        step = _write_mesh(file, name, parts)
        _write_nodes(step, parts, families)
        _write_elements(step, parts if lines else parts.only(2, 3), families)
        families.write(folder(folder(file, "FAS"), name))


class _Families:
    """Sets of groups: each node and each element is of one family."""

    def __init__(self) -> None:
        self._of_nodes: List[Tuple[str, ...]] = []
        self._of_elements: Dict[Tuple[str, ...], int] = {}

    def of_elements(self, groups: Tuple[str, ...]) -> int:
        return -self._of_elements.setdefault(groups, len(self._of_elements) + 1)

    def of_nodes(self, count: int, sets: List[Tuple[str, Any]]):
        """(count,) numbers; 0: the node is in no set."""
        if not sets:
            return np.zeros(count, np.int32)
        member = np.concatenate([nodes for _name, nodes in sets])
        of_set = np.repeat(np.arange(len(sets)), [len(nodes) for _name, nodes in sets])
        order = np.lexsort((of_set, member))
        nodes, first = np.unique(member[order], return_index=True)
        found = np.zeros(count, np.int32)
        numbers: Dict[bytes, int] = {}
        for node, groups in zip(nodes.tolist(), np.split(of_set[order], first[1:])):
            key = groups.tobytes()
            if key not in numbers:
                self._of_nodes.append(tuple(sets[group][0] for group in groups.tolist()))
                numbers[key] = len(self._of_nodes)
            found[node] = numbers[key]
        return found

    def write(self, group) -> None:
        _ints(folder(group, "FAMILLE_ZERO"), NUM=0)
        for entities, families in (
                ("ELEME", {-number: names for names, number in self._of_elements.items()}),
                ("NOEUD", dict(enumerate(self._of_nodes, 1)))):
            if families:
                kept = folder(group, entities)
                for number, names in families.items():
                    _write_family(folder(kept, f"FAM_{number}"), number, names)


def _write_family(group, number: int, names: Tuple[str, ...]) -> None:
    _ints(group, NUM=number)
    kept = folder(group, "GRO")
    _ints(kept, NBR=len(names))
    letters = np.zeros((len(names), _GROUP_SIZE), np.int8)
    for row, name in zip(letters, names):
        text = np.frombuffer(name.encode("utf-8")[:_GROUP_SIZE], np.int8)
        row[:len(text)] = text
    # A row of 80 letters is one value of the data set.
    kept.create_dataset("NOM", (len(names),), dtype=np.dtype((np.int8, (_GROUP_SIZE,))))[...] = (
        letters)


def _write_mesh(file, name: bytes, parts: MeshParts):
    mesh = folder(folder(file, "ENS_MAA"), name)
    _ints(mesh, DIM=max(parts.dimension, 1), ESP=3, REP=0, SRT=1, TYP=0)
    unit = _UNITS.get(parts.metre, "").encode()
    _texts(mesh, UNT=b"", DES=b"", NOM=b"".join(axis.ljust(16) for axis in (b"X", b"Y", b"Z")),
           UNI=unit.ljust(16) * 3)
    step = folder(mesh, _STEP)
    _ints(step, CGT=1, NDT=-1, NOR=-1, NXI=-1, NXT=-1, PVI=-1, PVT=-1)
    step.attrs.create("PDT", -1.0)
    return step


def _write_nodes(step, parts: MeshParts, families: _Families) -> None:
    kept = _entities(folder(step, "NOE"))
    count = len(parts.nodes)
    _data(kept, "COO", np.ascontiguousarray(parts.nodes.T).ravel(), count)
    _data(kept, "FAM", families.of_nodes(count, parts.node_sets(1)), count)


def _write_elements(step, parts: MeshParts, families: _Families) -> None:
    cells = folder(step, "MAI")
    _ints(cells, CGT=1)
    of_kind: Dict[str, List[Tuple[int, Block]]] = {}
    for start, block in zip(parts.starts, parts.blocks):
        of_kind.setdefault(block.kind, []).append((start + 1, block))
    for kind, blocks in of_kind.items():
        name, order = _TYPES[kind]
        nodes = np.concatenate([block.cells for _first, block in blocks])
        numbers = [np.arange(first, first + len(block), dtype=np.int32) for first, block in blocks]
        count = len(nodes)
        kept = _entities(folder(cells, name))
        # All first nodes, then all second ones, and so on.
        _data(kept, "NOD", (nodes.T[list(order)] + 1).ravel(), count)
        _data(kept, "NUM", np.concatenate(numbers), count)
        _data(kept, "FAM", np.concatenate([_element_families(parts, block, families)
                                           for _first, block in blocks]), count)


def _element_families(parts: MeshParts, block: Block, families: _Families):
    in_groups: Dict[int, List[str]] = {}
    for group in parts.groups:
        if group.dimension == block.dimension:
            for number in group.parts:
                in_groups.setdefault(number, []).append(group.name)
    layered = parts.layer_groups and block.dimension == 2
    # A table of all that may be is quicker than sorting the elements.
    layers = int(block.layers.max()) + 1 if layered else 1
    key = block.part.astype(np.int64) * layers + (block.layers if layered else 0)
    table = np.zeros(int(key.max()) + 1, np.int32)
    for value in np.flatnonzero(np.bincount(key)).tolist():
        part, layer_number = divmod(value, layers)
        names = [parts.name(block.dimension, part), *in_groups.get(part, ())]
        if layered:
            names.append(f"Layer{layer_number}" if layer_number else "Core")
        table[value] = families.of_elements(tuple(dict.fromkeys(names)))
    return table[key]


def _entities(group):
    _ints(group, CGT=1, CGS=1)
    _texts(group, PFL=b"MED_NO_PROFILE_INTERNAL")
    return group


def _data(group, name: str, values, count: int) -> None:
    _ints(group.create_dataset(name, data=values), CGT=1, NBR=count)


def _ints(group, **values: int) -> None:
    for name, value in values.items():
        group.attrs.create(name, value, dtype=np.int32)


def _texts(group, **values: bytes) -> None:
    for name, value in values.items():
        group.attrs.create(name, np.bytes_(value) if value else np.bytes_(b"\0"),
                           dtype=f"S{max(len(value), 1)}")

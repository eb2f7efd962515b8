"""UGRID of AFLR and FUN3D as text (.ugrid), or as doubles and 32-bit integers, big-endian
(.b8.ugrid) or little-endian (.lb8.ugrid). The names of the surfaces stand in a file .mapbc beside
it.
"""
from __future__ import annotations

import os
from typing import Any, Dict, Iterator, List, Tuple

import numpy as np

from advlayers.formats.boundary_kind import boundary_kind
from advlayers.formats.mesh_parts import Block, MeshParts
from advlayers.formats.plain_names import plain_names
from advlayers.formats.text_file import TextFile

# In the order of the file; the pyramid's apex is its third node.
_SURFACE = {"tri3": (0, 1, 2), "quad4": (0, 1, 2, 3)}
_VOLUME = {"tet4": (0, 1, 2, 3), "pyramid5": (0, 3, 4, 1, 2), "prism6": tuple(range(6)),
           "hex8": tuple(range(8))}
KINDS = frozenset(_SURFACE) | frozenset(_VOLUME)
_ORDERS: Dict[str, Tuple[int, ...]] = {**_SURFACE, **_VOLUME}
_NAME_SIZE = 60
_ENDING = ".ugrid"
# FUN3D's numbers.
_CONDITIONS = {"wall": 4000, "symmetry": 6662, "patch": 5000}


def write(path: str, parts: MeshParts) -> None:
    names, numbers = _surfaces(parts)
    blocks = {kind: [block for block in parts.blocks if block.kind == kind] for kind in _ORDERS}
    counts = [len(parts.nodes)] + [sum(map(len, blocks[kind])) for kind in _ORDERS]
    binary = {".b8": ">", ".lb8": "<"}.get(os.path.splitext(path.lower()[:-len(_ENDING)])[1])
    if binary is None:
        _write_text(path, parts, blocks, counts, numbers)
    else:
        _write_binary(path, parts, blocks, counts, numbers, binary)
    _write_names(names_file(path), names)


def names_file(path: str) -> str:
    """FUN3D looks for it under the name without all endings."""
    stem = path[:-len(_ENDING)]
    start, ending = os.path.splitext(stem)
    return (start if ending.lower() in (".b8", ".lb8") else stem) + ".mapbc"


def _surfaces(parts: MeshParts) -> Tuple[List[str], Any]:
    """The names of the surfaces, numbered from 1, and the number by part."""
    owners = parts.owners(2)
    names = list(dict.fromkeys(owners.values()))
    numbers = np.zeros(max(owners, default=0) + 1, np.int32)
    for part, owner in owners.items():
        numbers[part] = names.index(owner) + 1
    return names, numbers


Blocks = Dict[str, List[Block]]


def _sections(blocks: Blocks, numbers: Any) -> Iterator[Any]:
    """What follows the coordinates: corners and numbers of the surfaces, then the volume."""
    for kind, order in _SURFACE.items():
        for block in blocks[kind]:
            yield block.cells[:, order] + 1
    for kind in _SURFACE:
        for block in blocks[kind]:
            yield numbers[block.part]
    for kind, order in _VOLUME.items():
        for block in blocks[kind]:
            yield block.cells[:, order] + 1


def _write_text(path: str, parts: MeshParts, blocks: Blocks, counts: List[int],
                numbers: Any) -> None:
    with TextFile(path) as file:
        file.text(" ".join(map(str, counts)) + "\n")
        file.rows("%r %r %r\n", parts.nodes)
        for rows in _sections(blocks, numbers):
            width = rows.shape[1] if rows.ndim == 2 else 1
            file.rows(" ".join(["%d"] * width) + "\n", rows)


def _write_binary(path: str, parts: MeshParts, blocks: Blocks, counts: List[int], numbers: Any,
                  order: str) -> None:
    with open(path, "wb") as file:
        file.write(np.array(counts, f"{order}i4").tobytes())
        file.write(np.ascontiguousarray(parts.nodes, f"{order}f8").tobytes())
        for rows in _sections(blocks, numbers):
            file.write(np.ascontiguousarray(rows, f"{order}i4").tobytes())


def _write_names(path: str, names: List[str]) -> None:
    plain = plain_names(names, _NAME_SIZE)
    with open(path, "w", encoding="ascii") as file:
        file.write(f"{len(names)}\n")
        for number, name in enumerate(names, 1):
            file.write(f"{number} {_CONDITIONS[boundary_kind(name)]} {plain[name]}\n")

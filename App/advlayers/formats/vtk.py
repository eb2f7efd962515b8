"""VTK's legacy format, version 3, binary: what every reader of VTK files knows.

Its numbers are plain `int`: newer readers drop the arrays of other integer types of older files.
"""
from __future__ import annotations

from typing import Any, BinaryIO

import numpy as np

from advlayers.formats.mesh_parts import MeshParts
from advlayers.formats.vtu import ELEMENTS, cell_arrays, drawn, group_numbers, node_arrays

KINDS = frozenset(ELEMENTS)
_PIECE = 2**16  # rows at a time


def write(path: str, parts: MeshParts) -> None:
    """The arrays of vtu; the names of the groups stand in the title, as far as it has room."""
    parts = drawn(parts)
    count = sum(len(block) for block in parts.blocks)
    with open(path, "wb") as file:
        names = " ".join(f"{number}={name}" for name, number in group_numbers(parts).items())
        title = " ".join(f"Advancing Layers {names}".split()).encode("utf-8")[:255]
        file.write(b"# vtk DataFile Version 3.0\n" + title.decode("utf-8", "ignore").encode("utf-8")
                   + b"\nBINARY\nDATASET UNSTRUCTURED_GRID\n")
        file.write(f"POINTS {len(parts.nodes)} double\n".encode())
        _write(file, parts.nodes, ">f8")
        size = sum(len(block) * (block.cells.shape[1] + 1) for block in parts.blocks)
        file.write(f"CELLS {count} {size}\n".encode())
        for block in parts.blocks:
            order = list(ELEMENTS[block.kind][1])
            for start in range(0, len(block), _PIECE):
                cells = block.cells[start:start + _PIECE, order]
                _write(file, np.insert(cells, 0, len(order), axis=1), ">i4", end=b"")
        file.write(f"\nCELL_TYPES {count}\n".encode())
        for block in parts.blocks:
            _write(file, np.full(len(block), ELEMENTS[block.kind][0]), ">i4", end=b"")
        file.write(f"\nCELL_DATA {count}\n".encode())
        for name, of_block in cell_arrays(parts):
            _scalars(file, name, map(of_block, parts.blocks))
        if parts.node_layer is not None:
            file.write(f"POINT_DATA {len(parts.nodes)}\n".encode())
        for name, values in node_arrays(parts):
            _scalars(file, name, [values])


def _scalars(file: BinaryIO, name: str, pieces) -> None:
    file.write(f"SCALARS {name} int 1\nLOOKUP_TABLE default\n".encode())
    for values in pieces:
        _write(file, values, ">i4", end=b"")
    file.write(b"\n")


def _write(file: BinaryIO, values: Any, kind: str, end: bytes = b"\n") -> None:
    for start in range(0, len(values), _PIECE):
        file.write(np.ascontiguousarray(values[start:start + _PIECE], kind).tobytes())
    file.write(end)

"""VTK's unstructured grids (VTU): binary in base64, piece by piece.

FreeCAD's own VTK export rounds to single precision and loses the triangles of a mixed mesh.
"""
from __future__ import annotations

import base64
import sys
from typing import Any, BinaryIO, Callable, Dict, Iterable, Iterator, List, Tuple
from xml.sax.saxutils import quoteattr

import numpy as np

from advlayers.formats.mesh_parts import Block, MeshParts, order_of

# By kind VTK's number and order of the nodes: its wedges begin with the side that faces outward.
ELEMENTS: Dict[str, Tuple[int, Tuple[int, ...]]] = {
    "line2": (3, (0, 1)), "line3": (21, (0, 1, 2)),
    "tri3": (5, (0, 1, 2)), "tri6": (22, tuple(range(6))),
    "quad4": (9, (0, 1, 2, 3)), "quad8": (23, tuple(range(8))), "quad9": (28, tuple(range(9))),
    "tet4": (10, (0, 1, 2, 3)), "tet10": (24, tuple(range(10))),
    "pyramid5": (14, tuple(range(5))), "prism6": (13, (0, 2, 1, 3, 5, 4)),
    "hex8": (12, tuple(range(8))), "pyramid13": (27, tuple(range(13))),
    "prism15": (26, order_of("prism15", (0, 2, 1, 3, 5, 4))), "hex20": (25, tuple(range(20))),
}
KINDS = frozenset(ELEMENTS)
_TYPES = {"float64": "Float64", "int32": "Int32", "int64": "Int64", "uint8": "UInt8"}
# Bytes at a time; a multiple of three is a whole number of letters.
_PIECE = 3 * 2**18
Pieces = Iterable[Any]  # arrays, one after another


def write(path: str, parts: MeshParts) -> None:
    """Cell arrays `face`, `layer` (0: core), `edge` and `solid` where there are lines and volumes,
    and `group`: the number that stands in the field of the group's name, 0 for none. Node arrays
    `layer` and `parent` (the node that it was extruded from, zero-based; -1: none)."""
    parts = drawn(parts)
    order = "LittleEndian" if sys.byteorder == "little" else "BigEndian"
    with open(path, "wb") as file:
        file.write(
            '<?xml version="1.0"?>\n'
            f'<VTKFile type="UnstructuredGrid" version="1.0" byte_order="{order}" '
            'header_type="UInt64">\n<UnstructuredGrid>\n'.encode("ascii"))
        _write_names(file, group_numbers(parts))
        count = sum(len(block) for block in parts.blocks)
        file.write(f'<Piece NumberOfPoints="{len(parts.nodes)}" NumberOfCells="{count}">\n'
                   "<Points>\n".encode("ascii"))
        _write_array(file, "Points", np.float64, len(parts.nodes), [parts.nodes], 3)
        file.write(b"</Points>\n<Cells>\n")
        _write_cells(file, parts, count)
        file.write(b"</Cells>\n<PointData>\n")
        for name, values in node_arrays(parts):
            _write_array(file, name, np.int32, len(values), [values])
        file.write(b"</PointData>\n<CellData>\n")
        for name, of_block in cell_arrays(parts):
            _write_array(file, name, np.int32, count, map(of_block, parts.blocks))
        file.write(b"</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


def drawn(parts: MeshParts) -> MeshParts:
    """Without the lines that are in no group: a viewer would draw all of them."""
    grouped = parts.grouped(1)
    blocks = []
    for block in parts.blocks:
        if block.dimension == 1:
            kept = np.isin(block.part, grouped)
            block = Block(block.kind, block.cells[kept], block.part[kept])
        if len(block):
            blocks.append(block)
    return parts.with_blocks(blocks)


def group_numbers(parts: MeshParts) -> Dict[str, int]:
    """From 1, of the names that an element may have in the array `group`."""
    names = [group.name for group in parts.groups]
    present = {dimension: set(parts.part_numbers(dimension)) for dimension in (1, 2, 3)}
    names += [name for (dimension, number), name in parts.names.items()
              if number in present[dimension]]
    return {name: number for number, name in enumerate(dict.fromkeys(names), 1)}


def cell_arrays(parts: MeshParts) -> List[Tuple[str, Callable[[Block], Any]]]:
    """Name, and the values of a block."""
    arrays: List[Tuple[str, Callable[[Block], Any]]] = [
        ("face", _part_of(2)), ("layer", lambda block: block.layers)]
    for dimension, name in ((1, "edge"), (3, "solid")):
        if parts.of(dimension):
            arrays.append((name, _part_of(dimension)))
    numbers = group_numbers(parts)
    if numbers:
        tables = {dimension: _group_of_part(parts, dimension, numbers) for dimension in (1, 2, 3)}
        arrays.append(("group", lambda block: tables[block.dimension][block.part]))
    return arrays


def _part_of(dimension: int) -> Callable[[Block], Any]:
    return lambda block: (block.part if block.dimension == dimension
                          else np.zeros(len(block), np.int32))


def _group_of_part(parts: MeshParts, dimension: int, numbers: Dict[str, int]):
    owners = parts.owners(dimension)
    table = np.zeros(max(owners, default=0) + 1, np.int32)
    for part, owner in owners.items():
        table[part] = numbers.get(owner, 0)
    return table


def node_arrays(parts: MeshParts) -> List[Tuple[str, Any]]:
    given = (("layer", parts.node_layer), ("parent", parts.node_parent))
    return [(name, values) for name, values in given if values is not None]


def _write_cells(file: BinaryIO, parts: MeshParts, count: int) -> None:
    orders = [list(ELEMENTS[block.kind][1]) for block in parts.blocks]
    length = sum(len(block) * len(order) for block, order in zip(parts.blocks, orders))
    rows = _PIECE // 64
    _write_array(file, "connectivity", np.int64, length, (
        block.cells[start:start + rows, order]
        for block, order in zip(parts.blocks, orders) for start in range(0, len(block), rows)))
    _write_array(file, "offsets", np.int64, count, _offsets(parts, rows))
    _write_array(file, "types", np.uint8, count, (
        np.full(len(block), ELEMENTS[block.kind][0], np.uint8) for block in parts.blocks))


def _offsets(parts: MeshParts, rows: int) -> Iterator[Any]:
    end = 0
    for block in parts.blocks:
        width = block.cells.shape[1]
        for start in range(0, len(block), rows):
            count = min(rows, len(block) - start)
            yield end + width * np.arange(1, count + 1)
            end += width * count


def _write_names(file: BinaryIO, numbers: Dict[str, int]) -> None:
    """A field of one number for each name: not all readers know fields of texts."""
    if not numbers:
        return
    file.write(b"<FieldData>\n")
    for name, number in numbers.items():
        file.write(f'<DataArray type="Int32" Name={quoteattr(name)} NumberOfTuples="1" '
                   f'format="ascii">{number}</DataArray>\n'.encode("utf-8"))
    file.write(b"</FieldData>\n")


def _write_array(file: BinaryIO, name: str, kind: Any, length: int, pieces: Pieces,
                 components: int = 0) -> None:
    """`components`: of a vector; 0 for plain numbers, which some readers tell from vectors of 1."""
    kind = np.dtype(kind)
    vector = f' NumberOfComponents="{components}"' if components else ""
    file.write(f'<DataArray type="{_TYPES[kind.name]}" Name="{name}"{vector} '
               'format="binary">'.encode("ascii"))
    size = length * max(components, 1) * kind.itemsize
    left = np.array([size], np.uint64).tobytes()
    for values in pieces:
        data = memoryview(np.ascontiguousarray(values, kind)).cast("B")
        taken = 0
        while len(left) + len(data) - taken >= _PIECE:
            part = left + bytes(data[taken:taken + _PIECE - len(left)])
            taken += _PIECE - len(left)
            left = b""
            file.write(base64.b64encode(part))
        left += bytes(data[taken:])
    file.write(base64.b64encode(left))
    file.write(b"</DataArray>\n")

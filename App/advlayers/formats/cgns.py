"""CGNS files on HDF5: one zone, sections by part, families for the names.

The nodes of a CGNS file are laid down as the library's HDF5 mapping says: a group with the
attributes name, label, type and flags, its data in a data set " data".
"""
from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from advlayers.formats import plane, sides
from advlayers.formats.boundary_kind import boundary_kind
from advlayers.formats.hdf5 import folder, open_new
from advlayers.formats.mesh_parts import MeshParts, Run, upright_first
from advlayers.formats.plain_names import plain_names

# By kind the number of the element type and the order of the nodes.
_ELEMENTS: Dict[str, Tuple[int, Tuple[int, ...]]] = {
    "line2": (3, (0, 1)), "line3": (4, (0, 1, 2)),
    "tri3": (5, (0, 1, 2)), "tri6": (6, tuple(range(6))),
    "quad4": (7, (0, 1, 2, 3)), "quad8": (8, tuple(range(8))), "quad9": (9, tuple(range(9))),
    "tet4": (10, (0, 1, 2, 3)), "tet10": (11, tuple(range(10))),
    "pyramid5": (12, tuple(range(5))), "prism6": (14, tuple(range(6))),
    "hex8": (17, tuple(range(8))), "pyramid13": (21, tuple(range(13))),
    "prism15": (15, upright_first("prism15")), "hex20": (18, upright_first("hex20")),
}
KINDS = frozenset(_ELEMENTS)
_NAME_SIZE = 32
_VERSION = 3.3
_LENGTHS = {1.0: "Meter", 0.01: "Centimeter", 0.001: "Millimeter", 0.3048: "Foot", 0.0254: "Inch"}
_CONDITIONS = {"wall": "BCWall", "symmetry": "BCSymmetryPlane", "patch": "BCFarfield"}
_LOCATIONS = {1: "EdgeCenter", 2: "FaceCenter"}


def write(path: str, parts: MeshParts) -> None:
    cells = max(parts.dimension, 2)
    flat = plane.axes(parts.nodes.min(axis=0), parts.nodes.max(axis=0)) if cells == 2 else None
    if flat is not None:
        parts = plane.turned_up(parts, flat)
    # A plane domain at z = 0 is one of two dimensions: its third coordinate says nothing.
    physical = 2 if flat == (0, 1) and not parts.nodes[:, 2].any() else 3
    with open_new(path) as file:
        _root(file)
        _node(file, "CGNSLibraryVersion", "CGNSLibraryVersion_t", np.array([_VERSION], np.float32))
        base = _node(file, "Base", "CGNSBase_t", np.array([cells, physical], np.int32))
        _units(base, parts.metre)
        count = sum(len(block) for block in parts.of(cells))
        zone = _node(base, "Zone", "Zone_t",
                     np.array([[len(parts.nodes)], [count], [0]], np.int32))
        _node(zone, "ZoneType", "ZoneType_t", "Unstructured")
        grid = _node(zone, "GridCoordinates", "GridCoordinates_t")
        for axis, letter in enumerate("XYZ"[:physical]):
            _node(grid, f"Coordinate{letter}", "DataArray_t",
                  np.ascontiguousarray(parts.nodes[:, axis]))
        ranges = _sections(zone, parts, cells)
        _conditions(base, zone, parts, cells, ranges)


class _Range(NamedTuple):
    """Elements of the file, numbered from 1, the last one included."""

    name: str
    dimension: int
    first: int
    last: int


def _sections(zone, parts: MeshParts, cells: int) -> List[_Range]:
    """The cells first, then what bounds them, each owner's elements in one row."""
    ranges: List[_Range] = []
    first = 1
    for dimension in (cells, cells - 1):
        owners = parts.owners(dimension)
        runs: Dict[Tuple[str, str], List[Any]] = {}
        for run in _outer(parts, dimension) if dimension < cells else parts.by_part(dimension):
            runs.setdefault((owners[run.part], run.kind), []).append(run.cells)
        plain = plain_names([f"{owner}_{kind}" for owner, kind in runs], _NAME_SIZE)
        for owner, kind in sorted(runs, key=lambda run: list(owners.values()).index(run[0])):
            number, order = _ELEMENTS[kind]
            rows = np.concatenate(runs[owner, kind])
            last = first + len(rows) - 1
            section = _node(zone, plain[f"{owner}_{kind}"], "Elements_t",
                            np.array([number, 0], np.int32))
            _node(section, "ElementRange", "IndexRange_t", np.array([first, last], np.int32))
            _node(section, "ElementConnectivity", "DataArray_t",
                  (rows[:, order] + 1).astype(np.int32).ravel())
            if ranges and ranges[-1].name == owner and ranges[-1].dimension == dimension:
                ranges[-1] = ranges[-1]._replace(last=last)
            else:
                ranges.append(_Range(owner, dimension, first, last))
            first = last + 1
    return ranges


def _outer(parts: MeshParts, dimension: int):
    """What has cells on one side only, or is in a group."""
    grouped = set(parts.grouped(dimension))
    for run in parts.by_part(dimension):
        if run.part not in grouped:
            _element, _place, count = sides.find(parts, [(run.kind, run.cells)])
            kept = count == 1
            run = Run(run.part, run.kind, run.elements[kept], run.cells[kept])
        if len(run.cells):
            yield run


def _conditions(base, zone, parts: MeshParts, cells: int, ranges: List[_Range]) -> None:
    plain = plain_names([entry.name for entry in ranges], _NAME_SIZE)
    bounds = [entry for entry in ranges if entry.dimension < cells]
    families = dict.fromkeys(entry.name for entry in ranges)
    for name in families:
        family = _node(base, plain[name], "Family_t")
        if any(entry.name == name for entry in bounds):
            _node(family, "FamilyBC", "FamilyBC_t", _CONDITIONS[boundary_kind(name)])
    if bounds:
        conditions = _node(zone, "ZoneBC", "ZoneBC_t")
        for entry in bounds:
            condition = _node(conditions, plain[entry.name], "BC_t", "FamilySpecified")
            _node(condition, "PointRange", "IndexRange_t",
                  np.array([[entry.first], [entry.last]], np.int32))
            _node(condition, "GridLocation", "GridLocation_t", _LOCATIONS[entry.dimension])
            _node(condition, "FamilyName", "FamilyName_t", plain[entry.name])
    if cells == 2:
        _name_cells(zone, ranges, plain)


def _name_cells(zone, ranges: List[_Range], plain: Dict[str, str]) -> None:
    """The faces of a surface: regions of its cells."""
    for entry in ranges:
        if entry.dimension == 2:
            region = _node(zone, f"of_{plain[entry.name]}"[:_NAME_SIZE], "ZoneSubRegion_t",
                           np.array([2], np.int32))
            _node(region, "PointRange", "IndexRange_t",
                  np.array([[entry.first], [entry.last]], np.int32))
            _node(region, "GridLocation", "GridLocation_t", "CellCenter")
            _node(region, "FamilyName", "FamilyName_t", plain[entry.name])


def _units(base, metre: float) -> None:
    length = next((name for size, name in _LENGTHS.items()
                   if abs(metre / size - 1.0) < 1e-12), None)
    if length is not None:
        _node(base, "DataClass", "DataClass_t", "Dimensional")
        words = ["Kilogram", length, "Second", "Kelvin", "Degree"]
        letters = np.array([list(word.ljust(32).encode("ascii")) for word in words], np.int8)
        _node(base, "DimensionalUnits", "DimensionalUnits_t", letters)


# --- nodes in HDF5 --------------------------------------------------------------------------------

def _root(file) -> None:
    _attributes(file, "HDF5 MotherNode", "Root Node of HDF5 File", "MT")
    _letters(file, " format", "IEEE_LITTLE_32", 15)
    _letters(file, " hdf5version", "HDF5 Version 1.8.17", 33)


def _node(parent, name: str, label: str, data: Optional[Any] = None):
    node = folder(parent, name)
    if isinstance(data, str):
        data = np.frombuffer(data.encode("ascii"), np.int8)
    types = {"int8": "C1", "int32": "I4", "float32": "R4", "float64": "R8"}
    _attributes(node, name, label, "MT" if data is None else types[data.dtype.name])
    if data is not None:
        node.create_dataset(" data", data=data)
    return node


def _attributes(node, name: str, label: str, kind: str) -> None:
    for key, text, size in (("name", name, 33), ("label", label, 33), ("type", kind, 3)):
        node.attrs.create(key, np.bytes_(text), dtype=f"S{size}")
    if kind != "MT" or label != "Root Node of HDF5 File":
        node.attrs.create("flags", np.array([1], np.int32))


def _letters(file, name: str, text: str, size: int) -> None:
    file.create_dataset(name, data=np.frombuffer(text.encode("ascii").ljust(size, b"\0"), np.int8))

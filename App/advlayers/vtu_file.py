"""Writes VTK's unstructured-grid files (VTU): doubles, quads and triangles, the mesh's own arrays.

FreeCAD's own VTK export rounds to single precision and loses the triangles of a mixed mesh.
"""
from __future__ import annotations

import base64
import sys

import numpy as np

from advlayers.mesh_groups import face_of_element, layer_of_element

_TYPES = {"float64": "Float64", "int32": "Int32", "int64": "Int64", "uint8": "UInt8"}
_VTK_TRIANGLE, _VTK_QUAD = 5, 9


def write_vtu(path: str, mesh) -> None:
    """Cell arrays `face` (CAD face number) and `layer` (0: core); node arrays `layer` and `parent`
    (the node it was extruded from, zero-based; -1: none)."""
    quads, triangles = len(mesh.quads), len(mesh.triangles)
    connectivity = np.concatenate([mesh.quads.ravel(), mesh.triangles.ravel()]).astype(np.int64)
    offsets = np.cumsum(np.repeat([4, 3], [quads, triangles]), dtype=np.int64)
    types = np.repeat([_VTK_QUAD, _VTK_TRIANGLE], [quads, triangles]).astype(np.uint8)
    order = "LittleEndian" if sys.byteorder == "little" else "BigEndian"
    lines = [
        '<?xml version="1.0"?>',
        f'<VTKFile type="UnstructuredGrid" version="1.0" byte_order="{order}" '
        'header_type="UInt64">',
        "<UnstructuredGrid>",
        f'<Piece NumberOfPoints="{len(mesh.nodes)}" NumberOfCells="{quads + triangles}">',
        "<Points>", _array("Points", mesh.nodes.astype(np.float64), 3), "</Points>",
        "<Cells>", _array("connectivity", connectivity), _array("offsets", offsets),
        _array("types", types), "</Cells>",
        "<PointData>", _array("layer", mesh.node_layer.astype(np.int32)),
        _array("parent", mesh.node_parent.astype(np.int32)), "</PointData>",
        "<CellData>", _array("face", face_of_element(mesh)),
        _array("layer", layer_of_element(mesh)), "</CellData>",
        "</Piece>", "</UnstructuredGrid>", "</VTKFile>",
    ]
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")


def _array(name: str, values, components: int = 0) -> str:
    """`components`: of a vector; 0 for plain numbers, which some readers tell from vectors of 1."""
    data = np.ascontiguousarray(values).tobytes()
    header = np.array([len(data)], np.uint64).tobytes()
    text = base64.b64encode(header + data).decode("ascii")
    vector = f' NumberOfComponents="{components}"' if components else ""
    return (f'<DataArray type="{_TYPES[values.dtype.name]}" Name="{name}"{vector} '
            f'format="binary">{text}</DataArray>')

"""A finished mesh to FreeCAD's Fem.FemMesh."""
from __future__ import annotations

import importlib.util
import os
import tempfile
from typing import Callable, Dict, Optional, Tuple

import numpy as np

from advlayers.formats import med, unv
from advlayers.formats.mesh_parts import MeshParts, order_of

# Entries between two looks at the request to stop: some 20 ms.
_BLOCK = 5000
# FreeCAD's order of the nodes of volume elements: the first side is clockwise from inside.
_ORDERS: Dict[str, Tuple[int, ...]] = {
    "tet4": (0, 2, 1, 3), "tet10": (0, 2, 1, 3, 6, 5, 4, 7, 9, 8), "pyramid5": (0, 3, 2, 1, 4),
    "prism6": (0, 2, 1, 3, 5, 4), "hex8": (0, 3, 2, 1, 4, 7, 6, 5),
    "pyramid13": order_of("pyramid13", (0, 3, 2, 1, 4)),
    "prism15": order_of("prism15", (0, 2, 1, 3, 5, 4)),
    "hex20": order_of("hex20", (0, 3, 2, 1, 4, 7, 6, 5)),
}


def to_fem_mesh(parts: MeshParts, check: Optional[Callable[[], None]] = None):
    """`check` is called now and then, and what it raises ends the work. Without it FreeCAD reads
    the mesh from a file, which takes a third of the time and cannot be stopped.

    Node and element ids run from 1 without a gap, as FreeCAD renumbers them on saving otherwise.
    Lines are left out, but their nodes are groups. FreeCAD prints a line for each group."""
    return _through_file(parts) if check is None else _one_by_one(parts, check)


def _through_file(parts: MeshParts):
    import Fem

    kind, writer = ("med", med) if importlib.util.find_spec("h5py") else ("unv", unv)
    with tempfile.TemporaryDirectory(prefix="advlayers-") as folder:
        path = os.path.join(folder, f"mesh.{kind}")
        writer.write(path, parts, lines=False)
        return Fem.read(path)


def _one_by_one(parts: MeshParts, check: Callable[[], None]):
    import Fem

    fem = Fem.FemMesh()
    for start in range(0, len(parts.nodes), _BLOCK):
        check()
        for i, (x, y, z) in enumerate(parts.nodes[start:start + _BLOCK].tolist(), start + 1):
            fem.addNode(x, y, z, i)
    number = 0
    for block in parts.of(2, 3):
        add = fem.addFace if block.dimension == 2 else fem.addVolume
        order = list(_ORDERS.get(block.kind, range(block.cells.shape[1])))
        for start in range(0, len(block), _BLOCK):
            check()
            for cell in (block.cells[start:start + _BLOCK, order] + 1).tolist():
                number += 1
                add(cell, number)
    kinds = {2: "Face", 3: "Volume"}
    for name, dimension, elements in parts.element_sets(2, 3):
        _add_group(fem, name, kinds[dimension], elements)
    for name, nodes in parts.node_sets(1):
        _add_group(fem, name, "Node", nodes + 1)
    return fem


def _add_group(fem, name: str, kind: str, ids: np.ndarray) -> None:
    index = fem.addGroup(name, kind)
    fem.addGroupElements(index, ids.tolist())


def empty():
    import Fem

    return Fem.FemMesh()


def compact(fem):
    """The same mesh in half of the memory: FreeCAD logs every node and element that is added one
    by one, but not those of a copy."""
    import Fem

    return Fem.FemMesh(fem)

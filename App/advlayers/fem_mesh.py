"""A finished mesh to FreeCAD's Fem.FemMesh."""
from __future__ import annotations

from typing import Callable, Mapping, Sequence

from advlayers.mesh_groups import mesh_groups


# Entries between two looks at the request to stop: some 20 ms.
_BLOCK = 5000


def to_fem_mesh(mesh, named: Mapping[str, Sequence[str]],
                check: Callable[[], None] = lambda: None):
    """`check` is called now and then, and what it raises ends the work.

    Node and element ids run from 1 without a gap, as FreeCAD renumbers them on saving
    otherwise: quads first, then triangles. FreeCAD prints a line for each group."""
    import Fem

    fem = Fem.FemMesh()
    for start in range(0, len(mesh.nodes), _BLOCK):
        check()
        for i, (x, y, z) in enumerate(mesh.nodes[start:start + _BLOCK].tolist(), start + 1):
            fem.addNode(x, y, z, i)
    number = 0
    for cells in (mesh.quads, mesh.triangles):
        for start in range(0, len(cells), _BLOCK):
            check()
            for cell in (cells[start:start + _BLOCK] + 1).tolist():
                number += 1
                fem.addFace(cell, number)
    for group in mesh_groups(mesh, named):
        index = fem.addGroup(group.name, "Node" if group.of_nodes else "Face")
        fem.addGroupElements(index, group.ids.tolist())
    return fem


def empty():
    import Fem

    return Fem.FemMesh()


def compact(fem):
    """The same mesh in half of the memory: FreeCAD logs every node and element that is added one
    by one, but not those of a copy."""
    import Fem

    return Fem.FemMesh(fem)

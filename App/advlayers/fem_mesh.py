"""A finished mesh to FreeCAD's Fem.FemMesh."""
from __future__ import annotations

from typing import Mapping, Sequence

from advlayers.mesh_groups import mesh_groups


def to_fem_mesh(mesh, named: Mapping[str, Sequence[str]]):
    """Node and element ids run from 1 without a gap, as FreeCAD renumbers them on saving
    otherwise: quads first, then triangles. FreeCAD prints a line for each group."""
    import Fem

    fem = Fem.FemMesh()
    for i, (x, y, z) in enumerate(mesh.nodes.tolist(), 1):
        fem.addNode(x, y, z, i)
    number = 0
    for cells in (mesh.quads, mesh.triangles):
        for cell in (cells + 1).tolist():
            number += 1
            fem.addFace(cell, number)
    for group in mesh_groups(mesh, named):
        index = fem.addGroup(group.name, "Node" if group.of_nodes else "Face")
        fem.addGroupElements(index, group.ids.tolist())
    return fem

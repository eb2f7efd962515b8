"""A layer mesh as a Mesh::Feature, FreeCAD's triangle mesh, with all of each quad."""
from __future__ import annotations

from advlayers import stored_mesh
from advlayers.triangle_mesh import triangles_of


def make_mesh_feature(mesh_object):
    """Adds the Mesh::Feature to the document. Raises InputError where there is no mesh."""
    import FreeCAD
    import Mesh

    mesh = stored_mesh.read(mesh_object)
    cells, _elements = triangles_of(mesh)
    points = [FreeCAD.Vector(*point) for point in mesh.nodes.tolist()]
    made = mesh_object.Document.addObject("Mesh::Feature", f"{mesh_object.Name}_Triangles")
    made.Label = f"{mesh_object.Label} triangles"
    made.Mesh = Mesh.Mesh([(points[a], points[b], points[c]) for a, b, c in cells.tolist()])
    return made

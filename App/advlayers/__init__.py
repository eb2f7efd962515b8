"""Advancing Layers: everything between a CAD shape and a finished mesh that needs no window.

Importing the package is cheap: FreeCAD and the mesher's core are loaded at first use.
"""
from __future__ import annotations

__version__ = "0.1.0"


def make_layer_mesh(source, **settings):
    """Meshes a document object and returns the new Fem::FemMeshObjectPython.

    The settings are those of the reference page: `make_layer_mesh(doc.Body, faces=["Face1"],
    first_height="7 mm")`. Lengths may be numbers [mm], texts with a unit, or quantities.
    Raises InputError for a setting or a source that cannot be used.
    """
    from advlayers import layer_mesh

    mesh_object = layer_mesh.create(source, **settings)
    layer_mesh.update(mesh_object)
    return mesh_object

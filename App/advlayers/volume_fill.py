"""Fills a closed layer mesh of a document with volume cells: an object beside it, for FEM."""
from __future__ import annotations

from advlayers import analysis, cad_input, fem_mesh, stored_mesh
from advlayers.formats.mesh_parts import MeshParts, of_mesh
from advlayers.language import tr
from advlayers.layer_mesh import window_watch
from advlayers.settings_check import check_all
from advlayers.settings_table import VOLUME_SETTINGS
from advlayers.volume.fill import VolumeFill


def fill(mesh_object, **options):
    """Adds a Fem::FemMeshObject with the cells, and with the surface's elements in groups of its
    faces and the named ones; `options` are what a job may say of the volume: `quads="keep"`. The
    surface's nodes keep their numbers, and its order is the volume's. In analyses the cells take
    the surface's place: FEM solves with one mesh.

    Raises InputError where there is no mesh, where it is not closed, or where the program that
    fills it is missing or fails; nothing has changed then.
    """
    checked = check_all(options, VOLUME_SETTINGS)
    mesh = stored_mesh.read(mesh_object)
    parts = of_mesh(mesh, mesh.named)
    model = cad_input.model_of(mesh_object)
    filled = VolumeFill.of_settings(checked, mesh_object.Size.Value).fill(
        parts, model.solids, mesh_object.Label, model.project, lambda: window_watch.get()([]))
    made = add_object(mesh_object, filled.parts)
    analysis.replace(mesh_object, made)
    return made


def add_object(mesh_object, parts: MeshParts):
    """Of cells that fill the mesh of the object."""
    fem = fem_mesh.to_fem_mesh(parts)
    made = mesh_object.Document.addObject("Fem::FemMeshObject", f"{mesh_object.Name}_Volume")
    made.Label = tr("{} volume").format(mesh_object.Label)
    # FEM looks for the shape here when it searches the nodes of a constraint.
    made.addProperty("App::PropertyLinkGlobal", "Part", "Geometry", "The object that is meshed.")
    made.Part = mesh_object.Part
    made.FemMesh = fem
    return made

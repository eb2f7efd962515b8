"""Settings and references of a mesh object of FreeCAD's own, made with Gmsh, for a layer mesh."""
from __future__ import annotations

from typing import Any, Dict, List, Tuple

from advlayers import analysis, cad_input, controls, layer_mesh
from advlayers.errors import InputError
from advlayers.face_edges import FaceEdges
from advlayers.freecad_versions import gmsh_source
from advlayers.picked_names import names_on


def is_gmsh_mesh(document_object) -> bool:
    return getattr(getattr(document_object, "Proxy", None), "Type", "") == "Fem::FemMeshGmsh"


def take_over(gmsh_mesh):
    """Adds a layer mesh with the largest size, boundary layers, regions and groups of the Gmsh
    mesh, not meshed yet, and puts it in its place in the analyses. The Gmsh mesh stays in the
    document.

    Raises InputError; nothing has changed then.
    """
    if not is_gmsh_mesh(gmsh_mesh):
        raise InputError("", "{} is no mesh made with Gmsh", gmsh_mesh.Label)
    source = gmsh_source(gmsh_mesh)
    if source is None:
        raise InputError("", "{} has no object to mesh", gmsh_mesh.Label)
    shape = cad_input.global_shape(source)
    walls = [entry for layer in gmsh_mesh.MeshBoundaryLayerList
             for entry in _walls(source, shape, layer)]
    sizes = [_size(source, region) for region in gmsh_mesh.MeshRegionList]
    groups = [(group.Label if group.UseLabel else group.Name, names_on(source, group.References))
              for group in gmsh_mesh.MeshGroupList]

    largest = gmsh_mesh.CharacteristicLengthMax.Value
    settings = {"size": largest} if 0.0 < largest < 1e20 else {}
    created = layer_mesh.create(source, **settings)
    for names, values, label in walls:
        controls.make(controls.Wall, created, names, label, values=values)
    for names, values, label in sizes:
        controls.make(controls.Size, created, names, label, values=values)
    for name, names in groups:
        if names:
            controls.make_group(created, name, names)
    analysis.replace(gmsh_mesh, created)
    return created


_Entry = Tuple[List[str], Dict[str, Any], str]


def _walls(source, shape, layer) -> List[_Entry]:
    """Edges are walls on both sides. Layers that Gmsh grows from a face go into the volume; on the
    faces beside it they start at the edges shared with it."""
    names = names_on(source, layer.References)
    values: Dict[str, Any] = {"growth": layer.GrowthRate, "layers": layer.NumberOfLayers}
    if layer.MinimumThickness.Value > 0.0:
        values["first_height"] = layer.MinimumThickness.Value
    edges = [name for name in names if name.startswith("Edge")]
    faces = [name for name in names if name.startswith("Face")]
    found = [(edges, values, layer.Label)] if edges else []
    if faces:
        table = FaceEdges(shape)
        shared = {edge: [face for face in table.beside(edge) if face not in faces]
                  for edge in table.boundary(faces)}
        picked = [edge for edge, beside in shared.items() if beside]
        beside = sorted({face for group in shared.values() for face in group})
        if picked:
            found.append((picked + beside, values, layer.Label))
    return found


def _size(source, region) -> _Entry:
    values = {}
    if region.CharacteristicLength.Value > 0.0:
        values["size"] = region.CharacteristicLength.Value
    names = [name for name in names_on(source, region.References)
             if name.startswith(controls.Size.KINDS)]
    return names, values, region.Label

"""What is selected in the window, as the commands need it."""
from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import FreeCAD
import FreeCADGui

from advlayers import controls, faceted, layer_mesh
from advlayers.errors import InputError
from advlayers.picked_names import names_on

Pick = Tuple[Any, Tuple[str, ...]]


def layer_meshes() -> List[Any]:
    """The selected layer meshes, also those of selected children."""
    found: List[Any] = []
    for entry in FreeCADGui.Selection.getSelection():
        mesh = controls.mesh_of(entry) if controls.is_control(entry) else entry
        if mesh is not None and layer_mesh.is_layer_mesh(mesh) and mesh not in found:
            found.append(mesh)
    return found


def layer_meshes_or_all() -> List[Any]:
    return layer_meshes() or all_layer_meshes()


def all_layer_meshes() -> List[Any]:
    """Of the active document."""
    document = FreeCAD.ActiveDocument
    return [entry for entry in document.Objects if layer_mesh.is_layer_mesh(entry)]


def source() -> Optional[Tuple[Any, List[str]]]:
    """The selected object that has a shape, and its selected faces and edges; of a body's last
    feature the body, which stays when further features come. A Mesh object counts as well. Raises
    InputError where there are several."""
    found: Dict[Any, List[str]] = {}
    for entry in FreeCADGui.Selection.getSelectionEx():
        if faceted.is_mesh(entry.Object):
            found[entry.Object] = []
        elif _has_shape(entry.Object):
            owner, names = _of_body(entry.Object, entry.SubElementNames)
            found.setdefault(owner, []).extend(names)
    if len(found) > 1:
        labels = ", ".join(owner.Label for owner in found)
        raise InputError("", "Select one shape, not several ({}): a layer mesh is of one, which "
                         "may be a compound.", labels)
    return next(iter(found.items()), None)


def _of_body(document_object, names) -> Tuple[Any, List[str]]:
    picked = [name for name in names if name.startswith(("Face", "Edge"))]
    body = document_object.getParentGeoFeatureGroup()
    if getattr(body, "Tip", None) is not document_object:
        return document_object, picked
    return body, names_on(body, [(document_object, picked)])


def picks() -> List[Pick]:
    """Selected faces, edges and vertices, by their objects."""
    return [(entry.Object, tuple(entry.SubElementNames))
            for entry in FreeCADGui.Selection.getSelectionEx()
            if entry.SubElementNames and _has_shape(entry.Object)]


def mesh_for(picked: List[Pick]) -> Optional[Any]:
    """The layer mesh that picked faces and edges are meant for: the selected one, or the only one
    of their object, or the only one."""
    chosen = layer_meshes()
    if chosen:
        return chosen[0]
    meshes = all_layer_meshes()
    of_object = [mesh for mesh in meshes if picked and mesh.Part is picked[0][0]]
    for found in (of_object, meshes):
        if len(found) == 1:
            return found[0]
    return None


def _has_shape(document_object) -> bool:
    import Part

    return not (layer_mesh.is_layer_mesh(document_object)
                or controls.is_control(document_object)
                or Part.getShape(document_object).isNull())

"""Objects of ours that were saved by a FreeCAD without the add-on: their data is whole, but nothing
says any more what they are."""
from __future__ import annotations

from advlayers import controls, layer_mesh
from advlayers.window import attach_view

# A property that only this kind of object has, and its class.
_MARKS = (("MeshedSettings", layer_mesh.LayerMesh), ("Condition", controls.Wall),
          ("GroupName", controls.Group), ("Segments", controls.Size))


def revive(document) -> int:
    """Makes them what they were; returns how many."""
    found = [(entry, kind) for entry in document.Objects for kind in [_kind_of(entry)] if kind]
    for entry, kind in found:
        kind(entry)
        attach_view(entry)
    for entry, kind in found:
        if kind is layer_mesh.LayerMesh:
            layer_mesh.refresh_state(entry)
    return len(found)


def _kind_of(document_object):
    properties = document_object.PropertiesList
    if "Picked" not in properties or "Proxy" not in properties:
        return None
    if document_object.Proxy is not None:
        return None
    return next((kind for mark, kind in _MARKS if mark in properties), None)

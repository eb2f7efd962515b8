"""Brings objects of older files to the way in which data is kept now, one step at a time."""
from __future__ import annotations

import json
from typing import Callable, Dict

import FreeCAD

from advlayers import controls
from advlayers.language import tr
from advlayers.settings_check import check_all
from advlayers.settings_table import MESH_SETTINGS


def migrate(document_object) -> None:
    """Files without a version are of version 1. Those of a later program are left as they are."""
    version = document_object.SchemaVersion or 1
    if version > CURRENT:
        FreeCAD.Console.PrintWarning(tr(
            "{} was saved by a later version of Advancing Layers (schema {}, here {}): some of its "
            "settings may not be seen.").format(document_object.Label, version, CURRENT) + "\n")
        return
    while version < CURRENT:
        _STEPS[version](document_object)
        version += 1
    if document_object.SchemaVersion != CURRENT:
        document_object.SchemaVersion = CURRENT


def _texts_to_children(document_object) -> None:
    """1 to 2: walls, match and off edges and groups were texts of the mesh object."""
    present = document_object.PropertiesList
    if "Walls" not in present:
        return
    settings = {
        "walls": json.loads(document_object.Walls),
        "match": list(document_object.MatchEdges),
        "off": list(document_object.OffEdges),
        "groups": {name: names.split() for name, names in document_object.Groups.items()},
    }
    for name in ("Walls", "MatchEdges", "OffEdges", "Groups"):
        document_object.removeProperty(name)
    if document_object.Part is not None:
        controls.from_settings(document_object, check_all(settings, MESH_SETTINGS))


_STEPS: Dict[int, Callable] = {1: _texts_to_children}
CURRENT = max(_STEPS) + 1

"""The properties of a layer mesh: its settings, its children and its results."""
from __future__ import annotations

from typing import List

from advlayers.properties import HIDDEN, READ_ONLY, add_setting, to_property
from advlayers.settings_table import MESH_SETTINGS, Setting, property_name

# name, type, group, tooltip
_OTHER_PROPERTIES = (
    # Global: the object may stand in a part or a body that the mesh is not in.
    ("Part", "App::PropertyLinkGlobal", "Geometry", "The object whose faces are meshed."),
    ("GrowFromAll", "App::PropertyBool", "Layers",
     "Layers grow from every boundary edge, as long as no Wall of the mesh says otherwise."),
    ("WallList", "App::PropertyLinkList", "Layers", "The walls of the mesh."),
    ("SizeList", "App::PropertyLinkList", "Size", "The local sizes of the mesh."),
    ("GroupList", "App::PropertyLinkList", "Geometry", "The named groups of the mesh."),
    ("AutoUpdate", "App::PropertyBool", "Run",
     "Meshes again whenever a recompute finds the mesh out of date."),
)
_RESULTS = (
    ("State", "App::PropertyString", "Whether the mesh fits the settings and the shape."),
    ("NodeCount", "App::PropertyInteger", "Nodes of the mesh."),
    ("QuadCount", "App::PropertyInteger", "Quads of the mesh."),
    ("TriangleCount", "App::PropertyInteger", "Triangles of the mesh."),
    ("QuadPercent", "App::PropertyFloat", "Quads among all elements [%]."),
    ("GoodAnglePercent", "App::PropertyFloat", "Corner angles from 45 to 135 degrees [%]."),
    ("MinAngle", "App::PropertyAngle", "The smallest corner angle."),
    ("MaxAngle", "App::PropertyAngle", "The largest corner angle."),
    ("InvertedCount", "App::PropertyInteger", "Elements turned over against the surface."),
    ("Messages", "App::PropertyStringList", "What the mesher had to say."),
)
_HIDDEN_RESULTS = (
    ("Details", "App::PropertyString", "The report of the mesh, as a job writes it."),
    ("HeightErrors", "App::PropertyFloatList",
     "How far the height of each element of a layer is from the one asked for, relative to it; "
     "NaN for the core."),
    ("ElementLayers", "App::PropertyFloatList", "The layer of each element; 0 for the core."),
    ("EdgeSegments", "App::PropertyFloatList",
     "Mesh edges on CAD edges: the edge and two nodes, counted from 0, of each."),
    ("NodeLayers", "App::PropertyFloatList", "The layer that each node was extruded in; else 0."),
    ("NodeParents", "App::PropertyFloatList",
     "The node, counted from 0, that each node was extruded from; else -1."),
    ("MeshedSettings", "App::PropertyString", "The settings that the mesh was made with."),
    ("MeshedShape", "App::PropertyFloatList", "Points of the shape that was meshed."),
    ("MeshedInitialMesh", "App::PropertyFloatList",
     "Counts and nodes of the initial mesh that the mesh was made from."),
    ("MeshedConstraints", "App::PropertyStringList",
     "The constraints of analyses that the mesh has groups for, each with its faces."),
)
_KEPT = (
    ("MeshId", "App::PropertyString", "Tells this mesh from the ones before it."),
    ("Picked", "App::PropertyStringList", "What the faces looked like when they were picked."),
    ("SchemaVersion", "App::PropertyInteger", "The way in which the object keeps its data."),
)
_UNSET = {"App::PropertyString": "", "App::PropertyInteger": 0, "App::PropertyFloat": 0.0,
          "App::PropertyAngle": 0.0, "App::PropertyStringList": [], "App::PropertyFloatList": []}


def property_settings() -> List[Setting]:
    """The settings that are properties of the mesh object; the others are in its children."""
    return [entry for entry in MESH_SETTINGS if entry.group]


def add_properties(document_object) -> None:
    """Adds the properties that are not there yet: all to a new object, later ones to an old one."""
    present = set(document_object.PropertiesList)
    for entry in property_settings():
        add_setting(document_object, entry, entry.group, entry.doc)
        name = property_name(entry)
        if name not in present and entry.default is not None:
            setattr(document_object, name, to_property(entry, entry.default))
    for name, kind, group, doc in _OTHER_PROPERTIES:
        if name not in present:
            document_object.addProperty(kind, name, group, doc)
    if "GrowFromAll" not in present:
        document_object.GrowFromAll = True
    for mode, results in ((READ_ONLY, _RESULTS), (HIDDEN, _HIDDEN_RESULTS + _KEPT)):
        for name, kind, doc in results:
            if name not in present:
                document_object.addProperty(kind, name, "Result", doc)
            document_object.setEditorMode(name, mode)


def clear_results(document_object) -> None:
    """There is no mesh."""
    for name, kind, _doc in _RESULTS + _HIDDEN_RESULTS:
        setattr(document_object, name, _UNSET[kind])

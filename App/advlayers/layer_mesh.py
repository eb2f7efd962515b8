"""The mesh object in a FreeCAD document: settings and results as properties, the mesh in FemMesh.

All data lies in properties. Recomputing never meshes: it only says whether the mesh is out of date.
The module's and the class's name are part of saved files.
"""
from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional

import FreeCAD

from advlayers import cad_input, fem_mesh, freshness
from advlayers.core_access import load_core
from advlayers.errors import InputError
from advlayers.layer_heights import height_errors
from advlayers.meshing import Run, core_settings, default_lengths
from advlayers.report import make_report
from advlayers.settings_check import check_all, check_names
from advlayers.settings_table import MESH_SETTINGS, Setting

NOT_MESHED, UP_TO_DATE, OUT_OF_DATE = "Not meshed", "Up to date", "Out of date"
_READ_ONLY, _HIDDEN = 1, 2  # editor modes

# name, type, group, tooltip
_OTHER_PROPERTIES = (
    ("Part", "App::PropertyLink", "Geometry", "The object whose faces are meshed."),
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
    ("Details", "App::PropertyString", "The report of the mesh, as a job writes it."),
    ("HeightErrors", "App::PropertyFloatList",
     "How far the height of each element of a layer is from the one asked for, relative to it; "
     "NaN for the core."),
    ("MeshedSettings", "App::PropertyString", "The settings that the mesh was made with."),
    ("MeshedShape", "App::PropertyFloatList", "Points of the shape that was meshed."),
)
_HIDDEN_RESULTS = ("Details", "HeightErrors", "MeshedSettings", "MeshedShape")


class LayerMesh:
    """Proxy of a Fem::FemMeshObjectPython."""

    Type = "AdvancingLayers::LayerMesh"

    def __init__(self, document_object) -> None:
        document_object.Proxy = self
        add_properties(document_object)

    def execute(self, document_object) -> None:
        refresh_state(document_object)

    def onDocumentRestored(self, document_object) -> None:
        add_properties(document_object)
        # Files saved without a window carry no view provider of ours.
        if FreeCAD.GuiUp:
            from advlayers_gui import view_provider

            view_provider.attach_to(document_object)

    # FreeCAD 0.20 calls the second pair, later versions the first.
    def dumps(self):
        return None

    def loads(self, _state) -> None:
        return None

    def __getstate__(self):
        return None

    def __setstate__(self, _state) -> None:
        return None


def is_layer_mesh(document_object) -> bool:
    return isinstance(getattr(document_object, "Proxy", None), LayerMesh)


def create(source, **settings):
    """Adds a mesh object for `source` to its document, without meshing yet.

    Raises InputError.
    """
    if getattr(source, "Document", None) is None:
        raise InputError("", f"a document object is needed to mesh, got {source!r}")
    shape = cad_input.global_shape(source)
    if shape.isNull() or not shape.Faces:
        raise InputError("", f"{source.Label} has no face to mesh")
    checked = check_all(_plain_values(settings), MESH_SETTINGS)
    check_names(checked, len(shape.Faces), len(shape.Edges), source.Label)
    checked.update(default_lengths(checked, shape.BoundBox.DiagonalLength))

    created = source.Document.addObject("Fem::FemMeshObjectPython", "LayerMesh")
    LayerMesh(created)
    created.Label = f"{source.Label} layers"
    created.Part = source
    for entry in MESH_SETTINGS:
        setattr(created, entry.property, _to_property(entry, checked[entry.key]))
    refresh_state(created)
    if FreeCAD.GuiUp:
        from advlayers_gui import view_provider

        view_provider.attach_to(created)
    return created


@dataclass(frozen=True)
class MadeFrom:
    """What a mesh is compared with to tell whether it is out of date."""

    settings: Dict[str, Any]  # checked
    settings_text: str
    points: List[float]


@dataclass(frozen=True)
class Task:
    """All that one run needs, read from the document beforehand: the document may change while the
    mesher is at work, and the mesh then belongs to what was read."""

    brep: str
    made_from: MadeFrom

    def make_mesher(self, core):
        """Reads the shape; may run in any thread. Raises what the core raises."""
        model = core.read_brep(self.brep)
        return core.Mesher(model, core_settings(core, self.made_from.settings, model.diagonal))

    def make_fem_mesh(self, mesh, check: Callable[[], None] = lambda: None):
        return fem_mesh.to_fem_mesh(mesh, self.made_from.settings["groups"], check)


def prepare(document_object) -> Task:
    """Raises InputError."""
    shape = _shape_of(document_object)
    origin = made_from(document_object)
    check_names(origin.settings, len(shape.Faces), len(shape.Edges), document_object.Part.Label)
    return Task(shape.exportBrepToString(), origin)


def made_from(document_object) -> MadeFrom:
    """Raises InputError."""
    return MadeFrom(settings_of(document_object),
                    freshness.settings_text(_raw_settings(document_object)),
                    freshness.shape_points(cad_input.global_shape(document_object.Part)))


def update(document_object, watch: Optional[Callable[[List[Any]], None]] = None) -> None:
    """Meshes with the settings as they stand. `watch` gets the core's reports on the way; what it
    raises stops the run and leaves the old mesh. Raises InputError, or what the core raises."""
    core = load_core()
    task = prepare(document_object)
    mesh = Run(lambda: task.make_mesher(core)).finish(watch or (lambda _reports: None))
    set_mesh(document_object, mesh, task.make_fem_mesh(mesh), task.made_from)


def set_mesh(document_object, mesh, fem, origin: MadeFrom) -> None:
    """Stores a finished mesh of the settings and the shape that `origin` tells."""
    document_object.FemMesh = fem
    figures = mesh.figures
    document_object.NodeCount = figures["nodes"]
    document_object.QuadCount = figures["quads"]
    document_object.TriangleCount = figures["triangles"]
    document_object.QuadPercent = figures["quad_percent"]
    document_object.GoodAnglePercent = figures["angles_45_135_percent"]
    document_object.MinAngle = figures["min_angle"]
    document_object.MaxAngle = figures["max_angle"]
    document_object.InvertedCount = figures["inverted"]
    document_object.Messages = [
        f"{entry['severity']}: {entry['text']} ({entry['code']})" for entry in mesh.diagnostics]
    document_object.Details = json.dumps(
        make_report(document_object.Part.Label, mesh, origin.settings, [], mesh.seconds))
    document_object.HeightErrors = height_errors(mesh).tolist()
    document_object.MeshedSettings = origin.settings_text
    document_object.MeshedShape = origin.points
    refresh_state(document_object)


def settings_of(document_object) -> Dict[str, Any]:
    """The settings as the properties have them, checked. Raises InputError."""
    return check_all(_raw_settings(document_object), MESH_SETTINGS)


def refresh_state(document_object) -> None:
    """Compares settings and shape with those of the mesh; writes State only where it changes."""
    if not document_object.MeshedSettings:
        state = NOT_MESHED
    else:
        state = UP_TO_DATE if _fits(document_object) else OUT_OF_DATE
    if document_object.State != state:
        document_object.State = state


def _fits(document_object) -> bool:
    settings = freshness.settings_text(_raw_settings(document_object))
    if document_object.Part is None or document_object.MeshedSettings != settings:
        return False
    shape = cad_input.global_shape(document_object.Part)
    return not shape.isNull() and freshness.same_points(
        document_object.MeshedShape, freshness.shape_points(shape), shape.BoundBox.DiagonalLength)


def add_properties(document_object) -> None:
    """Adds the properties that are not there yet: all to a new object, later ones to an old one."""
    present = set(document_object.PropertiesList)
    for entry in MESH_SETTINGS:
        if entry.property not in present:
            document_object.addProperty(
                entry.property_type, entry.property, entry.group, entry.doc)
            if entry.choices:
                setattr(document_object, entry.property, list(entry.choices))
            if entry.default is not None:
                setattr(document_object, entry.property, _to_property(entry, entry.default))
    for name, kind, group, doc in _OTHER_PROPERTIES:
        if name not in present:
            document_object.addProperty(kind, name, group, doc)
    for name, kind, doc in _RESULTS:
        if name not in present:
            document_object.addProperty(kind, name, "Result", doc)
        document_object.setEditorMode(name, _HIDDEN if name in _HIDDEN_RESULTS else _READ_ONLY)


def _shape_of(document_object):
    if document_object.Part is None:
        raise InputError("Part", f"of {document_object.Label} is empty: there is nothing to mesh")
    shape = cad_input.global_shape(document_object.Part)
    if shape.isNull() or not shape.Faces:
        raise InputError("Part", f"{document_object.Part.Label} has no face to mesh")
    return shape


def _raw_settings(document_object) -> Dict[str, Any]:
    return {entry.key: _from_property(entry, getattr(document_object, entry.property))
            for entry in MESH_SETTINGS}


def _plain_values(settings: Mapping[str, Any]) -> Dict[str, Any]:
    """Numbers in mm and degrees for texts and quantities with a unit."""
    units = {entry.key: entry.unit for entry in MESH_SETTINGS if entry.kind == "number"}
    values = dict(settings)
    for key, unit in units.items():
        value = values.get(key)
        if isinstance(value, (str, FreeCAD.Units.Quantity)):
            values[key] = _in_unit(key, value, unit)
    return values


def _in_unit(key: str, value, unit: str) -> float:
    try:
        quantity = FreeCAD.Units.Quantity(value)
        plain = quantity.Unit == FreeCAD.Units.Unit()
        return quantity.Value if plain or not unit else float(quantity.getValueAs(unit))
    except (ValueError, ArithmeticError, SyntaxError, TypeError) as error:
        what = f"in {unit}" if unit else "without a unit"
        raise InputError(key, f"must be a number {what}, got {str(value)!r}") from error


def _to_property(entry: Setting, value: Any) -> Any:
    if entry.kind in ("layers", "walls") and not isinstance(value, str):
        return json.dumps(value)
    if entry.kind == "faces":
        return [] if value == "all" else list(value)
    if entry.kind == "edges":
        return list(value)
    if entry.kind == "groups":
        return {name: " ".join(members) for name, members in value.items()}
    return value


def _from_property(entry: Setting, value: Any) -> Any:
    if entry.kind == "number":
        return value.Value if hasattr(value, "Value") else value
    if entry.kind in ("layers", "walls"):
        try:
            return json.loads(value)
        except ValueError:
            return value
    if entry.kind == "faces":
        return list(value) or "all"
    if entry.kind == "edges":
        return list(value)
    if entry.kind == "groups":
        return {name: members.split() for name, members in value.items()}
    return value

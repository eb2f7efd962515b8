"""The mesh object in a FreeCAD document: settings and results as properties, the mesh in FemMesh.

All data lies in properties, and in children for walls, sizes and groups. Recomputing meshes only
where AutoUpdate is set: else it says whether the mesh is out of date. The module's and the class's
name are part of saved files.
"""
from __future__ import annotations

import json
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import FreeCAD

from advlayers import (
    analysis, cad_input, controls, faceted, features, fem_mesh, freshness, initial_mesh, limits,
    mesh_data, mesh_history, migrations, presets, source_state, stored_mesh)
from advlayers.core_access import load_core
from advlayers.errors import InputError
from advlayers.formats import mesh_parts
from advlayers.freecad_versions import Stateless
from advlayers.language import tr
from advlayers.mesh_data import MeshData
from advlayers.mesh_properties import add_properties, clear_results, property_settings
from advlayers.meshing import Run, core_settings, default_lengths
from advlayers.properties import from_property, plain_values, to_property
from advlayers.references import Picker, Problem, problems, remembered
from advlayers.sentence import Sentence, listed
from advlayers.settings_check import check_all, check_names
from advlayers.settings_table import MESH_SETTINGS, property_name
from advlayers.window import (
    attach_view, can_update_beside, draw_view, prepare_view, show_mesh, update_beside)

NOT_MESHED, UP_TO_DATE, OUT_OF_DATE = "Not meshed", "Up to date", "Out of date"
LOST_REFERENCES, SOURCE_IN_ERROR = "Lost references", "Source in error"


def _unwatched(_reports: List[Any]) -> None:
    """For a script."""


# What update() calls on the way where it is given no watch: a window shows its progress by it.
window_watch: ContextVar[Callable[[List[Any]], None]] = ContextVar(
    "window_watch", default=_unwatched)


class LayerMesh(Stateless):
    """Proxy of a Fem::FemMeshObjectPython."""

    Type = "AdvancingLayers::LayerMesh"
    latest: Tuple[str, Optional[MeshData]] = ("", None)  # see mesh_data.remember()

    def __init__(self, document_object) -> None:
        document_object.Proxy = self
        add_properties(document_object)
        document_object.SchemaVersion = migrations.CURRENT
        mesh_history.watch(document_object, _mesh_is_lost)
        analysis.watch(_refresh_mesh)
        source_state.watch(_refresh_mesh)

    def onChanged(self, document_object, name: str) -> None:
        if document_object.Document.Restoring:
            if name == "SchemaVersion":  # one that comes before the mesh itself
                prepare_view(document_object)
        elif name in ("Faces", "Part") and hasattr(document_object, "Picked"):
            _remember_faces(document_object)

    def execute(self, document_object) -> None:
        refresh_state(document_object)
        if document_object.AutoUpdate and document_object.State in (NOT_MESHED, OUT_OF_DATE):
            _update_by_itself(document_object)

    def onDocumentRestored(self, document_object) -> None:
        add_properties(document_object)
        migrations.migrate(document_object)
        controls.own_children(document_object)
        mesh_history.watch(document_object, _mesh_is_lost)
        analysis.watch(_refresh_mesh)
        source_state.watch(_refresh_mesh)
        attach_view(document_object)


def is_layer_mesh(document_object) -> bool:
    return isinstance(getattr(document_object, "Proxy", None), LayerMesh)


def create(source, **settings):
    """Adds a mesh object for `source` to its document, without meshing yet. Of one of FreeCAD's
    Mesh objects a shape is made and added first.

    Raises InputError.
    """
    if getattr(source, "Document", None) is None:
        raise InputError("", "a document object is needed to mesh, got {}", repr(source))
    if faceted.is_mesh(source):
        settings.setdefault("feature_angle", faceted.FEATURE_ANGLE)
        source = faceted.add_shape(source)
    shape = cad_input.global_shape(source)
    if shape.isNull() or not shape.Faces:
        raise InputError("", "{} has no face to mesh", source.Label)
    checked = _checked(presets.applied(settings), shape)
    check_names(checked, len(shape.Faces), len(shape.Edges), source.Label)
    checked.update(default_lengths(checked, shape.BoundBox.DiagonalLength))
    checked[initial_mesh.KEY] = initial_mesh.in_document(source.Document, checked[initial_mesh.KEY])

    created = source.Document.addObject("Fem::FemMeshObjectPython", "LayerMesh")
    LayerMesh(created)
    created.Label = tr("{} layers").format(source.Label)
    created.Part = source
    for entry in property_settings():
        setattr(created, property_name(entry), to_property(entry, checked[entry.key]))
    controls.from_settings(created, checked)
    refresh_state(created)
    attach_view(created)
    return created


def apply_preset(document_object, word: str) -> None:
    """What the preset asks for, and its walls in place of those that are there. Raises InputError,
    and changes nothing then."""
    asked = presets.applied({"preset": word})
    checked = _checked(asked, _shape_of(document_object))
    for entry in property_settings():
        if entry.key in asked:
            setattr(document_object, property_name(entry), to_property(entry, checked[entry.key]))
    for wall in document_object.WallList:
        document_object.Document.removeObject(wall.Name)
    document_object.GrowFromAll = True
    controls.from_settings(document_object, checked)
    refresh_state(document_object)


def _checked(settings: Dict[str, Any], shape) -> Dict[str, Any]:
    """With names for the features among them. Raises InputError."""
    checked = check_all(plain_values(settings, MESH_SETTINGS), MESH_SETTINGS)
    if not features.are_asked(checked):
        return checked
    model = load_core().read_brep(shape.exportBrepToString(), checked["sew_tolerance"])
    return features.expanded(checked, model)


@dataclass(frozen=True)
class MadeFrom:
    """What a mesh is compared with to tell whether it is out of date."""

    settings: Dict[str, Any]  # checked
    settings_text: str
    points: List[float]
    initial_points: List[float]
    constraints: List[str]  # of analyses, that need groups


@dataclass(frozen=True)
class Task:
    """All that one run needs, read from the document beforehand: the document may change while the
    mesher is at work, and the mesh then belongs to what was read."""

    label: str  # of what is meshed
    brep: str
    made_from: MadeFrom
    initial: Optional[initial_mesh.Arrays]
    groups: Dict[str, Sequence[str]]  # named ones, and those that constraints of analyses need

    def make_mesher(self, core, context):
        """Reads the shape; may run in any thread. Raises what the core raises."""
        model = core.read_brep(self.brep, self.made_from.settings["sew_tolerance"], context)
        settings = {**self.made_from.settings, initial_mesh.KEY: self.initial}
        for_core = core_settings(core, settings, model.diagonal)
        many = limits.check(core, model, for_core, settings, context)
        if many is not None:
            FreeCAD.Console.PrintWarning(f"{self.label}: {many.translated}\n")
        return core.Mesher(model, for_core, context)

    def make_fem_mesh(self, mesh, check: Optional[Callable[[], None]] = None):
        parts = mesh_parts.of_mesh(mesh, self.groups, self.made_from.settings["layer_groups"])
        return fem_mesh.compact(fem_mesh.to_fem_mesh(parts, check))


def prepare(document_object) -> Task:
    """Raises InputError."""
    shape = _shape_of(document_object)
    if source_state.in_error(document_object.Part):
        raise InputError("", "{} is in error, and its shape may be an older one: mend it first",
                         document_object.Part.Label)
    check_references(document_object)
    origin = made_from(document_object)
    check_names(origin.settings, len(shape.Faces), len(shape.Edges), document_object.Part.Label)
    groups = {**origin.settings["groups"], **analysis.constraint_groups(document_object)}
    initial = document_object.InitialMesh and initial_mesh.of_object(document_object.InitialMesh)
    return Task(document_object.Part.Label, shape.exportBrepToString(), origin, initial, groups)


def made_from(document_object) -> MadeFrom:
    """Raises InputError."""
    return MadeFrom(settings_of(document_object),
                    freshness.settings_text(raw_settings(document_object)),
                    freshness.shape_points(cad_input.global_shape(document_object.Part)),
                    initial_mesh.fingerprint(document_object.InitialMesh),
                    analysis.constraint_texts(document_object))


def update(document_object, watch: Optional[Callable[[List[Any]], None]] = None) -> None:
    """Meshes with the settings as they stand. `watch` gets the core's reports on the way; what it
    raises stops the run and leaves the old mesh. Raises InputError, or what the core raises."""
    core = load_core()
    task = prepare(document_object)
    context = core.RunContext()
    run = Run(context, lambda: task.make_mesher(core, context),
              on_mesh=lambda mesh, check: (
                  mesh, task.make_fem_mesh(mesh, check if FreeCAD.GuiUp else None)))
    mesh, fem = run.finish(watch or window_watch.get())
    set_mesh(document_object, mesh, fem, task.made_from)
    if window_watch.get() is _unwatched:
        draw_view(document_object)  # a script may look at the view next


def _update_by_itself(document_object) -> None:
    """Within a recompute. A window is not kept waiting: it has the mesh a while later. Raises what
    update() does."""
    if can_update_beside():
        update_beside(document_object, prepare(document_object))
    else:
        update(document_object)


def set_mesh(document_object, mesh, fem, origin: MadeFrom,
             data: Optional[MeshData] = None) -> None:
    """Stores a finished mesh of the settings and the shape that `origin` tells; `data` where they
    have been gathered already."""
    data = data or mesh_data.of_core(document_object.Part.Label, mesh)
    if not document_object.MeshId:
        show_mesh(document_object)
    mesh_history.store(document_object, fem)
    mesh_data.remember(document_object, data)
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
    document_object.Details = json.dumps(data.report)
    document_object.HeightErrors = data.relative_height_errors.tolist()
    document_object.ElementLayers = data.mesh.layers.tolist()
    document_object.EdgeSegments = stored_mesh.row_of_segments(mesh.edge_segments)
    document_object.NodeLayers = mesh.node_layer.tolist()
    document_object.NodeParents = mesh.node_parent.tolist()
    document_object.MeshedSettings = origin.settings_text
    document_object.MeshedShape = origin.points
    document_object.MeshedInitialMesh = origin.initial_points
    document_object.MeshedConstraints = origin.constraints
    refresh_state(document_object)
    if document_object.State == UP_TO_DATE:  # else the model was edited meanwhile
        accept_references(document_object)


def _mesh_is_lost(document_object) -> None:
    """Undo or redo has brought back the results of a mesh that is not kept any more."""
    clear_results(document_object)
    mesh_history.store(document_object, fem_mesh.empty())
    refresh_state(document_object)
    FreeCAD.Console.PrintWarning(tr(
        "{}: the mesh of this step is not kept any more: update it.").format(
            document_object.Label) + "\n")


def settings_of(document_object) -> Dict[str, Any]:
    """The settings as properties and children have them, checked. Raises InputError."""
    return check_all(raw_settings(document_object), MESH_SETTINGS)


def own_settings(document_object) -> Dict[str, Any]:
    """Those of the object itself, without its children, unchecked. Raises InputError for
    refinements that cannot be read."""
    return {entry.key: from_property(entry, getattr(document_object, property_name(entry)))
            for entry in property_settings()}


def raw_settings(document_object) -> Dict[str, Any]:
    """As the document has them, unchecked. Raises InputError for children that make no sense."""
    settings = own_settings(document_object)
    found = controls.contributions(document_object)
    found["refinements"] = settings["refinements"] + found["refinements"]
    settings.update(found)
    return settings


# --- references -----------------------------------------------------------------------------------

def reference_problems(document_object) -> List[Problem]:
    """The picked faces and edges, of the object and its children, whose names do not stand for
    what was picked any more."""
    found: List[Problem] = []
    if document_object.Part is not None and document_object.Faces:
        found += problems(document_object, document_object.Faces, document_object.Picked,
                          Picker(cad_input.global_shape(document_object.Part)))
    for child in controls.children(document_object):
        found += controls.problems(child)
    return found


def check_references(document_object) -> None:
    """Raises InputError that names every reference that cannot be trusted."""
    found = reference_problems(document_object)
    if found:
        texts = listed("; ", (Sentence("{}: {}", (problem.owner.Label, problem.said))
                              for problem in found))
        raise InputError("", "the model has changed under the references: {}. Pick them again, or "
                         "use Follow References or Accept References", texts)


def follow_references(document_object) -> None:
    """Renames the references to what was picked, where it is still there; others stay as they
    are."""
    new_names: Dict[Any, Dict[str, str]] = {}
    for problem in reference_problems(document_object):
        if problem.found:
            new_names.setdefault(problem.owner, {})[problem.name] = problem.found
    for owner, renamed in new_names.items():
        if owner is document_object:
            owner.Faces = [renamed.get(name, name) for name in owner.Faces]
            _remember_faces(owner, anew=True)
        else:
            controls.replace_names(owner, renamed)
    refresh_state(document_object)


def accept_references(document_object) -> None:
    """Takes the references as they are now for what is meant."""
    _remember_faces(document_object, anew=True)
    for child in controls.children(document_object):
        controls.remember(child, anew=True)
    refresh_state(document_object)


def _remember_faces(document_object, anew: bool = False) -> None:
    if document_object.Part is None:
        return
    texts = remembered([] if anew else document_object.Picked, document_object.Faces,
                       Picker(cad_input.global_shape(document_object.Part)))
    if texts != list(document_object.Picked):
        document_object.Picked = texts


# --- state ----------------------------------------------------------------------------------------

def refresh_state(document_object) -> None:
    """Compares settings and shape with those of the mesh; writes State only where it changes."""
    state = _state(document_object)
    if document_object.State != state:
        document_object.State = state


def _refresh_mesh(member) -> None:
    if is_layer_mesh(member):
        refresh_state(member)


def _state(document_object) -> str:
    if source_state.in_error(document_object.Part):
        return SOURCE_IN_ERROR
    if document_object.MeshedSettings and _as_now(
            document_object, document_object.MeshedSettings, document_object.MeshedShape,
            document_object.MeshedInitialMesh):
        return OUT_OF_DATE if analysis.missing_groups(document_object) else UP_TO_DATE
    if reference_problems(document_object):
        return LOST_REFERENCES
    return OUT_OF_DATE if document_object.MeshedSettings else NOT_MESHED


def fits(document_object, origin: MadeFrom) -> bool:
    """Whether settings, shape and initial mesh are still those that a mesh was made from."""
    return (_as_now(document_object, origin.settings_text, origin.points, origin.initial_points)
            and set(analysis.constraint_texts(document_object)) <= set(origin.constraints))


def _as_now(document_object, settings: str, points: Sequence[float],
            initial_points: Sequence[float]) -> bool:
    if document_object.Part is None:
        return False
    try:
        now = freshness.settings_text(raw_settings(document_object))
    except InputError:
        return False
    if not freshness.same_settings(settings, now):
        return False
    shape = cad_input.global_shape(document_object.Part)
    if shape.isNull():
        return False
    diagonal = shape.BoundBox.DiagonalLength
    initial = initial_mesh.fingerprint(document_object.InitialMesh)
    return (freshness.same_points(points, freshness.shape_points(shape), diagonal)
            and freshness.same_points(initial_points, initial, diagonal))


def _shape_of(document_object):
    if document_object.Part is None:
        raise InputError("", "Part of {} is empty: there is nothing to mesh", document_object.Label)
    shape = cad_input.global_shape(document_object.Part)
    if shape.isNull() or not shape.Faces:
        raise InputError("", "{} has no face to mesh", document_object.Part.Label)
    return shape

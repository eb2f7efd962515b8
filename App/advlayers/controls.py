"""Children of a layer mesh in the document: walls, sizes and named groups of faces and edges.

Each holds references to the meshed object and its own values; together they are the settings
`walls`, `match`, `off`, `boundary`, `smooth`, `sizes` and `groups`. The module's and the classes'
names are part of saved files.
"""
from __future__ import annotations

from types import MappingProxyType
from typing import Any, Dict, Iterable, Iterator, List, Mapping, Tuple

from advlayers import cad_input
from advlayers.errors import InputError
from advlayers.face_edges import FaceEdges
from advlayers.freecad_versions import Stateless
from advlayers.language import tr
from advlayers.picked_names import link_value, names_on
from advlayers.properties import (
    HIDDEN, add_setting, from_property, plain_values, to_property)
from advlayers.references import Picker, Problem, remembered
from advlayers.references import problems as reference_problems
from advlayers.sentence import Sentence
from advlayers.settings_check import check_all
from advlayers.settings_table import (
    REFINEMENT_SETTINGS, SIZE_SETTINGS, WALL_SETTINGS, Setting, optional_doc, property_name,
    setting, unset_value, value_settings)
from advlayers.window import attach_view

CONDITIONS = ("Wall", "Match", "Off", "Boundary", "Smooth")
_REFERENCES = "References"
_PICKED = "Picked"


class Control(Stateless):
    """Proxy of an App::FeaturePython with references to faces, edges or vertices."""

    Type = ""
    LIST = ""  # the mesh object's property that holds such children
    TABLE: Tuple[Setting, ...] = ()
    REFERENCES = ""  # tooltip
    KINDS: Tuple[str, ...] = ("Face", "Edge")  # what may be picked

    def __init__(self, document_object) -> None:
        document_object.Proxy = self
        self.add_properties(document_object)

    def add_properties(self, document_object) -> None:
        """Adds those that are not there yet: all to a new object, later ones to an old one."""
        present = document_object.PropertiesList
        if _REFERENCES not in present:
            # Global: the picked object may stand in a part or a body that this child is not in.
            document_object.addProperty(
                "App::PropertyLinkSubListGlobal", _REFERENCES, "Geometry", self.REFERENCES)
        if _PICKED not in present:
            document_object.addProperty(
                "App::PropertyStringList", _PICKED, "Geometry",
                "What the references looked like when they were picked.")
        document_object.setEditorMode(_PICKED, HIDDEN)
        for entry in value_settings(self.TABLE):
            name = property_name(entry)
            add_setting(document_object, entry, type(self).__name__, optional_doc(entry))
            if name not in present:
                setattr(document_object, name, unset_value(entry))

    def onChanged(self, document_object, name: str) -> None:
        if name == _REFERENCES and not document_object.Document.Restoring:
            remember(document_object)

    def execute(self, document_object) -> None:
        remember(document_object)

    def onDocumentRestored(self, document_object) -> None:
        self.add_properties(document_object)
        attach_view(document_object)


class Wall(Control):
    Type = "AdvancingLayers::Wall"
    LIST = "WallList"
    TABLE = WALL_SETTINGS
    REFERENCES = ("The edges that the values hold for. With faces too: only on the side of those "
                  "faces. Faces alone: all their boundary edges, on their side.")

    def add_properties(self, document_object) -> None:
        super().add_properties(document_object)
        if "Condition" not in document_object.PropertiesList:
            document_object.addProperty(
                "App::PropertyEnumeration", "Condition", "Wall",
                "Wall: layers grow from the edges. Match: layers of other walls run along them. "
                "Off: neither. Boundary: they bound their faces, however smoothly these meet. "
                "Smooth: layers run across them.")
            document_object.Condition = list(CONDITIONS)
        elif document_object.getEnumerationsOfProperty("Condition") != list(CONDITIONS):
            chosen = document_object.Condition  # of a file from before there were so many
            document_object.Condition = list(CONDITIONS)
            document_object.Condition = chosen


class Size(Control):
    Type = "AdvancingLayers::Size"
    LIST = "SizeList"
    TABLE = (*SIZE_SETTINGS, setting("radius", REFINEMENT_SETTINGS))
    REFERENCES = "The faces, edges and vertices that the size holds for."
    KINDS = ("Face", "Edge", "Vertex")


class Group(Control):
    Type = "AdvancingLayers::Group"
    LIST = "GroupList"
    REFERENCES = "The faces and edges of the group; the mesh groups them under its label."

    def add_properties(self, document_object) -> None:
        super().add_properties(document_object)
        if "GroupName" not in document_object.PropertiesList:
            document_object.addProperty(
                "App::PropertyString", "GroupName", "Group",
                "The group's name in the mesh; the label, unless another is given here.")

    def onChanged(self, document_object, name: str) -> None:
        super().onChanged(document_object, name)
        # Not when a file is read or an object copied: FreeCAD may have changed the label then, as
        # labels are unique within a document.
        if name == "Label" and not document_object.Document.Restoring:
            document_object.GroupName = document_object.Label


KINDS = (Wall, Size, Group)


def is_control(document_object) -> bool:
    return isinstance(getattr(document_object, "Proxy", None), KINDS)


def children(mesh_object) -> List[Any]:
    """Every wall, size and group of the mesh object."""
    return [child for kind in KINDS for child in getattr(mesh_object, kind.LIST)]


def own_children(mesh_object) -> None:
    """A copied mesh object refers to the children of the one that it was copied from: gives it
    its own."""
    for kind in KINDS:
        kept = list(getattr(mesh_object, kind.LIST))
        own = [_copy(child) if mesh_of(child) not in (None, mesh_object) else child
               for child in kept]
        if own != kept:
            setattr(mesh_object, kind.LIST, own)


def _copy(child):
    made = child.Document.addObject("App::FeaturePython", type(child.Proxy).__name__)
    type(child.Proxy)(made)
    made.Label = child.Label
    for name in child.PropertiesList:
        if child.getGroupOfProperty(name) not in ("Base", ""):
            setattr(made, name, getattr(child, name))
    attach_view(made)
    return made


def mesh_of(control):
    """The layer mesh that the child belongs to, or None."""
    return next((parent for parent in control.InList
                 if control in getattr(parent, control.Proxy.LIST, [])), None)


def make(kind, mesh_object, references, label: str = "", condition: str = CONDITIONS[0],
         values: Mapping[str, Any] = MappingProxyType({})):
    """Adds a child of the kind to the mesh object. Values are those of the kind's table, with
    units where wanted. Raises InputError, and changes nothing then."""
    source = mesh_object.Part
    picked = names_on(source, references)
    if not picked:
        raise InputError("references", "of a new {} must not be empty", Sentence(kind.__name__))
    picker = Picker(cad_input.global_shape(source))
    for name in picked:
        picker.pick(name)
        if _sort(name) not in kind.KINDS:
            raise InputError("references", "of a {} cannot hold {}", Sentence(kind.__name__), name)
    condition = _condition(condition)
    table = value_settings(kind.TABLE)
    checked = check_all(plain_values(values, table), tuple(table))

    made = mesh_object.Document.addObject("App::FeaturePython", kind.__name__)
    kind(made)
    made.Label = label or tr(kind.__name__)
    made.References = link_value(source, picked)
    for entry in table:
        if checked[entry.key] is not None:
            setattr(made, property_name(entry), to_property(entry, checked[entry.key]))
    if kind is Wall:
        made.Condition = condition
    setattr(mesh_object, kind.LIST, list(getattr(mesh_object, kind.LIST)) + [made])
    attach_view(made)
    return made


def make_group(mesh_object, name: str, references):
    """Adds a named group. Raises InputError."""
    made = make(Group, mesh_object, references, name)
    made.GroupName = name
    return made


def _condition(value: str) -> str:
    if str(value).capitalize() not in CONDITIONS:
        raise InputError("condition", "must be one of {}, got {}", ", ".join(CONDITIONS),
                         repr(value))
    return value.capitalize()


def _sort(name: str) -> str:
    """"Face", "Edge" or "Vertex", also of a name that the model has lost ("?Face1")."""
    return name.lstrip("?").rstrip("0123456789")


def remember(control, anew: bool = False) -> None:
    """Remembers what the references look like, where that is not known yet; `anew`: as they are
    now, whatever they were."""
    texts: List[str] = []
    for picker, picked in _by_owner(control):
        texts += remembered([] if anew else control.Picked, picked, picker)
    if texts != list(control.Picked):
        control.Picked = texts


def problems(control) -> List[Problem]:
    """The references that do not stand for what was picked any more."""
    return [problem for picker, picked in _by_owner(control)
            for problem in reference_problems(control, picked, control.Picked, picker)]


def replace_names(control, new_names: Mapping[str, str]) -> None:
    """Renames references, and remembers them as they are now."""
    control.References = [(owner, tuple(new_names.get(name, name) for name in picked))
                          for owner, picked in control.References]
    remember(control, anew=True)


def _by_owner(control) -> Iterator[Tuple[Picker, Tuple[str, ...]]]:
    for owner, picked in control.References:
        shape = cad_input.global_shape(owner)
        if not shape.isNull():
            yield Picker(shape), picked


def values(control) -> Dict[str, Any]:
    """The values that are given, by key."""
    found = {}
    for entry in value_settings(control.Proxy.TABLE):
        value = from_property(entry, getattr(control, property_name(entry)))
        if value != unset_value(entry):
            found[entry.key] = value
    return found


def contributions(mesh_object) -> Dict[str, Any]:
    """What the children add up to, as a job would say it. Raises InputError for references that
    are none of the meshed object's."""
    source = mesh_object.Part
    for child in children(mesh_object):
        if not child.References:
            raise InputError("", "{} refers to nothing: pick faces or edges for it", child.Label)
    conditions: Dict[str, List[Any]] = {condition: [] for condition in CONDITIONS}
    for wall in mesh_object.WallList:
        conditions[wall.Condition].append(_wall(wall, source))
    found = {
        "walls": conditions["Wall"] or ("all" if mesh_object.GrowFromAll else []),
        **{condition.lower(): [edge for wall in conditions[condition] for edge in wall["edges"]]
           for condition in CONDITIONS[1:]},
        "groups": {group.GroupName: names_on(source, group.References)
                   for group in mesh_object.GroupList},
    }
    found["sizes"], found["refinements"] = [], []
    for size in mesh_object.SizeList:
        _add_size(size, source, found)
    return found


def _add_size(size, source, found: Dict[str, Any]) -> None:
    """A size about a vertex is a refinement at its point; the radius is for those alone."""
    picked, given = names_on(source, size.References), values(size)
    radius = given.pop("radius", 0.0)
    entry = _split(picked)
    vertices = entry.pop("vertices")
    if entry["edges"] or entry["faces"]:
        found["sizes"].append({**entry, **given})
    shape = cad_input.global_shape(source)
    for name in vertices:
        if "size" not in given:
            raise InputError("", "{} has no value for its size: give one for the surroundings of "
                             "{}", size.Label, name)
        point = list(Picker(shape).pick(name).centre)
        found["refinements"].append({"point": point, "size": given["size"], "radius": radius})


def _split(picked: Iterable[str]) -> Dict[str, List[str]]:
    found: Dict[str, List[str]] = {"edges": [], "faces": [], "vertices": []}
    for name in picked:
        found[{"Edge": "edges", "Vertex": "vertices"}.get(_sort(name), "faces")].append(name)
    return found


def _wall(wall, source) -> Dict[str, Any]:
    entry: Dict[str, Any] = _split(names_on(source, wall.References))
    del entry["vertices"]  # a wall has none
    if entry["faces"] and not entry["edges"]:
        entry["edges"] = FaceEdges(cad_input.global_shape(source)).boundary(entry["faces"])
    return {**entry, **values(wall)}


def from_settings(mesh_object, settings: Mapping[str, Any]) -> None:
    """Makes the children that checked settings ask for."""
    if settings["walls"] != "all":
        mesh_object.GrowFromAll = False
        for entry in settings["walls"]:
            _make_entry(Wall, mesh_object, entry)
    for condition in CONDITIONS[1:]:
        if settings[condition.lower()]:
            make(Wall, mesh_object, settings[condition.lower()], condition, condition)
    for entry in settings["sizes"]:
        _make_entry(Size, mesh_object, entry)
    for name, members in settings["groups"].items():
        make_group(mesh_object, name, members)


def _make_entry(kind, mesh_object, entry: Mapping[str, Any]) -> None:
    picked = [*entry["edges"], *entry["faces"]]
    given = {key: value for key, value in entry.items()
             if key not in ("edges", "faces") and value is not None}
    make(kind, mesh_object, picked, values=given)

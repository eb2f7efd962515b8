"""The table of settings: source of job keys, FreeCAD properties, tooltips and reference page.

What the core is told comes from the core's own rows; here stand only what documents add to them,
and the settings that the core does not see. Lengths are in mm and angles in degrees throughout.
"""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, FrozenSet, Iterable, List, Mapping, Optional, Tuple, Union

from advlayers.core_access import core_schema
from advlayers.sentence import Sentence, tell_settings


@dataclass(frozen=True)
class Setting:
    key: str  # in jobs and in Python
    kind: str  # what values it takes, see settings_check.CHECKS
    default: Any  # None: worked out from the model, or nothing
    doc: str  # one sentence or two for tooltip and reference page
    unit: str = ""
    low: Optional[float] = None
    high: Optional[float] = None
    low_open: bool = False  # low itself is not allowed
    high_open: bool = False
    choices: Tuple[str, ...] = ()
    group: str = ""  # of the property editor; empty: no property
    child: str = ""  # what child objects of the mesh object carry it instead
    required: bool = False
    decimals: int = 4  # that a widget shows of a number without a unit
    becomes: str = ""  # the setting that has it in a document


# Where documents have the core's settings: the group of a property, or the child objects.
_GROUPS = {
    "faces": "Geometry", "feature_angle": "Geometry", "initial_mesh": "Geometry",
    "size": "Size", "curvature_angle": "Size", "min_size": "Size", "chord_deviation": "Size",
    "relative_chord": "Size", "cells_across": "Size", "size_growth": "Size",
    "refinements": "Size", "mapped": "Size", "periodic": "Size", "core": "Size",
    "order": "Size", "first_height": "Layers", "growth": "Layers", "layers": "Layers",
    "others": "Layers", "threads": "Run",
}
_CHILDREN = {"sizes": "Size", "walls": "Wall", "match": "Wall", "off": "Wall", "boundary": "Wall",
             "smooth": "Wall"}
# Worked out from the model where they are not given.
_WORKED_OUT = ("size", "first_height")


def _of_core(row: Mapping[str, Any], required: bool) -> Setting:
    return Setting(
        row["key"], row["kind"], row["default"], row["doc"], row["unit"], row["lowest"],
        row["highest"], row["above"], row["below"], tuple(row["choices"]),
        required=required and row["required"])


def _mesh_setting(row: Mapping[str, Any]) -> Setting:
    key = row["key"]
    return replace(_of_core(row, key not in _WORKED_OUT), group=_GROUPS.get(key, ""),
                   child=_CHILDREN.get(key, ""))


def _table(name: str) -> Tuple[Setting, ...]:
    """Of the entries of a list, where a box that is not ticked says nothing."""
    return tuple(replace(entry, default=None) if entry.kind in ("flag", "point") else entry
                 for entry in (_of_core(row, True) for row in _SCHEMA[name]))


_SCHEMA = core_schema()

# What one wall, one size and one point of refinement of a list may say; a number that a wall does
# not give is that of the mesh.
WALL_SETTINGS = _table("walls")
SIZE_SETTINGS = _table("sizes")
REFINEMENT_SETTINGS = _table("refinements")
PERIODIC_SETTINGS = _table("periodic")

# Of the mesh, but not of the core's Settings.
OWN_SETTINGS = (
    Setting(
        "sew_tolerance", "number", 0.0,
        "Faces whose edges lie within this distance of each other are joined there before meshing; "
        "0 joins none. Faces and edges keep their names.",
        unit="mm", low=0.0, group="Geometry",
    ),
    Setting(
        "preset", "choice", None,
        "What is asked for where nothing else is said: cfd grows layers from every sharp edge "
        "until they are as high as wide, fem has none, washers puts two rings of quads about every "
        "hole.",
        choices=("cfd", "fem", "washers"), becomes="layers",
    ),
    Setting(
        "y_plus", "y_plus", None,
        "Instead of first_height: the dimensionless wall distance y+ of the first layer and the "
        "flow that it is for.",
        becomes="first_height",
    ),
    Setting(
        "layer_groups", "flag", False,
        "Makes a group of the elements of each layer, too: Layer1, Layer2, … and Core.",
        group="Run",
    ),
    Setting(
        "max_elements", "number", 0.0,
        "A mesh that is estimated to have more elements is refused before it is begun; 0: two "
        "million.",
        low=0.0, group="Run", decimals=0,
    ),
    Setting(
        "max_memory", "number", 0.0,
        "A mesh that is estimated to take more megabytes is refused before it is begun; 0: four "
        "fifths of the machine's memory.",
        low=0.0, group="Run", decimals=0,
    ),
    Setting(
        "max_seconds", "number", 0.0,
        "A mesh that is estimated to take more seconds of computing is refused before it is begun; "
        "0: ten minutes.",
        low=0.0, group="Run", decimals=0,
    ),
    Setting(
        "groups", "groups", {},
        "Named groups for boundary conditions: a name and the CAD faces or edges in it.",
        child="Group",
    ),
)
# What documents have no place for is for those who call the core themselves.
MESH_SETTINGS = (*(_mesh_setting(row) for row in _SCHEMA["mesh"]
                   if row["key"] in _GROUPS or row["key"] in _CHILDREN), *OWN_SETTINGS)

JOB_SETTINGS = (
    Setting(
        "input", "path", None,
        "The CAD file: .step .stp .iges .igs .brep .brp .FCStd .stl.", required=True,
    ),
    Setting(
        "object", "text", None,
        "Name or label of the object to mesh in an FCStd file. Default: the only top-level shape, "
        "of several the one with most faces.",
    ),
    Setting(
        "parameters", "values", {},
        "Values that an FCStd file is given before its shape is taken: cells of spreadsheets by "
        "alias, constraints of sketches by name, and properties, as OBJECT.NAME.",
    ),
    Setting("outputs", "paths", (), "The files to write; the ending says the format."),
    Setting("picture", "path", None, "The file to draw a picture of the mesh to, as PNG."),
    Setting(
        "extrude", "extrude", None,
        "Makes a plane mesh solid: hexahedra and prisms, with patches named after edges and their "
        "groups, in every file that has cells.",
    ),
    Setting(
        "volume", "volume", None,
        "Fills a closed mesh with cells, in every file that has them; by Gmsh, else by Netgen.",
    ),
    Setting("report", "path", None, "The file to write the report to, as JSON."),
    Setting(
        "strict", "flag", False,
        "Makes a shortfall of layers or heights an error: the job ends with status 2.",
    ),
)

# What is asked of the files; also keywords of export_mesh().
EXPORT_SETTINGS = (
    Setting(
        "scale", "number", 1.0,
        "Coordinates in files are in mm times this: 0.001 writes metres.",
        low=0.0, low_open=True,
    ),
    Setting(
        "msh_version", "choice", "4.1", "The version of .msh files.", choices=("4.1", "2.2"),
    ),
    Setting(
        "quad_nodes", "count", 8,
        "Nodes of a quad of order 2: 8, or 9 with one in its middle, on the face.",
        low=8, high=9,
    ),
    Setting(
        "inp_elements", "choice", "shell",
        "What the surface elements of .inp files are: S4, S4R, CPS4, CPE4, CAX4 or M3D4 and those "
        "of three, six and eight nodes.",
        choices=("shell", "reduced shell", "plane stress", "plane strain", "axisymmetric",
                 "membrane"),
    ),
)

# What a block "y_plus" may say; see flow_height.estimate().
Y_PLUS_SETTINGS = (
    Setting(
        "y_plus", "number", 1.0,
        "Dimensionless height of the first layer; its middle lies at half of it.",
        low=0.0, low_open=True, high=1e5),
    Setting("speed", "number", None, "Speed of the flow [m/s].", low=0.0, low_open=True,
            high=1e5, required=True),
    Setting(
        "length", "number", None,
        "Along a plate, a wing, a hull: the distance from its leading edge. In a pipe or a duct: "
        "its hydraulic diameter.",
        unit="mm", low=0.0, low_open=True, required=True),
    Setting("flow", "choice", "plate", "Past a plate, or developed in a pipe.",
            choices=("plate", "pipe")),
    Setting("fluid", "choice", "air", "Air at 15 °C, or water at 20 °C, both at 1 bar.",
            choices=("air", "water")),
    Setting("density", "number", None, "Density of another fluid [kg/m³].", low=0.0, low_open=True,
            high=1e5),
    Setting("viscosity", "number", None, "Dynamic viscosity of another fluid [Pa s].", low=0.0,
            low_open=True, high=1e5, decimals=8),
)

# What the block `extrude` of a job may say.
EXTRUDE_SETTINGS = (
    Setting("thickness", "number", None, "Of the plate, from the plane of the mesh on.", unit="mm",
            low=0.0, low_open=True),
    Setting("cells", "count", 1, "Number of cells across the thickness or the angle.", low=1),
    Setting(
        "direction", "point", None,
        "Which way the plate grows, at right angles to the plane. Default: the normal of the "
        "faces.",
    ),
    Setting(
        "axis_direction", "point", None,
        "Instead of a plate: turns the mesh about this direction, a line in its plane that it does "
        "not cross.",
    ),
    Setting("axis_point", "point", None, "A point on that line. Default: the origin.", unit="mm"),
    Setting(
        "angle", "number", None,
        "Of the turn in all, half of it to either side of the plane.",
        unit="deg", low=0.0, low_open=True, high=180.0, high_open=True,
    ),
    Setting("front", "text", "front", "Name of the patch at the far end."),
    Setting("back", "text", "back", "Name of the patch at the near end."),
    Setting(
        "patch_types", "words", {},
        "What OpenFOAM takes a patch for, by its name: wall, patch, symmetry, symmetryPlane, empty "
        "or wedge. Default: empty or wedge for front and back, wall or symmetry where the name "
        "says so, else patch.",
    ),
)

# What the block `volume` of a job may say.
VOLUME_SETTINGS = (
    Setting("size", "number", None, "The longest edge inside. Default: that of the mesh.",
            unit="mm", low=0.0, low_open=True),
    Setting(
        "program", "choice", "any", "What fills the mesh; any takes Gmsh where it is installed.",
        choices=("any", "gmsh", "netgen"),
    ),
    Setting(
        "quads", "choice", "split",
        "Whether quads are split in two, or kept, with a pyramid on each (by Gmsh).",
        choices=("split", "keep"),
    ),
    Setting("name", "text", "Volume", "Name of the group of all cells."),
    Setting(
        "most_slivers", "number", 10.0,
        "The most tetrahedra with an angle below 5 degrees between two sides, in percent: where "
        "there are more, the filling fails.",
        low=0.0, high=100.0,
    ),
)


def setting(key: str, table: Tuple[Setting, ...] = MESH_SETTINGS) -> Setting:
    return next(entry for entry in table if entry.key == key)


def value_settings(table: Iterable[Setting]) -> List[Setting]:
    """Those of a table that are values, not references."""
    return [entry for entry in table if entry.key not in ("edges", "faces")]


def keys() -> FrozenSet[str]:
    """Of all settings, and what an InputError of another origin has for one."""
    tables = (MESH_SETTINGS, JOB_SETTINGS, EXPORT_SETTINGS, WALL_SETTINGS, SIZE_SETTINGS,
              REFINEMENT_SETTINGS, PERIODIC_SETTINGS, Y_PLUS_SETTINGS, EXTRUDE_SETTINGS,
              VOLUME_SETTINGS)
    return frozenset(entry.key for table in tables for entry in table) | {
        "references", "condition", "file"}


def label(key: str) -> str:
    """As the window shows a setting: "First height" of "first_height"."""
    return key.replace("_", " ").capitalize()


def property_name(entry: Setting) -> str:
    """Of the property that a document object has it in."""
    return "".join(word.capitalize() for word in entry.key.split("_"))


def range_said(entry: Setting) -> Sentence:
    """The allowed range: "> 0 mm", ">= 0 and < 180 deg"; empty without a bound."""
    unit = f" {entry.unit}" if entry.unit else ""
    bounds = []
    if entry.low is not None:
        bounds.append(f"{'>' if entry.low_open else '>='} {entry.low:g}")
    if entry.high is not None:
        bounds.append(f"{'<' if entry.high_open else '<='} {entry.high:g}")
    if not bounds:
        return Sentence("")
    bounds[-1] += unit
    return Sentence("{} and {}", tuple(bounds)) if len(bounds) == 2 else Sentence(bounds[0])


def unset_value(entry: Setting) -> Union[str, int]:
    """What stands in a property for a value that is not given: the default, else something out of
    the setting's range."""
    if entry.default is not None:
        return entry.default
    if entry.kind == "layers":
        return ""
    if entry.kind == "flag":
        return False
    zero_allowed = entry.low is None or (entry.low <= 0.0 and not entry.low_open)
    return -1 if zero_allowed else 0


def optional_doc(entry: Setting) -> str:
    """The tooltip of a value that need not be given."""
    if entry.kind == "flag" or entry.default is not None:
        return entry.doc
    unset = unset_value(entry)
    return f"{entry.doc} {'Empty' if unset == '' else unset}: not given."


tell_settings(lambda key: label(key) if key in keys() else "")

"""The one table of settings: source of job keys, FreeCAD properties, tooltips and reference page.

Lengths are in mm and angles in degrees throughout.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, FrozenSet, Optional, Tuple, Union

from advlayers.sentence import Sentence


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
    property: str = ""  # name of the FreeCAD property; empty: none
    property_type: str = ""
    group: str = ""  # of the property editor
    child: str = ""  # what child objects of the mesh object carry it instead
    required: bool = False


MESH_SETTINGS = (
    Setting(
        "faces", "faces", "all",
        "The CAD faces to mesh, by name, or all of them.",
        property="Faces", property_type="App::PropertyStringList", group="Geometry",
    ),
    Setting(
        "feature_angle", "number", 0.0,
        "Faces that meet at an angle below this are meshed as one patch; layers run across the "
        "edge between them. 0 makes every CAD face a patch of its own; an STL file is meshed "
        "with 20.",
        unit="deg", low=0.0, high=180.0, high_open=True,
        property="FeatureAngle", property_type="App::PropertyAngle", group="Geometry",
    ),
    Setting(
        "sew_tolerance", "number", 0.0,
        "Faces whose edges lie within this distance of each other are joined there before meshing; "
        "0 joins none. Faces and edges keep their names.",
        unit="mm", low=0.0,
        property="SewTolerance", property_type="App::PropertyLength", group="Geometry",
    ),
    Setting(
        "initial_mesh", "mesh", None,
        "An existing mesh of the shape to start from. Inside the faces its nodes are where the "
        "triangulation starts; where it is finer than size, edges and core become as fine. Its "
        "layers and its order do not come over.",
        property="InitialMesh", property_type="App::PropertyLinkGlobal", group="Geometry",
    ),
    Setting(
        "size", "number", None,
        "Edge length of the mesh away from the layers. Default: 1/40 of the diagonal of the "
        "shape's bounding box.",
        unit="mm", low=0.0, low_open=True,
        property="Size", property_type="App::PropertyLength", group="Size",
    ),
    Setting(
        "curvature_angle", "number", 20.0,
        "The most that one element edge may turn along a curved edge or face; finer than size "
        "where the shape is curved.",
        unit="deg", low=0.0, low_open=True, high=90.0,
        property="CurvatureAngle", property_type="App::PropertyAngle", group="Size",
    ),
    Setting(
        "size_growth", "number", 1.4,
        "The most that neighbouring mesh edges differ in length where the size changes, through "
        "the surface and along edges.",
        low=1.0, low_open=True, high=3.0,
        property="SizeGrowth", property_type="App::PropertyFloat", group="Size",
    ),
    Setting(
        "sizes", "sizes", (),
        "Edge lengths, numbers of segments and clustering of some edges and faces.",
        child="Size",
    ),
    Setting(
        "refinements", "refinements", (),
        "Points about which the mesh is finer; as a property, texts of five numbers: x y z size "
        "radius.",
        property="Refinements", property_type="App::PropertyStringList", group="Size",
    ),
    Setting(
        "first_height", "number", None,
        "Height of the first layer, measured along the surface. Default: 1/10 of size.",
        unit="mm", low=0.0, low_open=True,
        property="FirstHeight", property_type="App::PropertyLength", group="Layers",
    ),
    Setting(
        "growth", "number", 1.2,
        "Each layer is this much higher than the one before it.",
        low=1.0,
        property="Growth", property_type="App::PropertyFloat", group="Layers",
    ),
    Setting(
        "layers", "layers", 0,
        "Number of layers; 0 grows them until the fronts close; \"isotropic\" grows each until "
        "its height reaches the spacing along the wall.",
        low=0,
        property="Layers", property_type="App::PropertyString", group="Layers",
    ),
    Setting(
        "walls", "walls", "all",
        "The boundary edges that layers grow from: all, or a list of walls with their own "
        "spacing.",
        child="Wall",
    ),
    Setting(
        "match", "edges", (),
        "Boundary edges that layers run along: their nodes lie where the layers of the walls at "
        "their ends arrive. Beside listed walls, the edges that meet them are match edges by "
        "default.",
        child="Wall",
    ),
    Setting(
        "off", "edges", (),
        "Boundary edges that no layer grows from or runs along: beside them each layer ends in a "
        "triangle.",
        child="Wall",
    ),
    Setting(
        "boundary", "edges", (),
        "Edges that bound the patches of their faces whatever feature_angle says, so that layers "
        "may grow from them: also smooth edges, and the seams of closed faces.",
        child="Wall",
    ),
    Setting(
        "smooth", "edges", (),
        "Edges between two faces that layers run across whatever feature_angle says. The faces "
        "may meet there at up to 70 degrees.",
        child="Wall",
    ),
    Setting(
        "core", "choice", "quads",
        "What fills the part that no layer reaches: quads where they come out well, or triangles.",
        choices=("quads", "triangles"),
        property="Core", property_type="App::PropertyEnumeration", group="Size",
    ),
    Setting(
        "threads", "count", 0,
        "Threads to mesh with; 0 uses all processors. The mesh does not depend on it.",
        low=0,
        property="Threads", property_type="App::PropertyInteger", group="Run",
    ),
    Setting(
        "groups", "groups", {},
        "Named groups for boundary conditions: a name and the CAD faces or edges in it.",
        child="Group",
    ),
)

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
    Setting("outputs", "paths", (), "The files to write; the ending says the format."),
    Setting("report", "path", None, "The file to write the report to, as JSON."),
    Setting(
        "strict", "flag", False,
        "Makes a shortfall of layers or heights an error: the job ends with status 2.",
    ),
)

# What one wall of a list of walls may say; a number that is not given is that of the job.
WALL_SETTINGS = (
    Setting("edges", "edges", None, "The edges of the wall.", required=True),
    Setting(
        "faces", "faces_only", (),
        "Layers grow on these faces only. Default: on every side of the edges.",
    ),
    Setting("first_height", "number", None, "Height of this wall's first layer.", unit="mm",
            low=0.0, low_open=True),
    Setting(
        "end_height", "number", None,
        "The first height at the end of each edge; it changes linearly along the edge, from "
        "first_height at its first vertex.",
        unit="mm", low=0.0, low_open=True,
    ),
    Setting(
        "aspect_ratio", "number", None,
        "Instead of first_height: the length of the mesh edges along the wall over the first "
        "height, everywhere.",
        low=0.0, low_open=True,
    ),
    Setting(
        "turning_angle", "number", None,
        "Instead of first_height: the angle that the wall turns over a length of one first "
        "height; the height is size where the wall is straight.",
        unit="deg", low=0.0, low_open=True, high=90.0,
    ),
    Setting("growth", "number", None, "Each layer of this wall is this much higher than the one "
            "before it.", low=1.0),
    Setting("layers", "count", None, "Number of this wall's layers; 0 grows them until the "
            "fronts close.", low=0),
    Setting(
        "thickness", "number", None,
        "Height of all layers together. With two of first_height, growth and layers it gives the "
        "third; where fewer are given, those of the whole mesh stand in, and layers are worked out "
        "first.",
        unit="mm", low=0.0, low_open=True,
    ),
)

# What one size of a list of sizes may say.
SIZE_SETTINGS = (
    Setting("edges", "edges", (), "The edges that the size holds for."),
    Setting("faces", "faces_only", (), "The faces that the size holds for."),
    Setting("size", "number", None, "Edge length of the mesh.", unit="mm", low=0.0, low_open=True),
    Setting("segments", "count", None, "Number of mesh edges along each of the edges.", low=1),
    Setting(
        "cluster", "number", None,
        "Ratio of the last mesh edge along a CAD edge to the first, in geometric steps.",
        low=1e-6, high=1e6,
    ),
    Setting(
        "both_ends", "flag", None,
        "Clusters towards both ends: the ratio is then that of the middle to the ends.",
    ),
)

# What one point of refinement may say.
REFINEMENT_SETTINGS = (
    Setting("point", "point", None, "Its coordinates [mm].", required=True),
    Setting("size", "number", None, "Edge length about the point; away from it, size_growth leads "
            "back to the other sizes.", unit="mm", low=0.0, low_open=True, required=True),
    Setting("radius", "number", 0.0, "The size holds within this distance of the point.",
            unit="mm", low=0.0),
)


def setting(key: str, table: Tuple[Setting, ...] = MESH_SETTINGS) -> Setting:
    return next(entry for entry in table if entry.key == key)


def keys() -> FrozenSet[str]:
    """Of all settings, and what an InputError of another origin has for one."""
    tables = (MESH_SETTINGS, JOB_SETTINGS, WALL_SETTINGS, SIZE_SETTINGS, REFINEMENT_SETTINGS)
    return frozenset(entry.key for table in tables for entry in table) | {
        "references", "condition", "file"}


def label(key: str) -> str:
    """As the window shows a setting: "First height" of "first_height"."""
    return key.replace("_", " ").capitalize()


def property_name(entry: Setting) -> str:
    """Of the property that a document object has it in."""
    return entry.property or "".join(word.capitalize() for word in entry.key.split("_"))


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

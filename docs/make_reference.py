"""Writes docs/settings.md, the settings in the core's stub, and the copy of the core's rows that
serves where there is no core, from the rows that the program itself follows.

Run by `./dev docs`; the tests compare all with what this would write.
"""
import json
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
for part in ("App", os.path.join("mesher_core", "python")):
    sys.path.insert(0, os.path.join(ROOT, part))

PAGE = os.path.join(ROOT, "docs", "settings.md")
STUB = os.path.join(ROOT, "mesher_core", "python", "advlayers_core", "_core.pyi")
SCHEMA_FILE = os.path.join(ROOT, "App", "advlayers", "schema.json")

_HEAD = """# Settings

*Written by `./dev docs` from the rows in `mesher_core/src/sizing/schema.cpp` and
`App/advlayers/settings_table.py`, and from `App/advlayers/export.py`: change those, not this page.*

Lengths are in mm and angles in degrees. Faces and edges have the names that FreeCAD shows: `Face3`,
`Edge7`. In a job file an unknown key is an error. In Python the mesh settings are the keywords of
`advlayers.make_layer_mesh`, where lengths and angles may also be texts with a unit; in a document
they are properties of the mesh object.
"""

_VALUES = {
    "faces": '`"all"` or a list of names',
    "faces_only": "list of names",
    "edges": "list of names",
    "number": "number",
    "count": "whole number",
    "layers": 'whole number or `"isotropic"`',
    "walls": '`"all"` or a list of walls',
    "sizes": "list of sizes",
    "refinements": "list of points, lines and boxes",
    "periodic": "list of motions",
    "point": "list of three numbers",
    "y_plus": "object, see below",
    "extrude": "object, see below",
    "volume": "object, see below",
    "words": "object: name to word",
    "values": "object of names and numbers or texts",
    "groups": "object: name to list of names",
    "flag": "true or false",
    "text": "text",
    "path": "path",
    "mesh": "path",
    "paths": "list of paths",
}


def page():
    from advlayers import settings_table as table

    parts = [
        _HEAD, "## Job files", "", _table(table.JOB_SETTINGS, properties=False), "",
        "Relative paths are relative to the job file. Of several shapes in an FCStd file the "
        "report names the one taken.", "",
        "## Mesh", "", _table(table.MESH_SETTINGS, properties=True), "",
        "Where no size is given, `curvature_angle` is 10: a circle has 36 mesh edges then.", "",
        "`initial_mesh` is a file of surface or solid elements in mm, of first or second order, "
        "read by its ending: " + _endings() + ". In Python it may also be a pair of points (n, 3) "
        "and triangles (m, 3), or a mesh object of the document (Gmsh's, Netgen's, a layer mesh, a "
        "Mesh object), which it is linked to; a file or arrays become such an object. What becomes "
        "of its nodes stands in [method.md](method.md#starting-from-an-existing-mesh).", "",
        "## One wall of a list of walls", "", _table(table.WALL_SETTINGS, properties=False), "",
        "With a list of walls, `others` says what becomes of the other boundary edges; `match` and "
        "`off` override that. `end_height` is for edges with two ends.", "",
        "In any list of edges, also in `match`, `off`, `boundary`, `smooth` and in sizes, some "
        "words stand for edges of the shape: `\"holes\"` for the inner outlines of plane faces, "
        "`\"holes 4 10\"` for those whose diameter [mm] lies between the two (an outline that is "
        "no circle counts as one as long), `\"sharp\"` for edges whose faces meet at more than 30 "
        "degrees, `\"sharp 45\"` at more than 45. In a document they become names.", "",
        "## One size of a list of sizes", "", _table(table.SIZE_SETTINGS, properties=False), "",
        "An edge takes its own size, or else the least of the faces beside it. Curved places stay "
        "as fine as curvature_angle asks. A fixed number of segments and clustering hold whatever "
        "else asks for; so do a first and a last segment, between which segments follow hyperbolic "
        "tangents, geometric steps or are alike.", "",
        "## One point, line or box of refinement", "",
        _table(table.REFINEMENT_SETTINGS, properties=False), "",
        "## One periodic motion", "", _table(table.PERIODIC_SETTINGS, properties=False), "",
        "What lies where the edges and faces come to lie is found by itself; it takes their nodes, "
        "to rounding. The report lists the pairs of nodes, and MSH files have them as links.", "",
        "## A block y_plus", "", _table(table.Y_PLUS_SETTINGS, properties=False), "",
        "The height comes from the friction on a smooth plate or in a smooth pipe; formulas and "
        "sources stand in [method.md](method.md#a-first-height-from-y). The report says it, with "
        "the thickness of the boundary layer and the layers that reach through it. In Python: "
        "`advlayers.y_plus(speed=50, length=1000)`.", "",
        "## A block extrude", "", _table(table.EXTRUDE_SETTINGS, properties=False), "",
        "Give a thickness, or axis_direction and angle. Groups of edges become patches, groups of "
        "faces groups of cells.", "",
        "## A block volume", "", _table(table.VOLUME_SETTINGS, properties=False), "",
        "Also keywords of `volume_fill.fill`. At order 2 quads are split.", "",
        "## Output formats", "",
        "What all of them hold: the nodes, quads and triangles, and a name for each CAD face "
        "(`FaceN`) and edge (`EdgeN`), and for the groups. Edges are lines, of all edges where a "
        "row does not say otherwise. Nodes and elements are numbered from 1, quads before "
        "triangles, lines last.", "",
        _formats(), "",
        "Where an element has one name only (CGNS, SU2, UGRID, OBJ, STL, and a volume's sides in "
        "UNV), that is the name of its group, or else of its CAD face or edge. A format that "
        "cannot carry what a job asks for (a group of edges, a second name, a volume, elements of "
        "second order) is refused before meshing. What each program makes of the files is told in "
        "[downstream.md](downstream.md).", "",
        "## Options of the files", "",
        "Keys of a job, and keywords of `object_export.export_mesh`.", "",
        _table(table.EXPORT_SETTINGS, properties=False), "",
    ]
    return "\n".join(parts)


def _table(settings, properties):
    head = ["key", "value", "default", "range"] + ["property"] * properties + ["meaning"]
    rows = [head, ["---"] * len(head)]
    for entry in settings:
        row = [f"`{entry.key}`", _value(entry), _default(entry), _range(entry)]
        row += [_where(entry)] * properties
        rows.append(row + [entry.doc])
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def _value(entry):
    if entry.kind == "choice":
        return " or ".join(f'`"{choice}"`' for choice in entry.choices)
    return _VALUES[entry.kind] + (f" [{entry.unit}]" if entry.unit else "")


def _default(entry):
    if entry.required:
        return "required"
    if entry.default is None or entry.default in ((), {}):
        return ""
    if isinstance(entry.default, bool):
        return str(entry.default).lower()
    return f'`"{entry.default}"`' if isinstance(entry.default, str) else f"{entry.default:g}"


def _range(entry):
    from advlayers.settings_table import range_said

    return range_said(entry).english


def _where(entry):
    """What has the setting in a document."""
    from advlayers.settings_table import property_name, setting

    if entry.child:
        return f"{entry.child} objects"
    return f"`{property_name(setting(entry.becomes) if entry.becomes else entry)}`"


_HINTS = {
    "number": "float", "count": "int", "flag": "bool", "edges": "Iterable[str]",
    "faces": 'Union[Literal["all"], Iterable[str]]', "faces_only": "Iterable[str]",
    "layers": 'Union[int, Literal["isotropic"]]', "choice": "str",
    "walls": 'Union[Literal["all"], Iterable[Mapping[str, Any]]]',
    "sizes": "Iterable[Mapping[str, Any]]", "refinements": "Iterable[Mapping[str, Any]]",
    "periodic": "Iterable[Mapping[str, Any]]",
    "mesh": "Optional[Tuple[NDArray[np.float64], NDArray[np.int32]]]",
}
_GIVEN = {"number": "float", "count": "int", "flag": "bool", "edges": "Tuple[str, ...]",
          "faces": "Union[str, Tuple[str, ...]]", "faces_only": "Tuple[str, ...]",
          "layers": "Union[int, str]", "choice": "str"}
_BEGIN, _END = "class Settings:\n", "\ndef schema("


def stub():
    """The stub of the core with its class Settings as the rows have it."""
    import advlayers_core

    with open(STUB, encoding="utf-8") as file:
        text = file.read()
    before, rest = text.split(_BEGIN)
    _old, after = rest.split(_END)
    return before + _BEGIN + _settings_class(advlayers_core.schema()["mesh"]) + _END + after


def schema():
    """What App reads where there is no core."""
    import advlayers_core

    return json.dumps(advlayers_core.schema(), indent=1, ensure_ascii=False) + "\n"


def _settings_class(rows):
    lines = ['    """What is asked for, by the keys of docs/settings.md.', "",
             "    Raises InvalidInput naming the setting and its value. What depends on the model",
             "    is checked by Mesher.",
             '    """', "",
             "    def __init__(", "        self, *,"]
    for row in rows:
        default = "" if row["required"] else " = ..."
        lines.append(f"        {row['key']}: {_HINTS[row['kind']]}{default},")
    lines.append("    ) -> None: ...")
    for row in rows:
        if row["kind"] in _GIVEN:
            lines += ["    @property",
                      f"    def {row['key']}(self) -> {_GIVEN[row['kind']]}: ..."]
    return "\n".join(lines) + "\n"


def _endings():
    from advlayers.initial_mesh import ENDINGS

    return " ".join(f"`{ending}`" for ending in ENDINGS)


def _formats():
    from advlayers.export import FORMATS

    rows = ["| ending | needs | keeps | loses |", "| --- | --- | --- | --- |"]
    for ending, entry in FORMATS.items():
        shown = ".FCStd" if ending == ".fcstd" else ending
        rows.append(f"| `{shown}` | {entry.needs} | {entry.keeps} | {entry.loses} |")
    return "\n".join(rows)


if __name__ == "__main__":
    for path, text in ((PAGE, page()), (STUB, stub()), (SCHEMA_FILE, schema())):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

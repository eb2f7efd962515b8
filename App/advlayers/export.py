"""The formats a mesh can be written in, what each can carry, and the one call that writes."""
from __future__ import annotations

import importlib.util
import os
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, FrozenSet, Mapping, Optional, Sequence

from advlayers.errors import InputError
from advlayers.formats import (
    bdf, cgns, inp, med, medit, mesh_parts, msh, obj, plane, ply, polymesh, stl, su2, ugrid, unv,
    vtk, vtu)
from advlayers.formats.mesh_parts import MeshParts


# Of the diagonal of a box: what it may have about a plane face.
_AIR = 1e-5
_PYRAMIDS = frozenset(("pyramid5", "pyramid13"))


@dataclass
class Product:
    """All that a writer may need: the mesh, what was asked of files, and FreeCAD's document, if
    there is one."""

    parts: MeshParts
    options: Mapping[str, Any] = field(default_factory=dict)  # of EXPORT_SETTINGS
    document: Any = None  # FreeCAD document with the shape and the mesh object


@dataclass(frozen=True)
class Asked:
    """What a mesh is to have, as far as some formats lack it; known before there is a mesh."""

    groups: Mapping[str, Sequence[str]]
    order: int = 1
    cells: FrozenSet[str] = frozenset()  # kinds of its volume elements
    quad_nodes: int = 8  # of order 2


@dataclass(frozen=True)
class Format:
    title: str  # in the file dialog
    write: Callable[[str, Product], None]
    keeps: str  # for the reference page
    loses: str = ""
    kinds: FrozenSet[str] = frozenset(mesh_parts.KINDS)
    edges: bool = True  # it has the groups of edges
    only_cells: bool = False  # it has no surface by itself
    one_name: bool = False  # each element has one name: that of its group, or of its CAD face
    needs: str = ""  # "FreeCAD", a Python package or nothing


def _plain(write: Callable[[str, MeshParts], None]) -> Callable[[str, Product], None]:
    return lambda path, product: write(path, product.parts)


def _write_msh(path: str, product: Product) -> None:
    msh.write(path, product.parts, product.options.get("msh_version", msh.VERSIONS[0]))


def _write_inp(path: str, product: Product) -> None:
    inp.write(path, product.parts, product.options.get("inp_elements", "shell"))


def _write_document(path: str, product: Product) -> None:
    product.document.saveCopy(path)


# The tests read each with programs that have nothing to do with this one.
FORMATS: Dict[str, Format] = {
    ".vtu": Format(
        "VTK unstructured grid", _plain(vtu.write),
        "cell arrays face, layer, edge, solid and group, a field per group with its number; node "
        "arrays layer and parent; exact", "lines of edges without a group", vtu.KINDS),
    ".vtk": Format(
        "VTK legacy", _plain(vtk.write),
        "the arrays of .vtu; names of groups in the title; exact",
        "lines of edges without a group", vtk.KINDS),
    ".msh": Format(
        "Gmsh", _write_msh,
        "FaceN, EdgeN and groups as physical names, entities numbered as the CAD; exact",
        "blanks in names; in version 2.2 all groups of a face but the first", msh.KINDS),
    ".inp": Format(
        "Abaqus", _write_inp,
        "FaceN, EdgeN and groups as ELSET and NSET, groups also as SURFACE; 16 to 17 digits",
        "signs in names but letters, digits, _ . -", inp.KINDS),
    ".bdf": Format(
        "Nastran", _plain(bdf.write),
        "a property per face with its name as a comment, EdgeN and groups as SET1; 11 to 14 digits",
        "", bdf.KINDS),
    ".unv": Format(
        "I-DEAS universal", _plain(unv.write), "FaceN, EdgeN and groups as groups; exact",
        "with a volume, all groups of a face but the first, which OpenFOAM cannot read", unv.KINDS),
    ".med": Format(
        "Salome MED", _plain(med.write), "FaceN, EdgeN and groups as groups; exact", "",
        med.KINDS, needs="h5py"),
    ".cgns": Format(
        "CGNS", _plain(cgns.write),
        "FaceN, EdgeN and groups as families, boundary conditions and regions; the unit; exact",
        "lines within a face", cgns.KINDS, one_name=True, needs="h5py"),
    ".su2": Format(
        "SU2", _plain(su2.write), "EdgeN and groups of the border as markers; exact",
        "names of faces of a plane domain; surfaces that are not plane", su2.KINDS, one_name=True),
    ".ugrid": Format(
        "UGRID", _plain(ugrid.write), "FaceN and groups as surfaces, their names in .mapbc; exact",
        "edges", ugrid.KINDS, edges=False, one_name=True),
    ".b8.ugrid": Format(
        "UGRID, big-endian", _plain(ugrid.write), "as .ugrid", "edges", ugrid.KINDS, edges=False,
        one_name=True),
    ".lb8.ugrid": Format(
        "UGRID, little-endian", _plain(ugrid.write), "as .ugrid", "edges", ugrid.KINDS,
        edges=False, one_name=True),
    ".mesh": Format(
        "Medit", _plain(medit.write), "numbers of faces and edges as references; exact",
        "names", medit.KINDS),
    ".obj": Format(
        "Wavefront", _plain(obj.write), "FaceN and groups as groups; exact",
        "lines of edges without a group", obj.KINDS, one_name=True),
    ".stl": Format(
        "STL", _plain(stl.write), "FaceN and groups as solids; exact",
        "edges; quads, which are cut in two", stl.KINDS, edges=False, one_name=True),
    ".ply": Format(
        "Stanford polygons", _plain(ply.write), "the number of each face; exact", "names and edges",
        ply.KINDS, edges=False),
    polymesh.NAME.lower(): Format(
        "OpenFOAM", _plain(polymesh.write),
        "groups, else FaceN or, extruded, EdgeN, as patches of a type; exact",
        "groups of cells; edges", polymesh.KINDS, only_cells=True, one_name=True),
    ".fcstd": Format(
        "FreeCAD document", _write_document,
        "the shape and the mesh object with all groups and settings", needs="FreeCAD"),
}


def format_of(path: str) -> str:
    """The longest known ending, else what follows the last point. OpenFOAM's is the whole name."""
    lower = path.lower()
    if os.path.basename(lower) == polymesh.NAME.lower():
        return polymesh.NAME.lower()
    known = [ending for ending in FORMATS if ending[0] == "." and lower.endswith(ending)]
    return max(known, key=len) if known else os.path.splitext(lower)[1]


def beside(path: str) -> Optional[str]:
    """The file that is written along with this one."""
    return ugrid.names_file(path) if format_of(path).endswith(".ugrid") else None


def check_format(key: str, path: str, freecad: bool) -> None:
    """Raises InputError for a format that is not written, or not on this machine."""
    ending = format_of(path)
    if ending not in FORMATS:
        known = " ".join(FORMATS)
        raise InputError(key, "has the unknown format {} (known: {}): {}", repr(ending), known,
                         path)
    needs = FORMATS[ending].needs
    if needs == "FreeCAD" and not freecad:
        raise InputError(key, "needs FreeCAD to be written: run the job with freecadcmd: {}", path)
    if needs not in ("", "FreeCAD") and importlib.util.find_spec(needs) is None:
        raise InputError(key, "needs the Python package {} (python3-{}): {}", needs, needs, path)


def check_carries(key: str, path: str, asked: Asked) -> None:
    """Raises InputError where the format cannot carry what the mesh is to have."""
    entry = FORMATS[format_of(path)]
    if asked.order == 2:
        _check_order(key, path, entry, asked)
    if entry.only_cells and not asked.cells:
        raise InputError(key, "{} needs cells: ask for extrude or volume: {}", entry.title, path)
    if asked.cells and "tet4" not in entry.kinds:
        raise InputError(key, "{} files have no volume elements: {}", entry.title, path)
    if asked.cells & _PYRAMIDS - entry.kinds:
        raise InputError(key, "{} files have no pyramids, which stand on quads that are kept: {}",
                         entry.title, path)
    for group, members in asked.groups.items():
        edges = [member for member in members if member.startswith("Edge")]
        if edges and not entry.edges:
            raise InputError(key, "{} files have no edges: the group {} of {} would be lost in {}",
                             entry.title, group, edges[0], path)
    if entry.one_name:
        _check_one_name(key, path, entry, asked)


def _check_order(key: str, path: str, entry: Format, asked: Asked) -> None:
    second = {"tri6", f"quad{asked.quad_nodes}"}
    if entry.kinds & second == second:
        return
    if "tri6" not in entry.kinds:
        raise InputError(key, "{} files have no elements of second order: {}", entry.title, path)
    raise InputError(key, "{} files have no quads of {} nodes: {}", entry.title, asked.quad_nodes,
                     path)


def check_kinds(key: str, path: str, parts: MeshParts) -> None:
    """Raises InputError where the format lacks elements that no one asked for by name: those about
    an axis."""
    entry = FORMATS[format_of(path)]
    if any(block.kind in _PYRAMIDS - entry.kinds for block in parts.blocks):
        raise InputError(key, "{} files have no pyramids, which the mesh has along the axis: {}",
                         entry.title, path)


def check_shape(key: str, path: str, asked: Asked, low: Sequence[float],
                high: Sequence[float]) -> None:
    """Raises InputError where the format has plane domains only, and what is to be meshed is none;
    the corners are those of a box about it, with some air."""
    if format_of(path) == ".su2" and not asked.cells and plane.axes(low, high, _AIR) is None:
        raise InputError(key, "SU2 files have plane domains (x, y or z constant) and volumes, no "
                         "surfaces: {}", path)


def _check_one_name(key: str, path: str, entry: Format, asked: Asked) -> None:
    first: Dict[str, str] = {}
    for group, members in asked.groups.items():
        for member in members:
            if first.setdefault(member, group) != group:
                raise InputError(
                    key, "{} files have one name for each element: {} is in the groups {} and {}, "
                    "which {} cannot hold", entry.title, member, first[member], group, path)

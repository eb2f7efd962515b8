"""The formats a mesh can be written in, and writing them so that nothing half-written remains."""
from __future__ import annotations

import errno
import importlib.util
import os
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Sequence, Tuple

from advlayers.errors import InputError
from advlayers.mesh_groups import Group, face_of_element, layer_of_element
from advlayers.unv_file import write_unv
from advlayers.vtu_file import write_vtu


@dataclass
class Product:
    """All that a writer may need: the mesh, its groups, and FreeCAD's document, if any."""

    mesh: Any
    groups: Sequence[Group]
    document: Any = None  # FreeCAD document with the shape and the mesh object
    fem_mesh: Any = None


@dataclass(frozen=True)
class Format:
    title: str  # in the file dialog
    write: Callable[[str, Product], None]
    keeps: str  # for the reference page
    needs: str = ""  # "FreeCAD", "meshio" or nothing


def _write_unv(path: str, product: Product) -> None:
    write_unv(path, product.mesh, product.groups)


def _write_vtu(path: str, product: Product) -> None:
    write_vtu(path, product.mesh)


def _write_document(path: str, product: Product) -> None:
    product.document.saveCopy(path)


def _write_fem_mesh(path: str, product: Product) -> None:
    product.fem_mesh.write(path)


def _write_meshio(path: str, product: Product) -> None:
    import meshio

    mesh = product.mesh
    quads = len(mesh.quads)
    cells = [(kind, part) for kind, part in
             (("quad", mesh.quads), ("triangle", mesh.triangles)) if len(part)]
    arrays = {}
    if path.lower().endswith(".vtk"):
        for name, values in (("face", face_of_element(mesh)), ("layer", layer_of_element(mesh))):
            arrays[name] = [part for part in (values[:quads], values[quads:]) if len(part)]
    meshio.Mesh(mesh.nodes, cells, cell_data=arrays).write(path)


# Only formats whose quads, triangles and coordinates come back when the file is read again; the
# tests check each.
FORMATS: Dict[str, Format] = {
    ".vtu": Format("VTK unstructured grid", _write_vtu,
                   "cell arrays face and layer, node arrays layer and parent; exact"),
    ".unv": Format("I-DEAS universal", _write_unv, "all groups; exact"),
    ".fcstd": Format("FreeCAD document", _write_document,
                     "the shape and the mesh object with all groups and settings",
                     "FreeCAD"),
    ".med": Format("Salome MED", _write_fem_mesh, "all groups; exact", "FreeCAD"),
    ".vtk": Format("VTK legacy", _write_meshio, "cell arrays face and layer; exact", "meshio"),
    ".msh": Format("Gmsh", _write_meshio, "nodes and elements (gmsh 4.1); exact", "meshio"),
    ".inp": Format("Abaqus", _write_meshio, "nodes and elements (Abaqus); exact", "meshio"),
    ".bdf": Format("Nastran", _write_meshio, "nodes and elements (Nastran); 12 digits", "meshio"),
    ".mesh": Format("Medit", _write_meshio, "nodes and elements (Medit); exact", "meshio"),
    ".ply": Format("Stanford polygons", _write_meshio, "nodes and elements; exact", "meshio"),
    ".obj": Format("Wavefront", _write_meshio, "nodes and elements; exact", "meshio"),
}


def format_of(path: str) -> str:
    return os.path.splitext(path)[1].lower()


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
    if needs == "meshio" and importlib.util.find_spec("meshio") is None:
        raise InputError(key, "needs the Python package meshio (python3-meshio): {}", path)


class Outputs:
    """Files that appear together or not at all: each is written under a temporary name beside its
    target and takes its place in publish(). Leaving the `with` block removes what is left."""

    def __init__(self) -> None:
        self._pending: List[Tuple[str, str]] = []

    def __enter__(self) -> "Outputs":
        return self

    def __exit__(self, *_error) -> None:
        for temporary, _target in self._pending:
            if os.path.exists(temporary):
                os.remove(temporary)

    def write(self, target: str, writer: Callable[[str], None]) -> None:
        folder, name = os.path.split(target)
        stem, ending = os.path.splitext(name)
        temporary = os.path.join(folder, f".{stem}.{os.getpid()}.part{ending}")
        self._pending.append((temporary, target))
        writer(temporary)
        # FreeCAD's writers say nothing when the disk is full.
        if not os.path.exists(temporary) or not os.path.getsize(temporary):
            raise OSError(errno.EIO, "nothing was written", target)

    def publish(self) -> None:
        for temporary, target in self._pending:
            os.replace(temporary, target)
        self._pending.clear()

"""An existing mesh of the shape, to start the triangulation from: out of a file, a document, or
arrays. All of it comes down to points (n, 3) [mm] and triangles (m, 3)."""
from __future__ import annotations

import contextlib
import importlib.util
import io
import os
from typing import Any, Dict, List, Tuple

import numpy as np

from advlayers import child
from advlayers.errors import InputError
from advlayers.surface_arrays import CORNERS, triangles_of
from advlayers.unv_file import read_unv

KEY = "initial_mesh"
Arrays = Tuple[Any, Any]

_MESHIO = (".vtu", ".vtk", ".msh", ".inp", ".bdf", ".nas", ".mesh", ".ply", ".obj", ".stl", ".off")
_FREECAD = (".med",)
ENDINGS = _MESHIO + (".unv",) + _FREECAD
# FreeCAD tells elements apart by the number of their nodes; the corners come first.
_FACES = {3: "triangle", 6: "triangle", 7: "triangle", 4: "quad", 8: "quad", 9: "quad"}
_VOLUMES = {4: "tetra", 10: "tetra", 5: "pyramid", 13: "pyramid", 6: "wedge", 15: "wedge",
            18: "wedge", 8: "hexahedron", 20: "hexahedron", 27: "hexahedron"}
_SAMPLES = 100  # nodes that tell whether a mesh is still the same


# --- files ----------------------------------------------------------------------------------------

def check_readable(path: str, freecad: bool) -> None:
    """Raises InputError for an unknown ending, a missing file, or one that cannot be read here."""
    ending = os.path.splitext(path)[1].lower()
    if ending not in ENDINGS:
        raise InputError(KEY, "has the unknown format {} ({}): {}", repr(ending), " ".join(ENDINGS),
                         path)
    if not os.path.isfile(path):
        raise InputError(KEY, "is no file: {}" if os.path.exists(path) else "does not exist: {}",
                         path)
    if not os.access(path, os.R_OK):
        raise InputError(KEY, "cannot be read: {}", path)
    if ending in _FREECAD and not freecad:
        raise InputError(KEY, "needs FreeCAD to be read: run the job with freecadcmd: {}", path)
    if ending in _MESHIO and importlib.util.find_spec("meshio") is None:
        raise InputError(KEY, "needs the Python package meshio (python3-meshio): {}", path)


def read(path: str) -> Arrays:
    """Reads the file in a child process. Raises InputError naming it."""
    try:
        points, triangles = child.call(KEY, path, os.path.getsize(path), _read, path)
    except InputError:
        raise
    except Exception as error:  # each reader has its own ways to fail
        text = " ".join(str(error).split()) or type(error).__name__
        raise InputError(KEY, "cannot be read: {}: {}", text, path) from error
    if not len(triangles):
        raise InputError(KEY, "has no surface elements: {}", path)
    return points, triangles


def _read(path: str) -> Arrays:
    ending = os.path.splitext(path)[1].lower()
    if ending == ".unv":
        points, cells = read_unv(path)
    elif ending in _FREECAD:
        import Fem

        points, cells = _of_fem(Fem.read(path))
    else:
        points, cells = _of_meshio(path)
    triangles = triangles_of(cells)
    if len(triangles) and (triangles.min() < 0 or triangles.max() >= len(points)):
        raise ValueError("an element has a node that is not there")
    if not np.isfinite(points).all():
        raise ValueError("a node is nowhere")
    return points, triangles


def _of_meshio(path: str):
    import meshio

    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            mesh = meshio.read(path)
    except SystemExit as error:  # meshio ends the program over a damaged file
        raise ValueError(said.getvalue() or "damaged") from error
    cells: Dict[str, List[Any]] = {}
    for block in mesh.cells:
        kind = block.type.rstrip("0123456789")
        if kind in CORNERS:
            cells.setdefault(kind, []).append(np.asarray(block.data)[:, :CORNERS[kind]])
    points = np.zeros((len(mesh.points), 3))
    points[:, :mesh.points.shape[1]] = mesh.points
    return points, {kind: np.concatenate(blocks) for kind, blocks in cells.items()}


# --- documents ------------------------------------------------------------------------------------

def holds_mesh(document_object) -> bool:
    """Whether it is one of FreeCAD's FEM meshes, or of its Mesh objects."""
    return document_object.isDerivedFrom("Fem::FemMeshObject") or \
        document_object.isDerivedFrom("Mesh::Feature")


def of_object(document_object) -> Arrays:
    """The object's mesh, where it stands in the document. Raises InputError."""
    if not holds_mesh(document_object):
        raise InputError(KEY, "must be a mesh object, got {}", document_object.Label)
    if document_object.isDerivedFrom("Mesh::Feature"):
        points, facets = document_object.Mesh.Topology
        cells: Dict[str, Any] = {"triangle": np.array(facets, np.int64).reshape(-1, 3)}
        points = np.array([tuple(point) for point in points], float).reshape(-1, 3)
    else:
        points, cells = _of_fem(document_object.FemMesh)
    triangles = triangles_of(cells)
    if not len(triangles):
        raise InputError(KEY, "{} has no surface elements: mesh it first", document_object.Label)
    return _placed(document_object, points), triangles


def fingerprint(document_object) -> List[float]:
    """Numbers that change with the object's mesh or its place: counts and some of the nodes. None
    without an object, or for one without a mesh."""
    if document_object is None or not holds_mesh(document_object):
        return []
    if document_object.isDerivedFrom("Mesh::Feature"):
        points = [tuple(point.Vector) for point in document_object.Mesh.Points]
        counts = [len(points), document_object.Mesh.CountFacets]
    else:
        fem = document_object.FemMesh
        nodes = fem.Nodes
        points = [tuple(nodes[number]) for number in sorted(nodes)]
        counts = [len(points), fem.FaceCount, fem.VolumeCount]
    chosen = np.linspace(0, len(points) - 1, min(len(points), _SAMPLES)).astype(int)
    sample = np.array([points[i] for i in chosen]).reshape(-1, 3)
    return [float(n) for n in counts] + _placed(document_object, sample).ravel().tolist()


def in_document(document, given):
    """The mesh object of the document that stands for a path, arrays, or itself. Raises InputError.
    """
    if given is None:
        return None
    if isinstance(given, str):
        check_readable(given, freecad=True)
        return add_to(document, read(given), os.path.basename(given))
    if isinstance(given, tuple):
        from advlayers.language import tr

        return add_to(document, given, tr("Initial mesh"))
    if given.Document is not document:
        raise InputError(KEY, "must be in the same document as the shape, got {}", given.Label)
    if not holds_mesh(given):
        raise InputError(KEY, "must be a mesh object, got {}", given.Label)
    return given


def add_to(document, arrays: Arrays, label: str):
    """A FEM mesh object with the arrays' mesh, for a layer mesh to be linked to."""
    import Fem

    fem = Fem.FemMesh()
    points, triangles = arrays
    for number, point in enumerate(np.asarray(points, float).tolist(), 1):
        fem.addNode(*point, number)
    for number, corners in enumerate((np.asarray(triangles, int) + 1).tolist(), 1):
        fem.addFace(corners, number)
    made = document.addObject("Fem::FemMeshObject", "InitialMesh")
    made.Label = label
    made.FemMesh = fem
    made.Visibility = False
    return made


def _of_fem(fem):
    nodes = fem.Nodes
    ids = sorted(nodes)
    index = {number: place for place, number in enumerate(ids)}
    points = np.array([tuple(nodes[number]) for number in ids], float).reshape(-1, 3)
    cells: Dict[str, List[Any]] = {}
    for elements, kinds in ((fem.Faces, _FACES), (fem.Volumes, _VOLUMES)):
        for element in elements:
            numbers = fem.getElementNodes(element)
            kind = kinds.get(len(numbers))
            if kind is not None:
                corners = numbers[:CORNERS[kind]]
                cells.setdefault(kind, []).append([index[number] for number in corners])
    return points, {kind: np.array(rows, np.int64) for kind, rows in cells.items()}


def _placed(document_object, points):
    """FreeCAD gives points with the object's own placement, but without those of its parents."""
    beyond = _parent_placement(document_object)
    if beyond is None or not len(points):
        return points
    matrix = np.array(beyond.toMatrix().A).reshape(4, 4)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _parent_placement(document_object):
    """Of the part that it is in, directly or in a group (an analysis); None without one."""
    part = document_object.getParentGeoFeatureGroup()
    if part is not None:
        return part.getGlobalPlacement()
    group = document_object.getParentGroup()
    return None if group is None else _parent_placement(group)

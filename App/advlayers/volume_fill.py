"""Fills the inside of a closed layer mesh with tetrahedra, by FreeCAD's Gmsh.

Quads are cut in two for it, without a new node: a tetrahedron has no quad side.
"""
from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import time
from typing import Any, Dict, List, Tuple

import numpy as np

from advlayers import cad_input, stored_mesh
from advlayers.errors import InputError
from advlayers.formats import mesh_parts
from advlayers.language import tr
from advlayers.layer_mesh import window_watch
from advlayers.sentence import Sentence
from advlayers.triangle_mesh import triangles_of

_POLL = 0.05  # [s] between two looks at the program
_MSH_TRIANGLE, _MSH_TETRAHEDRON = 2, 4
# FreeCAD (SMESH, MED and UNV too) sees the first three nodes of a tetrahedron turn clockwise from
# the fourth; files of Gmsh and CalculiX have them the other way round.
_TO_FREECAD = (1, 0, 2, 3)


def fill(mesh_object):
    """Adds a Fem::FemMeshObject with the tetrahedra, and with the surface's triangles in groups of
    its faces and the named ones. The surface's nodes keep their numbers.

    Raises InputError where there is no mesh, where it is not closed, or where Gmsh is missing or
    fails; nothing has changed then.
    """
    command = gmsh_command()
    mesh = stored_mesh.read(mesh_object)
    cells, elements = triangles_of(mesh)
    check_closed(mesh, mesh_object.Label)
    faces = np.concatenate([mesh.face_of_quad, mesh.face_of_triangle])[elements]
    solids = _solids(mesh_object.Part, sorted(set(faces.tolist())))
    nodes, tetrahedra = _run(command, mesh.nodes, cells, faces, solids, mesh_object.Size.Value)
    fem = _fem_mesh(mesh, nodes, cells, elements, tetrahedra)

    made = mesh_object.Document.addObject("Fem::FemMeshObject", f"{mesh_object.Name}_Volume")
    made.Label = tr("{} volume").format(mesh_object.Label)
    # FEM looks for the shape here when it searches the nodes of a constraint.
    made.addProperty("App::PropertyLinkGlobal", "Part", "Geometry", "The object that is meshed.")
    made.Part = mesh_object.Part
    made.FemMesh = fem
    return made


def gmsh_command() -> str:
    """The Gmsh that FreeCAD's FEM workbench is set up with. Raises InputError."""
    import FreeCAD

    kept = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Fem/Gmsh")
    command = "" if kept.GetBool("UseStandardGmshLocation", True) else kept.GetString(
        "gmshBinaryPath", "")
    command = command or shutil.which("gmsh") or os.path.join(FreeCAD.getHomePath(), "bin", "gmsh")
    if not os.access(command, os.X_OK):
        raise InputError("", "Gmsh is not installed: install the package gmsh, or tell FreeCAD "
                             "where it is under Edit > Preferences > FEM > Gmsh")
    return command


def check_closed(mesh, label: str) -> None:
    """Raises InputError where a side of an element has no neighbour."""
    sides = np.concatenate([
        np.stack([part, np.roll(part, -1, axis=1)], axis=2).reshape(-1, 2)
        for part in (mesh.quads, mesh.triangles)])
    unique, counts = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
    open_sides = unique[counts < 2]
    if len(open_sides):
        place = mesh.nodes[open_sides[0]].mean(axis=0)
        raise InputError("", "{} is not closed: {} sides of elements have no neighbour, one at "
                         "({}, {}, {})", label, len(open_sides), f"{place[0]:.6g}",
                         f"{place[1]:.6g}", f"{place[2]:.6g}")


def _solids(source, meshed: List[int]) -> List[List[int]]:
    """The CAD faces around each volume: of the solids, or all of them where there is none."""
    shape = cad_input.global_shape(source)
    faces = shape.Faces
    found = [[number for number, face in enumerate(faces, 1)
              if any(face.isSame(other) for other in solid.Faces)] for solid in shape.Solids]
    found = [numbers for numbers in found if set(numbers) <= set(meshed)]
    return found or [meshed]


def _run(command: str, nodes, cells, faces, solids, size: float) -> Tuple[Any, Any]:
    """All nodes, those of the surface first, and the tetrahedra."""
    with tempfile.TemporaryDirectory(prefix="advlayers-") as folder:
        _write_msh(os.path.join(folder, "surface.msh"), nodes, cells, faces)
        with open(os.path.join(folder, "volume.geo"), "w", encoding="ascii") as file:
            file.write('Merge "surface.msh";\nMesh.SaveAll = 1;\n')
            file.write(f"Mesh.CharacteristicLengthMax = {size:.9g};\n")
            for number, solid in enumerate(solids, 1):
                loop = ", ".join(map(str, solid))
                file.write(f"Surface Loop({number}) = {{{loop}}};\n"
                           f"Volume({number}) = {{{number}}};\n")
        log, status = _call([command, "volume.geo", "-3", "-format", "msh22", "-o", "volume.msh"],
                            folder)
        path = os.path.join(folder, "volume.msh")
        errors = [line.split(":", 1)[1].strip() for line in log.splitlines()
                  if line.startswith("Error")]
        found = _read_msh(path) if os.path.exists(path) else (nodes, np.zeros((0, 4), int))
    if status or not len(found[1]):
        why = errors[0] if errors else Sentence("no tetrahedron came out, exit status {}",
                                                (status,))
        raise InputError("", "Gmsh cannot fill the mesh: {}", why)
    return _surface_first(nodes, *found)


def _call(command: List[str], folder: str) -> Tuple[str, int]:
    """What the program printed, and its exit status. Like a run of the mesher it lets a window
    show that it goes on, and stop it."""
    log = os.path.join(folder, "log.txt")
    with open(log, "w", encoding="utf-8") as file:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=file,
                                   stderr=subprocess.STDOUT)
        try:
            while process.poll() is None:
                window_watch.get()([])
                time.sleep(_POLL)
        except BaseException:
            process.kill()
            process.wait()
            raise
    with open(log, encoding="utf-8", errors="replace") as file:
        return file.read(), process.returncode


def _surface_first(surface, nodes, tetrahedra) -> Tuple[Any, Any]:
    """Gmsh numbers nodes anew: the surface's go first again, in their order. It writes 16 digits
    of each coordinate, by which they are told."""
    places = {place: i for i, place in enumerate(map(tuple, nodes.tolist()))}
    order = [places.pop(tuple(float(f"{x:.16g}") for x in point), -1)
             for point in surface.tolist()]
    if -1 in order:
        raise InputError("", "Gmsh cannot fill the mesh: it moved the nodes of the surface")
    order += sorted(places.values())
    place = np.empty(len(nodes), int)
    place[order] = np.arange(len(nodes))
    return nodes[order], place[tetrahedra]


def _write_msh(path: str, nodes, cells, faces) -> None:
    """Format 2.2: the CAD face is the elementary entity of its triangles."""
    with open(path, "w", encoding="ascii") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(nodes)}\n")
        for number, point in enumerate(nodes.tolist(), 1):
            file.write("%d %.17g %.17g %.17g\n" % (number, *point))
        file.write(f"$EndNodes\n$Elements\n{len(cells)}\n")
        rows = zip((cells + 1).tolist(), faces.tolist())
        for number, (cell, face) in enumerate(rows, 1):
            file.write("%d %d 2 0 %d %d %d %d\n" % (number, _MSH_TRIANGLE, face, *cell))
        file.write("$EndElements\n")


def _read_msh(path: str) -> Tuple[Any, Any]:
    with open(path, encoding="ascii") as file:
        lines = file.read().splitlines()
    start = lines.index("$Nodes") + 2
    rows = [line.split() for line in lines[start:lines.index("$EndNodes")]]
    index: Dict[int, int] = {int(row[0]): i for i, row in enumerate(rows)}
    nodes = np.array([row[1:4] for row in rows], float)
    start = lines.index("$Elements") + 2
    rows = [line.split() for line in lines[start:lines.index("$EndElements")]]
    cells = [[index[int(node)] for node in row[3 + int(row[2]):]]
             for row in rows if int(row[1]) == _MSH_TETRAHEDRON]
    return nodes, np.array(cells, int).reshape(-1, 4)


def _fem_mesh(mesh, nodes, cells, elements, tetrahedra):
    """Ids from 1 without a gap: triangles of the surface, then tetrahedra."""
    import Fem

    fem = Fem.FemMesh()
    # The surface's own coordinates: Gmsh writes them with fewer digits.
    for number, point in enumerate(mesh.nodes.tolist() + nodes[len(mesh.nodes):].tolist(), 1):
        fem.addNode(*point, number)
    for number, cell in enumerate((cells + 1).tolist(), 1):
        fem.addFace(cell, number)
    cells_of_freecad = tetrahedra[:, _TO_FREECAD] + 1
    for number, cell in enumerate(cells_of_freecad.tolist(), len(cells) + 1):
        fem.addVolume(cell, number)
    parts = mesh_parts.of_mesh(mesh, mesh.named)
    for name, _dimension, members in parts.element_sets(2):
        index = fem.addGroup(name, "Face")
        fem.addGroupElements(index, (np.flatnonzero(np.isin(elements, members - 1)) + 1).tolist())
    for name, members in parts.node_sets(1):
        index = fem.addGroup(name, "Node")
        fem.addGroupElements(index, (members + 1).tolist())
    return fem

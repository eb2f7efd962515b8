"""Fills a skin by Gmsh: with tetrahedra, and a pyramid on each quad."""
from __future__ import annotations

import os
import tempfile
from typing import Any, Callable, Dict, List, Tuple

import numpy as np

from advlayers.errors import InputError
from advlayers.sentence import Sentence
from advlayers.volume.programs import Cells, call
from advlayers.volume.skin import Skin

_TRIANGLE, _QUAD, _TETRAHEDRON, _PYRAMID = 2, 3, 4, 7  # as the format numbers them
_DELAUNAY = 1  # of the algorithms the one that leaves quads as they are


def fill(command: str, skin: Skin, size: float, watch: Callable[[], None]) -> Cells:
    """Raises InputError where Gmsh fails."""
    with tempfile.TemporaryDirectory(prefix="advlayers-") as folder:
        _write_msh(os.path.join(folder, "surface.msh"), skin)
        with open(os.path.join(folder, "volume.geo"), "w", encoding="ascii") as file:
            file.write('Merge "surface.msh";\nMesh.SaveAll = 1;\n')
            file.write(f"Mesh.Algorithm3D = {_DELAUNAY};\n")
            file.write(f"Mesh.CharacteristicLengthMax = {size:.9g};\n")
            for number, solid in enumerate(skin.solids, 1):
                loop = ", ".join(map(str, solid))
                file.write(f"Surface Loop({number}) = {{{loop}}};\n"
                           f"Volume({number}) = {{{number}}};\n")
        log, status = call([command, "volume.geo", "-3", "-format", "msh22", "-o", "volume.msh"],
                           folder, watch)
        path = os.path.join(folder, "volume.msh")
        found = _read_msh(path) if os.path.exists(path) else None
    if status or found is None or not len(found[1][_TETRAHEDRON][0]):
        errors = [line.split(":", 1)[1].strip() for line in log.splitlines()
                  if line.startswith("Error")]
        why = errors[0] if errors else Sentence("no tetrahedron came out, exit status {}",
                                                (status,))
        raise InputError("", "Gmsh cannot fill the mesh: {}", why)
    return _skin_first(skin, *found)


def _write_msh(path: str, skin: Skin) -> None:
    """Format 2.2: the CAD face is the elementary entity of its elements."""
    with open(path, "w", encoding="ascii") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(skin.nodes)}\n")
        for number, point in enumerate(skin.nodes.tolist(), 1):
            file.write("%d %.17g %.17g %.17g\n" % (number, *point))
        file.write(f"$EndNodes\n$Elements\n{len(skin.triangles) + len(skin.quads)}\n")
        number = 0
        for kind, cells, faces in ((_TRIANGLE, skin.triangles, skin.face_of_triangle),
                                   (_QUAD, skin.quads, skin.face_of_quad)):
            row = "%d %d 2 0 %d" + " %d" * cells.shape[1] + "\n"
            for cell, face in zip((cells + 1).tolist(), faces.tolist()):
                number += 1
                file.write(row % (number, kind, face, *cell))
        file.write("$EndElements\n")


def _read_msh(path: str) -> Tuple[Any, Dict[int, Tuple[Any, Any]]]:
    """Nodes; by type the cells and the volume of each."""
    with open(path, encoding="ascii") as file:
        lines = file.read().splitlines()
    start = lines.index("$Nodes") + 2
    rows = [line.split() for line in lines[start:lines.index("$EndNodes")]]
    numbers = np.array([int(row[0]) for row in rows])
    nodes = np.array([row[1:4] for row in rows], float).reshape(-1, 3)
    index = np.zeros(numbers.max(initial=0) + 1, np.int64)
    index[numbers] = np.arange(len(numbers))
    start = lines.index("$Elements") + 2
    found: Dict[int, List[List[int]]] = {_TETRAHEDRON: [], _PYRAMID: []}
    for line in lines[start:lines.index("$EndElements")]:
        row = line.split()
        if int(row[1]) in found:
            found[int(row[1])].append([int(row[4])] + list(map(int, row[3 + int(row[2]):])))
    cells = {}
    for kind, corners in ((_TETRAHEDRON, 4), (_PYRAMID, 5)):
        table = np.array(found[kind], np.int64).reshape(-1, corners + 1)
        cells[kind] = index[table[:, 1:]], table[:, 0]
    return nodes, cells


def _skin_first(skin: Skin, nodes, cells) -> Cells:
    """Gmsh numbers nodes anew, and writes 16 digits of each coordinate, by which they are told. The
    skin's come back as they were."""
    places = {place: i for i, place in enumerate(map(tuple, nodes.tolist()))}
    order = [places.pop(tuple(float(f"{x:.16g}") for x in point), -1)
             for point in skin.nodes.tolist()]
    if -1 in order:
        raise InputError("", "Gmsh cannot fill the mesh: it moved the nodes of the surface")
    inner = sorted(places.values())
    place = np.empty(len(nodes), np.int64)
    place[order + inner] = np.arange(len(nodes))
    (tetrahedra, solid_of_tetrahedron), (pyramids, solid_of_pyramid) = (
        cells[_TETRAHEDRON], cells[_PYRAMID])
    return Cells(np.concatenate([skin.nodes, nodes[inner]]), place[tetrahedra], place[pyramids],
                 solid_of_tetrahedron, solid_of_pyramid)

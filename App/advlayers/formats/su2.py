"""SU2's native meshes: plane domains with a marker per group of edges, volumes with one per group
of faces."""
from __future__ import annotations

import os
from typing import Any, Dict, List

import numpy as np

from advlayers.errors import InputError
from advlayers.formats import plane, sides
from advlayers.formats.mesh_parts import MeshParts, Run
from advlayers.formats.plain_names import plain_names
from advlayers.formats.text_file import TextFile

# VTK's numbers, without VTK's order of the wedge.
_ELEMENTS = {"line2": 3, "tri3": 5, "quad4": 9, "tet4": 10, "hex8": 12, "prism6": 13,
             "pyramid5": 14}
KINDS = frozenset(_ELEMENTS)
_NAME_SIZE = 60


def write(path: str, parts: MeshParts) -> None:
    """Raises InputError for a surface that is no plane domain."""
    dimension = parts.dimension
    points = parts.nodes
    if dimension == 2:
        in_plane = plane.axes(points.min(axis=0), points.max(axis=0))
        if in_plane is None:
            raise InputError("outputs", "SU2 files have plane domains (x, y or z constant) and "
                             "volumes, no surfaces: {}", os.path.basename(path))
        parts = plane.turned_up(parts, in_plane)
        points = points[:, in_plane]
    cells = parts.of(dimension)
    with TextFile(path) as file:
        file.text(f"NDIME= {dimension}\nNELEM= {sum(len(block) for block in cells)}\n")
        first = 0
        for block in cells:
            form = f"{_ELEMENTS[block.kind]}" + " %d" * block.cells.shape[1] + " %d\n"
            file.rows(form, block.cells, np.arange(first, first + len(block)))
            first += len(block)
        file.text(f"NPOIN= {len(points)}\n")
        file.rows("%r " * dimension + "%d\n", points, np.arange(len(points)))
        _write_markers(file, _markers(parts, dimension - 1))


def _markers(parts: MeshParts, dimension: int) -> Dict[str, List[Any]]:
    """By name the elements on the border; what lies inside is none."""
    owners = parts.owners(dimension)
    found: Dict[str, List[Any]] = {}
    for run in parts.by_part(dimension):
        _element, _place, count = sides.find(parts, [(run.kind, run.cells)])
        cells = run.cells[count == 1]
        if len(cells):
            found.setdefault(owners[run.part], []).append(Run(run.part, run.kind, count, cells))
    return found


def _write_markers(file: TextFile, markers: Dict[str, List[Any]]) -> None:
    plain = plain_names(markers, _NAME_SIZE)
    file.text(f"NMARK= {len(markers)}\n")
    for name, runs in markers.items():
        file.text(f"MARKER_TAG= {plain[name]}\n"
                  f"MARKER_ELEMS= {sum(len(run.cells) for run in runs)}\n")
        for run in runs:
            file.rows(f"{_ELEMENTS[run.kind]}" + " %d" * run.cells.shape[1] + "\n", run.cells)

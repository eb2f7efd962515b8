"""STL as text, for its names: a solid per part of the surface, quads cut in two."""
from __future__ import annotations

from typing import Dict, List

import numpy as np

from advlayers.formats.mesh_parts import MeshParts
from advlayers.formats.plain_names import plain_names
from advlayers.formats.text_file import TextFile
from advlayers.triangle_mesh import halves_of_quads

KINDS = frozenset({"tri3", "quad4"})
_NAME_SIZE = 80


def write(path: str, parts: MeshParts) -> None:
    owners = parts.owners(2)
    plain = plain_names(owners.values(), _NAME_SIZE)
    solids: Dict[str, List[np.ndarray]] = {}
    for run in parts.by_part(2):
        cells = run.cells if run.kind == "tri3" else halves_of_quads(parts.nodes, run.cells)
        solids.setdefault(owners[run.part], []).append(cells)
    with TextFile(path) as file:
        for name, cells in solids.items():
            file.text(f"solid {plain[name]}\n")
            for triangles in cells:
                _write_triangles(file, parts.nodes[triangles])
            file.text(f"endsolid {plain[name]}\n")


def _write_triangles(file: TextFile, corners) -> None:
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0.0)
    file.rows("facet normal %r %r %r\nouter loop\n" + "vertex %r %r %r\n" * 3
              + "endloop\nendfacet\n", normals, corners.reshape(-1, 9))

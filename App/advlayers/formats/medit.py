"""Medit's .mesh as text: references are the numbers of CAD faces, edges and solids."""
from __future__ import annotations

from typing import Dict, Tuple

from advlayers.formats.mesh_parts import MeshParts
from advlayers.formats.text_file import TextFile

# In the order of the file.
_KEYWORDS: Dict[str, Tuple[str, Tuple[int, ...]]] = {
    "line2": ("Edges", (0, 1)), "line3": ("EdgesP2", (0, 1, 2)),
    "tri3": ("Triangles", (0, 1, 2)), "tri6": ("TrianglesP2", tuple(range(6))),
    "quad4": ("Quadrilaterals", (0, 1, 2, 3)), "quad9": ("QuadrilateralsQ2", tuple(range(9))),
    "tet4": ("Tetrahedra", (0, 1, 2, 3)), "tet10": ("TetrahedraP2", tuple(range(10))),
    "pyramid5": ("Pyramids", tuple(range(5))),
    "prism6": ("Prisms", tuple(range(6))), "hex8": ("Hexahedra", tuple(range(8))),
}
KINDS = frozenset(_KEYWORDS)


def write(path: str, parts: MeshParts) -> None:
    with TextFile(path) as file:
        file.text(f"MeshVersionFormatted 2\n\nDimension 3\n\nVertices\n{len(parts.nodes)}\n")
        file.rows("%r %r %r 0\n", parts.nodes)
        for kind, (keyword, order) in _KEYWORDS.items():
            blocks = [block for block in parts.blocks if block.kind == kind]
            if blocks:
                file.text(f"\n{keyword}\n{sum(len(block) for block in blocks)}\n")
            for block in blocks:
                file.rows("%d " * len(order) + "%d\n", block.cells[:, order] + 1, block.part)
        file.text("\nEnd\n")

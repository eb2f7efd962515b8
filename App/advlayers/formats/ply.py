"""PLY as text: polygons with the number of their CAD face."""
from __future__ import annotations

from advlayers.formats.mesh_parts import MeshParts
from advlayers.formats.text_file import TextFile

KINDS = frozenset({"tri3", "quad4"})


def write(path: str, parts: MeshParts) -> None:
    surface = parts.of(2)
    with TextFile(path) as file:
        file.text(f"ply\nformat ascii 1.0\ncomment Advancing Layers\n"
                  f"element vertex {len(parts.nodes)}\n"
                  "property double x\nproperty double y\nproperty double z\n"
                  f"element face {sum(len(block) for block in surface)}\n"
                  "property list uchar int vertex_indices\nproperty int face\nend_header\n")
        file.rows("%r %r %r\n", parts.nodes)
        for block in surface:
            width = block.cells.shape[1]
            file.rows(f"{width}" + " %d" * (width + 1) + "\n", block.cells, block.part)

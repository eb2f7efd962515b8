"""Wavefront OBJ: a group per part of the surface, lines of the edges that are in groups."""
from __future__ import annotations

from advlayers.formats.mesh_parts import MeshParts
from advlayers.formats.plain_names import plain_names
from advlayers.formats.text_file import TextFile

KINDS = frozenset({"line2", "tri3", "quad4"})
_NAME_SIZE = 200


def write(path: str, parts: MeshParts) -> None:
    grouped = set(parts.grouped(1))
    owners = {dimension: parts.owners(dimension) for dimension in (1, 2)}
    plain = plain_names([*owners[2].values(), *owners[1].values()], _NAME_SIZE)
    with TextFile(path) as file:
        file.rows("v %r %r %r\n", parts.nodes)
        for dimension, letter in ((2, "f"), (1, "l")):
            for run in parts.by_part(dimension):
                if dimension == 2 or run.part in grouped:
                    file.text(f"g {plain[owners[dimension][run.part]]}\n")
                    file.rows(letter + " %d" * run.cells.shape[1] + "\n", run.cells + 1)

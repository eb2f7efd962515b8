"""A closed surface mesh as the programs that fill volumes take it."""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, List, Sequence, Tuple

import numpy as np

from advlayers.errors import InputError
from advlayers.formats.mesh_parts import Block, MeshParts
from advlayers.triangle_mesh import halves_of_quads


@dataclass(frozen=True)
class Skin:
    nodes: Any  # (n, 3) [mm], all of them corners
    triangles: Any  # (t, 3) indices into the nodes
    quads: Any  # (q, 4)
    face_of_triangle: Any  # number of the CAD face
    face_of_quad: Any
    solids: Tuple[Tuple[int, ...], ...]  # the faces around each volume, those of cavities too


def check_closed(parts: MeshParts, label: str) -> None:
    """Raises InputError where a side of an element has no neighbour."""
    sides = np.concatenate([
        block.cells[:, [k, (k + 1) % count]] for block in parts.of(2)
        for count in [_corners(block)] for k in range(count)])
    unique, counts = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
    open_sides = unique[counts < 2]
    if len(open_sides):
        place = parts.nodes[open_sides[0]].mean(axis=0)
        raise InputError("", "{} is not closed: {} sides of elements have no neighbour, one at "
                         "({}, {}, {})", label, len(open_sides), f"{place[0]:.6g}",
                         f"{place[1]:.6g}", f"{place[2]:.6g}")


def _corners(block: Block) -> int:
    return 4 if block.kind.startswith("quad") else 3


def in_triangles(parts: MeshParts) -> MeshParts:
    """Each quad cut in two, without a new node."""
    quads = [block for block in parts.of(2) if block.kind == "quad4"]
    if not quads:
        return parts
    made: List[Block] = []
    for block in parts.blocks:
        if block.kind != "quad4":
            made.append(block)
            continue
        made.append(Block("tri3", halves_of_quads(parts.nodes, block.cells),
                          np.repeat(block.part, 2), np.repeat(block.layers, 2)))
    triangles = [block for block in made if block.kind == "tri3"]
    one = Block("tri3", *(np.concatenate([getattr(block, name) for block in triangles])
                          for name in ("cells", "part", "layers")))
    return replace(parts, blocks=(one,) + tuple(b for b in made if b.kind != "tri3"))


def skin_of(parts: MeshParts, solids: Sequence[Sequence[int]]) -> Tuple[Skin, Any]:
    """Of a mesh of first order, and the numbers of its nodes in the mesh. Without solids all faces
    are around one volume."""
    meshed = set(parts.part_numbers(2))
    whole = [tuple(faces) for faces in solids if set(faces) <= meshed]
    found = {block.kind: block for block in parts.of(2)}
    triangles = found.get("tri3", Block("tri3", np.zeros((0, 3), int), np.zeros(0, int)))
    quads = found.get("quad4", Block("quad4", np.zeros((0, 4), int), np.zeros(0, int)))
    used = np.unique(np.concatenate([triangles.cells.ravel(), quads.cells.ravel()]))
    skin = Skin(parts.nodes[used], np.searchsorted(used, triangles.cells),
                np.searchsorted(used, quads.cells), triangles.part, quads.part,
                tuple(whole) or (tuple(sorted(meshed)),))
    return skin, used

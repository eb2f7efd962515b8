"""Plane domains: meshes all of whose nodes lie in a plane x, y or z = constant."""
from __future__ import annotations

from dataclasses import replace
from typing import Optional, Tuple

import numpy as np

from advlayers.formats.mesh_parts import KINDS, Block, MeshParts

# Of the diagonal of the mesh.
_FLAT = 1e-9


def axes(low, high, flat: float = _FLAT) -> Optional[Tuple[int, int]]:
    """The two axes of the plane between these corners of a bounding box, `flat` of the diagonal
    being nothing; None where there is none."""
    size = np.asarray(high, float) - np.asarray(low, float)
    thin = np.flatnonzero(size <= flat * np.linalg.norm(size))
    if len(thin) != 1:
        return None
    return ((1, 2), (0, 2), (0, 1))[int(thin[0])]


def turned_up(parts: MeshParts, plane: Tuple[int, int]) -> MeshParts:
    """All surface elements counter-clockwise in the plane, whichever way its CAD face looks."""
    points = parts.nodes[:, plane]
    return parts.with_blocks(
        _turned_up(block, points) if block.dimension == 2 else block for block in parts.blocks)


def _turned_up(block: Block, points) -> Block:
    kind = KINDS[block.kind]
    corners = points[block.cells[:, :kind.corners]]
    ahead = np.roll(corners, -1, axis=1)
    area = (corners[..., 0] * ahead[..., 1] - corners[..., 1] * ahead[..., 0]).sum(axis=1)
    over = area < 0.0
    if not over.any():
        return block
    # The first corner stays; sides, with the nodes on them, follow backwards.
    places = np.arange(kind.nodes)
    places[1:kind.corners] = places[1:kind.corners][::-1]
    if kind.sides and kind.nodes > kind.corners:
        places[kind.corners:2 * kind.corners] = places[kind.corners:2 * kind.corners][::-1]
    cells = np.where(over[:, None], block.cells[:, places], block.cells)
    return replace(block, cells=cells)

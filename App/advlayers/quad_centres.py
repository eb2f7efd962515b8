"""Quads of nine nodes: those of eight with one in the middle, on the CAD face."""
from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, Tuple

import numpy as np

from advlayers.formats.mesh_parts import Block, MeshParts

# By number of a CAD face: points near to it -> the nearest points of the face.
Project = Callable[[int, Any], Any]

# The nodes of the quad: corners, middles of sides, centre.
_PLACES = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (0, -1), (1, 0), (0, 1), (-1, 0), (0, 0)])


def added(parts: MeshParts, project: Project) -> MeshParts:
    """A centre that would turn its quad over at a node stays where the quad of eight nodes has its
    own."""
    nodes = parts.nodes
    blocks, fields = [], {"node_layer": 0, "node_parent": -1}
    for block in parts.blocks:
        if block.kind == "quad8":
            numbers = len(nodes) + np.arange(len(block))
            nodes = np.concatenate([nodes, _centres(parts.nodes, block, project)])
            block = replace(block, kind="quad9", cells=np.column_stack([block.cells, numbers]))
        blocks.append(block)
    more = len(nodes) - len(parts.nodes)
    known = {name: np.concatenate([getattr(parts, name), np.full(more, value, np.int32)])
             for name, value in fields.items() if getattr(parts, name) is not None}
    return replace(parts, nodes=nodes, blocks=tuple(blocks), **known)


def _centres(nodes, block: Block, project: Project):
    corners, mids = nodes[block.cells[:, :4]], nodes[block.cells[:, 4:]]
    plain = mids.sum(axis=1) / 2.0 - corners.sum(axis=1) / 4.0
    centres = plain.copy()
    for face in np.unique(block.part).tolist():
        own = block.part == face
        centres[own] = project(face, plain[own])
    turned = least_area(np.concatenate([corners, mids, centres[:, None]], axis=1)) <= 0.0
    centres[turned] = plain[turned]
    return centres


def least_area(points):
    """(m,) of (m, 9, 3): the least area per parameter at a node, along the mean normal."""
    along, across = (np.einsum("np,mpx->mnx", table, points) for table in _slopes())
    normals = np.cross(along, across)
    mean = normals.mean(axis=1)
    mean /= np.linalg.norm(mean, axis=1)[:, None]
    return np.einsum("mnx,mx->mn", normals, mean).min(axis=1)


def _slopes() -> Tuple[Any, Any]:
    """(9, 9) each: the derivative of the shape function of a node at another, in both parameters.
    """
    value = {-1: lambda s: s * (s - 1) / 2, 0: lambda s: 1 - s * s, 1: lambda s: s * (s + 1) / 2}
    slope = {-1: lambda s: s - 0.5, 0: lambda s: -2 * s, 1: lambda s: s + 0.5}
    along = [[slope[a](s) * value[b](t) for a, b in _PLACES.tolist()] for s, t in _PLACES]
    across = [[value[a](s) * slope[b](t) for a, b in _PLACES.tolist()] for s, t in _PLACES]
    return np.array(along), np.array(across)

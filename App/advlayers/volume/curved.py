"""Tetrahedra of ten nodes within a skin of second order."""
from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, Dict, NamedTuple, Tuple

import numpy as np

from advlayers.formats.mesh_parts import KINDS, SECOND_ORDER, Block, MeshParts

_EDGES = KINDS["tet10"].sides
_LEAST_JACOBIAN = 0.1  # of the straight cell's, at every node
_EASINGS = 4  # steps in which a mid node is drawn back to the middle of its chord

# By number of a CAD face: points near to it -> the nearest points of the face.
Project = Callable[[int, Any], Any]


class Curved(NamedTuple):
    parts: MeshParts
    off_shape: int  # mid nodes of the skin that had to be drawn back
    furthest: float  # [mm]


def with_mid_nodes(skin: MeshParts, cut: MeshParts, nodes, tetrahedra, solids,
                   project: Project) -> Curved:
    """`skin`: the mesh of second order; `cut`: its corners in triangles, in the same nodes;
    `tetrahedra`: in `nodes`, those of the skin first. A mid node on a diagonal that cut a quad is
    put on the shape. Where the shape bends a cell so far that it would be turned over at a node,
    the skin's mid nodes are drawn back."""
    edges, edge_of = _edges(tetrahedra)
    middle = nodes[edges].mean(axis=1)
    mids = middle.copy()
    on_skin = _place_on_skin(skin, cut, nodes, edges, mids, project)
    eased = _ease(nodes, tetrahedra, edge_of, middle, mids, on_skin)
    moved = np.linalg.norm(eased - mids, axis=1)

    bent = {tuple(edge): i for i, edge in enumerate(edges.tolist())}
    first = len(nodes)
    cells = np.concatenate([tetrahedra, first + edge_of], axis=1)
    blocks = [*(_raised(block, bent, first) for block in cut.of(2)), Block("tet10", cells, solids),
              *(_raised(block, bent, first) for block in cut.of(1))]
    parts = replace(cut, nodes=np.concatenate([nodes, eased]), blocks=tuple(blocks))
    return Curved(parts, int((moved > 0.0).sum()), float(moved.max(initial=0.0)))


def _edges(tetrahedra) -> Tuple[Any, Any]:
    """(e, 2) ascending, and which of them the six of each cell are."""
    ends = np.sort(np.concatenate([tetrahedra[:, list(pair)] for pair in _EDGES]), axis=1)
    unique, inverse = np.unique(ends, axis=0, return_inverse=True)
    return unique, inverse.reshape(6, len(tetrahedra)).T


def _place_on_skin(skin: MeshParts, cut: MeshParts, nodes, edges, mids, project: Project):
    """Moves the mid nodes on the skin to where they belong; returns which edges these are."""
    known: Dict[Tuple[int, int], int] = {}
    for block in skin.of(2):
        kind = KINDS[block.kind]
        for k, (a, b) in enumerate(kind.sides):
            pairs = np.sort(block.cells[:, [a, b]], axis=1)
            known.update(zip(map(tuple, pairs.tolist()),
                             block.cells[:, kind.corners + k].tolist()))
    index = {tuple(edge): i for i, edge in enumerate(edges.tolist())}
    on_skin = np.zeros(len(edges), bool)
    free: Dict[int, Dict[int, None]] = {}  # by CAD face, the edges to be put on it
    for block in cut.of(2):
        for a, b in ((0, 1), (1, 2), (2, 0)):
            pairs = np.sort(block.cells[:, [a, b]], axis=1)
            for pair, face in zip(map(tuple, pairs.tolist()), block.part.tolist()):
                edge = index[pair]
                on_skin[edge] = True
                if pair in known:
                    mids[edge] = skin.nodes[known[pair]]
                else:
                    free.setdefault(face, {})[edge] = None
    for face, found in sorted(free.items()):
        chosen = list(found)
        mids[chosen] = project(face, mids[chosen])
    return on_skin


def _ease(nodes, tetrahedra, edge_of, middle, mids, on_skin):
    share = np.zeros(len(mids), int)  # steps back
    at = mids.copy()
    suspect = np.flatnonzero(on_skin[edge_of].any(axis=1))
    for _ in range(2 * _EASINGS):
        bad = suspect[_least_jacobian(nodes, tetrahedra[suspect], at[edge_of[suspect]])
                      < _LEAST_JACOBIAN]
        edges = np.unique(edge_of[bad])
        edges = edges[on_skin[edges] & (share[edges] < _EASINGS)]
        if not len(edges):
            break
        share[edges] += 1
        part = (share[edges] / _EASINGS)[:, None]
        at[edges] = (1.0 - part) * mids[edges] + part * middle[edges]
    return at


def _least_jacobian(nodes, cells, mids):
    """(t,) least over the ten nodes, as a part of the straight cell's."""
    corners = nodes[cells]
    straight = _determinant(*(corners[:, k] - corners[:, 0] for k in (1, 2, 3)))
    places = list(np.eye(4)) + [(np.eye(4)[a] + np.eye(4)[b]) / 2.0 for a, b in _EDGES]
    least = np.full(len(cells), np.inf)
    for place in places:
        slopes = [corners[:, k] * (4.0 * place[k] - 1.0) for k in range(4)]
        for m, (a, b) in enumerate(_EDGES):
            slopes[a] = slopes[a] + 4.0 * place[b] * mids[:, m]
            slopes[b] = slopes[b] + 4.0 * place[a] * mids[:, m]
        found = _determinant(*(slopes[k] - slopes[0] for k in (1, 2, 3)))
        least = np.minimum(least, found / straight)
    return least


def _determinant(a, b, c):
    return np.einsum("ij,ij->i", np.cross(a, b), c)


def _raised(block: Block, bent: Dict[Tuple[int, int], int], first: int) -> Block:
    """A triangle or a line with the mid nodes of its sides."""
    kind = SECOND_ORDER[block.kind]
    mids = np.stack([[first + bent[tuple(pair)]
                      for pair in np.sort(block.cells[:, list(side)], axis=1).tolist()]
                     for side in KINDS[kind].sides], axis=1)
    return replace(block, kind=kind, cells=np.concatenate([block.cells, mids], axis=1))

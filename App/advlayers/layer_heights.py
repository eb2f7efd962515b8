"""How well the layers of a finished mesh keep the heights that were asked for."""
from __future__ import annotations

import numpy as np


def height_errors(mesh):
    """(q + t,) height of each element over the one asked for, less 1; quads first, NaN in the core
    and where no parent-kid edge bounds the element.

    The height is that of the element's kids over its side at the parents, square to it: where the
    front has a corner, the edge to the kid is longer. The mean of all kids; asked for is
    first_height * growth^k of the wall that the column stands on (the mean of both walls at a
    corner)."""
    asked_first, growth = _wall_of_root(mesh)
    parent = np.asarray(mesh.node_parent)
    root = np.arange(len(parent))
    for _ in range(int(np.max(mesh.node_layer, initial=0))):
        root = np.where(parent[root] >= 0, parent[root], root)
    layer = np.asarray(mesh.node_layer)
    asked = asked_first[root] * growth[root] ** np.maximum(layer - 1, 0)
    return np.concatenate([_of_elements(mesh.nodes, cells, layers, parent, asked)
                           for cells, layers in ((mesh.quads, mesh.layer_of_quad),
                                                 (mesh.triangles, mesh.layer_of_triangle))])


def _wall_of_root(mesh):
    """First height asked for [mm] and growth by node; NaN for nodes on no wall."""
    count = len(mesh.nodes)
    heights, growths, walls = np.zeros(count), np.zeros(count), np.zeros(count)
    for wall in mesh.walls:
        segments = np.asarray(mesh.edge_segments[int(wall["edge"][4:])])
        nodes = np.concatenate([segments[:1, 0], segments[:, 1]])
        asked = np.asarray(wall["first_heights"] or [wall["first_height"]] * len(nodes))
        nodes, first = np.unique(nodes, return_index=True)  # a closed edge ends where it began
        heights[nodes] += asked[first]
        growths[nodes] += wall["growth"]
        walls[nodes] += 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        return heights / walls, growths / walls


def _of_elements(nodes, cells, layers, parent, asked):
    """The mean error over the kids whose parent is a corner of the element too."""
    total, kids = np.zeros(len(cells)), np.zeros(len(cells))
    corners = cells.shape[1]
    for k in range(corners):
        foot, ahead, behind = cells[:, k], cells[:, (k + 1) % corners], cells[:, k - 1]
        for kid, along in ((ahead, behind), (behind, ahead)):
            at = np.flatnonzero((parent[kid] == foot) & np.isfinite(asked[kid]))
            start = nodes[foot[at]]
            height = _distance(nodes[kid[at]] - start, nodes[along[at]] - start)
            total[at] += height / asked[kid[at]] - 1.0
            kids[at] += 1.0
    known = (kids > 0) & (np.asarray(layers) > 0)
    return np.where(known, total / np.maximum(kids, 1.0), np.nan)


def _distance(points, along):
    """Of points from the lines through the origin in the directions `along`."""
    area = np.linalg.norm(np.cross(points, along), axis=1)
    return area / np.maximum(np.linalg.norm(along, axis=1), np.finfo(float).tiny)

"""How well the layers of a finished mesh keep the heights that were asked for."""
from __future__ import annotations

import numpy as np


def height_errors(mesh):
    """(q + t,) height of each element over the one asked for, less 1; quads first, NaN in the core
    and where no parent-kid edge bounds the element.

    The height is the mean length of the element's parent-kid edges; asked for is first_height *
    growth^k of the wall that its column stands on (the mean of both walls at a corner)."""
    asked_first, growth = _wall_of_root(mesh)
    parent = np.asarray(mesh.node_parent)
    root = np.arange(len(parent))
    for _ in range(int(np.max(mesh.node_layer, initial=0))):
        root = np.where(parent[root] >= 0, parent[root], root)
    layer = np.asarray(mesh.node_layer)
    asked = asked_first[root] * growth[root] ** np.maximum(layer - 1, 0)
    length = np.where(parent >= 0,
                      np.linalg.norm(mesh.nodes - mesh.nodes[parent], axis=1), np.nan)
    with np.errstate(divide="ignore", invalid="ignore"):
        error = length / asked - 1.0
    return np.concatenate([_of_elements(cells, layers, parent, error)
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


def _of_elements(cells, layers, parent, error):
    """The mean error of the sides that are parent-kid edges."""
    total, sides = np.zeros(len(cells)), np.zeros(len(cells))
    for k in range(cells.shape[1]):
        a, b = cells[:, k], cells[:, k - 1]
        for kid, other in ((a, b), (b, a)):
            side = (parent[kid] == other) & np.isfinite(error[kid])
            total += np.where(side, error[kid], 0.0)
            sides += side
    known = (sides > 0) & (np.asarray(layers) > 0)
    return np.where(known, total / np.maximum(sides, 1.0), np.nan)

"""Finds the elements of a mesh that lie in gaps of its border narrower than a given width."""
from __future__ import annotations

import numpy as np

from mesh_checks import Elements


def in_gaps(elements: Elements, normals: np.ndarray, width: float) -> np.ndarray:
    """Mask of the elements in gaps below `width` [mm]; `normals` of the surface at the nodes.

    A gap is where two stretches of border face each other (inward normals more than 120 degrees
    apart) that do not run into a common corner. Elements lie in it with their centroid, or with all
    of their nodes on the border and one of them there.
    """
    border = elements.border()
    nodes = elements.nodes
    start, vector = nodes[border[:, 0]], nodes[border[:, 1]] - nodes[border[:, 0]]
    lengths = np.linalg.norm(vector, axis=1)
    inward = np.cross(normals[border[:, 0]], vector / lengths[:, None])
    pieces = np.maximum(2, np.ceil(lengths / (0.25 * width)).astype(int))
    segment = np.repeat(np.arange(len(border)), pieces)
    offset = np.arange(len(segment)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    points = start[segment] + ((offset + 0.5) / pieces[segment])[:, None] * vector[segment]
    facing = inward[segment]
    place, length, ring = _along_border(border, lengths)
    at = place[segment] + (offset + 0.5) / pieces[segment] * lengths[segment]
    middles, halves = [], []
    near_gap = np.zeros(len(nodes), bool)
    for i in range(len(points)):
        towards = points - points[i]
        distance = np.linalg.norm(towards, axis=1)
        close = np.flatnonzero((distance < width) & (facing @ facing[i] < -0.5)
                               & (towards @ facing[i] > 0.5 * distance))
        if len(close):  # along the border, a corner's two sides are about as near as across
            way = np.abs(at[close] - at[i])
            same = ring[segment[close]] == ring[segment[i]]
            way = np.where(same, np.minimum(way, length[ring[segment[i]]] - way), np.inf)
            close = close[way > 6.0 * width]
        if len(close):
            j = close[distance[close].argmin()]
            middles.append(0.5 * (points[i] + points[j]))
            halves.append(max(0.5 * distance[j], 0.25 * width))
            near_gap[border[segment[i]]] = True
    found = np.zeros(len(elements), bool)
    if not middles:
        return found
    centroids = elements.centroids()
    for middle, half in zip(middles, halves):
        found |= np.linalg.norm(centroids - middle, axis=1) <= half
    on_border = np.zeros(len(nodes), bool)
    on_border[border] = True
    corners = elements.corners
    return found | (on_border[corners].all(axis=1) & near_gap[corners].any(axis=1))


def _along_border(border: np.ndarray, lengths: np.ndarray):
    """Place of each border edge along its ring [mm], the rings' lengths, and each edge's ring."""
    after = {int(edge[0]): i for i, edge in enumerate(border)}
    place, ring = np.zeros(len(border)), np.full(len(border), -1)
    totals = []
    for first in range(len(border)):
        i, way = first, 0.0
        while ring[i] < 0:
            ring[i], place[i] = len(totals), way
            way += lengths[i]
            i = after[int(border[i, 1])]
        if way > 0.0:
            totals.append(way)
    return place, np.array(totals), ring

"""Quads as two triangles each, for what knows triangles only."""
from __future__ import annotations

import numpy as np


def triangles_of(mesh):
    """(2 q + t, 3) node indices and the element (quads first, from 0) of each."""
    count = len(mesh.quads)
    cells = np.concatenate([halves_of_quads(mesh.nodes, mesh.quads), mesh.triangles])
    elements = np.concatenate([np.repeat(np.arange(count), 2),
                               np.arange(count, count + len(mesh.triangles))])
    return cells, elements


def halves_of_quads(nodes, quads):
    """(2 q, 3): every quad cut along the diagonal whose smallest angle is the larger, so that no
    part of it is lost."""
    first = _halves(quads, (0, 1, 2), (0, 2, 3))
    second = _halves(quads, (0, 1, 3), (1, 2, 3))
    better = _smallest_angle(nodes, first) >= _smallest_angle(nodes, second)
    return np.where(better[:, None, None], first, second).reshape(-1, 3)


def _halves(quads, one, other):
    return np.stack([quads[:, one], quads[:, other]], axis=1)


def _smallest_angle(nodes, halves):
    """(q,) over the six corners of both triangles [rad]"""
    points = nodes[halves]
    ahead = np.roll(points, -1, axis=2) - points
    back = np.roll(points, 1, axis=2) - points
    sine = np.linalg.norm(np.cross(ahead, back), axis=3)
    angle = np.arctan2(sine, np.einsum("qhcx,qhcx->qhc", ahead, back))
    return angle.reshape(len(halves), -1).min(axis=1) if len(halves) else np.zeros(0)

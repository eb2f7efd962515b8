"""Fills a skin of triangles by Netgen, in a process of its own: a fault there costs no document."""
from __future__ import annotations

import os
import tempfile
from typing import Callable, List

import numpy as np

from advlayers.errors import InputError
from advlayers.sentence import Sentence
from advlayers.volume.programs import Cells, call
from advlayers.volume.skin import Skin

_CHILD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "netgen_child.py")


def fill(python: str, skin: Skin, size: float, watch: Callable[[], None]) -> Cells:
    """Raises InputError where Netgen fails, or for quads: it has no pyramids."""
    if len(skin.quads):
        raise InputError("volume.quads", "Netgen cannot keep quads: install Gmsh, or split them")
    nodes, cells, solids = [skin.nodes], [], []
    count = len(skin.nodes)
    for number, faces in enumerate(skin.solids, 1):
        around = skin.triangles[np.isin(skin.face_of_triangle, faces)]
        inner, tetrahedra = _fill_one(python, skin.nodes, outward(skin.nodes, around), size, watch)
        own = tetrahedra >= len(skin.nodes)
        tetrahedra[own] += count - len(skin.nodes)
        nodes.append(inner)
        count += len(inner)
        cells.append(tetrahedra)
        solids.append(np.full(len(tetrahedra), number))
    return Cells(np.concatenate(nodes), np.concatenate(cells), np.zeros((0, 5), np.int64),
                 np.concatenate(solids), np.zeros(0, np.int64))


def _fill_one(python: str, nodes, triangles, size: float, watch: Callable[[], None]):
    with tempfile.TemporaryDirectory(prefix="advlayers-") as folder:
        used = np.unique(triangles)
        np.savez(os.path.join(folder, "skin.npz"), points=nodes[used], size=size,
                 triangles=np.searchsorted(used, triangles))
        log, status = call([python, _CHILD, "skin.npz", "cells.npz"], folder, watch)
        path = os.path.join(folder, "cells.npz")
        if status or not os.path.exists(path):
            lines = [line.strip() for line in log.splitlines() if line.strip()]
            why = lines[-1] if lines else Sentence("no tetrahedron came out, exit status {}",
                                                   (status,))
            raise InputError("", "Netgen cannot fill the mesh: {}", why)
        with np.load(path) as found:
            points, tetrahedra = found["points"], found["tetrahedra"]
    place = np.concatenate([used, len(nodes) + np.arange(len(points) - len(used))])
    return points[len(used):], place[tetrahedra]


def outward(nodes, triangles):
    """The triangles around one volume, turned so that all look out of it: a face between two solids
    looks out of one of them only."""
    triangles = triangles.copy()
    for shell in _shells(triangles):
        _turn_alike(triangles, shell)
    shells = _shells(triangles)
    volumes = [float(np.einsum("ij,ij->", *_moments(nodes, triangles[shell]))) for shell in shells]
    largest = int(np.argmax(np.abs(volumes)))
    for k, shell in enumerate(shells):
        if (volumes[k] > 0.0) != (k == largest):
            triangles[shell] = triangles[shell][:, [0, 2, 1]]
    return triangles


def _moments(nodes, triangles):
    a, b, c = (nodes[triangles[:, k]] for k in range(3))
    return a - nodes[0], np.cross(b - nodes[0], c - nodes[0])


def _neighbours(triangles):
    """Pairs of triangles that share a side, and whether they run along it the same way."""
    sides = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    owner = np.tile(np.arange(len(triangles)), 3)
    low, high = sides.min(axis=1), sides.max(axis=1)
    order = np.lexsort([high, low])
    same = (low[order][1:] == low[order][:-1]) & (high[order][1:] == high[order][:-1])
    first, second = order[:-1][same], order[1:][same]
    return owner[first], owner[second], sides[first, 0] == sides[second, 0]


def _shells(triangles) -> List[np.ndarray]:
    """The triangles of each connected part."""
    one, other, _alike = _neighbours(triangles)
    label = np.arange(len(triangles))
    while True:
        least = np.minimum(label[one], label[other])
        before = label.copy()
        np.minimum.at(label, one, least)
        np.minimum.at(label, other, least)
        label = label[label]
        if (label == before).all():
            return [np.flatnonzero(label == number) for number in np.unique(label)]


def _turn_alike(triangles, shell) -> None:
    """So that neighbours run along their common side in opposite ways."""
    one, other, alike = _neighbours(triangles[shell])
    if not alike.any():
        return
    reached = np.zeros(len(shell), bool)
    turned = np.zeros(len(shell), bool)
    reached[0] = True
    while True:
        ahead = (reached[one] & ~reached[other]) | (reached[other] & ~reached[one])
        if not ahead.any():
            break
        for a, b, same in zip(one[ahead].tolist(), other[ahead].tolist(), alike[ahead].tolist()):
            if reached[b]:
                a, b = b, a
            if not reached[b]:
                turned[b] = turned[a] ^ same
                reached[b] = True
    triangles[shell[turned]] = triangles[shell[turned]][:, [0, 2, 1]]

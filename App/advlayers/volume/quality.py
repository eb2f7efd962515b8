"""How good volume cells are: their volumes, by sign, and the angles between their sides."""
from __future__ import annotations

from typing import Any, Dict

import numpy as np

SLIVER = 5.0  # [deg] a tetrahedron with an angle between two sides below this is one
_EDGES = ((0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2), (1, 2, 0, 3), (1, 3, 2, 0), (2, 3, 0, 1))
# A pyramid has four corners at its base, each with a tetrahedron up to the tip.
_BASE_CORNERS = ((0, 1, 3, 4), (1, 2, 0, 4), (2, 3, 1, 4), (3, 0, 2, 4))


def tetrahedron_volumes(nodes, cells):
    """(t,) [mm^3], positive where the first three corners turn counter-clockwise as seen from
    inside."""
    a, b, c, d = (nodes[cells[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6.0


def least_pyramid_volumes(nodes, cells):
    """(p,) of the tetrahedra at the corners of each base the least: a pyramid is sound where it is
    positive."""
    return np.min([tetrahedron_volumes(nodes, cells[:, corner]) for corner in _BASE_CORNERS],
                  axis=0) if len(cells) else np.zeros(0)


def pyramid_volumes(nodes, cells):
    """The mean over both cuts of the base."""
    cuts = [tetrahedron_volumes(nodes, cells[:, corner]) for corner in _BASE_CORNERS]
    return sum(cuts) / 2.0 if len(cells) else np.zeros(0)


def dihedral_angles(nodes, cells):
    """(t, 6) [deg], between the sides at each edge of a tetrahedron."""
    angles = np.empty((len(cells), 6))
    for k, (a, b, c, d) in enumerate(_EDGES):
        start = nodes[cells[:, a]]
        along = nodes[cells[:, b]] - start
        one = np.cross(along, nodes[cells[:, c]] - start)
        other = np.cross(along, nodes[cells[:, d]] - start)
        sine = np.linalg.norm(np.cross(one, other), axis=1)
        angles[:, k] = np.degrees(np.arctan2(sine, np.einsum("ij,ij->i", one, other)))
    return angles


def figures(nodes, tetrahedra, pyramids) -> Dict[str, Any]:
    """As the report has them."""
    angles = dihedral_angles(nodes, tetrahedra) if len(tetrahedra) else np.full((1, 6), 90.0)
    slivers = int((angles.min(axis=1) < SLIVER).sum())
    volumes = [tetrahedron_volumes(nodes, tetrahedra), pyramid_volumes(nodes, pyramids)]
    return {
        "tetrahedra": len(tetrahedra), "pyramids": len(pyramids),
        "volume": float(sum(part.sum() for part in volumes)),
        "min_dihedral_angle": float(angles.min()), "max_dihedral_angle": float(angles.max()),
        "slivers": slivers,
        "sliver_percent": 100.0 * slivers / max(1, len(tetrahedra)),
    }

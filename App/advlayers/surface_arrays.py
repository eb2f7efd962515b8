"""The surface of a mesh of any elements, as points and triangles."""
from __future__ import annotations

from typing import Any, Iterable, List, Mapping, Tuple

import numpy as np

# By the number of corners: the sides of a solid element, as places of its corners.
_SIDES = {
    "tetra": ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)),
    "hexahedron": ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
                   (3, 0, 4, 7)),
    "wedge": ((0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
    "pyramid": ((0, 1, 2, 3), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
}
CORNERS = {"triangle": 3, "quad": 4, "tetra": 4, "hexahedron": 8, "wedge": 6, "pyramid": 5}


def triangles_of(cells: Mapping[str, Any]):
    """(m, 3) indices: the triangles, the quads in two halves each, and the sides that one solid
    element alone has. `cells`: by the names of CORNERS, (k, corners) each; more columns are nodes
    on edges, and are passed over."""
    sides: List[Tuple[Any, Any]] = []
    for kind, table in _SIDES.items():
        if kind in cells:
            corners = np.asarray(cells[kind])
            sides += [(len(side), corners[:, list(side)]) for side in table]
    found = [np.empty((0, 3), np.int64)]
    for count, kind in ((3, "triangle"), (4, "quad")):
        flat = [np.asarray(cells[kind])[:, :count]] if kind in cells else []
        solid = [side for corners, side in sides if corners == count]
        if solid:
            flat.append(_used_once(np.concatenate(solid)))
        found += [part for polygon in flat for part in _halves(polygon)]
    return np.concatenate(found)


def _halves(polygons) -> Iterable[Any]:
    yield polygons[:, :3]
    if polygons.shape[1] == 4:
        yield polygons[:, [0, 2, 3]]


def _used_once(polygons):
    _, first, uses = np.unique(np.sort(polygons, axis=1), axis=0, return_index=True,
                               return_counts=True)
    return polygons[np.sort(first[uses == 1])]

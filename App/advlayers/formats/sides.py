"""Which element has a given side: lines as sides of surface elements, those of volume elements."""
from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np

from advlayers.formats.mesh_parts import KINDS, SECOND_ORDER, MeshParts

# Sides as places of corners, by kind; seen from outside they turn counter-clockwise.
SIDES: Dict[str, Tuple[Tuple[int, ...], ...]] = {
    "tri3": ((0, 1), (1, 2), (2, 0)),
    "quad4": ((0, 1), (1, 2), (2, 3), (3, 0)),
    "tet4": ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)),
    "pyramid5": ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
    "prism6": ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
    "hex8": ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
}
SIDES.update({second: SIDES[first] for first, second in SECOND_ORDER.items() if first in SIDES},
             quad9=SIDES["quad4"])


def find(parts: MeshParts, cells: List[Tuple[str, Any]]) -> Tuple[Any, Any, Any]:
    """For elements of one dimension, by kind and (m, nodes): the number of the first element of one
    dimension more that has each as a side, the place of that side in SIDES, both 0 where there is
    none, and how many there are."""
    dimension = KINDS[cells[0][0]].dimension
    wanted = _keys(part[:, :KINDS[kind].corners] for kind, part in cells)
    at_border = np.zeros(len(parts.nodes) + 1, bool)
    at_border[wanted.ravel()] = True
    sides, elements, places = [], [], []
    for start, block in zip(parts.starts, parts.blocks):
        if block.dimension != dimension + 1:
            continue
        for place, corners in enumerate(SIDES[block.kind]):
            near = np.flatnonzero(at_border[block.cells[:, corners] + 1].all(axis=1))
            sides.append(block.cells[near][:, corners])
            elements.append(start + 1 + near)
            places.append(np.full(len(near), place))
    if not sides:
        return (np.zeros(len(wanted), np.int64),) * 3
    given = _keys(sides)
    number = _same_rows(np.concatenate([wanted, given]))
    of_wanted, of_given = number[:len(wanted)], number[len(wanted):]
    element, place = np.concatenate(elements), np.concatenate(places)
    order = np.argsort(element, kind="stable")[::-1]  # so that the first of them stands in the end
    first = np.zeros((2, int(number.max()) + 1), np.int64)
    first[0, of_given[order]], first[1, of_given[order]] = element[order], place[order]
    count = np.bincount(of_given, minlength=first.shape[1])
    return first[0, of_wanted], first[1, of_wanted], count[of_wanted]


def _keys(cells):
    """(m, 4): the corners, from 1, ascending after zeros."""
    rows = [np.zeros((0, 4), np.int64)]
    for part in cells:
        row = np.zeros((len(part), 4), np.int64)
        row[:, 4 - part.shape[1]:] = np.sort(part, axis=1) + 1
        rows.append(row)
    return np.concatenate(rows)


def _same_rows(rows):
    """(m,) the same number for the same row."""
    order = np.lexsort(rows.T)
    ordered = rows[order]
    new = np.concatenate([[False], (ordered[1:] != ordered[:-1]).any(axis=1)])
    number = np.empty(len(rows), np.int64)
    number[order] = np.cumsum(new)
    return number

"""Volumes of cells and the balance of their sides, by their signs: nothing here takes an absolute
value."""
import numpy as np

# Sides as seen from outside, counter-clockwise; written for these tests alone.
SIDES = {
    "tet4": ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)),
    "pyramid5": ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
    "prism6": ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
    "hex8": ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
}


def fan(points):
    """(n, k, 3) corners of polygons -> (n, k, 3, 3) triangles about their middles."""
    middle = points.mean(axis=1, keepdims=True)
    following = np.roll(points, -1, axis=1)
    return np.stack([np.broadcast_to(middle, points.shape), points, following], axis=2)


def under(points):
    """(n,) signed volumes of the cones from the origin over polygons."""
    triangles = fan(points)
    return np.einsum("nki,nki->n", triangles[:, :, 0],
                     np.cross(triangles[:, :, 1], triangles[:, :, 2])) / 6.0


def volumes(nodes, kind, cells):
    """(n,) by the divergence theorem; positive where all sides look outward."""
    return sum(under(nodes[cells[:, list(side)]]) for side in SIDES[kind])


def border(parts):
    """The sides that one cell alone has, outward: sorted nodes -> nodes in order."""
    seen = {}
    for block in parts.of(3):
        for side in SIDES[block.kind]:
            for row in block.cells[:, list(side)].tolist():
                seen.setdefault(tuple(sorted(row)), []).append(tuple(row))
    assert max(map(len, seen.values())) <= 2
    return {key: rows[0] for key, rows in seen.items() if len(rows) == 1}


def same_turn(one, other):
    """Whether two rows of the same nodes go round the same way."""
    start = other.index(one[0])
    return other[start:] + other[:start] == one

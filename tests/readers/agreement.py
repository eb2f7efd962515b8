"""What a reader found against what was written."""
import numpy as np
from advlayers.formats.mesh_parts import KINDS


def same_points(parts, points, digits=17):
    """Bit for bit with 17 digits, else relative to each coordinate."""
    points = np.asarray(points)
    assert points.shape == parts.nodes.shape
    if digits >= 17:
        assert np.array_equal(points, parts.nodes)
    else:
        assert np.abs(points - parts.nodes).max() <= 10.0 ** -digits * np.abs(parts.nodes).max()
        assert np.allclose(points, parts.nodes, rtol=10.0 ** -digits, atol=1e-15)


def same_cells(parts, cells, dimensions):
    """`cells`: by kind, nodes from 0 in the order of KINDS; which of them comes first is free, but
    not the order of the nodes of one."""
    wanted = {}
    for block in parts.of(*dimensions):
        wanted.setdefault(block.kind, []).append(block.cells)
    assert {kind for kind, rows in cells.items() if len(rows)} == set(wanted)
    for kind, blocks in wanted.items():
        assert np.array_equal(ordered(cells[kind]), ordered(np.concatenate(blocks))), kind


def ordered(rows):
    rows = np.asarray(rows, np.int64)
    return rows[np.lexsort(rows.T[::-1])]


def corner_sets(rows):
    """Of elements whatever the order of their nodes."""
    return ordered(np.sort(np.asarray(rows, np.int64), axis=1))


def cells_of(parts, dimension, numbers):
    """By kind the elements of these parts."""
    found = {}
    for block in parts.of(dimension):
        kept = np.isin(block.part, list(numbers))
        if kept.any():
            found.setdefault(block.kind, []).append(block.cells[kept])
    return {kind: np.concatenate(rows) for kind, rows in found.items()}


def corners(kind, rows):
    return np.asarray(rows)[:, :KINDS[kind].corners]


def owned(parts, dimension):
    """By owner's name the numbers of its parts."""
    found = {}
    for number, name in parts.owners(dimension).items():
        found.setdefault(name, set()).add(number)
    return found


def group(parts, name, dimension):
    return next(entry.parts for entry in parts.groups
                if (entry.name, entry.dimension) == (name, dimension))


def signed_volume(points, kind, rows):
    """(m,) of tetrahedra, pyramids, prisms and hexahedra, positive where the first side is
    counter-clockwise from inside; by the divergence theorem over their sides."""
    from advlayers.formats.sides import SIDES

    total = np.zeros(len(rows))
    for side in SIDES[kind]:
        x = points[np.asarray(rows)[:, side]]
        for i in range(1, len(side) - 1):
            total += np.einsum("ij,ij->i", x[:, 0], np.cross(x[:, i], x[:, i + 1])) / 6.0
    return total

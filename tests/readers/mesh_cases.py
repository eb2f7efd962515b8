"""Meshes to write: what the core makes of solids, plane domains and facets, and what is made of
these by hand: mid nodes, extruded and filled domains."""
from dataclasses import replace
from functools import lru_cache

import core_meshes
import numpy as np
from advlayers.extrusion import Extrusion, extrude
from advlayers.formats import plane
from advlayers.formats.mesh_parts import KINDS, Block, Group, MeshParts, of_mesh

NAMES = ("solid", "plane", "facets", "second", "nine", "extruded", "extruded second",
         "turned second", "filled", "filled second")
THICKNESS = 0.75


@lru_cache(maxsize=None)
def case(name):
    return {"solid": _solid, "plane": _plane, "facets": _facets, "second": _second,
            "nine": _nine, "extruded": _extruded, "extruded second": _extruded_second,
            "turned second": _turned_second, "filled": _filled,
            "filled second": _filled_second}[name]()


def _solid():
    """A bracket; a group of faces, one of edges, one of both."""
    return of_mesh(core_meshes.mesh("bracket", size=2.0, first_height=0.3), {
        "inlet": ["Face1", "Face2"], "rim": ["Edge3", "Edge5"], "tip": ["Face4", "Edge1"]})


@lru_cache(maxsize=None)
def _plane():
    """The underside of a drilled plate: its normal is -z. The hole is a wall, a side an inlet."""
    model = core_meshes.model("drilled_plate")
    everything = core_meshes.mesh("drilled_plate", size=4.0, first_height=0.5)
    z = everything.nodes[:, 2]
    faces = np.concatenate([everything.face_of_quad, everything.face_of_triangle])
    cells = [*everything.quads.tolist(), *everything.triangles.tolist()]
    low = {face for face, cell in zip(faces.tolist(), cells) if (z[cell] == 0.0).all()}
    number, = low
    run = core_meshes.core.Mesher(model, core_meshes.core.Settings(
        size=2.0, first_height=0.3, layers=2, core="triangles", faces=[f"Face{number}"]))
    for _ in run:
        pass
    mesh = run.result()
    # A circle is the one whose nodes do not lie on a line.
    hole = [edge for edge, pairs in mesh.edge_segments.items()
            if np.ptp(mesh.nodes[pairs.ravel()], axis=0)[:2].min() > 1.0]
    left = [edge for edge, pairs in mesh.edge_segments.items()
            if np.ptp(mesh.nodes[pairs.ravel(), 0]) == 0.0][:1]
    return of_mesh(mesh, {"body": [f"Edge{edge}" for edge in hole],
                          "in let": [f"Edge{edge}" for edge in left]})


def _facets():
    """Triangles of all kinds alone, on a face for each side of a box."""
    parts = _filled()
    used, cells = np.unique(parts.of(2)[0].cells, return_inverse=True)
    block = replace(parts.of(2)[0], cells=cells.reshape(-1, 3).astype(np.int32))
    return MeshParts(parts.nodes[used], (block,), (Group("lid", 2, (6,)),))


SECOND = {"line2": "line3", "tri3": "tri6", "quad4": "quad8", "tet4": "tet10", "hex8": "hex20",
          "prism6": "prism15"}


def _second():
    """The bracket with a node in the middle of each side, moved off the straight line."""
    return _with_middles(_solid(), 0.001)


def _nine():
    """The bracket with a node in the middle of each quad, too."""
    parts = _second()
    nodes, blocks = parts.nodes, []
    for block in parts.blocks:
        if block.kind == "quad8":
            numbers = len(nodes) + np.arange(len(block), dtype=np.int32)
            nodes = np.vstack([nodes, parts.nodes[block.cells].mean(axis=1)])
            block = replace(block, kind="quad9", cells=np.column_stack([block.cells, numbers]))
        blocks.append(block)
    return replace(parts, nodes=nodes, blocks=tuple(blocks))


def _extruded_second():
    return _with_middles(_extruded(), 0.0)


def _turned_second():
    """A square turned about one of its sides, two cells about: hexahedra, prisms, and pyramids and
    tetrahedra at the axis."""
    square = of_mesh(core_meshes.mesh("square", size=3.0, first_height=1.0, layers=1, order=2,
                                      core="triangles"), {"rim": ["Edge3"]})
    return extrude(square, Extrusion(axis=((0, 0, 0), (1, 0, 0)), angle=40.0, cells=2))


def _filled_second():
    parts = _filled()
    return _with_middles(parts.with_blocks(
        block for block in parts.blocks if block.kind != "pyramid5"), 0.0)


def _with_middles(parts, shift):
    used = np.unique(np.concatenate([block.cells.ravel() for block in parts.blocks]))
    assert np.array_equal(used, np.arange(len(used)))  # a node that is left out is a last one
    parts = replace(parts, nodes=parts.nodes[:len(used)])
    sides = np.concatenate([np.sort(block.cells[:, list(side)], axis=1) for block in parts.blocks
                            for side in KINDS[SECOND[block.kind]].sides])
    sides = np.unique(sides, axis=0)
    middles = parts.nodes[sides].mean(axis=1)
    middles += shift * np.sin(middles[:, ::-1])
    keys = sides[:, 0].astype(np.int64) * len(parts.nodes) + sides[:, 1]
    blocks = []
    for block in parts.blocks:
        columns = [block.cells]
        for side in KINDS[SECOND[block.kind]].sides:
            pair = np.sort(block.cells[:, list(side)], axis=1).astype(np.int64)
            place = np.searchsorted(keys, pair[:, 0] * len(parts.nodes) + pair[:, 1])
            columns.append((len(parts.nodes) + place)[:, None].astype(np.int32))
        blocks.append(replace(block, kind=SECOND[block.kind], cells=np.hstack(columns)))
    return replace(parts, nodes=np.vstack([parts.nodes, middles]), blocks=tuple(blocks),
                   node_layer=None, node_parent=None)


def _extruded():
    """The plane domain, one cell thick: hexahedra and prisms; patches of its edges and two planes.
    """
    flat = plane.turned_up(_plane(), (0, 1))
    count = len(flat.nodes)
    nodes = np.vstack([flat.nodes, flat.nodes + (0.0, 0.0, THICKNESS)])
    volume, back, front, around = [], [], [], []
    for block in flat.of(2):
        kind = {"quad4": "hex8", "tri3": "prism6"}[block.kind]
        number = np.ones(len(block), np.int32)
        volume.append(Block(kind, np.hstack([block.cells, block.cells + count]), number))
        back.append(Block(block.kind, block.cells[:, ::-1], 1000 * number))
        front.append(Block(block.kind, block.cells + count, 1001 * number))
    lines, = flat.of(1)
    a, b = _outward(flat, lines.cells).T
    around.append(Block("quad4", np.stack([a, b, b + count, a + count], axis=1), lines.part))
    names = {(2, edge): f"Edge{edge}" for edge in flat.part_numbers(1)}
    names.update({(2, 1000): "back", (2, 1001): "front"})
    groups = tuple(Group(group.name, 2, group.parts) for group in flat.groups)
    return MeshParts(nodes, (*around, *back, *front, *volume), groups, names)


def _outward(flat, lines):
    """Each line as the side of its element has it: what is extruded from it looks outward."""
    sides = {tuple(side): None for block in flat.of(2) for cell in block.cells.tolist()
             for side in zip(cell, cell[1:] + cell[:1])}
    return np.array([line if tuple(line) in sides else line[::-1] for line in lines.tolist()])


def _filled():
    """A block of cubes: six tetrahedra in most of them, six pyramids in some."""
    n = 3
    grid = np.arange((n + 1) ** 3).reshape(n + 1, n + 1, n + 1)
    points = np.stack(np.meshgrid(*[np.linspace(0.0, 2.0, n + 1) ** 1.2] * 3, indexing="ij"),
                      axis=-1).reshape(-1, 3)
    tets, pyramids, middles = [], [], []
    for i, j, k in np.ndindex(n, n, n):
        at = grid[i:i + 2, j:j + 2, k:k + 2]
        if (i, j, k) == (1, 1, 1):
            middle = len(points) + len(middles)
            middles.append(points[at.ravel()].mean(axis=0))
            pyramids += [(*side, middle) for side in _cube_sides(at)]
            continue
        tets += _cube_tets(at)
    nodes = np.vstack([points, middles])
    # The cubes beside the one of pyramids have triangles there: the sides do not match, which no
    # reader minds.
    tets = _positive(nodes, np.array(tets, np.int32))
    outer = _outer_triangles(nodes, tets)
    part = np.array([1 + 2 * axis + int(high) for axis, high in _side_of_box(nodes, outer)],
                    np.int32)
    blocks = (Block("tri3", outer, part), Block("tet4", tets, np.ones(len(tets), np.int32)),
              Block("pyramid5", np.array(pyramids, np.int32), np.ones(len(pyramids), np.int32)))
    return MeshParts(nodes, blocks, (Group("bottom", 2, (5,)), Group("all of it", 3, (1,))))


def _cube_sides(at):
    """Of a cube, counter-clockwise from inside."""
    sides = [(at[0, 0, 0], at[0, 1, 0], at[0, 1, 1], at[0, 0, 1]),
             (at[0, 0, 0], at[0, 0, 1], at[1, 0, 1], at[1, 0, 0]),
             (at[0, 0, 0], at[1, 0, 0], at[1, 1, 0], at[0, 1, 0])]
    return sides + [(at[1, 0, 0], at[1, 0, 1], at[1, 1, 1], at[1, 1, 0]),
                    (at[0, 1, 0], at[1, 1, 0], at[1, 1, 1], at[0, 1, 1]),
                    (at[0, 0, 1], at[0, 1, 1], at[1, 1, 1], at[1, 0, 1])]


def _cube_tets(at):
    from itertools import permutations

    found = []
    for axes in permutations(range(3)):
        corner = [0, 0, 0]
        way = [at[tuple(corner)]]
        for axis in axes:
            corner[axis] = 1
            way.append(at[tuple(corner)])
        found.append(tuple(way))
    return found


def _positive(nodes, tets):
    a, b, c, d = nodes[tets].transpose(1, 0, 2)
    turned = np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) < 0.0
    tets[turned] = tets[turned][:, [0, 2, 1, 3]]
    return tets


def _outer_triangles(nodes, tets):
    sides = tets[:, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]].reshape(-1, 3)
    low, high = nodes.min(axis=0), nodes.max(axis=0)
    on = [((nodes[sides] == low).all(axis=1) | (nodes[sides] == high).all(axis=1)).any(axis=1)]
    return sides[on[0]]


def _side_of_box(nodes, triangles):
    low = nodes.min(axis=0)
    for triangle in triangles:
        points = nodes[triangle]
        axis = int(np.flatnonzero(np.ptp(points, axis=0) == 0.0)[0])
        yield axis, points[0, axis] != low[axis]

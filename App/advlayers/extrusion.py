"""Plane meshes made solid: hexahedra and prisms, extruded to a plate or turned about an axis.

The sides take the names of the CAD edges that they come from, and their groups; the cells those of
the CAD faces. Two patches of their own close the ends. What is of second order stays so: its cells
are made of the corners, on every other level, and then get the nodes between them.
"""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Dict, FrozenSet, List, Mapping, Optional, Tuple

import numpy as np

from advlayers.errors import InputError
from advlayers.formats.mesh_parts import (
    KINDS, SECOND_ORDER, Block, Group, MeshParts, of_first_order)

_PLANE = 1e-6  # of the diagonal: how far nodes may lie off their plane
_ON_AXIS = 1e-9  # of the diagonal


@dataclass(frozen=True)
class Extrusion:
    """What the block `extrude` says; `axis` makes it a turn about a line, by `angle` in all, half
    of it to either side of the plane."""

    thickness: float = 0.0  # [mm]
    cells: int = 1
    direction: Optional[Tuple[float, float, float]] = None  # None: the normal of the mesh
    axis: Optional[Tuple[Any, Any]] = None  # a point [mm] and a direction
    angle: float = 0.0  # [deg]
    front: str = "front"
    back: str = "back"
    patch_types: Mapping[str, str] = None


def of_settings(values: Mapping[str, Any]) -> Extrusion:
    """Of a checked block. Raises InputError where its keys do not go together."""
    turned = values["axis_direction"] is not None
    for key in ("angle",) if turned else ("thickness",):
        if values[key] is None:
            raise InputError(f"extrude.{key}", "is missing")
    for key in ("thickness", "direction") if turned else ("angle", "axis_point"):
        if values[key] is not None:
            raise InputError(f"extrude.{key}", "goes with axis_direction only" if not turned
                             else "does not go with axis_direction")
    if values["front"] == values["back"]:
        raise InputError("extrude.back", "is the name of the front, too: {}", values["back"])
    axis = (values["axis_point"] or (0.0, 0.0, 0.0), values["axis_direction"]) if turned else None
    return Extrusion(values["thickness"] or 0.0, values["cells"], values["direction"], axis,
                     values["angle"] or 0.0, values["front"], values["back"],
                     values["patch_types"])


def kinds(how: Extrusion, order: int) -> FrozenSet[str]:
    """Of the cells, but for those at nodes on an axis."""
    first = ("hex8", "prism6")
    return frozenset(first if order == 1 else (SECOND_ORDER[kind] for kind in first))


def extrude(parts: MeshParts, how: Extrusion) -> MeshParts:
    """Raises InputError for a mesh that is not plane, or that the axis cuts."""
    flat = _Flat(parts, how)
    steps = how.cells * (2 if parts.second_order else 1)
    levels = np.arange(steps + 1) / steps
    if how.axis is None:
        shifts = levels[:, None, None] * how.thickness * flat.normal
        nodes = (flat.nodes + shifts).reshape(-1, 3)
        index = np.arange(len(nodes)).reshape(len(levels), -1)
    else:
        turns = np.radians(how.angle) * (levels - 0.5)
        nodes, index = _turned(flat.nodes, flat, turns)
    if parts.second_order:
        made = _with_mid_nodes(_made_solid(of_first_order(parts), how, flat, nodes, index[::2]),
                               *_mids(flat, index))
    else:
        made = _made_solid(parts, how, flat, nodes, index)
    return _without_spare(made)


class _Flat:
    """The plane mesh, its elements counter-clockwise against the direction of extrusion."""

    def __init__(self, parts: MeshParts, how: Extrusion) -> None:
        surface = parts.of(2)
        if not surface:
            raise InputError("extrude", "needs a mesh of plane faces: there is no element")
        used = np.unique(np.concatenate([block.cells.ravel() for block in surface]))
        points = parts.nodes[used]
        middle = points.mean(axis=0)
        diagonal = float(np.linalg.norm(np.ptp(points, axis=0)))
        areas = {block.kind: _area_vectors(parts.nodes, block.cells[:, :KINDS[block.kind].corners])
                 for block in surface}
        own = np.linalg.svd(points - middle, full_matrices=False)[2][2]
        off = np.abs((points - middle) @ own)
        if off.max() > _PLANE * diagonal:
            raise InputError("extrude", "needs plane faces: a node lies {} mm off their plane",
                             f"{off.max():.3g}")
        self.normal = self._direction(own, sum(a.sum(axis=0) for a in areas.values()), how)
        self.on_axis = np.zeros(len(parts.nodes), bool)
        if how.axis is not None:
            self._find_axis(parts.nodes, used, how, diagonal)
        whole = of_first_order(parts).of(2)
        self.blocks, diagonals = _cut_at_axis([_upright(block, areas[curved.kind] @ self.normal)
                                               for block, curved in zip(whole, surface)],
                                              self.on_axis)
        self.nodes = parts.nodes
        self.mids = self._mids_of_sides(surface, diagonals) if parts.second_order else []

    @staticmethod
    def _direction(own, area, how: Extrusion):
        """The unit vector of the thickness; a plate's faces may look either way, also each its
        own."""
        if how.direction is None or how.axis is not None:
            return own if own @ area >= 0.0 else -own
        given = np.asarray(how.direction, float)
        length = float(np.linalg.norm(given))
        if length == 0.0:
            raise InputError("extrude.direction", "must have a length")
        if abs(own @ given) < (1.0 - 1e-6) * length:
            raise InputError("extrude.direction", "must be at right angles to the plane, whose "
                             "normal is ({}, {}, {})", *(f"{x:.6g}" for x in own))
        return own if own @ given > 0.0 else -own

    def _find_axis(self, nodes, used, how: Extrusion, diagonal: float) -> None:
        """The axis lies in the plane, all nodes on one side of it; seen so that the turn goes from
        the back to the front."""
        self.origin, along = (np.asarray(part, float) for part in how.axis)
        length = float(np.linalg.norm(along))
        if length == 0.0:
            raise InputError("extrude.axis_direction", "must have a length")
        self.axis = along / length
        lies_off = max(abs(float(self.axis @ self.normal)) * diagonal,
                       abs(float((self.origin - nodes[used[0]]) @ self.normal)))
        if lies_off > _PLANE * diagonal:
            raise InputError("extrude.axis_direction", "must lie in the plane of the mesh")
        outward = np.cross(self.axis, self.normal)
        radius = (nodes[used] - self.origin) @ outward
        near = _ON_AXIS * diagonal
        if radius.min() < -near and radius.max() > near:
            raise InputError("extrude.axis_direction", "cuts the mesh: it lies on both sides")
        self.on_axis[used] = np.abs(radius) <= near
        if radius.max() <= near:
            outward = -outward
        # A turn about the axis moves a point of the plane along axis x radius.
        self.normal = np.cross(self.axis, outward)

    def _mids_of_sides(self, surface: List[Block], diagonals):
        """(m, 3): two corners, and the node between them."""
        found = [np.zeros((0, 3), np.int64)]
        for block in surface:
            kind = KINDS[block.kind]
            found += [block.cells[:, [a, b, kind.corners + k]]
                      for k, (a, b) in enumerate(kind.sides)]
        if len(diagonals):
            # In the middle of the curved quad that was cut.
            sides = np.concatenate(found)
            known = _Pairs(sides[:, :2], sides[:, 2])
            mids = known.find(diagonals[:, [[0, 1], [1, 2], [2, 3], [3, 0]]].reshape(-1, 2))
            middle = (self.nodes[mids].reshape(-1, 4, 3).sum(axis=1) / 2.0
                      - self.nodes[diagonals].sum(axis=1) / 4.0)
            numbers = len(self.nodes) + np.arange(len(middle))
            self.nodes = np.concatenate([self.nodes, middle])
            self.on_axis = np.concatenate([self.on_axis, np.zeros(len(middle), bool)])
            found.append(np.column_stack([diagonals[:, [0, 2]], numbers]))
        return np.concatenate(found)


class _Pairs:
    """A value by two nodes, whichever comes first."""

    def __init__(self, pairs, values) -> None:
        self._keys, first = np.unique(_keys(np.sort(pairs, axis=1)), return_index=True)
        self._values = values[first]

    def find(self, pairs):
        return self._values[np.searchsorted(self._keys, _keys(np.sort(pairs, axis=1)))]


def _mids(flat: _Flat, index) -> Tuple[Any, Any]:
    """Pairs of nodes of the solid, and the node between them: in the levels that have corners, and
    on the ways of the corners, which pass through the levels between."""
    a, b, mid = flat.mids.T
    pairs = [np.stack([level[a], level[b]], axis=1) for level in index[::2]]
    mids = [level[mid] for level in index[::2]]
    corners = np.unique(flat.mids[:, :2])
    corners = corners[~flat.on_axis[corners]]
    for low, middle, high in zip(index[:-2:2], index[1:-1:2], index[2::2]):
        pairs.append(np.stack([low[corners], high[corners]], axis=1))
        mids.append(middle[corners])
    return np.concatenate(pairs), np.concatenate(mids)


def _with_mid_nodes(made: MeshParts, pairs, mids) -> MeshParts:
    known = _Pairs(pairs, mids)
    blocks = []
    for block in made.blocks:
        kind = SECOND_ORDER[block.kind]
        own = [known.find(block.cells[:, list(side)])[:, None] for side in KINDS[kind].sides]
        blocks.append(replace(block, kind=kind, cells=np.hstack([block.cells, *own])))
    return made.with_blocks(blocks)


def _area_vectors(nodes, cells):
    corners = nodes[cells]
    if cells.shape[1] == 4:
        return np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]) / 2.0
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2.0


def _upright(block: Block, areas) -> Block:
    """Each element begins with the same corner as before."""
    turned = np.concatenate([block.cells[:, :1], block.cells[:, :0:-1]], axis=1)
    return replace(block, cells=np.where((areas > 0.0)[:, None], block.cells, turned))


def _cut_at_axis(blocks: List[Block], on_axis) -> Tuple[List[Block], Any]:
    """Quads with one corner on the axis become two triangles: a cell of seven nodes has no name in
    most formats. Returns these quads as well, cut from their first to their third corner."""
    made: List[Block] = []
    quads = np.zeros((0, 4), np.int64)
    for block in blocks:
        if block.kind != "quad4":
            made.append(block)
            continue
        single = on_axis[block.cells].sum(axis=1) == 1
        made.append(_some(block, ~single))
        if not single.any():
            continue
        cells = block.cells[single]
        first = np.argmax(on_axis[cells], axis=1)
        rows = np.arange(len(cells))
        a, b, c, d = (cells[rows, (first + k) % 4] for k in range(4))
        quads = np.stack([a, b, c, d], axis=1)
        halves = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
        made.append(Block("tri3", halves, np.tile(block.part[single], 2),
                          np.tile(block.layers[single], 2)))
    return [block for block in made if len(block)], quads


def _some(block: Block, chosen) -> Block:
    layer = None if block.layer is None else block.layer[chosen]
    return replace(block, cells=block.cells[chosen], part=block.part[chosen], layer=layer)


def _turned(points, flat: _Flat, turns):
    """Nodes, each on the axis once, and the index of each node of the plane at each turn."""
    inside = points - flat.origin
    along = (inside @ flat.axis)[:, None] * flat.axis
    across = inside - along
    nodes = [points]
    index = np.empty((len(turns), len(points)), np.int64)
    moved = np.flatnonzero(~flat.on_axis)
    count = len(points)
    for level, turn in enumerate(turns):
        index[level] = np.arange(len(points))
        index[level, moved] = count + np.arange(len(moved))
        count += len(moved)
        nodes.append((flat.origin + along + np.cos(turn) * across
                      + np.sin(turn) * np.cross(flat.axis, across))[moved])
    # Those of the plane itself stay only where they lie on the axis.
    kept = np.ones(count, bool)
    kept[moved] = False
    place = np.cumsum(kept) - 1
    return np.concatenate(nodes)[kept], place[index]


def _made_solid(parts: MeshParts, how: Extrusion, flat: _Flat, nodes, index) -> MeshParts:
    volume: List[Block] = []
    ends: List[Block] = []
    back = max(parts.part_numbers(1), default=0) + 1
    for block in flat.blocks:
        for low, high in zip(index[:-1], index[1:]):
            volume += _cells(block, low, high)
        ends.append(replace(block, cells=index[0][_reversed(block.cells)],
                            part=np.full(len(block), back)))
        ends.append(replace(block, cells=index[-1][block.cells],
                            part=np.full(len(block), back + 1)))
    sides = _sides(parts, flat.blocks, index)
    names = {(3, number): parts.name(2, number) for number in parts.part_numbers(2)}
    names.update({(2, number): parts.name(1, number) for number in parts.part_numbers(1)})
    names.update({(2, back): how.back, (2, back + 1): how.front})
    closed = "empty" if how.axis is None else "wedge"
    types = {how.back: closed, how.front: closed, **(how.patch_types or {})}
    return MeshParts(nodes, tuple(_joined(sides + ends + volume)), _raised(parts.groups), names,
                     types, parts.metre)


def _reversed(cells):
    return np.concatenate([cells[:, :1], cells[:, :0:-1]], axis=1)


def _cells(block: Block, low, high) -> List[Block]:
    """Of one step; corners that do not move make cells of fewer nodes."""
    bottom, top = low[block.cells], high[block.cells]
    fixed = bottom == top
    made = [_solid("hex8" if block.kind == "quad4" else "prism6", block, ~fixed.any(axis=1),
                   np.concatenate([bottom, top], axis=1))]
    corners = block.cells.shape[1]
    for k in range(corners):  # the fixed corners begin with this one
        order = (np.arange(corners) + k) % corners
        low_k, high_k = bottom[:, order], top[:, order]
        alone, pair = fixed[:, order[0]] & (fixed.sum(axis=1) == 1), fixed[:, order[:2]].all(axis=1)
        if corners == 4:
            # a and b of the quad a b c d lie on the axis: two triangles, (a d d') and (b c c').
            made.append(_solid("prism6", block, pair, np.stack(
                [low_k[:, 0], low_k[:, 3], high_k[:, 3], low_k[:, 1], low_k[:, 2], high_k[:, 2]],
                axis=1)))
        else:
            made.append(_solid("pyramid5", block, alone, np.stack(
                [low_k[:, 1], high_k[:, 1], high_k[:, 2], low_k[:, 2], low_k[:, 0]], axis=1)))
            made.append(_solid("tet4", block, pair, np.stack(
                [low_k[:, 0], low_k[:, 1], low_k[:, 2], high_k[:, 2]], axis=1)))
    return [part for part in made if len(part)]


def _solid(kind: str, block: Block, chosen, cells) -> Block:
    some = _some(block, chosen)
    return replace(some, kind=kind, cells=cells[chosen])


def _sides(parts: MeshParts, blocks: List[Block], index) -> List[Block]:
    """Of the mesh edges on CAD edges with an element on one side only, outward."""
    border = _border(blocks)
    made = []
    for block in parts.of(1):
        for pairs in (block.cells, block.cells[:, ::-1]):
            outward = np.isin(_keys(pairs), border)
            cells, part = pairs[outward], block.part[outward]
            for low, high in zip(index[:-1], index[1:]):
                wall = np.stack([low[cells[:, 0]], low[cells[:, 1]],
                                 high[cells[:, 1]], high[cells[:, 0]]], axis=1)
                flat_first, flat_last = wall[:, 0] == wall[:, 3], wall[:, 1] == wall[:, 2]
                whole = ~flat_first & ~flat_last
                made.append(Block("quad4", wall[whole], part[whole]))
                first, last = flat_first & ~flat_last, flat_last & ~flat_first
                made.append(Block("tri3", wall[first][:, :3], part[first]))
                made.append(Block("tri3", wall[last][:, [0, 1, 3]], part[last]))
    return [block for block in made if len(block)]


def _border(blocks: List[Block]):
    """Keys of the directed mesh edges that have an element on their left alone."""
    ends = np.concatenate([block.cells[:, [k, (k + 1) % block.cells.shape[1]]]
                           for block in blocks for k in range(block.cells.shape[1])])
    return np.setdiff1d(_keys(ends), _keys(ends[:, ::-1]))


def _keys(pairs):
    """One number for each pair of nodes."""
    return (pairs[:, 0].astype(np.int64) << 32) + pairs[:, 1]


def _raised(groups) -> Tuple[Group, ...]:
    return tuple(replace(group, dimension=group.dimension + 1) for group in groups
                 if group.dimension < 3)


def _joined(blocks: List[Block]) -> List[Block]:
    """One block of each kind, in the order of first appearance."""
    by_kind: Dict[str, List[Block]] = {}
    for block in blocks:
        by_kind.setdefault(block.kind, []).append(block)
    return [Block(kind, np.concatenate([block.cells for block in found]),
                  np.concatenate([block.part for block in found]),
                  np.concatenate([block.layers for block in found]))
            for kind, found in by_kind.items()]


def _without_spare(made: MeshParts) -> MeshParts:
    """Without nodes of no element."""
    used = np.zeros(len(made.nodes), bool)
    for block in made.blocks:
        used[block.cells] = True
    place = np.cumsum(used) - 1
    return replace(made, nodes=made.nodes[used], blocks=tuple(
        replace(block, cells=place[block.cells]) for block in made.blocks))

"""A mesh as the writers of files see it: nodes, blocks of elements, and the names of its parts.

Elements are numbered from 1 through the blocks in their order. Each belongs to one part of its
dimension, the CAD face, edge or solid that it lies on or a patch that was made; a group is some
parts under one name.
"""
from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import (
    Any, Dict, Iterable, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple)

import numpy as np


class Kind(NamedTuple):
    """Corners first, counter-clockwise from outside or, in a plane, from above; those of a volume
    element begin with a side that is counter-clockwise from inside (of a pyramid: its base). Nodes
    on sides follow in the order of `sides`, then one in the middle."""

    dimension: int
    corners: int
    nodes: int
    sides: Tuple[Tuple[int, int], ...] = ()  # edges, those that have a node, as places of corners


Sides = Tuple[Tuple[int, int], ...]


def _ring(corners: int, first: int = 0) -> Sides:
    return tuple((first + i, first + (i + 1) % corners) for i in range(corners))


def _up(corners: int, top: Sequence[int]) -> Sides:
    return tuple(zip(range(corners), top))


KINDS: Dict[str, Kind] = {
    "line2": Kind(1, 2, 2),
    "line3": Kind(1, 2, 3, ((0, 1),)),
    "tri3": Kind(2, 3, 3),
    "tri6": Kind(2, 3, 6, _ring(3)),
    "quad4": Kind(2, 4, 4),
    "quad8": Kind(2, 4, 8, _ring(4)),
    "quad9": Kind(2, 4, 9, _ring(4)),
    "tet4": Kind(3, 4, 4),
    "tet10": Kind(3, 4, 10, _ring(3) + _up(3, (3, 3, 3))),
    "pyramid5": Kind(3, 5, 5),
    "pyramid13": Kind(3, 5, 13, _ring(4) + _up(4, (4, 4, 4, 4))),
    "prism6": Kind(3, 6, 6),
    "prism15": Kind(3, 6, 15, _ring(3) + _ring(3, 3) + _up(3, range(3, 6))),
    "hex8": Kind(3, 8, 8),
    "hex20": Kind(3, 8, 20, _ring(4) + _ring(4, 4) + _up(4, range(4, 8))),
}
SECOND_ORDER = {"line2": "line3", "tri3": "tri6", "quad4": "quad8", "tet4": "tet10",
                "pyramid5": "pyramid13", "prism6": "prism15", "hex8": "hex20"}
_FIRST_ORDER = {**{second: first for first, second in SECOND_ORDER.items()}, "quad9": "quad4"}
_OWN_NAME = {1: "Edge", 2: "Face", 3: "Solid"}


def order_of(kind: str, corners: Sequence[int], sides: Optional[Sides] = None) -> Tuple[int, ...]:
    """The nodes of a kind in the order of a format that has the corners in this one, and then a
    node on each of its own `sides`, places of its corners; without them, on those of the kind."""
    entry = KINDS[kind]
    place = {frozenset(side): entry.corners + i for i, side in enumerate(entry.sides)}
    return tuple(corners) + tuple(place[frozenset((corners[a], corners[b]))]
                                  for a, b in (entry.sides if sides is None else sides))


def upright_first(kind: str) -> Tuple[int, ...]:
    """The nodes of a kind where those on upright sides come before those on the sides of the top.
    """
    entry = KINDS[kind]
    if kind not in ("prism15", "hex20"):
        return tuple(range(entry.nodes))
    base = entry.corners // 2
    upright = entry.sides[:base] + entry.sides[2 * base:] + entry.sides[base:2 * base]
    return order_of(kind, range(entry.corners), upright)


@dataclass(frozen=True)
class Block:
    """Elements of one kind."""

    kind: str  # of KINDS
    cells: Any  # (m, nodes) indices into the nodes, from 0
    part: Any  # (m,) number of the element's part among those of its dimension
    layer: Optional[Any] = None  # (m,) 0: core; None: no element is of a layer

    @property
    def dimension(self) -> int:
        return KINDS[self.kind].dimension

    def __len__(self) -> int:
        return len(self.cells)

    @property
    def layers(self):
        return np.zeros(len(self), np.int32) if self.layer is None else self.layer


class Run(NamedTuple):
    """Elements of one kind and one part."""

    part: int
    kind: str
    elements: Any  # (m,) their numbers, ascending
    cells: Any  # (m, nodes)


@dataclass(frozen=True)
class Group:
    """Some parts of one dimension under one name."""

    name: str
    dimension: int
    parts: Tuple[int, ...]  # their numbers


@dataclass(frozen=True)
class MeshParts:
    nodes: Any  # (n, 3) float64
    blocks: Tuple[Block, ...]  # none of them empty; surface, then volume, then lines
    groups: Tuple[Group, ...] = ()
    names: Mapping[Tuple[int, int], str] = field(default_factory=dict)  # see name()
    # What a flow solver takes the part or the group of a name for: "wall", "symmetry", "empty", …
    patch_types: Mapping[str, str] = field(default_factory=dict)
    metre: float = 0.001  # length of one unit of the nodes [m]
    layer_groups: bool = False  # each layer of the surface is to be a group, too
    node_layer: Optional[Any] = None  # (n,) the layer that a node was extruded in; 0: none
    node_parent: Optional[Any] = None  # (n,) the node that it was extruded from; -1: none
    # (k, 2) each: nodes, and those that one periodic motion brings them onto.
    periodic: Tuple[Any, ...] = ()
    _elements_by_part: Dict[int, Dict[int, Any]] = field(
        default_factory=dict, init=False, repr=False, compare=False)

    @property
    def dimension(self) -> int:
        """Of the elements that the mesh consists of; those of fewer dimensions bound it."""
        return max((block.dimension for block in self.blocks), default=0)

    @property
    def second_order(self) -> bool:
        return any(KINDS[block.kind].sides for block in self.blocks)

    def of(self, *dimensions: int) -> List[Block]:
        return [block for block in self.blocks if block.dimension in dimensions]

    def only(self, *dimensions: int) -> "MeshParts":
        """Without the elements of other dimensions; all nodes stay."""
        return self.with_blocks(self.of(*dimensions))

    def with_blocks(self, blocks: Iterable[Block]) -> "MeshParts":
        return replace(self, blocks=tuple(blocks))

    def scaled(self, factor: float) -> "MeshParts":
        """With coordinates that are `factor` times as large: in another unit, of the same size."""
        if factor == 1.0:
            return self
        return replace(self, nodes=self.nodes * factor, metre=self.metre / factor)

    def name(self, dimension: int, number: int) -> str:
        """The part's own: FaceN, EdgeN, SolidN, or what `names` calls it."""
        return self.names.get((dimension, number)) or f"{_OWN_NAME[dimension]}{number}"

    def part_numbers(self, dimension: int) -> List[int]:
        """Of the parts that have elements, ascending."""
        numbers = [np.unique(block.part) for block in self.of(dimension)]
        return np.unique(np.concatenate(numbers)).tolist() if numbers else []

    def owners(self, dimension: int) -> Dict[int, str]:
        """One name for each part, for formats in which an element has only one: the first group
        that holds it, else its own."""
        found = {number: self.name(dimension, number) for number in self.part_numbers(dimension)}
        for group in reversed(self.groups):
            if group.dimension == dimension:
                found.update({number: group.name for number in group.parts if number in found})
        return found

    def grouped(self, dimension: int) -> List[int]:
        """The parts that lie in a group, ascending."""
        present = set(self.part_numbers(dimension))
        return sorted({number for group in self.groups if group.dimension == dimension
                       for number in group.parts if number in present})

    @cached_property
    def starts(self) -> List[int]:
        """For each block the number of elements before it."""
        return [0, *np.cumsum([len(block) for block in self.blocks]).tolist()][:-1]

    def elements_by_part(self, dimension: int) -> Dict[int, Any]:
        """By part the numbers of its elements, from 1, ascending."""
        if dimension not in self._elements_by_part:
            self._elements_by_part[dimension] = self._numbers_by(
                dimension, [block.part for block in self.of(dimension)])
        return self._elements_by_part[dimension]

    @cached_property
    def elements_by_layer(self) -> Dict[int, Any]:
        """Of the surface."""
        return self._numbers_by(2, [block.layers for block in self.of(2)])

    def _numbers_by(self, dimension: int, values: Sequence[Any]) -> Dict[int, Any]:
        if not values:
            return {}
        elements = np.concatenate([
            np.arange(start + 1, start + 1 + len(block))
            for start, block in zip(self.starts, self.blocks) if block.dimension == dimension])
        value = np.concatenate(values)
        order = np.argsort(value, kind="stable")
        found, first = np.unique(value[order], return_index=True)
        return dict(zip(found.tolist(), np.split(elements[order], first[1:])))

    def by_part(self, dimension: int) -> Iterator["Run"]:
        """The elements of each part in turn, those of one kind at a time."""
        runs = []
        for start, block in zip(self.starts, self.blocks):
            if block.dimension == dimension:
                order = np.argsort(block.part, kind="stable")
                found, first = np.unique(block.part[order], return_index=True)
                runs += [(number, start, block, places) for number, places
                         in zip(found.tolist(), np.split(order, first[1:]))]
        for number, start, block, places in sorted(runs, key=lambda run: run[:2]):
            yield Run(number, block.kind, start + 1 + places, block.cells[places])

    def element_sets(self, *dimensions: int) -> List[Tuple[str, int, Any]]:
        """(name, dimension, numbers of the elements, ascending): the parts of these dimensions, the
        groups, and the layers where they are asked for. Empty ones are left out."""
        found = [(self.name(dimension, number), dimension, elements)
                 for dimension in dimensions
                 for number, elements in sorted(self.elements_by_part(dimension).items())]
        for group in self.groups:
            if group.dimension in dimensions:
                by_part = self.elements_by_part(group.dimension)
                members = [by_part[number] for number in group.parts if number in by_part]
                if members:
                    found.append((group.name, group.dimension, np.sort(np.concatenate(members))))
        if self.layer_groups and 2 in dimensions:
            found += [(f"Layer{layer}" if layer else "Core", 2, elements)
                      for layer, elements in sorted(self.elements_by_layer.items())]
        return found

    def nodes_by_part(self, dimension: int) -> Dict[int, Any]:
        """The nodes of each part, from 0, ascending."""
        cells: Dict[int, List[Any]] = {}
        for run in self.by_part(dimension):
            cells.setdefault(run.part, []).append(run.cells.ravel())
        return {number: np.unique(np.concatenate(part)) for number, part in cells.items()}

    def node_sets(self, dimension: int) -> List[Tuple[str, Any]]:
        """(name, nodes from 0, ascending) of the parts, and of their groups."""
        by_part = self.nodes_by_part(dimension)
        found = [(self.name(dimension, number), nodes) for number, nodes in by_part.items()]
        for group in self.groups:
            members = [by_part[number] for number in group.parts if number in by_part]
            if group.dimension == dimension and members:
                found.append((group.name, np.unique(np.concatenate(members))))
        return found


def periodic_parts(parts: MeshParts, dimension: int) -> List[Tuple[int, int, Any]]:
    """(part, the one that it is a copy of, (k, 2) their nodes) of that dimension."""
    found = []
    nodes = {number: frozenset(own.tolist())
             for number, own in parts.nodes_by_part(dimension).items()}
    for pairs in parts.periodic:
        image = dict(np.asarray(pairs).tolist())
        of_nodes = {own: number for number, own in nodes.items()}
        for number, own in nodes.items():
            if own <= image.keys():
                copy = of_nodes.get(frozenset(image[node] for node in own))
                if copy is not None:
                    found.append((copy, number, np.array([(image[node], node)
                                                          for node in sorted(own)])))
    return found


def of_mesh(mesh, named: Mapping[str, Sequence[str]], layer_groups: bool = False) -> MeshParts:
    """Of a mesh of the core or of a document object, of second order where it has mid nodes;
    `named`: the groups, FaceN and EdgeN in each. A group of both becomes two of that name."""
    blocks = [
        Block("quad4", mesh.quads, mesh.face_of_quad, mesh.layer_of_quad),
        Block("tri3", mesh.triangles, mesh.face_of_triangle, mesh.layer_of_triangle),
        _lines(mesh.edge_segments),
    ]
    parts = MeshParts(
        mesh.nodes, tuple(block for block in blocks if len(block)), tuple(_groups(named)),
        layer_groups=layer_groups, node_layer=mesh.node_layer, node_parent=mesh.node_parent,
        periodic=tuple(np.array(pairs) for pairs in getattr(mesh, "periodic_nodes", ())
                       if len(pairs)))
    return _with_mid_nodes(parts, mesh) if len(mesh.mid_nodes) else parts


def of_first_order(parts: MeshParts) -> MeshParts:
    """The same mesh without its mid nodes, which stay in the list of nodes."""
    blocks = []
    for block in parts.blocks:
        kind = _FIRST_ORDER.get(block.kind, block.kind)
        blocks.append(replace(block, kind=kind, cells=block.cells[:, :KINDS[kind].corners]))
    return parts.with_blocks(blocks)


def _with_mid_nodes(parts: MeshParts, mesh) -> MeshParts:
    by_edge = mesh.mids_of_segment
    lines = np.concatenate([by_edge[edge] for edge in sorted(by_edge)] or [np.zeros(0, np.int32)])
    mids = {"quad4": mesh.mids_of_quad, "tri3": mesh.mids_of_triangle, "line2": lines}
    blocks = []
    for block in parts.blocks:
        own = mids[block.kind].reshape(len(block), -1)
        blocks.append(replace(block, kind=SECOND_ORDER[block.kind],
                              cells=np.concatenate([block.cells, own], axis=1)))
    none = np.zeros(len(mesh.mid_nodes), np.int32)
    return replace(parts, nodes=np.concatenate([parts.nodes, mesh.mid_nodes]),
                   blocks=tuple(blocks), node_layer=np.concatenate([parts.node_layer, none]),
                   node_parent=np.concatenate([parts.node_parent, none - 1]))


def _lines(segments: Mapping[int, Any]) -> Block:
    given = [(number, pairs) for number, pairs in sorted(segments.items()) if len(pairs)]
    cells = [np.asarray(pairs, np.int32) for _number, pairs in given]
    counts = [len(pairs) for pairs in cells]
    numbers = np.array([number for number, _pairs in given], np.int32)
    return Block("line2", np.concatenate([np.zeros((0, 2), np.int32), *cells]),
                 np.repeat(numbers, counts).astype(np.int32))


def _groups(named: Mapping[str, Iterable[str]]) -> Iterable[Group]:
    for dimension in (2, 1):
        own = _OWN_NAME[dimension]
        for name, members in named.items():
            parts = tuple(int(member[len(own):]) for member in members if member.startswith(own))
            if parts:
                yield Group(name, dimension, parts)

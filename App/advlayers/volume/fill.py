"""Fills a closed surface mesh with volume cells: the one way there, for jobs, scripts and windows.
"""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Callable, Dict, FrozenSet, List, Mapping, Optional, Sequence

import numpy as np

from advlayers.errors import InputError
from advlayers.formats.mesh_parts import (
    SECOND_ORDER, Block, Group, MeshParts, of_first_order)
from advlayers.volume import gmsh_filler, netgen_filler
from advlayers.volume.curved import Project, with_mid_nodes
from advlayers.volume.programs import Cells, gmsh, python_with_netgen
from advlayers.volume.quality import (
    SLIVER, figures, least_pyramid_volumes, tetrahedron_volumes)
from advlayers.volume.skin import Skin, check_closed, in_triangles, skin_of

_THINNEST_QUAD = 40  # measured: at 20 it takes twice the time of 7, at 70 there is no end
_FLIPPED = {4: (1, 0, 2, 3), 5: (0, 3, 2, 1, 4)}


@dataclass(frozen=True)
class Filled:
    parts: MeshParts
    figures: Dict[str, Any]  # as the report has them


def kinds(values: Mapping[str, Any], order: int) -> FrozenSet[str]:
    """Of the cells that a checked block asks for."""
    first = ("tet4", "pyramid5") if values["quads"] == "keep" else ("tet4",)
    return frozenset(first if order == 1 else (SECOND_ORDER[kind] for kind in first))


class VolumeFill:
    """What the block `volume` says."""

    def __init__(self, size: float, program: str = "any", quads: str = "split",
                 name: str = "Volume", most_slivers: float = 100.0) -> None:
        self._size, self._program, self._quads = size, program, quads
        self._name, self._most_slivers = name, most_slivers

    @classmethod
    def of_settings(cls, values: Mapping[str, Any], size: float) -> "VolumeFill":
        """Of a checked block; `size` [mm] where it has none."""
        return cls(values["size"] or size, values["program"], values["quads"], values["name"],
                   values["most_slivers"])

    def fill(self, parts: MeshParts, solids: Sequence[Sequence[int]], label: str,
             project: Optional[Project] = None,
             watch: Callable[[], None] = lambda: None) -> Filled:
        """`solids`: the CAD faces around each volume; none: all faces are around one. `project`
        puts mid nodes on the shape, where the mesh is of second order. Raises InputError where the
        surface is not closed, where no program is there or it fails, or where what came out is no
        good; and what `watch` raises, called while a program runs.
        """
        keep = self._quads == "keep"
        if parts.second_order and keep:
            raise InputError("volume.quads", "must be \"split\" at order 2, got \"keep\"")
        check_closed(parts, label)
        corners = of_first_order(parts)
        if keep:
            _check_sides(corners)
        cut = corners if keep else in_triangles(corners)
        skin, used = skin_of(cut, solids)
        cells = self._upright(self._run(skin, watch), label)
        told = figures(cells.nodes, cells.tetrahedra, cells.pyramids)
        self._judge(told, label)
        place = np.empty(len(parts.nodes), np.int64)
        place[used] = np.arange(len(used))
        cut = replace(cut, blocks=tuple(replace(block, cells=place[block.cells])
                                        for block in cut.blocks))
        if parts.second_order:
            moved = _renumbered(parts, place, used)
            curved = with_mid_nodes(moved, cut, cells.nodes, cells.tetrahedra,
                                    cells.solid_of_tetrahedron, project)
            told["mid_nodes_off_shape"] = curved.off_shape
            told["furthest_off_shape"] = curved.furthest
            made = curved.parts
        else:
            blocks = [Block("tet4", cells.tetrahedra, cells.solid_of_tetrahedron),
                      Block("pyramid5", cells.pyramids, cells.solid_of_pyramid)]
            made = replace(cut, nodes=cells.nodes, blocks=_in_order(cut, blocks))
        group = Group(self._name, 3, tuple(range(1, len(skin.solids) + 1)))
        made = replace(made, groups=made.groups + (group,), **_node_fields(parts, used, made))
        return Filled(made, told)

    def _run(self, skin: Skin, watch: Callable[[], None]) -> Cells:
        command = gmsh() if self._program in ("any", "gmsh") else ""
        if command:
            return gmsh_filler.fill(command, skin, self._size, watch)
        python = python_with_netgen() if self._program in ("any", "netgen") else ""
        if python:
            return netgen_filler.fill(python, skin, self._size, watch)
        if self._program == "any":
            raise InputError("", "Neither Gmsh nor Netgen is installed: install the package gmsh, "
                             "or tell FreeCAD where it is under Edit > Preferences > FEM > Gmsh")
        raise InputError("volume.program", "is not installed: {}", self._program)

    @staticmethod
    def _upright(cells: Cells, label: str) -> Cells:
        """All cells in the usual sense. A program turns all of them one way or all the other."""
        tetrahedra, pyramids = (_turned(cells.nodes, part) for part in
                                (cells.tetrahedra, cells.pyramids))
        volumes = np.concatenate([tetrahedron_volumes(cells.nodes, tetrahedra),
                                  least_pyramid_volumes(cells.nodes, pyramids)])
        bad = int((volumes <= 0.0).sum())
        if bad:
            raise InputError("", "{} cannot be filled: {} of {} cells have no volume, or a "
                             "negative one", label, bad, len(volumes))
        return cells._replace(tetrahedra=tetrahedra, pyramids=pyramids)

    def _judge(self, told: Dict[str, Any], label: str) -> None:
        if told["sliver_percent"] > self._most_slivers:
            raise InputError(
                "volume.most_slivers", "is exceeded in {}: {} % of the tetrahedra have an angle "
                "below {} degrees between their sides, beside elements that are thin: raise "
                "first_height there, or lower size", label, f"{told['sliver_percent']:.1f}",
                f"{SLIVER:g}")


def _check_sides(parts: MeshParts) -> None:
    """Gmsh finds no end with pyramids on quads that are too thin."""
    for block in parts.of(2):
        points = parts.nodes[block.cells]
        sides = np.linalg.norm(np.roll(points, -1, axis=1) - points, axis=2)
        thinnest = float((sides.max(axis=1) / sides.min(axis=1)).max())
        if block.kind == "quad4" and thinnest > _THINNEST_QUAD:
            raise InputError("volume.quads", "cannot be kept: one is {} times as long as high, and "
                             "{} is the most; split them, or raise first_height",
                             f"{thinnest:.0f}", _THINNEST_QUAD)


def _turned(nodes, cells):
    if not len(cells):
        return cells
    volumes = (tetrahedron_volumes if cells.shape[1] == 4 else least_pyramid_volumes)(nodes, cells)
    return cells if np.median(volumes) > 0.0 else cells[:, _FLIPPED[cells.shape[1]]]


def _in_order(cut: MeshParts, volume: List[Block]):
    """Surface, then volume, then lines."""
    return tuple(block for block in [*cut.of(2), *volume, *cut.of(1)] if len(block))


def _renumbered(parts: MeshParts, place, used) -> MeshParts:
    """Of second order, corners numbered as in the filled mesh, mid nodes after them."""
    others = np.setdiff1d(np.arange(len(parts.nodes)), used)
    place = place.copy()
    place[others] = len(used) + np.arange(len(others))
    return replace(parts, nodes=np.concatenate([parts.nodes[used], parts.nodes[others]]),
                   blocks=tuple(replace(block, cells=place[block.cells])
                                for block in parts.blocks))


def _node_fields(parts: MeshParts, used, made: MeshParts) -> Dict[str, Any]:
    """Layers of the skin's nodes; those inside have none."""
    if parts.node_layer is None:
        return {}
    layer = np.zeros(len(made.nodes), np.int32)
    layer[:len(used)] = np.asarray(parts.node_layer)[used]
    return {"node_layer": layer, "node_parent": None}

"""What stands in mesh files: the surface mesh, with mid nodes, extruded or filled as was asked."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence

from advlayers import export, extrusion, quad_centres
from advlayers.errors import InputError
from advlayers.formats.mesh_parts import MeshParts
from advlayers.report import info
from advlayers.sentence import Sentence
from advlayers.volume import fill


@dataclass(frozen=True)
class FileMesh:
    parts: MeshParts
    figures: Dict[str, Any] = field(default_factory=dict)  # of the volume, for the report
    notes: List[Dict[str, Any]] = field(default_factory=list)  # diagnostics


@dataclass(frozen=True)
class Form:
    """What is made of a surface mesh."""

    extrude: Optional[extrusion.Extrusion] = None
    volume: Optional[Mapping[str, Any]] = None  # the checked block
    quad_nodes: int = 8

    @property
    def needs_model(self) -> bool:
        return self.volume is not None or self.quad_nodes == 9

    def check(self, order: int) -> None:
        """Raises InputError where the wishes do not go together."""
        if self.extrude and self.volume:
            raise InputError("volume", "does not go with extrude")
        if self.quad_nodes == 9 and order == 1:
            raise InputError("quad_nodes", "goes with order 2 only, got 9")
        if self.quad_nodes == 9 and (self.extrude or self.volume):
            raise InputError("quad_nodes", "is of surfaces: 9 does not go with extrude or volume")

    def asked(self, groups: Mapping[str, Sequence[str]], order: int) -> export.Asked:
        cells = frozenset()
        if self.extrude:
            cells = extrusion.kinds(self.extrude, order)
            # Edges make faces.
            groups = {name: [f"Face{member[4:]}" for member in members if member.startswith("Edge")]
                      for name, members in groups.items()}
        elif self.volume:
            cells = fill.kinds(self.volume, order)
        return export.Asked(groups, order, cells, self.quad_nodes)

    def made(self, parts: MeshParts, model, label: str, size: float,
             watch: Callable[[], None] = lambda: None) -> FileMesh:
        """`size` [mm]: of the elements. Raises InputError, and what `watch` raises."""
        if self.extrude is not None:
            return FileMesh(extrusion.extrude(parts, self.extrude))
        if self.volume is None:
            nine = self.quad_nodes == 9
            return FileMesh(quad_centres.added(parts, model.project) if nine else parts)
        filled = fill.VolumeFill.of_settings(self.volume, size).fill(
            parts, model.solids, label, model.project, watch)
        return FileMesh(filled.parts, filled.figures, _notes(filled.figures))


def _notes(figures: Dict[str, Any]) -> List[Dict[str, Any]]:
    found = []
    if figures["slivers"]:
        found.append(info("volume-slivers", Sentence(
            "{} of {} tetrahedra have an angle below 5 degrees between two sides",
            (figures["slivers"], figures["tetrahedra"])).english))
    if figures.get("mid_nodes_off_shape"):
        found.append(info("volume-mid-nodes-off-shape", Sentence(
            "{} mid nodes of the volume's skin lie off the shape, by up to {} mm: on it, cells "
            "would be turned over",
            (figures["mid_nodes_off_shape"], f"{figures['furthest_off_shape']:.3g}")).english))
    return found

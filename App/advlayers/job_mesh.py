"""What a job writes: its surface mesh, with mid nodes, extruded or filled as it says."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List

from advlayers import extrusion, quad_centres
from advlayers.formats.mesh_parts import MeshParts, of_mesh
from advlayers.report import info
from advlayers.sentence import Sentence
from advlayers.volume.fill import VolumeFill


@dataclass(frozen=True)
class JobMesh:
    parts: MeshParts
    figures: Dict[str, Any] = field(default_factory=dict)  # of the volume, for the report
    notes: List[Dict[str, Any]] = field(default_factory=list)  # diagnostics


def job_mesh(job, mesh, model, label: str, size: float,
             watch: Callable[[], None] = lambda: None) -> JobMesh:
    """`job`: see job.Job; `size` [mm]: of the elements. Raises InputError, and what `watch` raises.
    """
    parts = of_mesh(mesh, job.settings["groups"], job.settings["layer_groups"])
    if job.extrude is not None:
        return JobMesh(extrusion.extrude(parts, job.extrude))
    if job.volume is None:
        nine = job.export["quad_nodes"] == 9
        return JobMesh(quad_centres.added(parts, model.project) if nine else parts)
    filled = VolumeFill.of_settings(job.volume, size).fill(
        parts, model.solids, label, model.project, watch)
    return JobMesh(filled.parts, filled.figures, _notes(filled.figures))


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

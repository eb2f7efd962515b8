"""The report of a finished mesh, as JSON may hold it."""
from __future__ import annotations

from typing import Any, Dict, List, Mapping

import advlayers
from advlayers.sentence import Sentence, of_diagnostic

FIGURES = (
    "nodes", "quads", "triangles", "quad_percent", "layer_quad_percent", "core_quad_percent",
    "angles_45_135_percent", "angles_below_20_percent", "angles_above_160_percent",
    "min_angle", "max_angle", "inverted",
)
SECONDS = ("read", "boundary", "triangulate", "layers", "core", "mesh_object", "write", "total")
# Diagnostics of the core that say of a wall what its "shortfalls" say.
WALL_SHORTFALL_CODES = ("wall-without-layers", "wall-short-of-layers", "wall-height-missed")


def make_report(input_name: str, mesh, notes: List[Dict[str, Any]],
                seconds: Mapping[str, float]) -> Dict[str, Any]:
    report: Dict[str, Any] = {"version": advlayers.__version__, "input": input_name}
    report.update((key, mesh.figures[key]) for key in FIGURES)
    report["patches"] = list(mesh.patches)
    # The heights asked for at every single node are for those who have the nodes.
    report["walls"] = [{key: value for key, value in wall.items() if key != "first_heights"}
                       for wall in mesh.walls]
    if len(mesh.periodic_nodes):
        report["periodic"] = [[[node + 1, other + 1] for node, other in pairs]
                              for pairs in mesh.periodic_nodes]
    report["diagnostics"] = list(notes) + list(mesh.diagnostics)
    report["seconds"] = {key: round(seconds.get(key, 0.0), 6) for key in SECONDS}
    return report


def info(code: str, text: str) -> Dict[str, Any]:
    """A diagnostic of the whole model that asks for no action."""
    return {"severity": "info", "code": code, "patch": None, "layer": 0, "point": None,
            "text": text}


def has_error(report: Mapping[str, Any]) -> bool:
    return any(entry["severity"] == "error" for entry in report["diagnostics"])


def make_strict(report: Mapping[str, Any]) -> None:
    """A wall that has less or other than it was asked for is an error."""
    for entry in report["diagnostics"]:
        if entry["code"] in WALL_SHORTFALL_CODES:
            entry["severity"] = "error"


def wall_shortfalls(wall: Mapping[str, Any]) -> List[Sentence]:
    """What one wall of a report has less or other than it was asked for."""
    return [of_diagnostic(entry) for entry in wall.get("shortfalls", ())]

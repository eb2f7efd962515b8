"""The report of a finished mesh, as JSON may hold it."""
from __future__ import annotations

from typing import Any, Dict, List, Mapping

import advlayers
from advlayers.sentence import Sentence

FIGURES = (
    "nodes", "quads", "triangles", "quad_percent", "layer_quad_percent", "core_quad_percent",
    "angles_45_135_percent", "angles_below_20_percent", "angles_above_160_percent",
    "min_angle", "max_angle", "inverted",
)
SECONDS = ("read", "boundary", "triangulate", "layers", "core", "mesh_object", "write", "total")
# A first height this far from the one asked for, relative to it, is a shortfall.
HEIGHT_TOLERANCE = 0.1
# Diagnostics of the core that say of a wall what wall_shortfalls() says of it.
WALL_SHORTFALL_CODES = ("wall-without-layers", "wall-short-of-layers", "wall-height-missed")


def make_report(input_name: str, mesh, notes: List[Dict[str, Any]],
                seconds: Mapping[str, float]) -> Dict[str, Any]:
    report: Dict[str, Any] = {"version": advlayers.__version__, "input": input_name}
    report.update((key, mesh.figures[key]) for key in FIGURES)
    report["patches"] = list(mesh.patches)
    # The heights asked for at every single node are for those who have the nodes.
    report["walls"] = [{key: value for key, value in wall.items() if key != "first_heights"}
                       for wall in mesh.walls]
    report["diagnostics"] = list(notes) + list(mesh.diagnostics)
    report["seconds"] = {key: round(seconds.get(key, 0.0), 6) for key in SECONDS}
    return report


def info(code: str, text: str) -> Dict[str, Any]:
    """A diagnostic of the whole model that asks for no action."""
    return {"severity": "info", "code": code, "patch": None, "layer": 0, "point": None,
            "text": text}


def has_error(report: Mapping[str, Any]) -> bool:
    return any(entry["severity"] == "error" for entry in report["diagnostics"])


def shortfalls(report: Mapping[str, Any]) -> List[Dict[str, Any]]:
    """An error-level diagnostic for each wall that got fewer layers than asked for, or layers of
    another first height."""
    return [{**info("shortfall", sentence.english), "severity": "error"}
            for wall in report["walls"] for sentence in wall_shortfalls(wall)]


def wall_shortfalls(wall: Mapping[str, Any]) -> List[Sentence]:
    """What one wall of a report has less or other than it was asked for."""
    found = []
    edge, face = wall["edge"], wall["face"]
    wanted = wall["requested_layers"]
    if isinstance(wanted, int) and wall["layers"] < wanted:
        found.append(Sentence("{} on {} got {} of {} layers",
                              (edge, face, str(wall["layers"]), str(wanted))))
    achieved = wall["achieved_first_height"]
    if achieved["max"] == 0.0:
        found.append(Sentence("{} on {} got no layer of a height that could be measured",
                              (edge, face)))
    elif wall["height_error"] > HEIGHT_TOLERANCE:
        found.append(Sentence(
            "{} on {} got first heights from {} to {} mm, off those asked for ({} mm on average) "
            "by up to {} %",
            (edge, face, f"{achieved['min']:.6g}", f"{achieved['max']:.6g}",
             f"{wall['first_height']:.6g}", f"{100.0 * wall['height_error']:.0f}")))
    return found

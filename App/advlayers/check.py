"""What is to be said about a mesh object: its references, its diagnostics, its worst elements."""
from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, List, Optional, Tuple

import numpy as np

from advlayers import analysis, element_mesh, layer_mesh
from advlayers.report import shortfalls

WORST = 10  # elements that are listed
# Better elements than this are none to list: a corner has some 25 or 155 degrees then.
_POOR_QUALITY = 0.3
_ORDER = ("error", "warning", "info")


@dataclass(frozen=True)
class Finding:
    severity: str  # "error", "warning" or "info"
    text: str
    point: Optional[Tuple[float, float, float]] = None  # [mm], where it has a place


def check(mesh_object) -> List[Finding]:
    """The gravest first."""
    found = [Finding("error", f"{problem.owner.Label}: {problem.text}")
             for problem in layer_mesh.reference_problems(mesh_object)]
    if mesh_object.State == layer_mesh.NOT_MESHED or not mesh_object.FemMesh.FaceCount:
        return found + [Finding("warning", "There is no mesh yet.")]
    if mesh_object.State == layer_mesh.OUT_OF_DATE:
        found.append(Finding("warning", "The mesh is out of date: settings or model have changed."))
    groups = {mesh_object.FemMesh.getGroupName(i) for i in mesh_object.FemMesh.Groups}
    for name in set(analysis.constraint_groups(mesh_object)) - groups:
        constraint = mesh_object.Document.getObject(name.rsplit("_", 1)[0])
        found.append(Finding("warning", f"{constraint.Label} came after the mesh and does not act "
                                        "on it: update the mesh."))
    if mesh_object.InvertedCount:
        found.append(Finding("error", f"{mesh_object.InvertedCount} elements are turned over."))
    if mesh_object.Details:
        report = json.loads(mesh_object.Details)
        found += [Finding("warning", entry["text"]) for entry in shortfalls(report)]
        found += [Finding(entry["severity"], entry["text"], _place(entry["point"]))
                  for entry in report["diagnostics"]]
    found += _worst_elements(mesh_object)
    return sorted(found, key=lambda finding: _ORDER.index(finding.severity))


def summary(mesh_object) -> str:
    """One line on the whole mesh."""
    return (f"{mesh_object.Label}: {mesh_object.QuadCount} quads, {mesh_object.TriangleCount} "
            f"triangles, {mesh_object.QuadPercent:.1f} % quads, "
            f"{mesh_object.GoodAnglePercent:.1f} % of angles in 45-135 deg, angles from "
            f"{mesh_object.MinAngle.Value:.1f} to {mesh_object.MaxAngle.Value:.1f} deg")


def _worst_elements(mesh_object) -> List[Finding]:
    mesh = element_mesh.of_fem(mesh_object.FemMesh)
    quality, centres = element_mesh.quality(mesh), element_mesh.centres(mesh)
    quads, triangles = element_mesh.angles(mesh)
    found = []
    for element in np.argsort(quality, kind="stable")[:WORST].tolist():
        if quality[element] >= _POOR_QUALITY:
            break
        corners = quads[element] if element < len(quads) else triangles[element - len(quads)]
        what = "Quad" if element < len(quads) else "Triangle"
        where = f"layer {mesh.layers[element]}" if mesh.layers[element] else "the core"
        found.append(Finding(
            "info", f"{what} {element + 1} in {where}: angles from {corners.min():.1f} to "
                    f"{corners.max():.1f} deg", _place(centres[element].tolist())))
    return found


def _place(point: Any) -> Optional[Tuple[float, float, float]]:
    return tuple(point) if point and any(point) else None

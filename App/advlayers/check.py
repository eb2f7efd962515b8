"""What is to be said about a mesh: its references, its diagnostics, its worst elements."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Iterable, List, Mapping, Optional, Tuple

import numpy as np

from advlayers import analysis, element_mesh, layer_mesh, mesh_data
from advlayers.language import tr
from advlayers.mesh_data import POOR_QUALITY, QUALITY, MeshData
from advlayers.report import WALL_SHORTFALL_CODES, wall_shortfalls
from advlayers.sentence import of_diagnostic

WORST = 10  # elements that are listed
_ORDER = ("error", "warning", "info")
# Kinds that something can be done about at once: lost references, a mesh that is to be made anew.
LOST, STALE = "lost-reference", "stale-mesh"


@dataclass(frozen=True)
class Finding:
    severity: str  # "error", "warning" or "info"
    text: str
    point: Optional[Tuple[float, float, float]] = None  # [mm], where it has a place
    element: int = -1  # from 0, where it is about one
    wall: int = -1  # its place among the walls of the report, where it is about one
    kind: str = ""  # findings of one kind are told together
    weight: float = 0.0  # how bad it is among those of its kind


@dataclass(frozen=True)
class Group:
    """Findings of one kind, the worst first."""

    findings: Tuple[Finding, ...]

    @property
    def severity(self) -> str:
        return self.findings[0].severity

    @property
    def kind(self) -> str:
        return self.findings[0].kind

    @property
    def text(self) -> str:
        """One line for all of them."""
        if len(self.findings) == 1:
            return self.findings[0].text
        return tr("{} times, the worst: {}").format(len(self.findings), self.findings[0].text)


def check(mesh_object) -> List[Finding]:
    """The gravest first."""
    found = of_object(mesh_object)
    if mesh_object.FemMesh.FaceCount:
        found += of_mesh(mesh_data.of_object(mesh_object))
    return by_severity(found)


def by_severity(findings: Iterable[Finding]) -> List[Finding]:
    return sorted(findings, key=lambda finding: _ORDER.index(finding.severity))


def grouped(findings: Iterable[Finding]) -> List[Group]:
    """By kind, the gravest first."""
    kinds: Dict[str, List[Finding]] = {}
    for number, finding in enumerate(findings):
        kinds.setdefault(finding.kind or str(number), []).append(finding)
    groups = [Group(tuple(sorted(members, key=lambda finding: (
        _ORDER.index(finding.severity), -finding.weight)))) for members in kinds.values()]
    return sorted(groups, key=lambda group: _ORDER.index(group.severity))


def of_object(mesh_object) -> List[Finding]:
    """How the mesh object stands in its document."""
    found = [Finding("error", f"{problem.owner.Label}: {problem.said.translated}", kind=LOST)
             for problem in layer_mesh.reference_problems(mesh_object)]
    if mesh_object.State == layer_mesh.SOURCE_IN_ERROR:
        found.append(Finding("error", tr(
            "{} is in error: the mesh cannot be updated before it is mended.").format(
                mesh_object.Part.Label)))
    if mesh_object.State == layer_mesh.NOT_MESHED or not mesh_object.FemMesh.FaceCount:
        return found + [Finding("warning", tr("There is no mesh yet."), kind=STALE)]
    missing = analysis.missing_groups(mesh_object)
    if mesh_object.State == layer_mesh.OUT_OF_DATE and not missing:
        found.append(Finding(
            "warning", tr("The mesh is out of date: settings or model have changed."),
            kind=STALE))
    for name in missing:
        constraint = mesh_object.Document.getObject(name.rsplit("_", 1)[0])
        found.append(Finding("warning", tr(
            "{} came after the mesh and does not act on it: update the mesh."
        ).format(constraint.Label), kind=STALE))
    return found


def of_mesh(data: MeshData) -> List[Finding]:
    """What the mesh itself gives cause for."""
    found = []
    if data.report.get("inverted"):
        found.append(Finding(
            "error", tr("{} elements are turned over.").format(data.report["inverted"])))
    walls = data.report.get("walls", ())
    for number, wall in enumerate(walls):
        found += [Finding("warning", sentence.translated, wall=number, kind=sentence.form,
                          weight=_missing_layers(wall))
                  for sentence in wall_shortfalls(wall)]
    found += [Finding(entry["severity"], of_diagnostic(entry).translated, _place(entry["point"]),
                      kind=entry["code"])
              for entry in data.report.get("diagnostics", ())
              if entry["code"] not in WALL_SHORTFALL_CODES
              or not any("shortfalls" in wall for wall in walls)]  # of an earlier version
    return found + _worst_elements(data)


def summary(mesh_object) -> str:
    """One line on the whole mesh."""
    return tr(
        "{label}: {quads} quads, {triangles} triangles, {percent:.1f} % quads, {good:.1f} % of "
        "angles in 45–135°, angles from {least:.1f}° to {largest:.1f}°").format(
            label=mesh_object.Label, quads=mesh_object.QuadCount,
            triangles=mesh_object.TriangleCount, percent=mesh_object.QuadPercent,
            good=mesh_object.GoodAnglePercent, least=mesh_object.MinAngle.Value,
            largest=mesh_object.MaxAngle.Value)


def _worst_elements(data: MeshData) -> List[Finding]:
    quality, mesh = data.field(QUALITY), data.mesh
    found = []
    for element in np.argsort(quality, kind="stable")[:WORST].tolist():
        if quality[element] >= POOR_QUALITY:
            break
        corners = element_mesh.angles_of(mesh, element)
        layer = int(mesh.layers[element])
        where = tr("in layer {}").format(layer) if layer else tr("in the core")
        text = tr("element {number} {where}: angles from {least:.1f}° to {largest:.1f}°").format(
            number=element + 1, where=where, least=corners.min(), largest=corners.max())
        centre = mesh.nodes[mesh.corners(element)].mean(axis=0)
        found.append(Finding("info", text, tuple(centre.tolist()), element, kind="worst-element",
                             weight=1.0 - float(quality[element])))
    return found


def _missing_layers(wall: Mapping[str, Any]) -> float:
    """Their share of those that were asked for."""
    asked = wall["requested_layers"]
    return 1.0 - wall["layers"] / asked if isinstance(asked, int) and asked > 0 else 0.0


def _place(point: Any) -> Optional[Tuple[float, float, float]]:
    return tuple(point) if point and any(point) else None

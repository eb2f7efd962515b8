"""Meshes one random face and says what is wrong with the mesh."""
from __future__ import annotations

import time
from typing import Any, Dict, List

import numpy as np

import advlayers_core as core
import cad_facts
import face_cases
from gaps import in_gaps
from mesh_checks import Elements, conformity_faults, turned_corners

LEAST_QUADS = 95.0  # [%] in each case
MEDIAN_QUADS = ((1.1, 98.0), (float("inf"), 97.0))  # growth up to -> [%] in the median


def mesh_shape(shape, job: Dict[str, Any]):
    """The finished mesh, by one thread."""
    mesher = core.Mesher(core.read_brep(shape.exportBrepToString()),
                         core.Settings(**job, threads=1))
    for _ in mesher:
        pass
    return mesher.result()


def area_tolerance(case: face_cases.FaceCase, elements: Elements) -> float:
    """What chords may take off or add to the area [mm^2]: arcs of the border lose c^3 k / 12, a
    surface of curvature k loses up to (k c)^2 / 8 of what it has."""
    border = elements.border()
    chords = np.linalg.norm(elements.nodes[border[:, 1]] - elements.nodes[border[:, 0]], axis=1)
    edges, _ = elements.directed_edges()
    longest = np.linalg.norm(elements.nodes[edges[:, 1]] - elements.nodes[edges[:, 0]],
                             axis=1).max()
    bend = 0.0 if case.surface.name == "plane" else 1.0 / case.surface.radius
    curvature = cad_facts.most_curved_edge(case.shape)
    return (1e-9 * case.shape.Area + (chords ** 3).sum() * curvature / 8.0
            + 0.15 * (bend * longest) ** 2 * case.shape.Area)


def faults_of(case: face_cases.FaceCase, mesh) -> List[str]:
    elements = Elements(mesh.nodes, mesh.quads, mesh.triangles)
    faults = conformity_faults(elements)
    normals = case.surface.normals(mesh.nodes)
    turned = turned_corners(elements, upward(case, normals))
    if turned:
        faults.append(f"{turned} elements turned over")
    if mesh.figures["inverted"]:
        faults.append(f"{mesh.figures['inverted']} inverted by the mesher's own count")
    if elements.euler() != cad_facts.euler_number(case.shape):
        faults.append(f"Euler number {elements.euler()} instead of "
                      f"{cad_facts.euler_number(case.shape)}")
    missing = elements.area() - case.shape.Area
    if abs(missing) > area_tolerance(case, elements):
        faults.append(f"area off by {missing:.3g} mm^2 of {case.shape.Area:.3g}")
    inside = np.ones(len(mesh.nodes), bool)
    inside[elements.border()] = False
    off = case.surface.distances(mesh.nodes)
    diagonal = case.shape.BoundBox.DiagonalLength
    if inside.any() and off[inside].max() > 1e-9 * diagonal:
        faults.append(f"a node lies {off[inside].max():.2g} mm off the surface")
    allowed = max(1e-9 * diagonal, cad_facts.worst_tolerance(case.shape))
    if off[~inside].max(initial=0.0) > allowed:
        faults.append(f"a border node lies {off[~inside].max():.2g} mm off the surface")
    errors = [entry["text"] for entry in mesh.diagnostics if entry["severity"] == "error"]
    return faults + errors


def upward(case: face_cases.FaceCase, normals: np.ndarray) -> np.ndarray:
    """`normals`, turned to the side that the face looks to."""
    point, normal = cad_facts.point_and_normal(case.shape)
    return normals if case.surface.normals(point[None])[0] @ normal > 0.0 else -normals


def run(seed: int, number: int) -> Dict[str, Any]:
    """A row of the table: never raises for a fault of the mesher."""
    case = face_cases.make(seed, number)
    row: Dict[str, Any] = {"number": number, "name": case.name, "growth": case.growth,
                           "job": case.job, "faults": []}
    start = time.perf_counter()
    try:
        mesh = mesh_shape(case.shape, case.job)
    except (ValueError, RuntimeError) as error:
        row["faults"].append(f"{type(error).__name__}: {error}")
        row["brep"] = case.shape.exportBrepToString()
        return row
    row["seconds"] = time.perf_counter() - start
    row["faults"] = faults_of(case, mesh)
    elements = Elements(mesh.nodes, mesh.quads, mesh.triangles)
    left_out = in_gaps(elements, upward(case, case.surface.normals(mesh.nodes)),
                       2.0 * case.job["first_height"])
    kept = ~left_out
    row["elements"], row["in_gaps"] = len(elements), int(left_out.sum())
    row["all_quads"] = mesh.figures["quad_percent"]
    row["quads"] = 100.0 * float(elements.is_quad()[kept].mean()) if kept.any() else 100.0
    row["figures"] = dict(mesh.figures)
    row["causes"] = mesh.patches[0]["triangles_by_cause"]
    if row["quads"] < LEAST_QUADS:
        row["faults"].append(f"{row['quads']:.1f} % quads")
    if row["faults"]:
        row["brep"] = case.shape.exportBrepToString()
    return row


def summary(rows: List[Dict[str, Any]]) -> List[str]:
    """Prints quads by kind and by surface; returns the medians that missed their bar."""
    measured = [row for row in rows if "quads" in row]
    print(f"  {'':22s} cases  elements  quads %: least  median   all, in gaps too   triangles by "
          "cause")
    for word in face_cases.KINDS + face_cases.surfaces.NAMES:
        _print_group(word, [row for row in measured if word in row["name"].split()])
    missed, low = [], 0.0
    for high, bar in MEDIAN_QUADS:
        group = [row for row in measured if low < row["growth"] <= high]
        name = f"growth up to {high:g}" if low == 0.0 else f"growth above {low:g}"
        _print_group(name, group)
        if group and np.median([row["quads"] for row in group]) < bar:
            missed.append(f"median at {name} is below {bar} % quads")
        low = high
    for line in missed:
        print("  " + line)
    return missed


def _print_group(name: str, rows: List[Dict[str, Any]]) -> None:
    if not rows:
        return
    quads = [row["quads"] for row in rows]
    causes: Dict[str, int] = {}
    for row in rows:
        for cause, count in row["causes"].items():
            causes[cause] = causes.get(cause, 0) + count
    print(f"  {name:22s} {len(rows):5d} {sum(row['elements'] for row in rows):9d} "
          f"{min(quads):14.2f} {np.median(quads):7.2f} "
          f"{np.median([row['all_quads'] for row in rows]):18.2f}   "
          + ", ".join(f"{count} {cause}" for cause, count in sorted(causes.items())))

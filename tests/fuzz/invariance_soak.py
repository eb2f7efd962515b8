"""Meshes one random face, and the same face moved, turned, scaled and mirrored."""
from __future__ import annotations

import time
from random import Random
from typing import Any, Dict, List

import numpy as np

import face_cases
from face_soak import mesh_shape
from freecad_part import FreeCAD

FIGURES = ("quad_percent", "angles_45_135_percent")
MEDIAN_BAR, EACH_BAR = 0.2, 0.5  # [percentage points]
SCALES = (1e-3, 1e-2, 0.1, 10.0, 1e3)


def copies(rng: Random, case: face_cases.FaceCase) -> Dict[str, Any]:
    """Name -> (shape, job); boxes stay at 1 mm and more."""
    vector = FreeCAD.Vector
    axis = vector(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1))
    reach = case.shape.BoundBox.DiagonalLength
    away = vector(*(rng.uniform(-20.0, 20.0) * reach for _ in range(3)))
    scale = rng.choice([each for each in SCALES if each * reach >= 1.0])
    scaled = case.shape.copy()
    scaled.scale(scale)
    job = {**case.job, "size": scale * case.job["size"],
           "first_height": scale * case.job["first_height"]}
    return {
        "turned": (case.shape.rotated(vector(), axis, rng.uniform(10.0, 350.0)), case.job),
        "moved": (case.shape.translated(away), case.job),
        "scaled": (scaled, job),
        "mirrored": (case.shape.mirror(vector(), axis), case.job),
    }


def run(seed: int, number: int) -> Dict[str, Any]:
    case = face_cases.make(seed, number)
    row: Dict[str, Any] = {"number": number, "name": case.name, "job": case.job, "faults": [],
                           "differences": {}}
    start = time.perf_counter()
    mesh = mesh_shape(case.shape, case.job)
    row["elements"] = len(mesh.quads) + len(mesh.triangles)
    for way, (shape, job) in copies(Random(f"{seed} copies {number}"), case).items():
        other = mesh_shape(shape, job)
        row["differences"][way] = {
            figure: abs(other.figures[figure] - mesh.figures[figure]) for figure in FIGURES}
        worst = max(row["differences"][way].values())
        if worst > EACH_BAR:
            row["faults"].append(f"{way} differs by {worst:.2f} points")
        if other.figures["inverted"]:
            row["faults"].append(f"{way} has {other.figures['inverted']} inverted")
    row["seconds"] = time.perf_counter() - start
    if row["faults"]:
        row["brep"] = case.shape.exportBrepToString()
    return row


def summary(rows: List[Dict[str, Any]]) -> List[str]:
    """Differences in percentage points; returns the medians that missed their bar."""
    missed = []
    print("             quads: median     most   45-135: median     most   points")
    for way in ("turned", "moved", "scaled", "mirrored"):
        line = f"  {way:10s}"
        for figure in FIGURES:
            points = [row["differences"][way][figure] for row in rows if way in
                      row.get("differences", {})]
            line += f"{np.median(points):15.3f} {max(points):8.3f}  "
            if np.median(points) > MEDIAN_BAR:
                missed.append(f"{figure} of the {way}: median above {MEDIAN_BAR} points")
        print(line)
    return missed

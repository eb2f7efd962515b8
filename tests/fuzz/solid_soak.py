"""Meshes one random solid and says what is wrong with the mesh."""
from __future__ import annotations

import os
import time
from random import Random
from typing import Any, Dict, List

import numpy as np

import advlayers_core as core
import cad_facts
import solid_shapes
from mesh_checks import Elements, conformity_faults, folds

KINDS = tuple(solid_shapes.MAKERS)
# Chords that turn by 30 degrees cut 4.5 % off a circle's area, and off a torus twice that.
AREA_OFF, VOLUME_OFF = 0.05, 0.09


def run(seed: int, number: int) -> Dict[str, Any]:
    """A row of the table: never raises for a fault of the mesher."""
    kind = KINDS[number % len(KINDS)]
    name = f"{seed} solid {number}"
    while not kernel_survives(kind, name):
        name += " again"
    rng = Random(name)
    shape = solid_shapes.make(kind, rng)
    size = shape.BoundBox.DiagonalLength / rng.uniform(15.0, 40.0)
    job = {"size": size, "first_height": size / rng.uniform(3.0, 12.0),
           "growth": rng.choice((1.05, 1.1, 1.2, 1.3)), "layers": rng.choice((0, 0, 3, 8)),
           "feature_angle": rng.choice((0.0, 20.0))}
    row: Dict[str, Any] = {"number": number, "name": kind, "job": job, "faces": len(shape.Faces),
                           "faults": []}
    text = shape.exportBrepToString()
    start = time.perf_counter()
    try:
        model = core.read_brep(text)
        mesher = core.Mesher(model, core.Settings(**job, threads=1))
        for _ in mesher:
            pass
        mesh = mesher.result()
    except (ValueError, RuntimeError) as error:
        return {**row, "faults": [f"{type(error).__name__}: {error}"], "brep": text}
    row["seconds"] = time.perf_counter() - start
    row["faults"] = faults_of(shape, model, mesh, size)
    row["elements"] = len(mesh.quads) + len(mesh.triangles)
    row["quads"] = mesh.figures["quad_percent"]
    row["figures"] = dict(mesh.figures)
    codes = [entry["code"] for entry in mesh.diagnostics]
    row["diagnostics"] = {code: codes.count(code) for code in sorted(set(codes))}
    if row["faults"]:
        row["brep"] = text
    return row


def kernel_survives(kind: str, name: str) -> bool:
    """Whether the shape can be made at all: OpenCASCADE crashes over some, and takes the process
    with it."""
    child = os.fork()
    if child == 0:
        solid_shapes.make(kind, Random(name))
        os._exit(0)
    return os.waitpid(child, 0)[1] == 0


def faults_of(shape, model, mesh, size: float) -> List[str]:
    """A face far smaller than an element may be lost in a patch, but not where it is one alone."""
    elements = Elements(mesh.nodes, mesh.quads, mesh.triangles)
    faults = conformity_faults(elements, model.closed)
    if mesh.figures["inverted"]:
        faults.append(f"{mesh.figures['inverted']} inverted")
    faces = np.concatenate([mesh.face_of_quad, mesh.face_of_triangle])
    folded = folds(elements, faces, cad_facts.tips(shape),
                   lambda face, points: cad_facts.turn_under(shape.Faces[face - 1], points))
    if folded:
        faults.append(f"{folded} folds")
    missing = set(range(1, model.face_count + 1)) - set(faces.tolist())
    missing = sorted(i for i in missing if shape.Faces[i - 1].Area > 2.0 * size * size or
                     any(patch["faces"] == [f"Face{i}"] for patch in mesh.patches))
    if missing:
        faults.append("no elements on " + ", ".join(f"Face{i}" for i in missing))
    if elements.euler() != cad_facts.euler_number(shape):
        faults.append(f"Euler number {elements.euler()} instead of "
                      f"{cad_facts.euler_number(shape)}")
    for what, got, wanted, most in (("area", elements.area(), shape.Area, AREA_OFF),
                                    ("volume", elements.volume(), shape.Volume, VOLUME_OFF)):
        if abs(got / wanted - 1.0) > most:
            faults.append(f"{what} off by {100.0 * (got / wanted - 1.0):.2f} %")
    return faults + [entry["text"] for entry in mesh.diagnostics if entry["severity"] == "error"]


def summary(rows: List[Dict[str, Any]]) -> List[str]:
    """Prints a line for each kind."""
    print(f"  {'':12s} cases  faces  elements  quads %: least  median   45-135 %   diagnostics")
    for kind in KINDS + ("",):
        group = [row for row in rows if "quads" in row and row["name"].startswith(kind)]
        if not group:
            continue
        codes: Dict[str, int] = {}
        for row in group:
            for code, count in row["diagnostics"].items():
                codes[code] = codes.get(code, 0) + count
        quads = [row["quads"] for row in group]
        print(f"  {kind or 'all':12s} {len(group):5d} {sum(row['faces'] for row in group):6d} "
              f"{sum(row['elements'] for row in group):9d} {min(quads):14.2f} "
              f"{np.median(quads):7.2f} "
              f"{np.median([row['figures']['angles_45_135_percent'] for row in group]):10.2f}   "
              + ", ".join(f"{count} {code}" for code, count in sorted(codes.items())))
    return []

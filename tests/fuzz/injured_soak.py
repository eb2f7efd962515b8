"""Meshes one shape with injured tolerances and says what is wrong with the mesh."""
from __future__ import annotations

import time
from random import Random
from typing import Any, Dict, List

import numpy as np

import advlayers_core as core
import injuries
from freecad_part import Part
from mesh_checks import Elements, conformity_faults

KINDS = tuple(injuries.MAKERS)
LEAST_EDGE = 1e-3  # of the size, where the shape has no shorter edge itself
KERNEL_FAULTS = (Part.OCCError, ValueError, RuntimeError, ArithmeticError)


def run(seed: int, number: int) -> Dict[str, Any]:
    """A row of the table: never raises for a fault of the mesher."""
    kind = KINDS[number % len(KINDS)]
    rng = Random(f"{seed} injured {number}")
    text = injured(kind, rng)
    shape = Part.Shape()
    shape.importBrepFromString(text)
    size = shape.BoundBox.DiagonalLength / rng.uniform(15.0, 60.0)
    job = {"size": size, "first_height": size / rng.uniform(3.0, 12.0),
           "growth": rng.choice((1.1, 1.2, 1.3)), "layers": rng.choice((0, 3)),
           "feature_angle": rng.choice((0.0, 20.0))}
    row: Dict[str, Any] = {"number": number, "name": kind, "job": job, "faults": []}
    start = time.process_time()
    try:
        model = core.read_brep(text)
        mesher = core.Mesher(model, core.Settings(**job, threads=1))
        for _ in mesher:
            pass
        mesh = mesher.result()
    except (ValueError, RuntimeError) as error:
        return {**row, "faults": [f"{type(error).__name__}: {error}"], "brep": text}
    row["seconds"] = time.process_time() - start
    row["elements"] = len(mesh.quads) + len(mesh.triangles)
    row["faults"] = faults_of(shape, model, mesh, size)
    if row["faults"]:
        row["brep"] = text
    return row


def injured(kind: str, rng: Random) -> str:
    """Tries until the kernel makes a shape of it."""
    while True:
        try:
            text = injuries.MAKERS[kind](rng)
            shape = Part.Shape()
            shape.importBrepFromString(text)
        except KERNEL_FAULTS:
            continue
        if shape.Faces and shape.Area > 0.1:
            return text


def faults_of(shape: "Part.Shape", model: "core.Model", mesh: "core.Mesh",
              size: float) -> List[str]:
    """All faces are sound but for what lies within the tolerances: each has elements, or is told to
    be narrower than they are."""
    elements = Elements(mesh.nodes, mesh.quads, mesh.triangles)
    if all(face.Orientation == shape.Faces[0].Orientation for face in shape.Faces):
        faults = conformity_faults(elements, model.closed)
    else:
        faults = uses_faults(elements, model.closed)
    if mesh.figures["inverted"]:
        faults.append(f"{mesh.figures['inverted']} inverted")
    faces = set(np.concatenate([mesh.face_of_quad, mesh.face_of_triangle]).tolist())
    told = " ".join(entry["text"] for entry in mesh.diagnostics)
    missing = [f"Face{i}" for i in range(1, model.face_count + 1)
               if i not in faces and f"Face{i} is narrower" not in told
               and shape.Faces[i - 1].Area > LEAST_EDGE * size * size]
    if missing:
        faults.append("no elements on " + ", ".join(missing))
    shortest = min((edge.Length for edge in shape.Edges if not edge.Degenerated), default=0.0)
    least = min(np.linalg.norm(mesh.nodes[corners] - mesh.nodes[np.roll(corners, 1, axis=1)],
                               axis=2).min()
                for corners in (mesh.quads, mesh.triangles) if len(corners)) if faces else 0.0
    if least < min(LEAST_EDGE * size, 0.5 * shortest):
        faults.append(f"a mesh edge of {least:.2g} mm at size {size:.3g}")
    return faults + [entry["text"] for entry in mesh.diagnostics if entry["severity"] == "error"]


def uses_faults(elements: Elements, closed: bool) -> List[str]:
    """Where faces look either way: what keeps the elements from being conforming."""
    edges, _ = elements.directed_edges()
    _, uses = np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)
    faults = [f"{int((uses > 2).sum())} edges of more than two elements"] if uses.max() > 2 else []
    if closed and uses.min() < 2:
        faults.append(f"{int((uses < 2).sum())} open edges of a closed shape")
    return faults


def summary(rows: List[Dict[str, Any]]) -> List[str]:
    """Prints a line for each kind."""
    print(f"  {'':20s} cases  failed  elements  seconds: most")
    for kind in KINDS:
        group = [row for row in rows if row["name"] == kind]
        done = [row for row in group if "elements" in row]
        if group:
            print(f"  {kind:20s} {len(group):5d} {sum(bool(row['faults']) for row in group):7d} "
                  f"{sum(row['elements'] for row in done):9d} "
                  f"{max((row['seconds'] for row in done), default=0.0):14.2f}")
    return []

"""Quality of the meshes against the paper's, gmsh's, and the bars of the method.

    ./dev bench quality [--peers] [--meshes FOLDER] [--json FILE] [--judge PATH] [NAME ...]

One line for each case: elements, quads (all, in layers, in the core), angles, and what was measured
on the finished mesh at regular wall nodes: share of first heights within 2 % of what was asked, the
largest deviation, the growth's, and the mean angle between extrusions and the front's normal. Then
the triangles by cause. --peers: gmsh beside it, isotropic quads and its boundary layers.
--meshes: keeps each mesh as VTU. --judge: a program that measures a mesh file against its CAD,
`PATH MESH CAD --h0 H --growth R --json FILE`. NAME: part of a case's name, or a group (paper, fan,
growth, primitive). Exit status 1: an element is inverted, a bar is missed, or the judge has found a
fault.
"""
from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from typing import Any, Dict, List, Tuple

import numpy as np

import advlayers_core as core
from cases import CASES, Case
from json_file import write_json
from layer_heights import measure
from mesh_checks import Elements

HEAD = (f"{'case':32s} {'elements':>8s} {'quads %':>7s} {'layers':>6s} {'core':>6s} {'45-135':>6s} "
        f"{'< 20':>6s} {'> 160':>6s} {'min':>5s} {'max':>5s} {'inv':>3s} | {'h0 2%':>6s} "
        f"{'worst':>6s} {'growth':>6s} {'normal':>6s} | triangles by cause")
PEER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "gmsh_peer.py")
# Of measure(): what, least, most.
LAYER_BARS = (("height_within_2", 95.0, 100.0), ("height_off", 0.0, 10.0),
              ("growth_off", 0.0, 3.0), ("direction", 0.0, 1.0))
ANGLE_BINS = tuple(range(0, 181, 5))


def run(case: Case) -> Tuple[Any, Any, Dict[str, Any]]:
    shape = case.shape()
    model = core.read_brep(shape.exportBrepToString())
    start = time.perf_counter()
    mesher = core.Mesher(model, core.Settings(**case.job, threads=1))
    for _ in mesher:
        pass
    mesh = mesher.result()
    seconds = time.perf_counter() - start
    figures = mesh.figures
    causes: Dict[str, int] = {}
    for patch in mesh.patches:
        for cause, count in patch["triangles_by_cause"].items():
            causes[cause] = causes.get(cause, 0) + count
    angles = Elements(mesh.nodes, mesh.quads, mesh.triangles).angles()
    return shape, mesh, {
        "name": case.name, "group": case.group, "job": case.job,
        "elements": figures["quads"] + figures["triangles"], "quads": figures["quad_percent"],
        "layer_quads": figures["layer_quad_percent"], "core_quads": figures["core_quad_percent"],
        "angles": figures["angles_45_135_percent"], "below_20": figures["angles_below_20_percent"],
        "above_160": figures["angles_above_160_percent"], "min": figures["min_angle"],
        "max": figures["max_angle"], "inverted": figures["inverted"], "seconds": seconds,
        "causes": causes,
        "early_triangles": int(np.isin(mesh.layer_of_triangle, (1, 2)).sum()),
        "histogram": np.histogram(angles, ANGLE_BINS)[0].tolist(),
        "layers": measure(shape, mesh, case.first_height, case.growth),
        "paper": case.paper, "bar": case.bar}


def missed(row: Dict[str, Any]) -> List[str]:
    """The bars that a row does not meet."""
    found = [f"{row['inverted']} inverted elements"] if row["inverted"] else []
    for key, bar in (row["bar"] or {}).items():
        if (row[key] > bar) if key == "elements" else (row[key] < bar):
            found.append(f"{key} {row[key]:.6g}, the bar is {bar:g}")
    layers = row["layers"]
    if row["group"] == "fan" and row["early_triangles"]:
        found.append(f"{row['early_triangles']} triangles in the first two layers of a fan")
    for key, low, high in LAYER_BARS if layers["columns"] else ():
        if not low <= layers[key] <= high:
            found.append(f"{key} {layers[key]:.3g}, the bar is {low or high:g}")
    return found


def print_row(row: Dict[str, Any]) -> None:
    layers = row["layers"]
    causes = ", ".join(f"{count} {cause}" for cause, count in sorted(row["causes"].items()))
    print(f"{row['name']:32s} {row['elements']:8d} {row['quads']:7.2f} {row['layer_quads']:6.2f} "
          f"{row['core_quads']:6.2f} {row['angles']:6.2f} {row['below_20']:6.3f} "
          f"{row['above_160']:6.3f} {row['min']:5.1f} {row['max']:5.1f} {row['inverted']:3d} | "
          f"{layers['height_within_2']:6.2f} {layers['height_off']:6.2f} "
          f"{layers['growth_off']:6.3f} {layers['direction']:6.2f} | {causes}", flush=True)
    if row["paper"]:
        paper = row["paper"]
        print(f"{'  the paper':32s} {paper.get('elements', ''):>8} {paper['quads']:7.2f} "
              f"{'':13s} {paper.get('angles', ''):>6}")


def peer(case: Case, shape, way: str) -> Dict[str, Any]:
    """gmsh's figures, or how it ended."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "shape.brep")
        shape.exportBrep(path)
        call = [sys.executable, PEER, path, str(case.size), way, str(case.first_height),
                str(case.growth)]
        try:
            done = subprocess.run(call, capture_output=True, text=True, timeout=30)
        except subprocess.TimeoutExpired:
            return {"failed": "no end within 30 s"}
    lines = done.stdout.strip().splitlines()
    if done.returncode or not lines:
        return {"failed": f"ended with {done.returncode}"}
    return json.loads(lines[-1])


def print_peer(way: str, got: Dict[str, Any], area: float) -> None:
    name = f"  gmsh, {way}"
    if "failed" in got:
        print(f"{name:32s} {got['failed']}")
        return
    least, mean, most = got["first_row"]
    print(f"{name:32s} {got['elements']:8d} {got['quads']:7.2f} {'':13s} {got['angles']:6.2f} "
          f"{got['below_20']:6.3f} {'':22s} | first row {least:.2f} .. {mean:.2f} .. "
          f"{most:.2f} h0, area off by {100.0 * (got['area'] / area - 1.0):.2f} %, "
          f"{got['turned']} reflex",
          flush=True)


def keep(folder: str, case: Case, mesh) -> None:
    """Writes the mesh as the batch program does."""
    from advlayers.export import FORMATS, Product

    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, re.sub(r"\W+", "-", case.name) + ".vtu")
    FORMATS[".vtu"].write(path, Product(mesh, {}))


def judge(program: str, case: Case, mesh, shape) -> Dict[str, Any]:
    import meshio
    with tempfile.TemporaryDirectory() as folder:
        file, cad, verdict = (os.path.join(folder, name) for name in
                              ("mesh.vtk", "shape.brep", "verdict.json"))
        shape.exportBrep(cad)
        cells = [("quad", mesh.quads), ("triangle", mesh.triangles)]
        meshio.write(file, meshio.Mesh(mesh.nodes, [cell for cell in cells if len(cell[1])]))
        call = [sys.executable, program] if program.endswith(".py") else [program]
        subprocess.run(call + [file, cad, "--h0", str(case.first_height), "--growth",
                               str(case.growth), "--json", verdict, "-q"], check=True)
        with open(verdict, encoding="utf-8") as stream:
            return json.load(stream)


def print_verdict(row: Dict[str, Any], verdict: Dict[str, Any]) -> None:
    error = (verdict.get("layer_summary") or {}).get("first_height_inner_error") or {}
    print(f"  judge: {verdict['pct_quads']:.2f} % quads, {verdict['pct_angles_45_135']:.2f} % in "
          f"45-135, inverted {verdict['inverted_gt90']}, first height off by "
          f"{100 * error.get('p95', 0.0):.2f} % (p95), {100 * error.get('max', 0.0):.2f} % (max)")
    for own, theirs in (("quads", "pct_quads"), ("angles", "pct_angles_45_135")):
        if abs(row[own] - verdict[theirs]) > 0.05:
            print(f"  {own} by the report {row[own]:.3f}, by the judge {verdict[theirs]:.3f}")
    for fault in verdict["faults"]:
        print(f"  fault: {fault}")


def main() -> int:
    parser = argparse.ArgumentParser(prog="./dev bench quality", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--peers", action="store_true")
    parser.add_argument("--meshes", metavar="FOLDER")
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--judge", metavar="PATH")
    asked = parser.parse_args()
    print(HEAD)
    rows, faults = [], 0
    for case in CASES:
        if asked.names and not any(name == case.group or name in case.name
                                   for name in asked.names):
            continue
        shape, mesh, row = run(case)
        print_row(row)
        for line in missed(row):
            print("  missed: " + line)
            faults += 1
        if asked.peers and case.group != "growth":
            row["peers"] = {way: peer(case, shape, way) for way in ("quads", "layers")}
            for way, got in row["peers"].items():
                print_peer(way, got, shape.Area)
        if asked.judge:
            row["judge"] = judge(asked.judge, case, mesh, shape)
            print_verdict(row, row["judge"])
            faults += len(row["judge"]["faults"])
        if asked.meshes:
            keep(asked.meshes, case, mesh)
        rows.append(row)
    if asked.json:
        write_json(asked.json, rows)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

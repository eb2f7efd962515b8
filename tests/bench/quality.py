"""Quality of the meshes of a few shapes, one line each.

    ./dev bench quality [--cases FOLDER] [--judge PATH] [--json FILE] [NAME ...]

--cases: also the STEP files of this folder that CASES knows. --judge: a program that measures a
mesh file against its CAD, `PATH MESH CAD --h0 H --growth R --json FILE`; its figures stand beside
the mesher's own, and its faults below. Names choose cases. Exit status 1: an element is inverted,
or the judge found a fault.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from typing import Any, Dict, List, NamedTuple, Optional

import advlayers_core as core

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.path.join(ROOT, "tests", "data")


class Case(NamedTuple):
    name: str
    file: str
    size: float
    first_height: float
    growth: float
    layers: Any = 0
    feature_angle: float = 0.0


CASES = (
    Case("box", "box.brep", 1.0, 0.1, 1.1),
    Case("box, 5 layers", "box.brep", 0.5, 0.05, 1.2, 5),
    Case("cylinder", "cylinder.brep", 1.0, 0.1, 1.1),
    Case("cone", "cone.brep", 1.0, 0.1, 1.1),
    Case("sphere", "sphere.brep", 1.0, 0.1, 1.1),
    Case("torus", "torus.brep", 1.0, 0.1, 1.1),
    Case("drilled plate", "drilled_plate.brep", 1.0, 0.1, 1.1),
    Case("bracket", "bracket.brep", 1.0, 0.1, 1.1),
    Case("wing, growth 1.05", "naca0018_sharp.step", 0.065, 0.007, 1.05),
    Case("wing, growth 1.1", "naca0018_sharp.step", 0.065, 0.007, 1.1),
    Case("concave plate, growth 1.04", "concave_plate.step", 0.2, 0.02, 1.04),
    Case("concave plate, growth 1.08", "concave_plate.step", 0.2, 0.02, 1.08),
    Case("cylinder shell", "cylinder.step", 0.5, 0.05, 1.1),
    Case("rectangle", "rect.step", 0.05, 0.005, 1.1),
    Case("saddle", "saddle.step", 0.05, 0.005, 1.1),
)
COLUMNS = (
    ("case", "{name:27s}"), ("elements", "{elements:8d}"), ("quads %", "{quad_percent:7.2f}"),
    ("layers", "{layer_quad_percent:6.2f}"), ("core", "{core_quad_percent:6.2f}"),
    ("45-135", "{angles_45_135_percent:6.2f}"), ("< 20", "{angles_below_20_percent:6.3f}"),
    ("> 160", "{angles_above_160_percent:6.3f}"), ("min", "{min_angle:5.1f}"),
    ("max", "{max_angle:5.1f}"), ("inv", "{inverted:3d}"), ("h0 off %", "{height_error:8.3f}"),
    ("growth off %", "{growth_error:12.3f}"), ("1000/s", "{rate:6.0f}"),
)


def find(case: Case, folder: Optional[str]) -> Optional[str]:
    for place in filter(None, (DATA, folder)):
        path = os.path.join(place, case.file)
        if os.path.exists(path):
            return path
    return None


def worst_error(walls: List[Dict[str, Any]], asked: str, got) -> float:
    """The largest deviation [%] of a wall's mean from what was asked; 0 without walls."""
    errors = [abs(got(wall) / wall[asked] - 1.0) for wall in walls if got(wall) > 0.0]
    return 100.0 * max(errors, default=0.0)


def run(case: Case, path: str):
    model = core.read_file(path)
    start = time.perf_counter()
    mesher = core.Mesher(model, core.Settings(size=case.size, first_height=case.first_height,
                                              growth=case.growth, layers=case.layers,
                                              feature_angle=case.feature_angle, threads=1))
    for _ in mesher:
        pass
    mesh = mesher.result()
    seconds = time.perf_counter() - start
    elements = len(mesh.quads) + len(mesh.triangles)
    row = {"name": case.name, "elements": elements, "rate": elements / seconds / 1000.0,
           **mesh.figures}
    row["height_error"] = worst_error(mesh.walls, "first_height",
                                      lambda wall: wall["achieved_first_height"]["mean"])
    row["growth_error"] = worst_error(mesh.walls, "growth", lambda wall: wall["achieved_growth"])
    return mesh, row


def judge(program: str, case: Case, mesh, path: str) -> Dict[str, Any]:
    import meshio
    with tempfile.TemporaryDirectory() as folder:
        file, verdict = os.path.join(folder, "mesh.vtk"), os.path.join(folder, "verdict.json")
        cells = [("quad", mesh.quads), ("triangle", mesh.triangles)]
        meshio.write(file, meshio.Mesh(mesh.nodes, [cell for cell in cells if len(cell[1])]))
        call = [sys.executable, program] if program.endswith(".py") else [program]
        subprocess.run(call + [file, path, "--h0", str(case.first_height), "--growth",
                               str(case.growth), "--json", verdict, "-q"], check=True)
        with open(verdict, encoding="utf-8") as stream:
            return json.load(stream)


def print_verdict(row: Dict[str, Any], verdict: Dict[str, Any]) -> None:
    summary = verdict.get("layer_summary") or {}
    error = summary.get("first_height_inner_error") or {}
    print(f"  judge: {verdict['pct_quads']:.2f} % quads, {verdict['pct_angles_45_135']:.2f} % in "
          f"45-135, inverted {verdict['inverted_gt90']}, first height off by "
          f"{100 * error.get('p95', 0.0):.2f} % (p95), {100 * error.get('max', 0.0):.2f} % (max)")
    for own, theirs in (("quad_percent", "pct_quads"),
                        ("angles_45_135_percent", "pct_angles_45_135")):
        if abs(row[own] - verdict[theirs]) > 0.05:
            print(f"  the report's {own} is {row[own]:.3f}, the judge's {verdict[theirs]:.3f}")
    for fault in verdict["faults"]:
        print(f"  fault: {fault}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--cases", metavar="FOLDER")
    parser.add_argument("--judge", metavar="PATH")
    parser.add_argument("--json", metavar="FILE")
    options = parser.parse_args()
    print("  ".join(head.ljust(len(form.format(**_WIDTHS))) for head, form in COLUMNS))
    rows, faults = [], 0
    for case in CASES:
        path = find(case, options.cases)
        if path is None or (options.names and case.name not in options.names):
            continue
        mesh, row = run(case, path)
        print("  ".join(form.format(**row) for _, form in COLUMNS))
        for entry in mesh.diagnostics:
            if entry["severity"] == "error":
                print("  " + entry["text"])
        faults += row["inverted"]
        if options.judge:
            verdict = judge(options.judge, case, mesh, path)
            print_verdict(row, verdict)
            faults += len(verdict["faults"])
            row["judge"] = verdict
        rows.append(row)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as stream:
            json.dump(rows, stream, indent=1)
    return 1 if faults else 0


_WIDTHS = {"name": "", "elements": 0, "quad_percent": 0.0, "layer_quad_percent": 0.0,
           "core_quad_percent": 0.0, "angles_45_135_percent": 0.0, "angles_below_20_percent": 0.0,
           "angles_above_160_percent": 0.0, "min_angle": 0.0, "max_angle": 0.0, "inverted": 0,
           "height_error": 0.0, "growth_error": 0.0, "rate": 0.0}

if __name__ == "__main__":
    sys.exit(main())

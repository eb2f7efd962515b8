"""Meshes every CAD file of a folder by batch jobs and prints a line for each.

    ./dev bench models [FOLDER] [--parts N ...] [--feature-angle DEG] [--json FILE]

FOLDER defaults to `shared/models` beside the checkout; without it there is nothing to do. The size
is the box diagonal over N (default 50, 100 and 200), the first height a tenth of it, growth 1.15.
Seconds and memory are those of the whole process, FreeCAD's start and the CAD's own included.
Exit status 1: a job failed, an element is inverted, or a file took a minute or a gigabyte.
"""
from __future__ import annotations

import argparse
import glob
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from typing import Any, Dict, List

from json_file import write_json

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BATCH = os.path.join(ROOT, "App", "advlayers_batch.py")
ENDINGS = (".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".fcstd", ".stl")
READ = """import sys, freecad_part, advlayers_core as core
from advlayers import cad_input
print(cad_input.read(core, sys.argv[1], None).model.diagonal)"""
LONGEST, LARGEST = 60.0, 1024.0  # [s], [MB]
HEAD = (f"{'file':28s} {'N':>3s} {'faces':>5s} {'patches':>7s} {'elements':>8s} {'quads %':>7s} "
        f"{'layers':>6s} {'45-135':>6s} {'< 20':>6s} {'> 160':>6s} {'inv':>3s} {'exit':>4s} "
        f"{'seconds':>7s} {'MB':>5s}  diagnostics")


def diagonal(path: str) -> float:
    """Of the box about the shape [mm], as the batch program's reader sees it.

    Read in a process of its own: the peak memory of a child begins with that of its parent.
    """
    call = [sys.executable, "-c", READ, path]
    done = subprocess.run(call, capture_output=True, text=True, check=True)
    return float(done.stdout.strip().splitlines()[-1])


def mesh_file(path: str, parts: float, feature_angle: float, whole: float) -> Dict[str, Any]:
    size = whole / parts
    with tempfile.TemporaryDirectory() as folder:
        job = {"input": os.path.abspath(path), "size": size, "first_height": size / 10.0,
               "growth": 1.15, "feature_angle": feature_angle, "report": "report.json"}
        with open(os.path.join(folder, "job.json"), "w", encoding="utf-8") as file:
            json.dump(job, file)
        log = os.path.join(folder, "stderr")
        start = time.perf_counter()
        with open(log, "wb") as stderr:
            child = subprocess.Popen(
                ["freecadcmd", BATCH, os.path.join(folder, "job.json")], stderr=stderr,
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                env={**os.environ, "FREECAD_USER_HOME": folder})
            _, status, used = os.wait4(child.pid, 0)
        row: Dict[str, Any] = {
            "file": os.path.basename(path), "parts": parts,
            "exit": os.waitstatus_to_exitcode(status),
            "seconds": time.perf_counter() - start,
            "computing": used.ru_utime + used.ru_stime, "megabytes": used.ru_maxrss / 1024.0}
        with open(log, encoding="utf-8", errors="replace") as file:
            row["error"] = file.read().strip()
        report = os.path.join(folder, "report.json")
        if os.path.exists(report):
            with open(report, encoding="utf-8") as file:
                row["report"] = json.load(file)
    return row


def faults_of(row: Dict[str, Any]) -> List[str]:
    found = []
    if "report" not in row:
        found.append(row["error"] or f"ended with {row['exit']}")
    elif row["report"]["inverted"]:
        found.append(f"{row['report']['inverted']} inverted")
    if min(row["seconds"], row["computing"]) > LONGEST:  # a busy machine has no say
        found.append(f"took more than {LONGEST:g} s")
    if row["megabytes"] > LARGEST:
        found.append(f"took more than {LARGEST:g} MB")
    return found


def print_row(row: Dict[str, Any]) -> None:
    start = f"{row['file'][:28]:28s} {row['parts']:3.0f} "
    end = f"{row['exit']:4d} {row['seconds']:7.1f} {row['megabytes']:5.0f}  "
    report = row.get("report")
    if report is None:
        print(start + f"{'':56s}" + end + row["error"], flush=True)
        return
    codes = [entry["code"] for entry in report["diagnostics"]]
    faces = {face for patch in report["patches"] for face in patch["faces"]}
    print(start + f"{len(faces):5d} {len(report['patches']):7d} "
          f"{report['quads'] + report['triangles']:8d} {report['quad_percent']:7.2f} "
          f"{report['layer_quad_percent']:6.2f} {report['angles_45_135_percent']:6.2f} "
          f"{report['angles_below_20_percent']:6.3f} {report['angles_above_160_percent']:6.3f} "
          f"{report['inverted']:3d} " + end
          + ", ".join(f"{codes.count(code)} {code}" for code in sorted(set(codes))), flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(prog="./dev bench models", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?",
                        default=os.path.join(os.path.dirname(ROOT), "shared", "models"))
    parser.add_argument("--parts", type=float, nargs="+", default=[50.0, 100.0, 200.0])
    parser.add_argument("--feature-angle", type=float, default=0.0)
    parser.add_argument("--json", metavar="FILE")
    asked = parser.parse_args()
    files = sorted(path for path in glob.glob(os.path.join(asked.folder, "*"))
                   if path.lower().endswith(ENDINGS))
    if not files:
        print(f"no CAD files in {asked.folder}: nothing to measure")
        return 0
    print(HEAD)
    rows, failed = [], 0
    for path in files:
        whole = diagonal(path)
        for parts in asked.parts:
            row = mesh_file(path, parts, asked.feature_angle, whole)
            print_row(row)
            for fault in faults_of(row):
                print("  fault: " + fault)
                failed += 1
            rows.append(row)
    for parts in asked.parts:
        quads = [row["report"]["quad_percent"] for row in rows
                 if row["parts"] == parts and "report" in row]
        if quads:
            print(f"diagonal/{parts:g}: quads in the median {statistics.median(quads):.2f} %, "
                  f"least {min(quads):.2f} %")
    if asked.json:
        write_json(asked.json, rows)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

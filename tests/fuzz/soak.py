"""Random shapes, job files and damaged files, meshed and measured.

    ./dev soak [PART ...] [--count N] [--seed S] [--only NUMBER ...] [--processes N] [--json FILE]

PART: faces (200 random faces on plane, cylinder, sphere and B-spline saddle), invariance (60 of
them turned, moved, scaled and mirrored), solids (300 random solids: primitives, booleans, fillets,
lofts, sweeps, threads), injured (300 shapes with gaps, slivers and the like within their
tolerances), jobs (150 spoilt job files), damaged (150 damaged CAD files); without
PART, all.
The same seed gives the same cases. What fails is written to out/soak as BREP and job file, to be
meshed again with `freecadcmd App/advlayers_batch.py out/soak/NAME.job.json`, or measured again
with --only. Exit status 1: a case or a median missed its bar.
"""
from __future__ import annotations

import argparse
import importlib
import json
import os
import sys
import time
from typing import Any, Dict, List

import case_runner
from json_file import write_json

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
OUT = os.path.join(ROOT, "out", "soak")


class Part:
    """One part of the soak: a module with run(seed, number) and summary(rows)."""

    def __init__(self, module: str, count: int, seconds: float) -> None:
        self.module, self.count, self.seconds = module, count, seconds


PARTS = {
    "faces": Part("face_soak", 200, 60.0),
    "invariance": Part("invariance_soak", 60, 120.0),
    "solids": Part("solid_soak", 300, 120.0),
    "injured": Part("injured_soak", 300, 60.0),
    "jobs": Part("job_soak", 150, 90.0),
    "damaged": Part("damaged_soak", 150, 60.0),
}


def keep(part: str, seed: int, row: Dict[str, Any]) -> str:
    """Writes a failed case, to be replayed; returns what to run, or nothing to run."""
    name = f"{part}-{seed}-{row['number']}"
    brep = row.pop("brep", None)
    if brep:
        os.makedirs(OUT, exist_ok=True)
        with open(os.path.join(OUT, name + ".brep"), "w", encoding="ascii") as file:
            file.write(brep)
        job = {"input": name + ".brep", **row["job"], "outputs": [name + ".vtu"],
               "report": name + ".report.json"}
        with open(os.path.join(OUT, name + ".job.json"), "w", encoding="utf-8") as file:
            json.dump(job, file, indent=1)
    return f"./dev soak {part} --seed {seed} --only {row['number']}"


def soak(name: str, asked: argparse.Namespace) -> List[str]:
    """Runs a part and prints its table; returns what failed."""
    part = PARTS[name]
    numbers = asked.only or list(range(asked.count or part.count))
    command = [sys.executable, os.path.abspath(__file__), name, "--seed", str(asked.seed),
               "--worker"]
    start, rows, failed = time.perf_counter(), [], []
    for row in case_runner.run_cases(command, numbers, asked.processes, part.seconds):
        rows.append(row)
        if row["faults"]:
            replay = keep(name, asked.seed, row)
            failed.append(f"{name} {row['number']}")
            print(f"  {row['number']:4d} {row['name']}: {'; '.join(row['faults'])}   [{replay}]",
                  flush=True)
    rows.sort(key=lambda row: row["number"])
    print(f"{name}: {len(rows)} cases, seed {asked.seed}, {len(failed)} failed, "
          f"{time.perf_counter() - start:.0f} s")
    failed += importlib.import_module(part.module).summary(rows)
    if asked.json:
        write_json(asked.json, rows)
    return failed


def main() -> int:
    parser = argparse.ArgumentParser(prog="./dev soak", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="PART")
    parser.add_argument("--count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, nargs="+", metavar="NUMBER")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--worker", action="store_true", help=argparse.SUPPRESS)
    asked = parser.parse_args()
    for name in asked.parts:
        if name not in PARTS:
            parser.error(f"no part {name}; there are {', '.join(PARTS)}")
    if asked.worker:
        run = importlib.import_module(PARTS[asked.parts[0]].module).run
        case_runner.serve(lambda number: run(asked.seed, number))
        return 0
    failed = [line for name in asked.parts or PARTS for line in soak(name, asked)]
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

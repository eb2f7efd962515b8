"""How long a run goes on once it was asked to stop, in computing time.

    ./dev bench cancel [--runs N] [--seconds S] [--seed K] [--write FILE] [SHAPE ...]

Each shape is meshed to the end once; then runs are cancelled from another thread at moments drawn
evenly over that length, from the making of the mesher to its result. Told are median, 95 % and the
worst, and the stage that the worst was in. Time is the process' own: what else the machine does
does not count. --runs (500) is per shape; --seconds ends a shape's runs after so much computing.
Exit status 1: a run took longer than 0.1 s to stop, or did not stop.
"""
from __future__ import annotations

import argparse
import random
import statistics
import sys
import threading
import time
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

import advlayers_core as core
from freecad_part import FreeCAD, Part
from hashes import checkered
from json_file import write_json

MOST = 0.1  # [s] of computing
POLL = 0.0005  # [s] between two looks at how far a run is

V = FreeCAD.Vector


class Shape(NamedTuple):
    name: str
    text: Callable[[], str]
    settings: Callable[[], Dict[str, Any]]


def unit_checkered() -> str:
    shell = checkered(70)
    shell.scale(1.0 / 70.0)
    return shell.exportBrepToString()


def fine_grid() -> Dict[str, Any]:
    """An initial mesh of 600 000 nodes on the unit square."""
    count = 775
    line = np.linspace(0.0, 1.0, count)
    x, y = np.meshgrid(line, line)
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(count * count)])
    corner = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)[None, :]).ravel()
    triangles = np.concatenate([
        np.column_stack([corner, corner + 1, corner + count + 1]),
        np.column_stack([corner, corner + count + 1, corner + count])])
    return {"initial_mesh": (points, triangles)}


def bumps() -> str:
    rows = [[V(i, j, 0.6 * ((i + j) % 2)) for j in range(7)] for i in range(7)]
    surface = Part.BSplineSurface()
    surface.interpolate(rows)
    return surface.toShape().exportBrepToString()


SHAPES: Tuple[Shape, ...] = (
    Shape("14 400 coplanar faces, one patch", lambda: checkered(120).exportBrepToString(),
          lambda: {"size": 1.0, "first_height": 0.1, "growth": 1.2, "layers": 3,
                   "feature_angle": 20.0}),
    Shape("4 900 faces of a unit plate", unit_checkered,
          lambda: {"size": 0.02, "first_height": 0.002, "growth": 1.2, "feature_angle": 0.0}),
    Shape("initial mesh of 600 000 nodes", lambda: Part.makePlane(1, 1).exportBrepToString(),
          lambda: {"size": 0.05, "first_height": 0.005, "growth": 1.2, **fine_grid()}),
    Shape("one B-spline face", bumps,
          lambda: {"size": 0.1, "first_height": 0.01, "growth": 1.2}))


def run_to_end(model: core.Model, settings: core.Settings, context: core.RunContext) -> None:
    mesher = core.Mesher(model, settings, context)
    for _ in mesher:
        pass
    mesher.result()


class Cancel(NamedTuple):
    took: float  # [s] of computing; infinite where the run was not cancelled at all
    stage: str
    at: float  # [s] into the run


def cancel_at(model: core.Model, settings: core.Settings, moment: float) -> Optional[Cancel]:
    """None where the run came to its end before."""
    context = core.RunContext()
    ended: List[Tuple[bool, float]] = []

    def work() -> None:
        try:
            run_to_end(model, settings, context)
            ended.append((False, time.process_time()))
        except core.Cancelled:
            ended.append((True, time.process_time()))

    start = time.process_time()
    worker = threading.Thread(target=work)
    worker.start()
    while time.process_time() - start < moment and not ended:
        time.sleep(POLL)
    stage = context.progress[0]
    early = bool(ended)
    asked = time.process_time()
    context.cancel()
    worker.join()
    if early:
        return None
    cancelled, done = ended[0]
    return Cancel(done - asked if cancelled else float("inf"), stage, asked - start)


def measure(shape: Shape, runs: int, seconds: float, draw: random.Random) -> Dict[str, Any]:
    model = core.read_brep(shape.text())
    settings = core.Settings(threads=1, **shape.settings())
    start = time.process_time()
    run_to_end(model, settings, core.RunContext())
    length = time.process_time() - start
    found: List[Cancel] = []
    start = time.process_time()
    while len(found) < runs and time.process_time() - start < seconds:
        cancel = cancel_at(model, settings, draw.uniform(0.0, length))
        if cancel is not None:
            found.append(cancel)
    took = sorted(cancel.took for cancel in found)
    worst = max(found)
    return {"shape": shape.name, "run": round(length, 3), "cancels": len(found),
            "median": round(statistics.median(took), 4),
            "p95": round(took[int(0.95 * (len(took) - 1))], 4),
            "worst": round(worst.took, 4), "stage": worst.stage, "at": round(worst.at, 3),
            "over": sum(value > MOST for value in took),
            "slowest": [(round(c.took, 4), c.stage, round(c.at, 3))
                        for c in sorted(found, reverse=True)[:8]]}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("shapes", nargs="*", metavar="SHAPE", help="a part of its name")
    parser.add_argument("--runs", type=int, default=500)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--write", metavar="FILE")
    asked = parser.parse_args()
    draw = random.Random(asked.seed)
    found = []
    for shape in SHAPES:
        if asked.shapes and not any(part in shape.name for part in asked.shapes):
            continue
        row = measure(shape, asked.runs, asked.seconds, draw)
        found.append(row)
        print(f"{row['shape']:34s} run {row['run']:7.2f} s, {row['cancels']:4d} cancels: median "
              f"{row['median']:.4f}, 95 % {row['p95']:.4f}, worst {row['worst']:.4f} s "
              f"({row['stage'] or 'before the first stage'} at {row['at']} s), "
              f"{row['over']} over {MOST} s", flush=True)
        for took, stage, at in row["slowest"]:
            print(f"    {took:.4f} s in {stage or '-'} at {at} s")
    if asked.write:
        write_json(asked.write, found)
    return 1 if any(row["over"] for row in found) else 0


if __name__ == "__main__":
    sys.exit(main())

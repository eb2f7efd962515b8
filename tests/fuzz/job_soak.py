"""Runs one spoilt batch job as a process and holds it to what the batch program promises."""
from __future__ import annotations

import copy
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
from random import Random
from typing import Any, Dict, List

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BATCH = os.path.join(ROOT, "App", "advlayers_batch.py")
SHAPES = ("box.brep", "bracket.brep", "drilled_plate.brep")
LIMIT = 50.0  # [s]

GOOD: Dict[str, Any] = {
    "size": 3.0, "first_height": 0.3, "growth": 1.2, "layers": 4, "feature_angle": 0.0,
    "curvature_angle": 20.0, "core": "quads", "faces": "all",
    "walls": [{"edges": ["Edge1", "Edge2"], "faces": ["Face1"], "first_height": 0.2,
               "end_height": 0.4, "growth": 1.1, "layers": 3},
              {"edges": ["Edge4"], "aspect_ratio": 5.0, "layers": 2},
              {"edges": ["Edge5"], "first_height": 0.2, "thickness": 1.0, "growth": 1.2}],
    "match": [], "off": ["Edge3"], "size_growth": 1.4,
    "sizes": [{"edges": ["Edge1"], "size": 1.0}, {"edges": ["Edge2"], "segments": 9,
                                                  "cluster": 3.0, "both_ends": True}],
    "refinements": [{"point": [0.0, 0.0, 0.0], "size": 0.8, "radius": 2.0}],
    "groups": {"inlet": ["Face1"]}, "threads": 1, "strict": False,
    "outputs": ["mesh.vtu"], "report": "report.json"}

NUMBERS = (0, -1, 1, 0.5, 1e-3, 1e-9, 1e-300, 1e9, 1e300, -1e-9, math.nan, math.inf,
           -math.inf, 2 ** 31, 2 ** 63, 10 ** 30, 1.0000001, 179.9999)
VALUES = NUMBERS + (None, True, False, "", "all", "none", "Edge1", "Face1", "Edge0", "Face-1",
                    "Edge99999999999999999999", "face1", "\u0000", "\ud83d\ude00" * 50, "/",
                    "../..", [], {}, [[]], [None], ["Edge1", "Edge1"], ["Edge2", 3], {"edges": []},
                    [{"edges": ["Edge1"]}] * 3, {"a": {"b": {"c": []}}}, "x" * 10000)


def _slots(value: Any, found: List[Any]) -> List[Any]:
    """Every (container, key) in a nested value."""
    pairs = value.items() if isinstance(value, dict) else \
        enumerate(value) if isinstance(value, list) else ()
    for key, inner in pairs:
        found.append((value, key))
        _slots(inner, found)
    return found


def spoil(rng: Random, job: Dict[str, Any]) -> None:
    """Changes, drops, adds or doubles one thing somewhere in the job."""
    container, key = rng.choice(_slots(job, []))
    way = rng.choice(("change", "change", "nudge", "nudge", "drop", "add", "grow"))
    if way == "drop":
        del container[key]
    elif way == "add" and isinstance(container, dict):
        name = rng.choice(("edges", "faces", "size", "siz", "walls", "", "object", "strict"))
        container[name] = copy.deepcopy(rng.choice(VALUES))
    elif way == "grow" and isinstance(container[key], list):
        container[key].append(copy.deepcopy(rng.choice(VALUES)))
    elif way == "nudge":
        number = rng.choice([(part, name) for part, name in _slots(job, [])
                             if isinstance(part[name], float)] or [(container, key)])
        number[0][number[1]] = 10.0 ** rng.uniform(-0.5, 3.0)
    else:
        container[key] = copy.deepcopy(rng.choice(VALUES))


def spoil_text(rng: Random, text: str) -> bytes:
    """The job file with some of its bytes damaged."""
    data = bytearray(text.encode("utf-8", "surrogatepass"))
    for _ in range(rng.randint(1, 4)):
        at = rng.randrange(len(data))
        way = rng.choice(("cut", "flip", "insert", "double"))
        if way == "cut":
            del data[at:at + rng.randint(1, 20)]
        elif way == "flip":
            data[at] = rng.randrange(256)
        elif way == "insert":
            data[at:at] = bytes(rng.randrange(256) for _ in range(rng.randint(1, 4)))
        else:
            data[at:at] = data[at:at + rng.randint(1, 60)]
        if not data:
            break
    return bytes(data)


def run(seed: int, number: int) -> Dict[str, Any]:
    rng = Random(f"{seed} job {number}")
    shape = rng.choice(SHAPES)
    job = {"input": shape, **copy.deepcopy(GOOD)}
    for _ in range(rng.choice((1, 1, 3)) if number else 0):
        spoil(rng, job)
        if not job:
            break
    text = json.dumps(job)
    damaged = number % 3 == 2
    data = spoil_text(rng, text) if damaged else text.encode("utf-8", "surrogatepass")
    folder = tempfile.mkdtemp(prefix="advlayers-soak-")
    try:
        shutil.copy(os.path.join(ROOT, "tests", "data", shape), folder)
        with open(os.path.join(folder, "job.json"), "wb") as file:
            file.write(data)
        status, faults = _watch(folder)
        if number == 0 and status != 0:
            faults.append("the job that is spoilt in all other cases is not sound")
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return {"number": number, "name": "damaged text" if damaged else "spoilt value",
            "status": status, "faults": faults, "text": data.decode("utf-8", "replace")[:2000]}


def _watch(folder: str):
    """The exit status of the job in the folder, and the promises that it broke."""
    before = set(os.listdir(folder))
    try:
        done = subprocess.run([sys.executable, BATCH, os.path.join(folder, "job.json")],
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return None, [f"no end within {LIMIT:g} s"]
    lines = done.stderr.decode("utf-8", "replace").splitlines()
    made = sorted(set(os.listdir(folder)) - before)
    faults = []
    if done.returncode not in (0, 1, 2):
        faults.append(f"exit status {done.returncode}")
    if done.returncode == 1:
        if len(lines) != 1 or "job.json" not in lines[0]:
            faults.append(f"{len(lines)} lines on stderr: {lines[:3]}")
        if made:
            faults.append(f"a failed job left {made}")
    elif lines:
        faults.append(f"stderr of a job that was meshed: {lines[:3]}")
    if lines and "internal error" in lines[0]:
        faults.append(lines[0])
    if done.returncode in (0, 2) and not made:
        faults.append("meshed, and wrote nothing")
    return done.returncode, faults


def summary(rows: List[Dict[str, Any]]) -> List[str]:
    for name in ("spoilt value", "damaged text"):
        group = [row for row in rows if row["name"] == name]
        counts = {status: sum(row.get("status") == status for row in group)
                  for status in (0, 1, 2)}
        print(f"  {name}: {len(group)} jobs; exit status "
              + ", ".join(f"{status}: {count}" for status, count in counts.items()))
    return []

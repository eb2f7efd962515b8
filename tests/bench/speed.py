"""Speed and memory of the mesher.

    ./dev bench speed [--runs N] [--largest ELEMENTS] [--json FILE]

Elements per second by kind of surface at about ten thousand elements, gmsh's isotropic quads (two
ways of pairing) of about as many elements beside them; time per element from 10^4 to --largest
elements (default 10^6) of the wing; two threads against one on a shape of many faces; bytes per
element. Medians of N runs (default five), the programs taking turns; reading the shape excluded.
Times are the processor's, of one thread, so that other work on the machine hardly shows; those of
two threads against one are wall-clock times.
"""
from __future__ import annotations

import argparse
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time
from typing import Any, Callable, Dict, List, Optional

import advlayers_core as core
import cases
from freecad_part import FreeCAD, Part
from json_file import write_json

V = FreeCAD.Vector
PEER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "gmsh_peer.py")
PEERS = ("quads", "full quads")
ELEMENTS = 10_000


def lattice() -> "Part.Shape":
    """64 drilled blocks: 448 faces."""
    block = Part.makeBox(10, 10, 10).cut(Part.makeCylinder(3, 20, V(5, 5, -5)))
    return Part.makeCompound([block.translated(V(12 * i, 12 * j, 12 * k))
                              for i in range(4) for j in range(4) for k in range(4)])


def side(solid) -> "Part.Shape":
    return max(solid.Faces, key=lambda face: face.Area)


SURFACES: Dict[str, Callable[[], Any]] = {
    "plane": cases.concave_plate,
    "cylinder": lambda: side(Part.makeCylinder(10, 40)),
    "cone": lambda: side(Part.makeCone(10, 5, 30)),
    "sphere": lambda: side(Part.makeSphere(10, V(), V(0, 0, 1), -60.0, 60.0)),
    "torus": lambda: side(Part.makeTorus(12, 4, V(), V(0, 0, 1), 0.0, 360.0, 200.0)),
    "B-spline": cases.saddle,
    "wing": cases.wing,
}


def mesh(text: str, size: float, threads: int = 1, clock=time.process_time):
    """Elements and seconds of one run; the shape is read anew, which is not counted."""
    model = core.read_brep(text)
    settings = core.Settings(size=size, first_height=size / 10.0, growth=1.1, threads=threads)
    start = clock()
    mesher = core.Mesher(model, settings)
    for _ in mesher:
        pass
    made = mesher.result()
    return len(made.quads) + len(made.triangles), clock() - start


def size_for(text: str, area: float, elements: int) -> float:
    """The size that gives about so many elements, by a few trials on small meshes and large."""
    size = math.sqrt(area / elements)
    for _ in range(4):
        made, _ = mesh(text, size)
        if abs(made / elements - 1.0) < 0.1:
            break
        size *= math.sqrt(made / elements)
    return size


def gmsh_run(path: str, size: float, way: str) -> Optional[Dict[str, float]]:
    call = [sys.executable, PEER, path, str(size), way, str(size / 10.0), "1.1"]
    try:
        done = subprocess.run(call, capture_output=True, text=True, timeout=300)
    except subprocess.TimeoutExpired:
        return None
    lines = done.stdout.strip().splitlines()
    return json.loads(lines[-1]) if done.returncode == 0 and lines else None


def by_surface(runs: int) -> List[Dict[str, Any]]:
    print(f"elements/s of processor time, median of {runs} interleaved runs\n{'surface':10s} "
          f"{'elements':>8s} {'ours':>8s} " + " ".join(f"{'gmsh, ' + way:>17s}" for way in PEERS)
          + "   ratio")
    rows = []
    for name, make in SURFACES.items():
        shape = make()
        text = shape.exportBrepToString()
        size = size_for(text, shape.Area, ELEMENTS)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shape.brep")
            shape.exportBrep(path)
            rates: Dict[str, List[float]] = {way: [] for way in ("ours",) + PEERS}
            for _ in range(runs):
                elements, seconds = mesh(text, size)
                rates["ours"].append(elements / seconds)
                for way in PEERS:
                    got = gmsh_run(path, math.sqrt(shape.Area / ELEMENTS), way)
                    if got:
                        rates[way].append(got["elements"] / got["seconds"])
        row = {"surface": name, "elements": elements,
               **{way: statistics.median(found) for way, found in rates.items() if found}}
        rows.append(row)
        peers = [row[way] for way in PEERS if way in row]
        print(f"{name:10s} {elements:8d} {row['ours']:8.0f} "
              + " ".join(f"{row[way]:17.0f}" if way in row else f"{'failed':>17s}"
                         for way in PEERS)
              + (f" {row['ours'] / max(peers):7.1f}" if peers else ""), flush=True)
    return rows


def scaling(runs: int, largest: int) -> List[Dict[str, Any]]:
    print(f"\nscaling on the wing\n{'elements':>8s} {'seconds':>8s} {'us/element':>10s} "
          f"{'bytes/element':>13s}")
    shape = cases.wing()
    rows = []
    asked = 10_000
    while asked <= largest:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shape.brep")
            shape.exportBrep(path)
            size = size_for(shape.exportBrepToString(), shape.Area, min(asked, 100_000))
            size *= math.sqrt(min(asked, 100_000) / asked)
            found = [_in_own_process(path, size) for _ in range(runs if asked < 10 ** 6 else 1)]
        row = {"elements": found[0]["elements"],
               "seconds": statistics.median(each["seconds"] for each in found),
               "bytes": statistics.median(each["bytes"] for each in found)}
        rows.append(row)
        print(f"{row['elements']:8d} {row['seconds']:8.2f} "
              f"{1e6 * row['seconds'] / row['elements']:10.2f} {row['bytes']:13.0f}", flush=True)
        asked *= 10
    return rows


def _in_own_process(path: str, size: float) -> Dict[str, float]:
    """Peak memory is a process's own: each run in a fresh one."""
    call = [sys.executable, os.path.abspath(__file__), "--one", path, str(size)]
    done = subprocess.run(call, capture_output=True, text=True, check=True)
    return json.loads(done.stdout.strip().splitlines()[-1])


def one(path: str, size: float) -> None:
    with open(path, encoding="ascii") as file:
        text = file.read()
    core.read_brep(text)
    before = _memory("VmRSS")
    elements, seconds = mesh(text, size)
    print(json.dumps({"elements": elements, "seconds": seconds,
                      "bytes": (_memory("VmHWM") - before) / elements}))


def _memory(entry: str) -> float:
    """[bytes], of this process, as Linux tells it."""
    with open("/proc/self/status", encoding="ascii") as file:
        return next(1024.0 * float(line.split()[1]) for line in file if line.startswith(entry))


def threads(runs: int) -> Dict[str, float]:
    text = lattice().exportBrepToString()
    times: Dict[int, List[float]] = {1: [], 2: []}
    for _ in range(runs):
        for count in times:
            times[count].append(mesh(text, 0.6, count, time.perf_counter)[1])
    row = {"one": min(times[1]), "two": min(times[2]), "gain": min(times[1]) / min(times[2])}
    print(f"\nthreads, 448 faces, best of {runs}: one {row['one']:.2f} s, two {row['two']:.2f} s, "
          f"gain {row['gain']:.2f}")
    return row


def main() -> int:
    parser = argparse.ArgumentParser(prog="./dev bench speed", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--largest", type=int, default=10 ** 6)
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--one", nargs=2, help=argparse.SUPPRESS)
    asked = parser.parse_args()
    if asked.one:
        one(asked.one[0], float(asked.one[1]))
        return 0
    result = {"surfaces": by_surface(asked.runs), "scaling": scaling(asked.runs, asked.largest),
              "threads": threads(asked.runs)}
    if asked.json:
        write_json(asked.json, result)
    return 0


if __name__ == "__main__":
    sys.exit(main())

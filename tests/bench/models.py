"""Meshes every CAD file of a folder and prints a line for each.

    ./dev bench models [FOLDER] [--parts N]

FOLDER defaults to `shared/models` beside the checkout; without it there is nothing to do. The size
is the box diagonal over N (default 100), the first height a tenth of it, growth 1.15.
"""
from __future__ import annotations

import argparse
import glob
import os
import time
from typing import Any, Dict

import advlayers_core as core

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ENDINGS = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
HEAD = (f"{'file':30s} {'faces':>5s} {'elements':>8s} {'quads %':>7s} {'45-135':>6s} {'< 20':>6s} "
        f"{'inv':>3s} {'seconds':>7s}  diagnostics")


def mesh_file(path: str, parts: float) -> Dict[str, Any]:
    model = core.read_file(path)
    size = model.diagonal / parts
    mesher = core.Mesher(model, core.Settings(size=size, first_height=size / 10, growth=1.15))
    for _ in mesher:
        pass
    mesh = mesher.result()
    codes = [found["code"] for found in mesh.diagnostics]
    return {**mesh.figures, "faces": model.face_count,
            "diagnostics": ", ".join(f"{codes.count(c)} {c}" for c in sorted(set(codes)))}


def main() -> None:
    parser = argparse.ArgumentParser(prog="./dev bench models")
    parser.add_argument("folder", nargs="?",
                        default=os.path.join(os.path.dirname(ROOT), "shared", "models"))
    parser.add_argument("--parts", type=float, default=100.0)
    asked = parser.parse_args()
    files = sorted(path for path in glob.glob(os.path.join(asked.folder, "*"))
                   if path.lower().endswith(ENDINGS))
    if not files:
        print(f"no CAD files in {asked.folder}: nothing to measure")
        return
    print(HEAD)
    for path in files:
        start = time.perf_counter()
        try:
            row = mesh_file(path, asked.parts)
        except (ValueError, RuntimeError) as error:
            print(f"{os.path.basename(path):30s} {error}", flush=True)
            continue
        print(f"{os.path.basename(path):30s} {row['faces']:5d} "
              f"{row['quads'] + row['triangles']:8d} {row['quad_percent']:7.2f} "
              f"{row['angles_45_135_percent']:6.2f} {row['angles_below_20_percent']:6.3f} "
              f"{row['inverted']:3d} {time.perf_counter() - start:7.1f}  {row['diagnostics']}",
              flush=True)


if __name__ == "__main__":
    main()

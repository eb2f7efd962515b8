"""What each step of the method is worth: every shape is meshed without one step at a time.

    ./dev bench ablation [--faces N] [--json FILE]

The shapes: the paper's cases of the quality benchmark, and N random faces of the soak (default 60).
Sums over all shapes, and the difference to the whole method.
"""
from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from typing import Any, Dict, Iterator, List, Tuple

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.path.join(ROOT, "build", "release", "tests", "bench", "ablation")
sys.path.append(os.path.join(ROOT, "tests", "fuzz"))

import cases  # noqa: E402 - tests/fuzz must be on the path for the next
import face_cases  # noqa: E402
from json_file import write_json  # noqa: E402


def shapes(faces: int) -> Iterator[Tuple[Any, Dict[str, Any]]]:
    for case in cases.PAPER:
        yield case.shape(), case.job
    for number in range(faces):
        case = face_cases.make(1, number)
        yield case.shape, case.job


def run(shape, job: Dict[str, Any]) -> List[Dict[str, Any]]:
    """A row for each step left out; none where the program gave up."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "shape.brep")
        shape.exportBrep(path)
        done = subprocess.run([PROGRAM, path, str(job["size"]), str(job["first_height"]),
                               str(job["growth"])], capture_output=True, text=True)
    if done.returncode:
        print(f"left out: {done.stderr.strip()}", file=sys.stderr)
        return []
    return [json.loads(line) for line in done.stdout.splitlines()]


def total(rows: List[List[Dict[str, Any]]], k: int) -> Dict[str, Any]:
    """The k-th variant over all shapes; angles are weighted by elements."""
    chosen = [variants[k] for variants in rows]
    quads, triangles = (sum(row[kind] for row in chosen) for kind in ("quads", "triangles"))
    elements = quads + triangles

    def mean(key: str) -> float:
        return sum(row[key] * (row["quads"] + row["triangles"]) for row in chosen) / elements
    return {"without": chosen[0]["without"], "elements": elements, "triangles": triangles,
            "quads": 100.0 * quads / elements,
            "least": min(100.0 * row["quads"] / (row["quads"] + row["triangles"])
                         for row in chosen),
            "angles": mean("angles"), "below_20": mean("below_20"),
            "inverted": sum(row["inverted"] for row in chosen),
            "seconds": sum(row["seconds"] for row in chosen)}


def main() -> None:
    parser = argparse.ArgumentParser(prog="./dev bench ablation", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--faces", type=int, default=60)
    parser.add_argument("--json", metavar="FILE")
    asked = parser.parse_args()
    rows = [found for found in (run(*each) for each in shapes(asked.faces)) if found]
    table = [total(rows, k) for k in range(len(rows[0]))]
    print(f"{len(rows)} shapes\n{'without':24s} {'elements':>8s} {'triangles':>9s} {'quads %':>7s} "
          f"{'least':>6s} {'45-135':>6s} {'< 20':>6s} {'inv':>3s} {'seconds':>7s}")
    for row in table:
        print(f"{row['without'] or '(the whole method)':24s} {row['elements']:8d} "
              f"{row['triangles']:9d} {row['quads']:7.2f} {row['least']:6.2f} "
              f"{row['angles']:6.2f} {row['below_20']:6.3f} {row['inverted']:3d} "
              f"{row['seconds']:7.2f}")
    if asked.json:
        write_json(asked.json, {"shapes": len(rows), "rows": table})


if __name__ == "__main__":
    main()

"""Writes docs/results.md, its tables, histograms and pictures, from what the benchmarks measured.

    ./dev bench quality --peers --meshes out/bench --json out/bench/quality.json
    ./dev bench ablation --json out/bench/ablation.json
    ./dev bench speed --json out/bench/speed.json
    ./dev docs results

Tables and histograms need no more than the JSON files; the pictures are drawn where there is a
mesh in out/bench.
"""
from __future__ import annotations

import json
import math
import os
import re
import subprocess
import sys
from typing import Any, Dict, List, Optional

DOCS = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(DOCS)
BENCH = os.path.join(ROOT, "out", "bench")
PICTURE = os.path.join(ROOT, "Resources", "examples", "mesh_picture.py")

INTRODUCTION = """# Results

Written by `./dev docs results` from what `./dev bench` measured; do not edit. Sizes in mm, angles
in degrees, shares in percent. *Heights within 2 %* and *normal* are measured on the mesh, over
the regular wall nodes (not within two segments of a corner, one kid): how many first kids are as
far from the wall's curve as was asked, to 2 %, and the mean angle between an extrusion and the
normal of its front in the first five layers.
"""
HISTOGRAMS = (
    ("wing", "NACA 0018", ("wing, growth 1.05", "wing, growth 1.1")),
    ("concave", "Plate with concave corners", ("concave plate, growth 1.04",
                                               "concave plate, growth 1.08")),
    ("ten-faces", "Solid of ten faces", ("ten faces, aspect ratio 9.5",)),
)
PICTURES = (
    ("wing, growth 1.05", "The wing at growth 1.05 (the paper's Fig. 15a and c)."),
    ("wing, growth 1.1", "The wing at growth 1.1 (Fig. 15b and d)."),
    ("concave plate, growth 1.04", "The plate with concave corners at growth 1.04 (Fig. 17a)."),
    ("concave plate, growth 1.08", "The same at growth 1.08 (Fig. 17b)."),
    ("ten faces, aspect ratio 9.5", "The solid of ten faces at an aspect ratio of 9.5 (Fig. 19)."),
    ("fan of 300 deg, A 5, growth 1.15", "A fan of three kids about a corner of 300 degrees."),
)


def stem(name: str) -> str:
    """The file name of a case's mesh and picture."""
    return re.sub(r"\W+", "-", name)


def read(name: str) -> Optional[Any]:
    path = os.path.join(BENCH, name)
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def table(head: List[str], rows: List[List[str]]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def quality_row(row: Dict[str, Any]) -> List[str]:
    layers = row["layers"]
    causes = ", ".join(f"{count} {cause}" for cause, count in sorted(row["causes"].items()))
    measured = layers["columns"] > 0
    return [row["name"], str(row["elements"]), f"{row['quads']:.2f}",
            f"{row['layer_quads']:.2f} / {row['core_quads']:.2f}", f"{row['angles']:.2f}",
            f"{row['below_20']:.3f} / {row['above_160']:.3f}",
            f"{layers['height_within_2']:.1f}" if measured else "",
            f"{layers['growth_off']:.2f}" if measured else "",
            f"{layers['direction']:.2f}" if measured else "", causes]


def peer_rows(row: Dict[str, Any]) -> List[List[str]]:
    found = []
    if row["paper"]:
        paper = row["paper"]
        found.append(["*the paper*", str(paper.get("elements", "")), f"{paper['quads']:.2f}", "",
                      f"{paper['angles']:.2f}" if "angles" in paper else "", "", "", "", "", ""])
    names = {"quads": "*gmsh, isotropic quads*", "layers": "*gmsh, boundary layers*"}
    for way, got in row.get("peers", {}).items():
        if "failed" in got:
            found.append([names[way], got["failed"]] + [""] * 8)
            continue
        least, mean, most = got["first_row"]
        found.append([names[way], str(got["elements"]), f"{got['quads']:.2f}", "",
                      f"{got['angles']:.2f}", f"{got['below_20']:.3f}",
                      f"first row {least:.1f} … {mean:.1f} … {most:.1f} h", "", "", ""])
    return found


def quality(rows: List[Dict[str, Any]]) -> str:
    head = ["case", "elements", "quads", "in layers / core", "45–135", "< 20 / > 160",
            "heights within 2 %", "growth off", "normal", "triangles by cause"]
    titles = {"paper": "The paper's cases", "fan": "Fans of kids at convex corners, ten layers",
              "growth": "Ten layers on a drilled plate",
              "primitive": "Primitives and trimmed faces"}
    text = ""
    for group, title in titles.items():
        lines = []
        for row in rows:
            if row["group"] == group:
                lines.append(quality_row(row))
                lines += peer_rows(row) if group != "fan" else []
        if lines:
            text += f"\n## {title}\n\n" + table(head, lines)
    return text


def histogram(title: str, rows: List[Dict[str, Any]]) -> str:
    """Interior angles in bins of five degrees, as SVG; counts on a logarithmic scale."""
    width, height, left, bottom = 640, 300, 52, 40
    colours = ("#2a5fa0", "#d98a2b")
    most = max(max(row["histogram"]) for row in rows)
    decades = max(1, math.ceil(math.log10(most)))
    across, up = (width - left - 12) / 36.0, (height - bottom - 34) / decades
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
             'font-family="sans-serif" font-size="12">',
             f'<rect width="{width}" height="{height}" fill="white"/>',
             f'<text x="{left}" y="18" font-size="14">{title}: interior angles</text>']
    base = height - bottom
    for decade in range(decades + 1):
        y = base - decade * up
        parts.append(f'<path d="M{left} {y:.1f}H{width - 12}" stroke="#ddd"/>'
                     f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">'
                     f'{10 ** decade}</text>')
    for angle in range(0, 181, 15):
        x = left + angle / 5.0 * across
        parts.append(f'<text x="{x:.1f}" y="{base + 16}" text-anchor="middle">{angle}</text>')
    bar = across / (len(rows) + 0.3)
    for i, row in enumerate(rows):
        for k, count in enumerate(row["histogram"]):
            if count:
                tall = max(math.log10(count) * up, 1.5)
                parts.append(f'<rect x="{left + k * across + (i + 0.15) * bar:.1f}" '
                             f'y="{base - tall:.1f}" width="{bar:.1f}" height="{tall:.1f}" '
                             f'fill="{colours[i]}"/>')
        x = left + i * 210
        parts.append(f'<rect x="{x}" y="{height - 14}" width="10" height="10" '
                     f'fill="{colours[i]}"/><text x="{x + 15}" y="{height - 5}">{row["name"]}'
                     '</text>')
    return "\n".join(parts + ["</svg>"]) + "\n"


def histograms(rows: List[Dict[str, Any]]) -> str:
    by_name = {row["name"]: row for row in rows}
    text = ""
    for short, title, names in HISTOGRAMS:
        chosen = [by_name[name] for name in names if name in by_name]
        if not chosen:
            continue
        file = f"angles-{short}.svg"
        with open(os.path.join(DOCS, "images", file), "w", encoding="utf-8") as stream:
            stream.write(histogram(title, chosen))
        text += f"\n![{title}: interior angles](images/{file})\n"
    return "\n## Angles\n\nThe paper's Figs. 16 and 18.\n" + text if text else ""


def pictures() -> str:
    text = ""
    for name, caption in PICTURES:
        mesh = os.path.join(BENCH, stem(name) + ".vtu")
        if not os.path.exists(mesh):
            continue
        file = f"mesh-{stem(name)}.png"
        subprocess.run([sys.executable, PICTURE, mesh, os.path.join(DOCS, "images", file), "960"],
                       check=True)
        text += f"\n{caption}\n\n![{name}](images/{file})\n"
    return "\n## Pictures\n\nLayers in blue, darkest at the walls.\n" + text if text else ""


def ablation(found: Dict[str, Any]) -> str:
    head = ["without", "elements", "triangles", "quads", "least quads of a shape", "45–135", "< 20",
            "seconds"]
    rows = [[row["without"] or "*(nothing: the whole method)*", str(row["elements"]),
             str(row["triangles"]), f"{row['quads']:.2f}", f"{row['least']:.2f}",
             f"{row['angles']:.2f}", f"{row['below_20']:.3f}", f"{row['seconds']:.2f}"]
            for row in found["rows"]]
    return (f"\n## What each step is worth\n\n{found['shapes']} shapes (the paper's cases and "
            "random faces) meshed with one step left out at a time; sums over all, seconds of "
            "processor time for layers and core. The steps are those of [method.md](method.md).\n\n"
            + table(head, rows))


def speed(found: Dict[str, Any]) -> str:
    head = ["surface", "elements", "elements/s", "gmsh, Blossom", "gmsh, full quads", "ratio"]
    rows = []
    for row in found["surfaces"]:
        peers = [row[way] for way in ("quads", "full quads") if way in row]
        rows.append([row["surface"], str(row["elements"]), f"{row['ours']:.0f}"]
                    + [f"{row[way]:.0f}" if way in row else "failed"
                       for way in ("quads", "full quads")]
                    + [f"{row['ours'] / max(peers):.1f}" if peers else ""])
    text = ("\n## Speed\n\nProcessor time of one thread, medians of interleaved runs, reading "
            "excluded; the ratio is to the faster of gmsh's.\n\n" + table(head, rows))
    scaling = [[str(row["elements"]), f"{row['seconds']:.2f}",
                f"{1e6 * row['seconds'] / row['elements']:.1f}", f"{row['bytes']:.0f}"]
               for row in found["scaling"]]
    text += "\n" + table(["wing, elements", "seconds", "µs per element", "bytes per element"],
                         scaling)
    gain = found["threads"]
    return text + (f"\n448 faces: {gain['one']:.2f} s with one thread, {gain['two']:.2f} s with "
                   f"two, a gain of {gain['gain']:.2f}.\n")


def main() -> None:
    text = INTRODUCTION
    rows = read("quality.json")
    if rows is None:
        sys.exit("no out/bench/quality.json: run ./dev bench quality first, as this file says")
    text += quality(rows) + histograms(rows) + pictures()
    steps = read("ablation.json")
    if steps:
        text += ablation(steps)
    timed = read("speed.json")
    if timed:
        text += speed(timed)
    with open(os.path.join(DOCS, "results.md"), "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()

"""Prints a hash of the mesh of each of some twenty shapes, to see what a change has moved.

    ./dev bench hashes [--against FILE] [--write FILE] [MODEL ...]

Nodes, elements, layers and faces go into a hash, bit for bit. --write keeps the hashes, --against
compares with those of another run; a MODEL is a CAD file that is meshed beside the shapes at a
hundredth of its diagonal. Exit status 1: a mesh differs from the one it was held against.
"""
from __future__ import annotations

import argparse
import hashlib
import json
import os
import sys
from typing import Any, Callable, Dict, Iterator, Tuple

import numpy as np

import advlayers_core as core
from cases import CASES
from freecad_part import FreeCAD, Part
from json_file import write_json

V = FreeCAD.Vector
# One of each of the kinds that the quality benchmark has many of.
TAKEN = ("wing, growth 1.1", "concave plate, growth 1.08", "ten faces, aspect ratio 9.5",
         "fan of 270 deg, A 5, growth 1.15", "fan of 360 deg, A 50, growth 1.15",
         "ten layers, growth 1.2", "box", "cylinder", "cone", "sphere", "torus", "bracket",
         "trimmed sphere", "trimmed torus", "B-spline patch")


def checkered(count: int) -> "Part.Shape":
    """One patch of many coplanar faces."""
    def square(i: int, j: int) -> "Part.Shape":
        points = [V(i, j, 0), V(i + 1, j, 0), V(i + 1, j + 1, 0), V(i, j + 1, 0), V(i, j, 0)]
        return Part.Face(Part.makePolygon(points))
    shell = Part.Shell([square(i, j) for i in range(count) for j in range(count)])
    shell.sewShape()
    return shell


def rounded_box() -> "Part.Shape":
    box = Part.makeBox(10, 8, 6)
    return box.makeFillet(1.5, box.Edges)


def narrow_strip() -> "Part.Shape":
    return Part.makePlane(20, 0.6)


def matched() -> Dict[str, Any]:
    return {"walls": [{"edges": ["Edge1"]}], "match": ["Edge2", "Edge4"], "off": ["Edge3"]}


OWN: Tuple[Tuple[str, Callable[[], Any], Dict[str, Any]], ...] = (
    ("rounded box", rounded_box, {"size": 0.8, "first_height": 0.1, "growth": 1.2}),
    ("checkered plate", lambda: checkered(12),
     {"size": 0.5, "first_height": 0.1, "growth": 1.2, "layers": 3}),
    ("narrow strip", narrow_strip, {"size": 0.7, "first_height": 0.4}),
    ("matched plate", lambda: Part.makePlane(10, 6),
     {"size": 0.5, "first_height": 0.05, "growth": 1.2, "layers": 8, **matched()}),
    ("triangles", lambda: Part.makePlane(10, 6),
     {"size": 0.5, "first_height": 0.1, "growth": 1.2, "layers": 4, "core": "triangles"}),
    ("until isotropic", lambda: Part.makeCylinder(4, 9),
     {"size": 0.6, "first_height": 0.05, "growth": 1.25, "layers": "isotropic"}))


def shapes(models: list) -> Iterator[Tuple[str, Any, Dict[str, Any]]]:
    for case in CASES:
        if case.name in TAKEN:
            yield case.name, core.read_brep(case.shape().exportBrepToString()), case.job
    for name, shape, settings in OWN:
        yield name, core.read_brep(shape().exportBrepToString()), settings
    for path in models:
        model = core.read_file(path)
        size = model.diagonal / 100.0
        yield os.path.basename(path), model, {"size": size, "first_height": size / 10.0,
                                              "growth": 1.15}


def mesh_hash(model, settings: Dict[str, Any]) -> str:
    mesher = core.Mesher(model, core.Settings(threads=1, **settings))
    for _ in mesher:
        pass
    mesh = mesher.result()
    digest = hashlib.sha256()
    for array in (mesh.nodes, mesh.quads, mesh.triangles, mesh.face_of_quad, mesh.face_of_triangle,
                  mesh.layer_of_quad, mesh.layer_of_triangle, mesh.node_parent, mesh.node_layer):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()[:16]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("models", nargs="*", metavar="MODEL")
    parser.add_argument("--against", metavar="FILE")
    parser.add_argument("--write", metavar="FILE")
    asked = parser.parse_args()
    before: Dict[str, str] = {}
    if asked.against:
        with open(asked.against, encoding="utf-8") as file:
            before = json.load(file)
    found: Dict[str, str] = {}
    moved = 0
    for name, model, settings in shapes(asked.models):
        found[name] = mesh_hash(model, settings)
        differs = before.get(name, found[name]) != found[name]
        moved += differs
        print(f"{name:36s} {found[name]}{'  differs' if differs else ''}", flush=True)
    if asked.write:
        write_json(asked.write, found)
    return 1 if moved else 0


if __name__ == "__main__":
    sys.exit(main())

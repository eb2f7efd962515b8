"""Reads and meshes one damaged CAD file: an error that says so, or a mesh; never a crash."""
from __future__ import annotations

import functools
import os
import re
import tempfile
import time
from random import Random
from typing import Any, Dict, List

import numpy as np

import advlayers_core as core
from freecad_part import FreeCAD, Part
from mesh_checks import Elements

ENDINGS = (".brep", ".step", ".iges")
WAYS = ("cut short", "bytes", "reals", "integers", "lines")
REAL = re.compile(rb"-?\d+\.\d*(?:[eE][-+]?\d+)?")
INTEGER = re.compile(rb"(?<![\d.eE+-])\d+(?![\d.eE])")


@functools.lru_cache(maxsize=None)
def sound_files() -> Dict[str, bytes]:
    """A small solid of planar, cylindrical, toroidal and B-spline faces, in each format."""
    vector = FreeCAD.Vector
    solid = Part.makeBox(10, 8, 4).cut(Part.makeCylinder(2, 9, vector(4, 4, -2)))
    solid = solid.makeFillet(0.8, solid.Edges[:4])
    solid = solid.fuse(Part.makeSphere(2.0, vector(10, 4, 2)))
    files = {}
    with tempfile.TemporaryDirectory() as folder:
        for ending, write in ((".brep", solid.exportBrep), (".step", solid.exportStep),
                              (".iges", solid.exportIges)):
            path = os.path.join(folder, "solid" + ending)
            write(path)
            with open(path, "rb") as file:
                files[ending] = file.read()
    return files


def damage(rng: Random, way: str, data: bytes) -> bytes:
    if way == "cut short":
        return data[:rng.randrange(len(data))]
    if way == "bytes":
        spoilt = bytearray(data)
        for _ in range(rng.randint(1, 30)):
            spoilt[rng.randrange(len(spoilt))] = rng.randrange(256)
        return bytes(spoilt)
    if way in ("reals", "integers"):
        return _other_numbers(rng, REAL if way == "reals" else INTEGER, data)
    lines = data.split(b"\n")
    for _ in range(rng.randint(1, 3)):
        i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
        lines[i], lines[j] = lines[j], lines[i]
    if rng.random() < 0.5:
        del lines[rng.randrange(len(lines))]
    return b"\n".join(lines)


def _other_numbers(rng: Random, pattern, data: bytes) -> bytes:
    """Some numbers replaced by others of the same length, so that columns stay where they are."""
    spoilt = bytearray(data)
    for found in rng.choices(list(pattern.finditer(data)), k=rng.randint(1, 4)):
        width = found.end() - found.start()
        if pattern is INTEGER:
            text = str(rng.choice((0, 1, int(found.group()[:9]) + rng.choice((-1, 1)),
                                   rng.randrange(10 ** min(width, 9)))))
        else:
            text = rng.choice(("0.", "1.", "-1.", "1.E30", "1.E-30", "9.E99",
                               repr(float(found.group()) * rng.uniform(-2.0, 2.0))))
        spoilt[found.start():found.end()] = text.encode()[:width].ljust(width)
    return bytes(spoilt)


def run(seed: int, number: int) -> Dict[str, Any]:
    rng = Random(f"{seed} damaged {number}")
    ending = ENDINGS[number % len(ENDINGS)]
    way = WAYS[number // len(ENDINGS) % len(WAYS)]
    row: Dict[str, Any] = {"number": number, "name": f"{ending[1:]}, {way}", "faults": []}
    data = damage(rng, way, sound_files()[ending])
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "damaged" + ending)
        with open(path, "wb") as file:
            file.write(data)
        try:
            row["outcome"] = _mesh(core.read_file(path), row["faults"])
        except (core.InvalidInput, core.GeometryError):
            row["outcome"] = "refused"
        except (ValueError, RuntimeError) as error:
            row["outcome"] = "failed"
            row["faults"].append(f"{type(error).__name__}: {error}")
    row["seconds"] = time.perf_counter() - start
    return row


def _mesh(model, faults: List[str]) -> str:
    size = model.diagonal / 25.0
    mesher = core.Mesher(model, core.Settings(size=size, first_height=size / 8.0, layers=5,
                                              threads=1))
    for _ in mesher:
        pass
    mesh = mesher.result()
    edges, _ = Elements(mesh.nodes, mesh.quads, mesh.triangles).directed_edges()
    if len(np.unique(edges, axis=0)) != len(edges) and model.closed:
        faults.append("an edge is used twice in one direction")
    trouble = [entry for entry in mesh.diagnostics if entry["severity"] == "error"]
    if mesh.figures["inverted"] and not trouble:
        faults.append(f"{mesh.figures['inverted']} inverted and no diagnostic")
    return "meshed, with diagnostics" if trouble else "meshed"


def summary(rows: List[Dict[str, Any]]) -> List[str]:
    for word in ENDINGS + WAYS:
        group = [row for row in rows if word.strip(".") in row["name"]]
        outcomes = [row.get("outcome", "crashed or hung") for row in group]
        print(f"  {word:14s} {len(group):4d} files: " + ", ".join(
            f"{outcomes.count(each)} {each}" for each in sorted(set(outcomes))))
    return []

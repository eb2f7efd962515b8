"""Writing 10^6 elements in each format: computing time, memory beside the mesh, size of the file.

`./dev bench formats [--elements N] [--document]`; the last one also builds FreeCAD's FemMesh, in
freecadcmd.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
import tracemalloc
from dataclasses import replace

import numpy as np

from advlayers import export
from advlayers.formats.mesh_parts import Block, Group, MeshParts

# [s] of computing time at 10^6 elements; memory in copies of the mesh.
BARS = {".unv": 2.0, ".msh": 4.0, ".inp": 4.0, ".bdf": 4.0, ".su2": 4.0}
VTU_MEMORY = 1.3
DOCUMENT = 4.0
FACES, LAYER = 13, 20


def sheet(elements):
    """Quads on a bent sheet, with one in fifty cut in two, on some CAD faces."""
    n = int(np.sqrt(elements))
    i, j = (values.ravel() for values in np.meshgrid(*[np.arange(n + 1)] * 2, indexing="ij"))
    nodes = np.stack([i / 3.0, j / 7.0, np.sin(i / 50.0)], axis=1)
    first = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    quads = np.stack([first, first + n + 1, first + n + 2, first + 1], axis=1).astype(np.int32)
    face = (1 + np.arange(len(quads)) * FACES // len(quads)).astype(np.int32)
    layer = (np.arange(len(quads)) % n // LAYER).astype(np.int32)
    cut = len(quads) // 50
    halves = quads[:cut][:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)
    lines = np.stack([np.arange(n), np.arange(1, n + 1)], axis=1).astype(np.int32)
    return MeshParts(
        nodes, (Block("quad4", quads[cut:], face[cut:], layer[cut:]),
                Block("tri3", halves, face[:cut].repeat(2), layer[:cut].repeat(2)),
                Block("line2", lines, np.ones(n, np.int32))),
        (Group("inlet", 2, (1, 2)), Group("rim", 1, (1,))))


def size_of(parts):
    return parts.nodes.nbytes + sum(
        array.nbytes for block in parts.blocks
        for array in (block.cells, block.part, block.layer) if array is not None)


def measure(parts, ending, folder):
    path = os.path.join(folder, f"mesh{ending}")
    if ending == ".su2":  # of a plane
        parts = replace(parts, nodes=parts.nodes * (1.0, 1.0, 0.0))
    product = export.Product(parts)
    start = time.process_time()
    export.FORMATS[ending].write(path, product)
    seconds = time.process_time() - start
    size = os.path.getsize(path)
    fresh = replace(parts)  # without what was worked out on the way
    tracemalloc.start()
    export.FORMATS[ending].write(path, export.Product(fresh))
    peak = 1.0 + tracemalloc.get_traced_memory()[1] / size_of(parts)
    tracemalloc.stop()
    os.remove(path)
    return seconds, peak, size / 2**20


def document(parts):
    """Seconds for a FemMesh with all groups, through a file and node by node."""
    from advlayers import fem_mesh

    for word, check in (("through a file", None), ("node by node", lambda: None)):
        start = time.process_time()
        fem_mesh.to_fem_mesh(parts, check)
        print(f"FemMesh, {word}: {time.process_time() - start:.1f} s (bar {DOCUMENT})", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--elements", type=int, default=10**6)
    parser.add_argument("--document", action="store_true")
    given = parser.parse_args()
    parts = sheet(given.elements)
    print(f"{'format':<12}{'CPU s':>8}{'bar':>6}{'copies':>8}{'MiB':>7}")
    with tempfile.TemporaryDirectory() as folder:
        for ending, entry in export.FORMATS.items():
            if entry.needs == "FreeCAD":
                continue
            seconds, peak, size = measure(parts, ending, folder)
            bar = BARS.get(ending, "")
            print(f"{ending:<12}{seconds:8.2f}{bar:>6}{peak:8.2f}{size:7.0f}", flush=True)
    print(f"bar of the memory of .vtu: {VTU_MEMORY} copies")
    if given.document and shutil.which("freecadcmd"):
        code = (f"import sys; sys.path[:0] = {sys.path!r}\nimport formats\n"
                f"formats.document(formats.sheet({given.elements}))")
        text = subprocess.run(["freecadcmd", "-c", code], stdin=subprocess.DEVNULL, text=True,
                              stdout=subprocess.PIPE, check=True).stdout
        print("\n".join(line for line in text.splitlines() if line.startswith("FemMesh,")))


if __name__ == "__main__":
    main()

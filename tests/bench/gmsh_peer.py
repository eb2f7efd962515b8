"""Meshes a BREP with gmsh and prints figures: gmsh_peer.py FILE.brep SIZE WAY H0 GROWTH

WAY: "quads" (isotropic, paired by Blossom), "full quads" (halved and paired again, which leaves no
triangle) or "layers" (the field BoundaryLayer on every edge of a planar face). A process of its
own, since gmsh may crash.
"""
from __future__ import annotations

import json
import sys
import time

import gmsh
import numpy as np

from freecad_part import Part
from layer_heights import first_rows
from mesh_checks import Elements


def mesh(path: str, size: float, way: str, height: float, growth: float) -> Elements:
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.model.occ.importShapes(path)
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.option.setNumber("Mesh.MeshSizeMin", 0.0 if way == "layers" else size)
    gmsh.option.setNumber("Mesh.Algorithm", 6)
    gmsh.option.setNumber("Mesh.RecombineAll", 1)
    gmsh.option.setNumber("Mesh.RecombinationAlgorithm",
                          3 if way == "full quads" else 1)
    if way == "layers":
        field = gmsh.model.mesh.field.add("BoundaryLayer")
        curves = [tag for _, tag in gmsh.model.getEntities(1)]
        gmsh.model.mesh.field.setNumbers(field, "CurvesList", curves)
        five_layers = height * (growth ** 5 - 1.0) / (growth - 1.0)  # it fails on more, mostly
        for name, value in (("Size", height), ("Ratio", growth), ("Quads", 1),
                            ("Thickness", five_layers)):
            gmsh.model.mesh.field.setNumber(field, name, value)
        gmsh.model.mesh.field.setAsBoundaryLayer(field)
    gmsh.model.mesh.generate(2)
    tags, places, _ = gmsh.model.mesh.getNodes()
    index = np.zeros(int(tags.max()) + 1, int)
    index[tags.astype(int)] = np.arange(len(tags))
    elements = {3: np.zeros((0, 4), int), 2: np.zeros((0, 3), int)}
    for kind, _, corners in zip(*gmsh.model.mesh.getElements(2)):
        if kind in elements:
            elements[kind] = index[corners.astype(int)].reshape(-1, 4 if kind == 3 else 3)
    return Elements(places.reshape(-1, 3), elements[3], elements[2])


def main() -> None:
    path, size, way = sys.argv[1], float(sys.argv[2]), sys.argv[3]
    height, growth = (float(word) for word in sys.argv[4:6])
    gmsh.initialize()
    start = time.process_time()
    elements = mesh(path, size, way, height, growth)
    seconds = time.process_time() - start
    angles = elements.angles()
    rows = first_rows(elements, Part.read(path)) / height
    print(json.dumps({
        "elements": len(elements), "quads": 100.0 * elements.quad_count / max(len(elements), 1),
        "angles": 100.0 * float(((angles >= 45.0) & (angles <= 135.0)).mean()),
        "below_20": 100.0 * float((angles < 20.0).mean()), "area": elements.area(),
        "turned": int((angles > 180.0).sum()), "seconds": seconds,
        "first_row": [float(rows.min()), float(rows.mean()), float(rows.max())]}))


if __name__ == "__main__":
    main()

"""Writes the shapes beside this file: run it with `freecadcmd -c "..."`, see the last lines.

    freecadcmd -c "import runpy; runpy.run_path('tests/data/make_shapes.py')"
"""
import os

import FreeCAD
import Part

V = FreeCAD.Vector
SHAPES = {
    "box": Part.makeBox(10, 8, 6),
    "cylinder": Part.makeCylinder(5, 12),
    "cone": Part.makeCone(5, 2, 8),
    "sphere": Part.makeSphere(6),
    "torus": Part.makeTorus(10, 3),
    "drilled_plate": Part.makeBox(20, 12, 4).cut(Part.makeCylinder(3, 10, V(8, 6, -2))),
    "bracket": Part.makeBox(12, 10, 8).cut(Part.makeBox(9, 10, 5, V(3, 0, 3))),
    "square": Part.Face(Part.makePolygon([V(0, 0), V(10, 0), V(10, 10), V(0, 10), V(0, 0)])),
}

folder = os.path.dirname(os.path.abspath(__file__))
for name, shape in SHAPES.items():
    with open(os.path.join(folder, name + ".brep"), "w", encoding="ascii") as file:
        file.write(shape.exportBrepToString())

"""Writes the shapes beside this file: run it with `freecadcmd -c "..."`, see the last lines.

    freecadcmd -c "import runpy; runpy.run_path('tests/data/make_shapes.py')"
"""
import math
import os

import FreeCAD
import Part

V = FreeCAD.Vector


def naca_0012(points=30):
    """Upper and lower side of a chord of 1000 mm with a sharp end, in a circle of 20 chords."""
    places = [(1 - math.cos(math.pi * i / points)) / 2 for i in range(points + 1)]
    heights = [60 * (2.969 * math.sqrt(x) - 1.26 * x - 3.516 * x ** 2 + 2.843 * x ** 3
                     - 1.036 * x ** 4) for x in places]
    upper = [V(1000 * x, y, 0) for x, y in zip(places, heights)]
    sides = []
    for row in (upper, [V(p.x, -p.y, 0) for p in upper]):
        curve = Part.BSplineCurve()
        curve.interpolate(row)
        sides.append(curve.toShape())
    airfoil = Part.Face(Part.Wire([sides[0], sides[1].reversed()]))
    centre = V(500, 0, 0)
    halves = [Part.makeCircle(20000, centre, V(0, 0, 1), at, at + 180) for at in (-90, 90)]
    return Part.Face(Part.Wire(halves)).cut(airfoil).Faces[0]


SHAPES = {
    "box": Part.makeBox(10, 8, 6),
    "cylinder": Part.makeCylinder(5, 12),
    "cone": Part.makeCone(5, 2, 8),
    "sphere": Part.makeSphere(6),
    "torus": Part.makeTorus(10, 3),
    "drilled_plate": Part.makeBox(20, 12, 4).cut(Part.makeCylinder(3, 10, V(8, 6, -2))),
    "bracket": Part.makeBox(12, 10, 8).cut(Part.makeBox(9, 10, 5, V(3, 0, 3))),
    "airfoil": naca_0012(),
    # A quarter of a plate of 40 x 20 with a hole of diameter 4, which is at the origin.
    "quarter_plate": Part.makePlane(20, 10).cut(Part.makeCylinder(2, 2, V(0, 0, -1))).Faces[0],
    "square": Part.Face(Part.makePolygon([V(0, 0), V(10, 0), V(10, 10), V(0, 10), V(0, 0)])),
}

folder = os.path.dirname(os.path.abspath(__file__))
for name, shape in SHAPES.items():
    with open(os.path.join(folder, name + ".brep"), "w", encoding="ascii") as file:
        file.write(shape.exportBrepToString())

"""Builds the NACA 0018 wing with a sharp trailing edge, and a batch job that meshes it.

Runs in FreeCAD: `write_demo("out")` from freecadcmd, or open it as a macro to see the wing.
"""
import json
import math
import os

import FreeCAD
import Part

CHORD, SPAN, THICKNESS = 1000.0, 1500.0, 0.18  # mm, mm, of the chord
SIZE, FIRST_HEIGHT, GROWTH = 65.0, 7.0, 1.1

# Half the thickness of a symmetric four-digit section, by powers of s = sqrt(x), x along the chord.
# The last coefficient is the one that closes the trailing edge.
SECTION = {1: 0.2969, 2: -0.1260, 4: -0.3516, 6: 0.2843, 8: -0.1036}


def side(sign):
    """One side of the section, leading to trailing edge. In s the section is a polynomial of
    degree 8, so that a Bezier curve is exactly it."""
    degree = max(SECTION)
    poles = []
    for j in range(degree + 1):
        share = {i: math.comb(j, i) / math.comb(degree, i) for i in range(j + 1)}
        x = share.get(2, 0.0)
        y = 5.0 * THICKNESS * sum(c * share.get(i, 0.0) for i, c in SECTION.items())
        poles.append(FreeCAD.Vector(CHORD * x, sign * CHORD * y, 0.0))
    poles[-1].y = 0.0
    curve = Part.BezierCurve()
    curve.setPoles(poles)
    return curve.toBSpline().toShape()


def wing():
    section = Part.Face(Part.Wire([side(1.0), side(-1.0)]))
    return section.extrude(FreeCAD.Vector(0.0, 0.0, SPAN))


def write_demo(folder):
    """Writes the wing and the job that meshes it."""
    shape = wing()
    if not shape.isValid() or len(shape.Faces) != 4:
        raise RuntimeError("the wing did not come out as a solid of four faces")
    shape.exportStep(os.path.join(folder, "naca0018.step"))
    job = {
        "input": "naca0018.step",
        "size": SIZE, "first_height": FIRST_HEIGHT, "growth": GROWTH,
        "outputs": ["naca0018.vtu", "naca0018.unv", "naca0018.FCStd"],
        "report": "naca0018.report.json",
    }
    with open(os.path.join(folder, "naca0018.job.json"), "w", encoding="utf-8") as file:
        json.dump(job, file, indent=1)


if FreeCAD.GuiUp:
    Part.show(wing(), "Wing")

"""Builds the NACA 0018 wing with a sharp trailing edge, and a batch job that meshes it.

Runs in FreeCAD: `write_demo("out")` from freecadcmd, or open it as a macro to see the wing.
"""
import json
import math
import os

import FreeCAD
import Part

CHORD, SPAN, THICKNESS = 1000.0, 1500.0, 0.18  # mm, mm, of the chord
POINTS = 61  # on either side; closer together at both ends
SIZE, FIRST_HEIGHT, GROWTH = 65.0, 7.0, 1.1


def half_thickness(x):
    """Of a symmetric four-digit section at x in [0, 1]; the last coefficient closes the tail."""
    return 5.0 * THICKNESS * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x ** 2
                              + 0.2843 * x ** 3 - 0.1036 * x ** 4)


def side(sign):
    """One side of the section as a spline, from the leading to the trailing edge."""
    steps = [0.5 * (1.0 - math.cos(math.pi * i / (POINTS - 1))) for i in range(POINTS)]
    points = [FreeCAD.Vector(CHORD * x, sign * CHORD * half_thickness(x), 0.0) for x in steps]
    points[-1].y = 0.0
    curve = Part.BSplineCurve()
    # The section stands upright on the leading edge.
    curve.interpolate(Points=points, InitialTangent=FreeCAD.Vector(0, sign, 0),
                      FinalTangent=points[-1] - points[-2])
    return curve.toShape()


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

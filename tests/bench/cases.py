"""The shapes of the quality benchmark: the paper's, fans, and FreeCAD's primitives."""
from __future__ import annotations

import math
import os
import runpy
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Optional

from freecad_part import FreeCAD, Part

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
V = FreeCAD.Vector


@dataclass(frozen=True)
class Case:
    name: str
    shape: Callable[[], Any]
    size: float
    first_height: float
    growth: float
    layers: Any = 0
    group: str = ""
    paper: Optional[Dict[str, float]] = None  # the paper's figures for it
    bar: Optional[Dict[str, float]] = field(default=None)  # least %, or most elements

    @property
    def job(self) -> Dict[str, Any]:
        return {"size": self.size, "first_height": self.first_height, "growth": self.growth,
                "layers": self.layers}


def wing() -> "Part.Shape":
    """NACA 0018 with a sharp trailing edge, chord 1 m, span 1.5 m."""
    example = os.path.join(ROOT, "Resources", "examples", "wing.FCMacro")
    return runpy.run_path(example)["wing"]()


def concave_plate() -> "Part.Shape":
    """A plate with corners of 30, 45, 60, 90 and more degrees, reflex corners, and two holes."""
    corners = [(0, 0), (40, 0), (40, 10), (52, 10), (52, -6), (72, -6), (84, 9), (96, 9), (96, 21),
               (82, 35), (68, 21), (62, 33), (46, 36), (30, 17.3205)]
    points = [V(x, y, 0) for x, y in corners]
    outer = Part.makePolygon(points + points[:1])
    holes = [Part.Wire(Part.makeCircle(radius, V(x, y, 0)))
             for x, y, radius in ((47.0, 24.0, 3.5), (82.0, 22.0, 3.0))]
    return Part.makeFace([outer] + holes, "Part::FaceMakerBullseye").Faces[0]


def ten_faces() -> "Part.Shape":
    """A block with a hole, a boss and a spherical dent: ten planar and curved faces."""
    block = Part.makeBox(60, 40, 20)
    block = block.cut(Part.makeCylinder(7, 40, V(15, 20, -10)))
    block = block.fuse(Part.makeCylinder(8, 12, V(42, 20, 20)))
    solid = block.cut(Part.makeSphere(9, V(60, 0, 20)))
    if len(solid.Faces) != 10:
        raise RuntimeError(f"{len(solid.Faces)} faces instead of ten")
    return solid


def fan(angle: float) -> "Part.Shape":
    """A disc with a wedge cut out, so that the rest has `angle` [deg] at its middle; at 360 deg it
    is slit along a radius."""
    half = math.radians(360.0 - angle) / 2.0
    radius = 100.0
    if angle == 360.0:
        disc = Part.Face(Part.Wire(Part.makeCircle(radius)))
        return disc.generalFuse([Part.makeLine(V(), V(radius, 0, 0))])[0].Faces[0]
    arms = [V(radius * math.cos(sign * half), radius * math.sin(sign * half), 0)
            for sign in (1.0, -1.0)]
    arc = Part.Arc(arms[0], V(-radius, 0, 0), arms[1]).toShape()
    edges = [arc, Part.LineSegment(arms[1], V()).toShape(),
             Part.LineSegment(V(), arms[0]).toShape()]
    return Part.Face(Part.Wire(edges))


def saddle() -> "Part.Shape":
    """A square patch of a bicubic surface, with a hole."""
    surface = Part.BezierSurface()
    surface.increase(3, 3)
    lift = ((0, 2, 2, 0), (-2, 1, 1, -2), (-2, 1, 1, -2), (0, 2, 2, 0))
    for i in range(4):
        for j in range(4):
            surface.setPole(i + 1, j + 1, V(4 * i, 4 * j, lift[i][j]))
    sheet = surface.toBSpline().toShape()
    return sheet.cut(Part.makeCylinder(2, 20, V(6, 6, -10))).Faces[0]


def sphere_zone() -> "Part.Shape":
    """A ball with its top cut off aslant and a hole through it."""
    ball = Part.makeSphere(6)
    ball = ball.cut(Part.makeBox(20, 20, 20, V(-10, -10, 2.5)).rotated(V(), V(1, 0, 0), 20.0))
    return ball.cut(Part.makeCylinder(1.5, 20, V(0, -1, -10)))


def torus_sector() -> "Part.Shape":
    return Part.makeTorus(10, 3, V(), V(0, 0, 1), 0.0, 360.0, 130.0)


def stored(name: str) -> Callable[[], Any]:
    return lambda: Part.read(os.path.join(ROOT, "tests", "data", name + ".brep"))


PAPER = [
    Case("wing, growth 1.05", wing, 65.0, 7.0, 1.05, group="paper",
         paper={"elements": 3912, "quads": 95.86, "angles": 97.38},
         bar={"elements": 4100, "quads": 99.0, "angles": 99.0}),
    Case("wing, growth 1.1", wing, 65.0, 7.0, 1.1, group="paper",
         paper={"elements": 2876, "quads": 93.11, "angles": 96.22},
         bar={"elements": 3000, "quads": 98.5, "angles": 98.5}),
    Case("concave plate, growth 1.04", concave_plate, 2.0, 0.2, 1.04, group="paper",
         paper={"quads": 96.43}, bar={"quads": 98.5}),
    Case("concave plate, growth 1.08", concave_plate, 2.0, 0.12, 1.08, group="paper",
         paper={"quads": 95.82}, bar={"quads": 98.5}),
    Case("ten faces, aspect ratio 9.5", ten_faces, 2.0, 2.0 / 9.5, 1.1, group="paper",
         bar={"quads": 98.0}),
]

FANS = [Case(f"fan of {angle:g} deg, A {aspect}, growth {growth:g}",
             lambda angle=angle: fan(angle), 4.0, 4.0 / aspect, growth, 10, group="fan")
        for angle in (270.0, 300.0, 336.0, 360.0) for aspect in (5, 50)
        for growth in (1.05, 1.15, 1.3)]

GROWTHS = [Case(f"ten layers, growth {growth:g}", stored("drilled_plate"), 0.6, 0.03, growth, 10,
                group="growth") for growth in (1.05, 1.1, 1.15, 1.2, 1.25, 1.3)]

PRIMITIVES = [Case(name.replace("_", " "), stored(name), 0.5, 0.05, 1.1, group="primitive")
              for name in ("square", "box", "cylinder", "cone", "sphere", "torus", "drilled_plate",
                           "bracket")]
PRIMITIVES += [Case(name, shape, 0.5, 0.05, 1.1, group="primitive")
               for name, shape in (("trimmed sphere", sphere_zone), ("trimmed torus", torus_sector),
                                   ("B-spline patch", saddle))]

CASES: List[Case] = PAPER + FANS + GROWTHS + PRIMITIVES

"""Random solids: primitives, booleans, fillets, chamfers, lofts, sweeps, threads.

Each maker takes a Random and gives a shape, or raises where the kernel could not make it.
"""
from __future__ import annotations

import math
from random import Random
from typing import Callable, Dict, List

import outlines
from freecad_part import FreeCAD, Part
from surfaces import flat_face

V = FreeCAD.Vector
KERNEL_FAULTS = (Part.OCCError, ValueError, RuntimeError)


def _direction(rng: Random) -> "FreeCAD.Vector":
    while True:
        vector = V(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1))
        if 0.2 < vector.Length < 1.0:
            return vector.normalize()


def _sector(rng: Random) -> float:
    """[deg], a full turn in half of the cases."""
    return rng.choice((360.0, rng.uniform(40.0, 330.0)))


def _box(rng: Random) -> "Part.Shape":
    return Part.makeBox(*(rng.uniform(3.0, 12.0) for _ in range(3)))


def _cylinder(rng: Random) -> "Part.Shape":
    return Part.makeCylinder(rng.uniform(1.5, 5.0), rng.uniform(2.0, 15.0), V(), V(0, 0, 1),
                             _sector(rng))


def _cone(rng: Random) -> "Part.Shape":
    return Part.makeCone(rng.uniform(2.0, 6.0), rng.choice((0.0, rng.uniform(0.5, 1.9))),
                         rng.uniform(3.0, 12.0), V(), V(0, 0, 1), _sector(rng))


def _sphere(rng: Random) -> "Part.Shape":
    low, high = rng.choice(((-90.0, 90.0), (rng.uniform(-80.0, -10.0), rng.uniform(10.0, 80.0))))
    return Part.makeSphere(rng.uniform(2.0, 6.0), V(), V(0, 0, 1), low, high, _sector(rng))


def _torus(rng: Random) -> "Part.Shape":
    radius = rng.uniform(4.0, 8.0)
    return Part.makeTorus(radius, rng.uniform(0.2, 0.7) * radius, V(), V(0, 0, 1), 0.0, 360.0,
                          _sector(rng))


def _wedge(rng: Random) -> "Part.Shape":
    x, y, z = (rng.uniform(4.0, 10.0) for _ in range(3))
    return Part.makeWedge(0, 0, 0, rng.uniform(0.1, 0.4) * z, rng.uniform(0.1, 0.4) * x, x, y, z,
                          rng.uniform(0.5, 0.9) * z, rng.uniform(0.5, 0.9) * x)


PRIMITIVES = (_box, _cylinder, _cone, _sphere, _torus, _wedge)


def primitive(rng: Random) -> "Part.Shape":
    return rng.choice(PRIMITIVES)(rng)


def boolean(rng: Random) -> "Part.Shape":
    shape = primitive(rng)
    for _ in range(rng.randint(1, 3)):
        other = primitive(rng)
        other.rotate(V(), _direction(rng), rng.uniform(0.0, 180.0))
        box = shape.BoundBox
        other.translate(V(*(rng.uniform(low, high) for low, high in (
            (box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax)))))
        shape = rng.choice((shape.cut, shape.fuse, shape.cut, shape.common))(other)
    return shape.removeSplitter() if rng.random() < 0.5 else shape


def drilled(rng: Random) -> "Part.Shape":
    """A plate with holes at random, which may break through one another and the rim."""
    x, y, z = rng.uniform(8.0, 20.0), rng.uniform(8.0, 20.0), rng.uniform(1.0, 5.0)
    shape = Part.makeBox(x, y, z)
    for _ in range(rng.randint(1, 8)):
        shape = shape.cut(Part.makeCylinder(rng.uniform(0.4, 2.5), 3.0 * z, V(
            rng.uniform(0.0, x), rng.uniform(0.0, y), -z)))
    return shape


def _prism(rng: Random) -> "Part.Shape":
    outline = outlines.scaled(outlines.polygon(rng), rng.uniform(4.0, 8.0))
    return flat_face(outline, 0.0).extrude(V(0, 0, rng.uniform(1.0, 8.0)))


def _some_edges(rng: Random, shape: "Part.Shape") -> List["Part.Edge"]:
    return [edge for edge in shape.Edges if rng.random() < 0.5] or shape.Edges[:1]


def rounded(rng: Random) -> "Part.Shape":
    shape = rng.choice((_box, _cylinder, _wedge, _prism, drilled))(rng)
    radius = rng.uniform(0.05, 0.3) * min(edge.Length for edge in shape.Edges)
    return shape.makeFillet(radius, _some_edges(rng, shape))


def chamfered(rng: Random) -> "Part.Shape":
    shape = rng.choice((_box, _cylinder, _wedge, _prism))(rng)
    width = rng.uniform(0.05, 0.3) * min(edge.Length for edge in shape.Edges)
    return shape.makeChamfer(width, _some_edges(rng, shape))


def _section(rng: Random, height: float, corners: int) -> "Part.Wire":
    """A circle (corners = 0) or a polygon, about the z axis."""
    radius = rng.uniform(1.5, 5.0)
    if not corners:
        return Part.Wire(Part.makeCircle(radius, V(rng.uniform(-1, 1), rng.uniform(-1, 1), height)))
    twist = rng.uniform(-0.3, 0.3)
    points = [V(radius * math.cos(twist + 2.0 * math.pi * i / corners),
                radius * math.sin(twist + 2.0 * math.pi * i / corners), height)
              for i in range(corners)]
    return Part.makePolygon(points + points[:1])


def loft(rng: Random) -> "Part.Shape":
    corners, height, wires = rng.choice((0, 0, 3, 4, 6)), 0.0, []
    for _ in range(rng.randint(2, 4)):
        wires.append(_section(rng, height, corners))
        height += rng.uniform(2.0, 6.0)
    return Part.makeLoft(wires, True, rng.random() < 0.5)


def _is_wrung(curve: "Part.BSplineCurve") -> bool:
    """Whether the plane in which the curve bends turns by 30 degrees in a thousandth of its length:
    the kernel's pipes are torn there, and its own integrals and triangles of them fail."""
    first, last = curve.FirstParameter, curve.LastParameter
    turned = None
    for i in range(1, 1000):
        t = first + (last - first) * i / 1000.0
        across = curve.getDN(t, 1).cross(curve.getDN(t, 2))
        if across.Length < 1e-12:
            continue
        if turned is not None and across.getAngle(turned) > math.radians(30.0):
            return True
        turned = across
    return False


def sweep(rng: Random) -> "Part.Shape":
    """A pipe along a spline; the section is a circle or a polygon."""
    curve = Part.BSplineCurve()
    points = [V(0, 0, 0), V(0, 0, 4)]
    for _ in range(rng.randint(1, 3)):
        points.append(points[-1] + V(rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(3, 6)))
    curve.interpolate(points)
    section = _section(rng, 0.0, rng.choice((0, 3, 4, 5)))
    section.scale(rng.uniform(0.15, 0.3))
    bends = [curve.curvature(curve.FirstParameter + (curve.LastParameter - curve.FirstParameter)
                             * i / 64.0) for i in range(65)]
    if max(bends) * section.BoundBox.DiagonalLength / 2.0 > 0.7:
        raise ValueError("the pipe would run into itself")
    if _is_wrung(curve):
        raise ValueError("the pipe would be wrung off")
    return Part.Wire(curve.toShape()).makePipeShell([section], True, rng.random() < 0.5)


def thread(rng: Random) -> "Part.Shape":
    """A ridge wound about a rod, joined with it or cut from it, or alone."""
    radius, pitch = rng.uniform(2.0, 5.0), rng.uniform(0.8, 2.0)
    turns, depth = rng.randint(1, 4), rng.uniform(0.3, 0.6) * pitch
    path = Part.makeHelix(pitch, turns * pitch, radius)
    ridge_corners = [V(radius - 0.2 * depth, 0, -0.4 * pitch), V(radius + depth, 0, -0.08 * pitch),
                     V(radius + depth, 0, 0.08 * pitch), V(radius - 0.2 * depth, 0, 0.4 * pitch)]
    section = Part.makePolygon(ridge_corners + ridge_corners[:1])
    ridge = Part.Wire(path).makePipeShell([section], True, True)
    way = rng.choice(("alone", "joined", "cut"))
    if way == "alone":
        return ridge
    length = (turns + 2.0) * pitch
    if way == "joined":
        return Part.makeCylinder(radius, length, V(0, 0, -pitch)).fuse(ridge)
    return Part.makeCylinder(radius + 0.6 * depth, length, V(0, 0, -pitch)).cut(ridge)


def revolved(rng: Random) -> "Part.Shape":
    outline = outlines.scaled(outlines.polygon(rng), rng.uniform(2.0, 4.0))
    face = flat_face(outline, 0.0).translated(V(rng.uniform(4.2, 8.0), 0, 0))
    return face.revolve(V(), V(0, 1, 0), _sector(rng))


def extruded(rng: Random) -> "Part.Shape":
    kind = rng.choice((outlines.polygon, outlines.star, outlines.ring,
                       lambda source: outlines.holed_plate(source, 1.0, 0.05, 1.0)))
    outline = kind(rng)
    factor = rng.uniform(4.0, 10.0) / outlines.extent(outline)
    lean = V(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(1.0, 6.0))
    return flat_face(outlines.scaled(outline, factor), 0.0).extrude(lean)


def hollow(rng: Random) -> "Part.Shape":
    shape = rng.choice((_box, _cylinder, _wedge))(rng)
    opened = [shape.Faces[rng.randrange(len(shape.Faces))]]
    wall = rng.uniform(0.04, 0.12) * shape.BoundBox.DiagonalLength
    return shape.makeThickness(opened, -min(wall, 0.6), 1e-4)


MAKERS: Dict[str, Callable[[Random], "Part.Shape"]] = {
    "primitive": primitive, "boolean": boolean, "drilled": drilled, "rounded": rounded,
    "chamfered": chamfered, "loft": loft, "sweep": sweep, "thread": thread, "revolved": revolved,
    "extruded": extruded, "hollow": hollow}


def make(kind: str, rng: Random) -> "Part.Shape":
    """Tries until the kernel calls the shape valid and it encloses something."""
    while True:
        try:
            shape = MAKERS[kind](rng)
        except KERNEL_FAULTS:
            continue
        if shape.Solids and shape.isValid() and shape.Volume > 1e-3:
            return shape

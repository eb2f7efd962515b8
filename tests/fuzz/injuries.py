"""Ways in which CAD files come short of what a kernel would make: each takes a Random, and gives
BREP text of a shape with that injury, all within the tolerances that it states.
"""
from __future__ import annotations

import math
from random import Random
from typing import Callable, Dict, List, Optional, Tuple

import solid_shapes
from brep_records import BrepText, Record
from freecad_part import FreeCAD, Part

V = FreeCAD.Vector


def _solid(rng: Random) -> "Part.Shape":
    """Planes and cylinders with holes, of an extent about 10."""
    return solid_shapes.make(rng.choice(("primitive", "boolean", "drilled", "extruded")), rng)


def _gap(rng: Random) -> float:
    """[mm] from 1e-8 to 1e-3."""
    return 10.0 ** rng.uniform(-8.0, -3.0)


def _taken_apart(rng: Random) -> BrepText:
    return BrepText(_solid(rng).exportBrepToString())


def moved_vertices(rng: Random) -> str:
    """Vertices beside the ends of their edges, as far as their tolerances allow."""
    brep = _taken_apart(rng)
    for vertex in brep.of_kind("Ve"):
        gap = _gap(rng)
        vertex.move([gap * rng.uniform(-0.5, 0.5) for _ in range(3)])
        vertex.set_tolerance(gap)
    return brep.text()


def _shift_ranges(edge: Record, shares: List[float]) -> None:
    """Curves end before, or go on beyond, the ends of the edge."""
    for i in edge.curve_ranges():
        words = edge.lines[i].split()
        first, last = float(words[-2]), float(words[-1])
        words[-2:] = [repr(first + shares[0] * (last - first)),
                      repr(last + shares[1] * (last - first))]
        edge.lines[i] = " ".join(words)


def gaps_between_edges(rng: Random) -> str:
    """Edges that end short of the vertices, or run past them."""
    brep = _taken_apart(rng)
    for edge in brep.of_kind("Ed"):
        if edge.lines[0].split()[-1] == "1" or len(edge.parts) != 2:
            continue  # a pole
        if edge.parts[0][1] is edge.parts[1][1]:
            continue  # closed: its curve must stay so
        gap = _gap(rng)
        _shift_ranges(edge, [0.01 * gap * rng.uniform(-1, 1) for _ in range(2)])
        for _, vertex, _ in edge.parts:
            vertex.set_tolerance(gap)
    return brep.text()


def loose_edges(rng: Random) -> str:
    """Curves in (u, v) that leave the curve in space by less than the edge's tolerance."""
    brep = _taken_apart(rng)
    for edge in brep.of_kind("Ed"):
        gap = _gap(rng)
        edge.set_tolerance(gap)
        edge.set_flags(same_parameter=False, same_range=False)
        for _, vertex, _ in edge.parts:
            vertex.set_tolerance(gap)
        for i in edge.curve_ranges():
            if edge.lines[i].split()[0] == "2" and len(edge.lines[i].split()) == 6:
                words = edge.lines[i].split()
                span = float(words[-1]) - float(words[-2])
                if len(edge.parts) == 2 and edge.parts[0][1] is not edge.parts[1][1]:
                    words[-2] = repr(float(words[-2]) + 0.02 * gap * span * rng.uniform(-1, 1))
                    edge.lines[i] = " ".join(words)
    return brep.text()


def reversed_faces(rng: Random) -> str:
    """Some faces that look inwards."""
    brep = _taken_apart(rng)
    for shell in brep.of_kind("Sh"):
        shell.parts = [({"+": "-", "-": "+"}.get(sign, sign) if rng.random() < 0.3 else sign,
                        face, location) for sign, face, location in shell.parts]
    return brep.text()


def false_poles(rng: Random) -> str:
    """Edges marked as degenerate where the surface is regular: they close gaps in wires."""
    brep = BrepText(Part.makeBox(*(rng.uniform(3.0, 9.0) for _ in range(3))).exportBrepToString())
    lines = brep.curves_in_uv()
    for face in brep.of_kind("Fa"):
        if rng.random() < 0.3:
            continue
        wire = face.parts[0][1]
        surface = face.lines[0].split()[2]
        edge = rng.choice(wire.parts)[1]
        vertex = edge.parts[0][1]
        uv = _uv_at_start(edge, surface, lines)
        if uv is None:
            continue
        gap = _gap(rng)
        vertex.set_tolerance(2.0 * gap)
        curve = brep.add_curve_in_uv(f"1 {uv[0]!r} {uv[1]!r} 1 0 ")
        pole = Record("Ed", [" 1e-07 1 1 1", f"2  {curve} {surface} 0 0 {gap!r}",
                             "0", "", "0101000"], [("+", vertex, "0"), ("-", vertex, "0")])
        brep.add_before(wire, pole)
        wire.parts.insert(rng.randrange(len(wire.parts) + 1), ("+", pole, "0"))
    return brep.text()


def _uv_at_start(edge: Record, surface: str, lines: List[str]) -> Optional[Tuple[float, float]]:
    """Where a straight edge begins in a plane."""
    for i in edge.curve_ranges():
        words = edge.lines[i].split()
        if words[0] == "2" and words[2] == surface:
            x, y, dx, dy = (float(word) for word in lines[int(words[1]) - 1].split()[1:5])
            t = float(words[-2])
            return x + t * dx, y + t * dy
    return None


def slivers(rng: Random) -> str:
    """Two boxes side by side, of which one stands out by next to nothing."""
    x, y, z = (rng.uniform(3.0, 9.0) for _ in range(3))
    step = 10.0 ** rng.uniform(-6.0, -2.0)
    other = Part.makeBox(rng.uniform(2.0, 6.0), y, z + step, V(x, 0, 0))
    return Part.makeBox(x, y, z).fuse(other).exportBrepToString()


def split_edges(rng: Random) -> str:
    """Edges in pieces, some of them shorter than a thousandth of the others."""
    shape = _solid(rng)
    points = []
    for edge in shape.Edges:
        if edge.Degenerated or rng.random() < 0.5:
            continue
        first, last = edge.ParameterRange
        t = first + (last - first) * rng.uniform(0.2, 0.8)
        points.append(edge.valueAt(t))
        points.append(edge.valueAt(t + (last - first) * 10.0 ** rng.uniform(-5.0, -1.0)))
    pieces, _ = shape.generalFuse([Part.Vertex(point) for point in points[:12]])
    return pieces.Solids[0].exportBrepToString()


def turned_seams(rng: Random) -> str:
    """Holes through, beside and along the seam of a cylinder."""
    radius, height = rng.uniform(2.0, 5.0), rng.uniform(6.0, 12.0)
    body = Part.makeCylinder(radius, height)
    angle = rng.choice((0.0, rng.uniform(-0.5, 0.5), 1e-6, -1e-4))
    body.rotate(V(), V(0, 0, 1), math.degrees(angle))
    for _ in range(rng.randint(1, 3)):
        drill = Part.makeCylinder(rng.uniform(0.2, 0.5) * radius, 3.0 * radius,
                                  V(0, 0, rng.uniform(0.3, 0.7) * height),
                                  V(1, rng.choice((0.0, rng.uniform(-0.3, 0.3))), 0))
        drill.rotate(drill.CenterOfMass, V(1, 0, 0), rng.choice((0.0, rng.uniform(0.0, 360.0))))
        body = body.cut(drill)
    return body.Solids[0].exportBrepToString()


def _wavy(rng: Random) -> "Part.BSplineSurface":
    """A saddle over about 10 by 10."""
    side = 10.0
    points = [[V(side * i / 4.0, side * j / 4.0, rng.uniform(-1.0, 1.0)) for j in range(5)]
              for i in range(5)]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return surface


def short_spans(rng: Random) -> str:
    """Knots that lie 1e-9 apart."""
    surface = _wavy(rng)
    for _ in range(rng.randint(1, 3)):
        at, apart = rng.uniform(0.2, 0.8), 10.0 ** rng.uniform(-9.0, -6.0)
        for knot in (at, at + apart):
            surface.insertUKnot(knot, rng.randint(1, 2), 1e-12)
            surface.insertVKnot(min(0.95, knot + 0.01), 1, 1e-12)
    return surface.toShape().exportBrepToString()


def zero_speed(rng: Random) -> str:
    """Surfaces whose speed falls to zero at one side, though they have an edge there."""
    surface = _wavy(rng)
    rows, columns = surface.NbUPoles, surface.NbVPoles
    for _ in range(rng.randint(1, 2)):
        if rng.random() < 0.5:
            at, beside = rng.choice(((1, 2), (rows, rows - 1)))
            for j in range(1, columns + 1):
                surface.setPole(beside, j, surface.getPole(at, j))
        else:
            at, beside = rng.choice(((1, 2), (columns, columns - 1)))
            for i in range(1, rows + 1):
                surface.setPole(i, beside, surface.getPole(i, at))
    return surface.toShape().exportBrepToString()


def vanishing_strips(rng: Random) -> str:
    """A flat face between two curves that leave a corner together."""
    length, radius = rng.uniform(5.0, 10.0), rng.uniform(3.0, 40.0)
    near = 10.0 ** rng.uniform(-7.0, -3.0)

    def curve(bend: float, noise: float) -> "Part.Edge":
        points = [V(length * t, bend * (length * t) ** 2 + (noise if 0 < t < 1 else 0.0), 0)
                  for t in (k / 8.0 for k in range(9))]
        made = Part.BSplineCurve()
        made.interpolate(points)
        return made.toShape()

    low, high = curve(0.0, 0.0), curve(0.5 / radius, near * rng.uniform(-1.0, 1.0))
    end = Part.makeLine(low.Vertexes[-1].Point, high.Vertexes[-1].Point)
    face = Part.makeFace(Part.Wire([low, end, high]), "Part::FaceMakerSimple")
    brep = BrepText(face.exportBrepToString())
    for record in brep.of_kind("Ed") + brep.of_kind("Ve"):
        record.set_tolerance(near)
    return brep.text()


MAKERS: Dict[str, Callable[[Random], str]] = {
    maker.__name__: maker for maker in (
        moved_vertices, gaps_between_edges, loose_edges, reversed_faces, false_poles, slivers,
        split_edges, turned_seams, short_spans, zero_speed, vanishing_strips)}

"""Outlines laid upon a plane, a cylinder, a sphere and a B-spline saddle, as exact faces.

All four are graphs over the plane z = 0, so an outline is cut out by the prism above it.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import List

import numpy as np

from freecad_part import FreeCAD, Part
from outlines import Circle, Loop

V = FreeCAD.Vector
NAMES = ("plane", "cylinder", "sphere", "saddle")


@dataclass
class Surface:
    """z = 0; x^2 + z^2 = radius^2; x^2 + y^2 + z^2 = radius^2; z = (x^2 - y^2) / (2 radius)."""
    name: str
    radius: float  # [mm], of curvature

    def normals(self, points: np.ndarray) -> np.ndarray:
        """Unit normals that look up, (n, 3)."""
        normals = np.zeros_like(points)
        if self.name == "plane":
            normals[:, 2] = 1.0
        elif self.name == "saddle":
            normals[:, 0] = -points[:, 0] / self.radius
            normals[:, 1] = points[:, 1] / self.radius
            normals[:, 2] = 1.0
        else:
            normals[:] = points
            if self.name == "cylinder":
                normals[:, 1] = 0.0
        return normals / np.linalg.norm(normals, axis=1)[:, None]

    def distances(self, points: np.ndarray) -> np.ndarray:
        """How far points are off the surface [mm]; for the saddle, to first order."""
        x, y, z = points.T
        if self.name == "plane":
            return np.abs(z)
        if self.name == "cylinder":
            return np.abs(np.hypot(x, z) - self.radius)
        if self.name == "sphere":
            return np.abs(np.linalg.norm(points, axis=1) - self.radius)
        return np.abs(z - (x * x - y * y) / (2.0 * self.radius)) * self.normals(points)[:, 2]

    def sheet(self, reach: float) -> "Part.Shape":
        """The untrimmed face over the square of half-width `reach` and beyond."""
        if self.name == "cylinder":  # its seam is below, and so is the sphere's
            return Part.makeCylinder(self.radius, 4.0 * reach, V(0, -2.0 * reach, 0),
                                     V(0, 1, 0)).Faces[0].rotated(V(0, 0, 0), V(0, 1, 0), 90.0)
        if self.name == "sphere":
            return Part.makeSphere(self.radius, V(0, 0, 0), V(0, 1, 0)).Faces[0].rotated(
                V(0, 0, 0), V(0, 1, 0), 90.0)
        surface = Part.BezierSurface()
        surface.increase(2, 2)
        square = (1.0, -1.0, 1.0)  # poles of t^2 over [-1, 1]
        for i in range(3):
            for j in range(3):
                surface.setPole(i + 1, j + 1, V(
                    reach * (i - 1), reach * (j - 1),
                    reach * reach / (2.0 * self.radius) * (square[i] - square[j])))
        return surface.toBSpline().toShape()


def flat_face(outline: List[Loop], height: float) -> "Part.Face":
    wires = []
    for loop in outline:
        if isinstance(loop, Circle):
            wires.append(Part.Wire(Part.makeCircle(loop.radius, V(loop.x, loop.y, height))))
        else:
            wires.append(Part.makePolygon([V(x, y, height) for x, y in loop + loop[:1]]))
    face = Part.makeFace(wires, "Part::FaceMakerBullseye")
    return face.Faces[0]


def face_on(surface: Surface, outline: List[Loop], reach: float) -> "Part.Face":
    """The part of the surface above the outline. Raises ValueError where it is not one face."""
    if surface.name == "plane":
        return flat_face(outline, 0.0)
    floor = -2.0 * reach if surface.name == "saddle" else 0.0
    prism = flat_face(outline, floor).extrude(V(0, 0, 4.0 * reach + surface.radius))
    faces = surface.sheet(1.5 * reach).common(prism).Faces
    if len(faces) != 1:
        raise ValueError(f"{len(faces)} faces instead of one")
    return faces[0]


def tube(surface: Surface, rng) -> "Part.Face":
    """An annulus that closes upon itself: a cylinder's side or a zone of a sphere."""
    if surface.name == "cylinder":
        height = surface.radius * rng.uniform(0.5, 2.5)
        return Part.makeCylinder(surface.radius, height, V(0, 0, 0), V(0, 1, 0)).Faces[0]
    low, high = rng.uniform(-70.0, -5.0), rng.uniform(5.0, 70.0)
    solid = Part.makeSphere(surface.radius, V(0, 0, 0), V(0, 1, 0), low, high, 360.0)
    return next(face for face in solid.Faces if len(face.Edges) == 3)  # two rims and the seam

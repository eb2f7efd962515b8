"""Random faces with job settings: shapes of five kinds on four surfaces, by number and seed."""
from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random
from typing import Any, Dict

import outlines
import surfaces
from freecad_part import Part

KINDS = ("polygon", "star", "holes", "channel", "annulus")
GROWTHS = (1.04, 1.08, 1.1, 1.2, 1.3)
UNITS = (1.0, 10.0, 250.0)  # [mm] radius of the outline


@dataclass
class FaceCase:
    number: int
    kind: str
    surface: surfaces.Surface
    shape: "Part.Face"
    job: Dict[str, Any]  # size, first_height, growth

    @property
    def name(self) -> str:
        return f"{self.kind} on {self.surface.name}"

    @property
    def growth(self) -> float:
        return self.job["growth"]


def _outline(kind: str, rng: Random, aspect: float):
    """An outline of unit extent and, where the kind asks for one, its first height."""
    if kind == "polygon":
        return outlines.polygon(rng), None
    if kind == "star":
        return outlines.star(rng), None
    if kind == "annulus":
        return outlines.ring(rng), None
    if kind == "channel":
        height = 1.0 / rng.uniform(2.2, 14.0)
        outline = outlines.channel(rng, 1.0, aspect * height)
    else:
        height = rng.uniform(0.03, 0.1)  # of a hole's radius
        outline = outlines.holed_plate(rng, 1.0, 0.4 * height, rng.uniform(2.0, 12.0) * height)
    extent = outlines.extent(outline)
    return outlines.scaled(outline, 1.0 / extent), height / extent


def make(seed: int, number: int) -> FaceCase:
    """Every kind on every surface at every growth within a hundred numbers."""
    rng = Random(f"{seed} face {number}")
    kind = KINDS[number % len(KINDS)]
    name = surfaces.NAMES[number // len(KINDS) % len(surfaces.NAMES)]
    growth = GROWTHS[number // (len(KINDS) * len(surfaces.NAMES)) % len(GROWTHS)]
    unit = rng.choice(UNITS)
    surface = surfaces.Surface(name, unit * rng.uniform(1.6, 4.0))
    aspect = rng.uniform(3.0, 10.0)
    if kind == "annulus" and name in ("cylinder", "sphere") and rng.random() < 0.4:
        shape, first_height = surfaces.tube(surface, rng), None
    else:
        while True:  # until the cut is one face
            outline, height = _outline(kind, rng, aspect)
            first_height = height and unit * height
            try:
                shape = surfaces.face_on(surface, outlines.scaled(outline, unit), unit)
                break
            except ValueError:
                continue
    size = math.sqrt(shape.Area / rng.uniform(250.0, 700.0))
    if first_height is None:
        first_height = size / aspect
    elif kind == "channel":
        size = first_height * aspect
    else:
        size = min(size, first_height * aspect)
    return FaceCase(number, kind, surface, shape,
                    {"size": size, "first_height": first_height, "growth": growth})

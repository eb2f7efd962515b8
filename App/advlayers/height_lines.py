"""Where the first layer and the last one asked for would end: lines beside the walls of a shape.

They are drawn in the planes that touch the faces along the edge, so they are a preview: the layers
themselves are measured along the surface, and give way to each other.
"""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Iterator, List, Mapping, Optional

import numpy as np

_MOST_SAMPLES = 33
# A sample for every so many degrees that a curve turns.
_TURN = 7.5


# Above the face, of the first height: so that the face does not hide the lines.
_LIFT = 0.05


@dataclass(frozen=True)
class WallLines:
    """Beside one edge on one face; (n, 3) points [mm]."""

    edge: str
    face: str
    foot: Any  # on the edge
    first: Any  # top of the first layer
    last: Optional[Any]  # top of the last one; None where the number of layers is open

    @property
    def first_heights(self):
        """(n,) [mm]"""
        return np.linalg.norm(self.first - self.foot, axis=1)

    @property
    def totals(self):
        """(n,) of all layers together [mm]; none where their number is open."""
        return np.zeros(0) if self.last is None else np.linalg.norm(self.last - self.foot, axis=1)


def thickness(first_height: float, growth: float, layers: int) -> float:
    """Of all layers together [mm]."""
    if growth == 1.0:
        return first_height * layers
    return first_height * (growth ** layers - 1.0) / (growth - 1.0)


def layers_until(first_height: float, growth: float, height: float) -> int:
    """Layers whose heights stay below `height`; with growth 1 there is no such number, 0."""
    if growth <= 1.0 or first_height >= height:
        return 0
    return int(math.floor(math.log(height / first_height) / math.log(growth))) + 1


def wall_lines(shape, settings: Mapping[str, Any]) -> Iterator[WallLines]:
    """The lines of every wall that checked settings ask for, with their lengths filled in; none
    for walls whose heights follow from the mesh (aspect_ratio, turning_angle)."""
    meshed = None if settings["faces"] == "all" else set(settings["faces"])
    for wall in _walls(shape, settings):
        spacing = _spacing(wall, settings)
        if spacing is None:
            continue
        for number, face in enumerate(shape.Faces, 1):
            name = f"Face{number}"
            if (meshed and name not in meshed) or (wall["faces"] and name not in wall["faces"]):
                continue
            for edge in face.Edges:
                edge_name = wall["names"].get(_key(edge))
                if edge_name and not edge.Degenerated and not edge.isSeam(face):
                    yield _lines(edge_name, name, edge, face, spacing)


@dataclass(frozen=True)
class _Spacing:
    start: float  # first height at the first vertex of an edge [mm]
    end: float  # and at its last one
    thickness: Optional[float]  # over first height; None where the number of layers is open


def _spacing(wall: Mapping[str, Any], settings: Mapping[str, Any]) -> Optional[_Spacing]:
    if wall.get("aspect_ratio") or wall.get("turning_angle"):
        return None
    growth = wall.get("growth") or settings["growth"]
    layers = wall["layers"] if wall.get("layers") is not None else settings["layers"]
    total = wall.get("thickness")
    height = wall.get("first_height")
    if height is None:
        height = settings["first_height"]
        if total and isinstance(layers, int) and layers > 0:
            height = total / thickness(1.0, growth, layers)
    if layers == "isotropic":
        layers = layers_until(height, growth, settings["size"])
    ratio = total / height if total else (thickness(1.0, growth, layers) if layers else None)
    return _Spacing(height, wall.get("end_height") or height, ratio)


def _walls(shape, settings: Mapping[str, Any]) -> List[Mapping[str, Any]]:
    names = {_key(edge): f"Edge{number}" for number, edge in enumerate(shape.Edges, 1)}
    if settings["walls"] == "all":
        without = {*settings["match"], *settings["off"], *settings["smooth"]}
        return [{"faces": (),
                 "names": {key: name for key, name in names.items() if name not in without}}]
    return [{**wall, "names": {key: name for key, name in names.items() if name in wall["edges"]}}
            for wall in settings["walls"]]


def _key(edge) -> int:
    # Faces hold an edge in either direction.
    return edge.hashCode()


def _lines(edge_name: str, face_name: str, edge, face, spacing: _Spacing) -> WallLines:
    feet, inward, heights = [], [], []
    side = 1.0 if edge.Orientation == "Forward" else -1.0
    first, last = edge.ParameterRange
    for parameter in _samples(edge):
        foot, tangent = edge.valueAt(parameter), edge.tangentAt(parameter)
        normal = face.normalAt(*face.Surface.parameter(foot))
        direction = normal.cross(tangent)
        if direction.Length > 0.0:
            share = (parameter - first) / (last - first)
            heights.append(spacing.start + share * (spacing.end - spacing.start))
            feet.append(tuple(foot + normal * (_LIFT * heights[-1])))
            inward.append(tuple(direction.normalize() * side))
    feet, inward = np.array(feet).reshape(-1, 3), np.array(inward).reshape(-1, 3)
    rise = np.array(heights)[:, None] * inward
    return WallLines(edge_name, face_name, feet, feet + rise,
                     None if spacing.thickness is None else feet + spacing.thickness * rise)


def _samples(edge):
    first, last = edge.ParameterRange
    tangents = [edge.tangentAt(first + share * (last - first)) for share in (0, 0.25, 0.5, 0.75, 1)]
    turn = sum(math.degrees(a.getAngle(b)) for a, b in zip(tangents, tangents[1:]))
    return np.linspace(first, last, min(_MOST_SAMPLES, 2 + int(turn / _TURN)))

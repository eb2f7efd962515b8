"""Where the first layer and the last one asked for would end: lines beside the walls of a shape.

They are drawn in the planes that touch the faces along the edge, so they are a preview: the layers
themselves are measured along the surface, and give way to each other.
"""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import (
    Any, Callable, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Set, Tuple)

import numpy as np

from advlayers.core_access import load_core
from advlayers.settings_table import WALL_SETTINGS, value_settings

# What a wall takes from the settings of the whole mesh.
_COMMON = ("size", "first_height", "growth", "layers")
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


def wall_lines(shape, settings: Mapping[str, Any]) -> Iterator[WallLines]:
    """The lines of every wall that checked settings ask for, with their lengths filled in; none
    for walls whose heights follow from the mesh (aspect_ratio, turning_angle).

    Raises the core's InvalidInput for a wall that contradicts itself."""
    for lines in face_by_face(shape, settings):
        yield from lines


def face_by_face(shape, settings: Mapping[str, Any],
                 without: Sequence[str] = ()) -> Iterator[List[WallLines]]:
    """The same in steps: those of one face in each; none of the edges named."""
    walls = _walls_of_edges(shape, settings, set(without))
    meshed = None if settings["faces"] == "all" else set(settings["faces"])
    for number, face in enumerate(shape.Faces, 1):
        name = f"Face{number}"
        if meshed and name not in meshed:
            continue
        yield [_lines(edge_name, name, edge, face, spacing)
               for edge in face.Edges
               for edge_name, faces, spacing in walls.get(_key(edge), ())
               if (not faces or name in faces) and not edge.Degenerated and not edge.isSeam(face)]


def _walls_of_edges(shape, settings: Mapping[str, Any],
                    without: Set[str]) -> Dict[int, List[Any]]:
    """By the edge: its name, the faces that the wall is on alone, and its spacing, for each of its
    walls with a known height."""
    core = load_core()
    common = core.Settings(**{key: settings[key] for key in _COMMON})
    keys = {f"Edge{number}": _key(edge) for number, edge in enumerate(shape.Edges, 1)
            if f"Edge{number}" not in without}
    found: Dict[int, List[Any]] = {}
    for wall in _walls(keys, settings):
        spacing = core.resolve_wall(common, {
            entry.key: wall[entry.key] for entry in value_settings(WALL_SETTINGS)
            if wall.get(entry.key) is not None})
        if spacing["first_height"] is not None:
            for name in wall["edges"]:
                if name in keys:
                    found.setdefault(keys[name], []).append((name, wall["faces"], spacing))
    return found


def _walls(names: Iterable[str], settings: Mapping[str, Any]) -> List[Mapping[str, Any]]:
    listed = [] if settings["walls"] == "all" else list(settings["walls"])
    if settings["walls"] != "all" and settings.get("others") != "wall":
        return listed
    without = {*settings["match"], *settings["off"], *settings["smooth"],
               *(name for wall in listed for name in wall["edges"])}
    return [*listed, {"faces": (), "edges": [name for name in names if name not in without]}]


def _key(edge) -> int:
    # Faces hold an edge in either direction.
    return edge.hashCode()


def _lines(edge_name: str, face_name: str, edge, face, spacing: Mapping[str, Any]) -> WallLines:
    feet, inward, heights = [], [], []
    side = 1.0 if edge.Orientation == "Forward" else -1.0
    first, last = edge.ParameterRange
    start = spacing["first_height"]
    end = start if spacing["end_height"] is None else spacing["end_height"]
    place_of = _places_in(face, edge)
    for parameter in _samples(edge):
        foot, tangent = edge.valueAt(parameter), edge.tangentAt(parameter)
        normal = face.normalAt(*place_of(parameter))
        direction = normal.cross(tangent)
        if direction.Length > 0.0:
            share = (parameter - first) / (last - first)
            heights.append(start + share * (end - start))
            feet.append(tuple(foot + normal * (_LIFT * heights[-1])))
            inward.append(tuple(direction.normalize() * side))
    feet, inward = np.array(feet).reshape(-1, 3), np.array(inward).reshape(-1, 3)
    rise = np.array(heights)[:, None] * inward
    total = spacing["thickness"]
    return WallLines(edge_name, face_name, feet, feet + rise,
                     None if total is None else feet + total / start * rise)


def _places_in(face, edge) -> Callable[[float], Tuple[float, float]]:
    """The face's (u, v) by the edge's parameter: from its curve in the face, which costs nothing
    beside a projection onto the surface; from that where there is none."""
    found = face.curveOnSurface(edge)
    if found is None:
        return lambda parameter: face.Surface.parameter(edge.valueAt(parameter))

    def place_of(parameter: float) -> Tuple[float, float]:
        place = found[0].value(parameter)
        return place.x, place.y

    return place_of


def _samples(edge):
    first, last = edge.ParameterRange
    tangents = [edge.tangentAt(first + share * (last - first)) for share in (0, 0.25, 0.5, 0.75, 1)]
    turn = sum(math.degrees(a.getAngle(b)) for a, b in zip(tangents, tangents[1:]))
    return np.linspace(first, last, min(_MOST_SAMPLES, 2 + int(turn / _TURN)))

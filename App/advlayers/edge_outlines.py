"""The edges of a shape as lines to draw, and how sharply their faces meet; found in steps."""
from __future__ import annotations

import math
from typing import Any, Dict, Iterator, List, Mapping, Optional, Tuple

import numpy as np

from advlayers.face_edges import FaceEdges

WALL, MATCH, OFF = "wall", "match", "off"
_MOST_POINTS = 49  # of one edge
_TURN = 7.5  # [deg] between two of them
_NO_BEND = -1.0  # of a seam, which no patch ends at
_SHARES = (0.1, 0.5, 0.9)  # of an edge, where its faces' normals are compared


class EdgeOutlines:
    def __init__(self, shape) -> None:
        self._shape = shape
        self.lines: Dict[str, Any] = {}  # (n, 3) [mm] by the edge's name
        self._bends: Dict[str, float] = {}  # [deg] of edges between two faces
        self._ends: Dict[str, Tuple[int, ...]] = {}  # hashes of the vertices

    def steps(self) -> Iterator[None]:
        """Finds all of it, one edge in each step."""
        sides = self._sides()
        for number, edge in enumerate(self._shape.Edges, 1):
            if not edge.Degenerated:
                name = f"Edge{number}"
                self.lines[name] = _points(edge)
                self._ends[name] = tuple(vertex.hashCode() for vertex in edge.Vertexes)
                pair = sides.get(edge.hashCode(), ())
                if len(pair) == 2:
                    self._bends[name] = _bend(*pair)
                elif pair and pair[0][1].isSeam(pair[0][0]):
                    self._bends[name] = _NO_BEND
            yield

    def conditions(self, settings: Mapping[str, Any]) -> Dict[str, str]:
        """What checked settings make of each boundary edge of a patch."""
        given = {name: kind for kind in (MATCH, OFF) for name in settings[kind]}
        if settings["walls"] == "all":
            return {name: given.get(name, WALL) for name in self._boundary(settings)}
        walls = {name for wall in settings["walls"] for name in wall["edges"]}
        touched = {end for name in walls for end in self._ends.get(name, ())}
        found = {}
        for name in self._boundary(settings):
            other = settings.get("others", MATCH)
            if other == MATCH and not touched.intersection(self._ends[name]):
                other = OFF
            found[name] = WALL if name in walls else given.get(name, other)
        return found

    def smooth(self, settings: Mapping[str, Any]) -> List[str]:
        """Edges that a patch goes over."""
        boundary, listed = set(settings["boundary"]), set(settings["smooth"])
        return [name for name in self.lines if name not in boundary and (
            name in listed or self._bends.get(name, math.inf) < settings["feature_angle"])]

    def of(self, names: List[str]) -> List[Any]:
        """The lines of edges, and those around faces."""
        return [self.lines[name] for name in _with_boundaries(self._shape, names)
                if name in self.lines]

    def _boundary(self, settings: Mapping[str, Any]) -> List[str]:
        smooth = set(self.smooth(settings))
        return [name for name in self.lines if name not in smooth]

    def _sides(self) -> Dict[int, List[Tuple[Any, Any]]]:
        """The faces beside each edge, with the edge as the face has it."""
        found: Dict[int, List[Tuple[Any, Any]]] = {}
        for face in self._shape.Faces:
            for edge in face.Edges:
                found.setdefault(edge.hashCode(), []).append((face, edge))
        return found


def outlines_of(shape, names: List[str]) -> List[Any]:
    """The lines of edges, and those around faces, of a few of them."""
    edges = shape.Edges
    return [_points(edges[int(name[4:]) - 1]) for name in _with_boundaries(shape, names)
            if int(name[4:]) <= len(edges) and not edges[int(name[4:]) - 1].Degenerated]


def _with_boundaries(shape, names: List[str]) -> List[str]:
    """The edges among the names, and those around the faces among them."""
    faces = [name for name in names if name.startswith("Face")]
    around = FaceEdges(shape).boundary(faces) if faces else []
    return list(dict.fromkeys([name for name in names if name.startswith("Edge")] + around))


def _points(edge):
    first, last = edge.ParameterRange
    tangents = [edge.tangentAt(first + share * (last - first)) for share in (0, 0.25, 0.5, 0.75, 1)]
    turn = sum(math.degrees(a.getAngle(b)) for a, b in zip(tangents, tangents[1:]))
    count = min(_MOST_POINTS, 2 + int(turn / _TURN))
    return np.array([tuple(edge.valueAt(parameter))
                     for parameter in np.linspace(first, last, count).tolist()])


def _bend(one: Tuple[Any, Any], other: Tuple[Any, Any]) -> float:
    """The greatest angle [deg] between the normals of two faces along their edge."""
    return max(math.degrees(_normal(*one, share).getAngle(_normal(*other, share)))
               for share in _SHARES)


def _normal(face, edge, share: float):
    found: Optional[Any] = face.curveOnSurface(edge)
    first, last = edge.ParameterRange
    parameter = first + share * (last - first)
    if found is None:
        return face.normalAt(*face.Surface.parameter(edge.valueAt(parameter)))
    place = found[0].value(parameter)
    return face.normalAt(place.x, place.y)

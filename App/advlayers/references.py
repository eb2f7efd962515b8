"""Faces, edges and vertices that a user picked, and whether their names still mean the same.

FreeCAD numbers a shape anew after every edit of the model. 0.20 keeps the name and so points
elsewhere, silently; 1.x follows the face and marks a lost one "?Face1". So what was picked is
remembered by kind, size, place and direction, and a name is trusted only while what it names now is
the likest of all. A length that changes moves faces but leaves each the likest to itself.
"""
from __future__ import annotations

import json
import math
import re
from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterable, List, Sequence, Tuple

from advlayers.errors import InputError
from advlayers.sentence import Sentence

Vector = Tuple[float, float, float]

_NAME = re.compile(r"(Face|Edge|Vertex)([1-9][0-9]*)")
# Of the box diagonal, of the measure, and of a unit direction: far above what saving changes.
_SAME = 1e-6
# Likeness: a distance of the box diagonal counts 1; a right angle and a factor e of the size:
_ANGLE_WEIGHT, _MEASURE_WEIGHT = 0.5, 0.2
# A name whose thing changed by more than this is asked about, even when nothing else is liker.
_TOO_DIFFERENT = 0.5


@dataclass(frozen=True)
class Pick:
    """A face, edge or vertex as it was: enough to know it again."""

    name: str
    kind: str  # of surface or curve
    measure: float  # area [mm²], length [mm], or 0
    centre: Vector  # [mm]
    relative: Vector  # the centre, 0..1 within the shape's box
    direction: Vector  # normal, or tangent of either sign, at the middle

    def text(self) -> str:
        numbers = [self.measure, *self.centre, *self.relative, *self.direction]
        return json.dumps([self.name, self.kind, *[float(f"{x:.12g}") for x in numbers]])

    @staticmethod
    def of_text(text: str) -> "Pick":
        name, kind, measure, *rest = json.loads(text)
        return Pick(name, kind, measure, tuple(rest[:3]), tuple(rest[3:6]), tuple(rest[6:9]))


@dataclass(frozen=True)
class Problem:
    """A reference that cannot be trusted any more."""

    owner: Any  # the document object that holds it
    name: str
    said: Sentence  # what is wrong with it
    found: str = ""  # the name that what was picked has now, where it is still there


class Picker:
    """Looks faces, edges and vertices up in one shape."""

    def __init__(self, shape) -> None:
        self._shape = shape
        self._box = shape.BoundBox
        self.diagonal = max(self._box.DiagonalLength, 1e-12)
        self._lists: Dict[str, list] = {}
        self._picks: Dict[str, List[Pick]] = {}

    def count(self, kind: str) -> int:
        return len(self._list(kind))

    def pick(self, name: str) -> Pick:
        """Raises InputError where the shape has no such face, edge or vertex."""
        match = _NAME.fullmatch(name)
        if not match:
            raise InputError("references", "holds {}, which is no face, edge or vertex", repr(name))
        kind, number = match.group(1), int(match.group(2))
        things = self._list(kind)
        if number > len(things):
            raise InputError("references", "names {}, but the shape has {} of that kind", name,
                             len(things))
        return self._measured(name, things[number - 1])

    def all_like(self, name: str) -> List[Pick]:
        """Every thing of the shape of the sort that the name is of."""
        kind = _NAME.fullmatch(name).group(1)
        if kind not in self._picks:
            self._picks[kind] = [self._measured(f"{kind}{i}", thing)
                                 for i, thing in enumerate(self._list(kind), 1)]
        return self._picks[kind]

    def distance(self, kept: Pick, now: Pick) -> float:
        """0: the same; infinite: of another kind."""
        if kept.kind != now.kind:
            return math.inf
        moved = min(math.dist(kept.centre, now.centre) / self.diagonal,
                    math.dist(kept.relative, now.relative))
        cosine = sum(a * b for a, b in zip(kept.direction, now.direction))
        if kept.name.startswith("Edge"):
            cosine = abs(cosine)
        turned = 0.0 if not any(kept.direction) else 1.0 - cosine
        grown = 0.0
        if kept.measure > 0.0 and now.measure > 0.0:
            grown = abs(math.log(now.measure / kept.measure))
        return moved + _ANGLE_WEIGHT * turned + _MEASURE_WEIGHT * grown

    def same(self, kept: Pick, now: Pick) -> bool:
        return (kept.kind == now.kind
                and math.dist(kept.centre, now.centre) <= _SAME * self.diagonal
                and abs(kept.measure - now.measure) <= _SAME * max(kept.measure, now.measure))

    def _list(self, kind: str) -> list:
        if kind not in self._lists:
            self._lists[kind] = getattr(self._shape, _LISTS[kind])
        return self._lists[kind]

    def _measured(self, name: str, thing) -> Pick:
        kind, measure, centre, direction = _MEASURES[_NAME.fullmatch(name).group(1)](thing)
        box, low = self._box, (self._box.XMin, self._box.YMin, self._box.ZMin)
        relative = tuple(
            (x - x0) / length if length > _SAME * self.diagonal else 0.5
            for x, x0, length in zip(centre, low, (box.XLength, box.YLength, box.ZLength)))
        return Pick(name, kind, measure, tuple(centre), relative, tuple(direction))


def _measure_face(face):
    u0, u1, v0, v1 = face.ParameterRange
    normal = _unless_singular(lambda: face.normalAt(0.5 * (u0 + u1), 0.5 * (v0 + v1)))
    return _type_name(lambda: face.Surface), face.Area, face.CenterOfMass, normal


def _measure_edge(edge):
    if edge.Degenerated:
        return "Degenerate", 0.0, edge.Vertexes[0].Point, (0.0, 0.0, 0.0)
    first, last = edge.ParameterRange
    tangent = _unless_singular(lambda: edge.tangentAt(0.5 * (first + last)))
    return _type_name(lambda: edge.Curve), edge.Length, edge.CenterOfMass, tangent


def _measure_vertex(vertex):
    return "Point", 0.0, vertex.Point, (0.0, 0.0, 0.0)


_LISTS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes"}
_MEASURES = {"Face": _measure_face, "Edge": _measure_edge, "Vertex": _measure_vertex}


def _type_name(get: Callable[[], Any]) -> str:
    try:
        return type(get()).__name__
    except (TypeError, NotImplementedError):  # a kind that FreeCAD has no class for
        return "Other"


def _unless_singular(get: Callable[[], Any]):
    import Part

    try:
        return get()
    except Part.OCCError:
        return 0.0, 0.0, 0.0


def remembered(kept: Sequence[str], names: Iterable[str], picker: Picker) -> List[str]:
    """The texts to keep for `names`: those there are, new ones for names that have none. Names
    that the shape does not have get none."""
    texts = {Pick.of_text(text).name: text for text in kept}
    result = []
    for name in names:
        if name not in texts:
            try:
                texts[name] = picker.pick(name).text()
            except InputError:
                continue
        result.append(texts[name])
    return result


def problems(owner, names: Iterable[str], kept: Sequence[str], picker: Picker) -> List[Problem]:
    """The names that do not stand for what was picked any more."""
    picks = {pick.name: pick for pick in map(Pick.of_text, kept)}
    found = []
    for name in names:
        problem = _problem(owner, name, picks.get(name), picker)
        if problem is not None:
            found.append(problem)
    return found


def _problem(owner, name: str, kept, picker: Picker):
    if name.startswith("?"):
        return Problem(owner, name, Sentence("{} is gone from the model", (name[1:],)))
    try:
        now = picker.pick(name)
    except InputError:
        return _lost(owner, name, kept, picker, Sentence("{} is not there any more", (name,)))
    if kept is None or picker.same(kept, now):
        return None
    likest = min(picker.all_like(name), key=lambda pick: picker.distance(kept, pick))
    own, best = picker.distance(kept, now), picker.distance(kept, likest)
    exact = next((pick for pick in picker.all_like(name) if picker.same(kept, pick)), None)
    if exact is not None:
        return _renamed(owner, name, exact)
    if own <= best and own < _TOO_DIFFERENT:
        return None
    return _lost(owner, name, kept, picker, Sentence("{} is not what was picked", (name,)))


def _lost(owner, name: str, kept, picker: Picker, said: Sentence) -> Problem:
    """Says where what was picked may be now."""
    if kept is not None and picker.all_like(name):
        likest = min(picker.all_like(name), key=lambda pick: picker.distance(kept, pick))
        if picker.same(kept, likest):
            return _renamed(owner, name, likest)
        if likest.name != name and picker.distance(kept, likest) < _TOO_DIFFERENT:
            said = Sentence("{}; {} is the likest to it", (said, likest.name))
            return Problem(owner, name, said, likest.name)
    return Problem(owner, name, said)


def _renamed(owner, name: str, now: Pick) -> Problem:
    return Problem(owner, name, Sentence("{} is called {} now", (name, now.name)), now.name)

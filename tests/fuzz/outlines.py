"""Random outlines in the plane: polygons, stars, channels, annuli, plates with holes.

An outline is a list of loops, the outer one first; a loop is a list of corners or a Circle.
"""
from __future__ import annotations

import math
from random import Random
from typing import List, NamedTuple, Optional, Tuple, Union

Point = Tuple[float, float]


class Circle(NamedTuple):
    x: float
    y: float
    radius: float


Loop = Union[List[Point], Circle]
SHARPEST, WIDEST = 20.0, 340.0  # [deg] interior angles of corners


def interior_angles(corners: List[Point]) -> List[float]:
    """[deg], of a counter-clockwise polygon."""
    angles = []
    for i, (x, y) in enumerate(corners):
        ax, ay = corners[i - 1]
        bx, by = corners[(i + 1) % len(corners)]
        back, ahead = math.atan2(ay - y, ax - x), math.atan2(by - y, bx - x)
        angles.append(math.degrees((back - ahead) % (2.0 * math.pi)))
    return angles


def _distance_to_segment(p: Point, a: Point, b: Point) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    along = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)
    along = min(1.0, max(0.0, along))
    return math.hypot(p[0] - a[0] - along * dx, p[1] - a[1] - along * dy)


def _cross(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def clearance(corners: List[Point]) -> float:
    """Least distance between edges that are no neighbours; 0 where two of them cross."""
    n, least = len(corners), math.inf
    edges = [(corners[i], corners[(i + 1) % n]) for i in range(n)]
    for i in range(n):
        for j in range(i + 2, n):
            if i == 0 and j == n - 1:
                continue
            (a, b), (c, d) = edges[i], edges[j]
            if _cross(a, b, c) * _cross(a, b, d) < 0 and _cross(c, d, a) * _cross(c, d, b) < 0:
                return 0.0
            least = min(least, _distance_to_segment(a, c, d), _distance_to_segment(b, c, d),
                        _distance_to_segment(c, a, b), _distance_to_segment(d, a, b))
    return least


def _shortest_edge(corners: List[Point]) -> float:
    return min(math.dist(corners[i - 1], corners[i]) for i in range(len(corners)))


def _into_unit_circle(corners: List[Point]) -> List[Point]:
    x = (min(p[0] for p in corners) + max(p[0] for p in corners)) / 2.0
    y = (min(p[1] for p in corners) + max(p[1] for p in corners)) / 2.0
    radius = max(math.hypot(p[0] - x, p[1] - y) for p in corners)
    return [((p[0] - x) / radius, (p[1] - y) / radius) for p in corners]


def _tooth(rng: Random, a: Point, b: Point) -> Optional[List[Point]]:
    """Three corners that make a notch or a spike on the edge a-b; None on a short edge."""
    length = math.dist(a, b)
    if length < 0.6:
        return None
    along = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
    inward = (-along[1], along[0])
    width, middle = rng.uniform(0.15, 0.35), rng.uniform(0.35, 0.65) * length
    half_angle = math.radians(rng.uniform(10.5, 45.0))
    depth = rng.choice((-1.0, 1.0)) * width / 2.0 / math.tan(half_angle)
    lean = rng.uniform(-0.1, 0.1)

    def at(s: float, t: float) -> Point:
        return (a[0] + s * along[0] + t * inward[0], a[1] + s * along[1] + t * inward[1])
    return [at(middle - width / 2, 0.0), at(middle + lean, depth), at(middle + width / 2, 0.0)]


def polygon(rng: Random) -> List[Loop]:
    """Corners from 20 to 340 degrees: a star-shaped hull with notches and spikes."""
    while True:
        count = rng.randint(3, 8)
        turns = [2.0 * math.pi * (i + rng.uniform(-0.3, 0.3)) / count for i in range(count)]
        corners = []
        for turn in turns:
            radius = rng.uniform(0.5, 1.0)
            corners.append((radius * math.cos(turn), radius * math.sin(turn)))
        for _ in range(rng.randint(0, 3)):
            i = rng.randrange(len(corners))
            tooth = _tooth(rng, corners[i], corners[(i + 1) % len(corners)])
            if tooth:
                corners[i + 1:i + 1] = tooth
        angles = interior_angles(corners)
        if SHARPEST <= min(angles) and max(angles) <= WIDEST and \
                _shortest_edge(corners) > 0.12 and clearance(corners) > 0.1:
            return [_into_unit_circle(corners)]


def star(rng: Random) -> List[Loop]:
    while True:
        points, inner = rng.randint(4, 10), rng.uniform(0.35, 0.75)
        start = rng.uniform(0.0, math.pi)
        corners = []
        for i in range(2 * points):
            radius = (1.0 if i % 2 == 0 else inner) * rng.uniform(0.95, 1.0)
            turn = start + math.pi * i / points
            corners.append((radius * math.cos(turn), radius * math.sin(turn)))
        if min(interior_angles(corners)) >= SHARPEST and _shortest_edge(corners) > 0.12:
            return [corners]


def channel(rng: Random, width: float, segment: float) -> List[Loop]:
    """A bent strip of the given width, some dozens of mesh segments long."""
    while True:
        direction = rng.uniform(0.0, 2.0 * math.pi)
        middle, turns = [(0.0, 0.0)], []
        for i in range(rng.randint(1, 4)):
            if i:
                turns.append(math.radians(rng.uniform(-100.0, 100.0)))
                direction += turns[-1]
            length = max(2.5 * width, rng.uniform(12.0, 30.0) * segment)
            middle.append((middle[-1][0] + length * math.cos(direction),
                           middle[-1][1] + length * math.sin(direction)))
        corners = _sides(middle, width)
        if clearance(corners) > 0.95 * width:
            return [corners]


def _sides(middle: List[Point], width: float) -> List[Point]:
    """Both sides of a line of points, mitred, as one counter-clockwise loop."""
    right, left = [], []
    for i, (x, y) in enumerate(middle):
        before = middle[max(i - 1, 0)]
        after = middle[min(i + 1, len(middle) - 1)]
        first = math.atan2(y - before[1], x - before[0]) if i else None
        second = math.atan2(after[1] - y, after[0] - x) if i + 1 < len(middle) else first
        first = second if first is None else first
        turn = math.remainder(second - first, 2.0 * math.pi)
        reach = width / 2.0 / math.cos(turn / 2.0)
        normal = first + turn / 2.0 + math.pi / 2.0
        left.append((x + reach * math.cos(normal), y + reach * math.sin(normal)))
        right.append((x - reach * math.cos(normal), y - reach * math.sin(normal)))
    return right + left[::-1]


def holed_plate(rng: Random, radius: float, least_gap: float, most_gap: float) -> List[Loop]:
    """A rectangle with rows of holes; gaps between neighbours of a row are drawn anew each time."""
    columns, rows = rng.randint(2, 4), rng.randint(1, 2)
    margin = rng.uniform(1.0, 6.0) * most_gap
    circles: List[Circle] = []
    y, widest = radius + margin, 0.0
    for _ in range(rows):
        x, tallest = margin, 0.0
        for _ in range(columns):
            r = radius * rng.uniform(0.7, 1.0)
            x += r
            circles.append(Circle(x, y, r))
            x += r + rng.uniform(least_gap, most_gap)
            tallest = max(tallest, r)
        widest = max(widest, x)
        y += 2.0 * radius + rng.uniform(least_gap, most_gap)
    width, height = widest + margin, y - radius + margin
    frame = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
    shift = [(x - width / 2.0, y - height / 2.0) for x, y in frame]
    return [shift] + [Circle(c.x - width / 2.0, c.y - height / 2.0, c.radius) for c in circles]


def ring(rng: Random) -> List[Loop]:
    """An annulus, the hole off its middle in half of the cases."""
    inner = rng.uniform(0.25, 0.8)
    offset = rng.choice((0.0, rng.uniform(0.0, 0.8))) * (1.0 - inner)
    turn = rng.uniform(0.0, 2.0 * math.pi)
    return [Circle(0.0, 0.0, 1.0),
            Circle(offset * math.cos(turn), offset * math.sin(turn), inner)]


def extent(outline: List[Loop]) -> float:
    """Radius of the circle about the origin that holds the outer loop."""
    outer = outline[0]
    if isinstance(outer, Circle):
        return math.hypot(outer.x, outer.y) + outer.radius
    return max(math.hypot(x, y) for x, y in outer)


def scaled(outline: List[Loop], factor: float) -> List[Loop]:
    return [Circle(*(factor * part for part in loop)) if isinstance(loop, Circle)
            else [(factor * x, factor * y) for x, y in loop] for loop in outline]

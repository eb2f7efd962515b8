"""Tells whether a mesh still fits its settings and its shape.

The shape's text will not do: saving and opening a document changes digits and locations in it. So
points of the shape are kept and compared with a tolerance.
"""
from __future__ import annotations

import json
from typing import Any, List, Mapping

# Of the diagonal: far above what saving changes, far below what a mesh would show.
_TOLERANCE = 1e-7


def settings_text(settings: Mapping[str, Any]) -> str:
    """What the mesh depends on, in a fixed order."""
    kept = {key: value for key, value in settings.items() if key != "threads"}
    return json.dumps(kept, sort_keys=True)


def shape_points(shape) -> List[float]:
    """Coordinates of a point on every vertex, edge and face, in FreeCAD's order."""
    numbers: List[float] = [len(shape.Vertexes), len(shape.Edges), len(shape.Faces)]
    for vertex in shape.Vertexes:
        numbers.extend(vertex.Point)
    for edge in shape.Edges:
        if not edge.Degenerated:
            first, last = edge.ParameterRange
            numbers.extend(edge.valueAt(0.37 * first + 0.63 * last))
    for face in shape.Faces:
        u0, u1, v0, v1 = face.ParameterRange
        numbers.extend(face.valueAt(0.37 * u0 + 0.63 * u1, 0.41 * v0 + 0.59 * v1))
    return numbers


def same_points(kept: List[float], now: List[float], diagonal: float) -> bool:
    if len(kept) != len(now):
        return False
    allowed = _TOLERANCE * diagonal
    return all(abs(a - b) <= allowed for a, b in zip(kept, now))

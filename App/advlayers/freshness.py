"""Tells whether a mesh still fits its settings and its shape.

The shape's text will not do: saving and opening a document changes digits and locations in it. So
points of the shape are kept and compared with a tolerance.
"""
from __future__ import annotations

import json
from typing import Any, Dict, List, Mapping

from advlayers import limits
from advlayers.settings_table import MESH_SETTINGS

# Of the diagonal: far above what saving changes, far below what a mesh would show.
_TOLERANCE = 1e-7
# As JSON gives them back.
_DEFAULTS = {entry.key: list(entry.default) if isinstance(entry.default, tuple) else entry.default
             for entry in MESH_SETTINGS}


def settings_text(settings: Mapping[str, Any]) -> str:
    """What the mesh depends on, in a fixed order; linked objects by their names."""
    kept = {key: value for key, value in settings.items() if key not in ("threads", *limits.KEYS)}
    return json.dumps(kept, sort_keys=True, default=lambda linked: linked.Name)


def same_settings(kept: str, now: str) -> bool:
    """A setting that is not there counts as its default: later versions of the program add some."""
    return kept == now or _given(json.loads(kept)) == _given(json.loads(now))


def _given(settings: Mapping[str, Any]) -> Dict[str, Any]:
    return {key: [_without_empty(item) for item in value] if isinstance(value, list) else value
            for key, value in settings.items() if value != _DEFAULTS.get(key)}


def _without_empty(item: Any) -> Any:
    """One wall or size of a list, without the values that say nothing."""
    if not isinstance(item, dict):
        return item
    return {key: value for key, value in item.items() if value not in (None, [])}


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

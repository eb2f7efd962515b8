"""Settings that contradict each other: what is said while they are typed, with the value that would
do."""
from __future__ import annotations

from typing import Any, Mapping, Optional

from advlayers.core_access import load_core
from advlayers.errors import CoreMissing
from advlayers.lengths import length_text
from advlayers.sentence import Sentence, of_error

_COMMON = ("size", "first_height", "growth", "layers")
_ONE_OF = ("first_height", "aspect_ratio", "turning_angle")


def of_mesh(values: Mapping[str, Any]) -> Optional[Sentence]:
    """Of the settings of a whole mesh, unchecked."""
    if 0.0 < values["size"] < values["first_height"]:
        return Sentence("First height {} is above the size {}: it may be {} at most", tuple(
            length_text(values[key]) for key in ("first_height", "size", "size")))
    return None


def of_wall(mesh: Mapping[str, Any], wall: Mapping[str, Any]) -> Optional[Sentence]:
    """Of the values that a wall is given, beside those of its mesh."""
    if sum(wall.get(key) is not None for key in _ONE_OF) > 1:
        return Sentence("Give one of first height, aspect ratio and turning angle, not several")
    first, thickness = wall.get("first_height"), wall.get("thickness")
    if first is None and not any(wall.get(key) is not None for key in _ONE_OF):
        first = mesh["first_height"]
    if first is not None and thickness is not None and thickness < first:
        return Sentence("Thickness {} is below the first height {}: {} is the least", tuple(
            length_text(length) for length in (thickness, first, first)))
    if wall.get("first_height") is not None and mesh["size"] > 0.0:
        said = of_mesh({"size": mesh["size"], "first_height": wall["first_height"]})
        if said is not None:
            return said
    return _of_core(mesh, wall)


def _of_core(mesh: Mapping[str, Any], wall: Mapping[str, Any]) -> Optional[Sentence]:
    try:
        core = load_core()
        core.resolve_wall(core.Settings(**{key: mesh[key] for key in _COMMON}), dict(wall))
    except CoreMissing:
        return None
    except ValueError as error:
        return of_error(error)
    return None

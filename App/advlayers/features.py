"""Edges by what they are: "holes", "holes 4 10" (diameters [mm]), "sharp", "sharp 40" [deg]."""
from __future__ import annotations

import re
from typing import Any, Dict, Iterable, List, Mapping, Tuple

from advlayers.errors import InputError

_NUMBER = r"[0-9]+(?:\.[0-9]*)?"
PATTERN = re.compile(rf"(holes)(?: ({_NUMBER}) ({_NUMBER}))?|(sharp)(?: ({_NUMBER}))?")
# Faces that meet at more than this [deg] meet at a sharp edge, where no angle is given.
_SHARP = 30.0
_LISTS = ("match", "off", "boundary", "smooth")


def is_feature(name: Any) -> bool:
    return isinstance(name, str) and PATTERN.fullmatch(name) is not None


def are_asked(settings: Mapping[str, Any]) -> bool:
    """Whether checked settings name any."""
    return any(is_feature(name) for _key, names in _lists(settings) for name in names)


def expanded(settings: Mapping[str, Any], model) -> Dict[str, Any]:
    """Checked settings with the names of the edges that the core's model has for them. Raises
    InputError where it has none."""
    found = dict(settings)
    for key in _LISTS:
        found[key] = _edges(key, settings[key], model)
    for key in ("walls", "sizes"):
        if settings[key] != "all":
            found[key] = tuple(
                {**entry, "edges": _edges(f"{key}[{i}].edges", entry["edges"], model)}
                for i, entry in enumerate(settings[key]))
    return found


def _lists(settings: Mapping[str, Any]) -> Iterable[Tuple[str, Iterable[str]]]:
    for key in _LISTS:
        yield key, settings[key]
    for key in ("walls", "sizes"):
        if settings[key] != "all":
            for entry in settings[key]:
                yield key, entry["edges"]


def _edges(key: str, names: Iterable[str], model) -> Tuple[str, ...]:
    edges: List[str] = []
    for name in names:
        found = find(name, model) if is_feature(name) else [name]
        if not found:
            raise InputError(key, "finds no edge for {}", repr(name))
        edges += found
    return tuple(dict.fromkeys(edges))


def find(name: str, model) -> List[str]:
    """The edges of the core's model that a feature stands for."""
    holes, least, most, _sharp, angle = PATTERN.fullmatch(name).groups()
    if holes:
        low, high = (float(least), float(most)) if least else (0.0, float("inf"))
        return [edge for _face, edges, diameter in model.holes
                if low * (1 - 1e-6) <= diameter <= high * (1 + 1e-6) for edge in edges]
    sharpest = float(angle) if angle else _SHARP
    return [f"Edge{number}" for number, dihedral in enumerate(model.dihedral_angles, 1)
            if dihedral is not None and dihedral > sharpest]

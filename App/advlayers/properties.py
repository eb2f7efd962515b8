"""Settings of the table as FreeCAD properties, and back."""
from __future__ import annotations

import itertools
from typing import Any, Dict, Iterable, Mapping

import FreeCAD
import numpy as np

from advlayers.errors import InputError
from advlayers.sentence import Sentence
from advlayers.settings_table import Setting, property_name

READ_ONLY, HIDDEN = 1, 2  # editor modes

_NUMBERS = {"mm": "App::PropertyLength", "deg": "App::PropertyAngle", "": "App::PropertyFloat"}
_TYPES = {"count": "App::PropertyInteger", "layers": "App::PropertyString",
          "choice": "App::PropertyEnumeration", "flag": "App::PropertyBool",
          "faces": "App::PropertyStringList", "faces_only": "App::PropertyStringList",
          "periodic": "App::PropertyStringList", "refinements": "App::PropertyStringList",
          # Global: the mesh may stand in a part or a body that the mesh object is not in.
          "mesh": "App::PropertyLinkGlobal"}


def property_type(entry: Setting) -> str:
    return _NUMBERS[entry.unit] if entry.kind == "number" else _TYPES[entry.kind]


def add_setting(document_object, entry: Setting, group: str, doc: str) -> None:
    """Adds the property of one setting unless it is there."""
    name = property_name(entry)
    if name in document_object.PropertiesList:
        return
    document_object.addProperty(property_type(entry), name, group, doc)
    if entry.choices:
        setattr(document_object, name, list(entry.choices))


def to_property(entry: Setting, value: Any) -> Any:
    if entry.kind == "layers":
        return str(value)
    if entry.kind == "faces":
        return [] if value == "all" else list(value)
    if entry.kind == "faces_only":
        return list(value)
    if entry.kind == "periodic":
        return [_periodic_text(item) for item in value]
    if entry.kind == "refinements":
        return [_refinement_text(item) for item in value]
    return value


def from_property(entry: Setting, value: Any) -> Any:
    if entry.kind == "number":
        return getattr(value, "Value", value)
    if entry.kind == "layers":
        return int(value) if value.strip().isdigit() else value
    if entry.kind == "faces":
        return list(value) or "all"
    if entry.kind == "faces_only":
        return list(value)
    if entry.kind == "periodic":
        return [_periodic(entry.key, text) for text in value]
    if entry.kind == "refinements":
        return [_refinement(entry.key, text) for text in value]
    return value


# The word that a text of a refinement begins with, and the key of its second point.
_SECOND_POINTS = {"line": "end", "box": "corner"}


def _refinement_text(item: Mapping[str, Any]) -> str:
    """ "x y z size radius", or with a second point "line x y z x y z size radius"."""
    numbers = [*item["point"], item["size"], item.get("radius") or 0.0]
    word = next((word for word, key in _SECOND_POINTS.items() if item.get(key)), "")
    if word:
        numbers[3:3] = item[_SECOND_POINTS[word]]
    return " ".join([word] * bool(word) + [f"{number:.17g}" for number in numbers])


def _refinement(key: str, text: str) -> Dict[str, Any]:
    """From such a text, the radius optional."""
    words = text.split()
    second = _SECOND_POINTS.get(words[0]) if words else None
    points = 6 if second else 3
    try:
        numbers = [float(word) for word in words[1 if second else 0:]]
        size, *radius = numbers[points:]
    except ValueError as error:
        raise InputError(key, 'must hold texts like "x y z size radius", got {}',
                         repr(text)) from error
    if len(radius) > 1:
        raise InputError(key, "holds a number too many: {}", repr(text))
    found = {"point": numbers[:3], "size": size, "radius": radius[0] if radius else 0.0}
    return {**found, second: numbers[3:6]} if second else found


# The words of a periodic motion, the keys of their numbers, and what these are by themselves.
_MOTIONS = {"turn": (("axis_point", (0.0, 0.0, 0.0)), ("axis_direction", (0.0, 0.0, 1.0)),
                     ("angle", (0.0,))),
            "move": (("translation", (0.0, 0.0, 0.0)),)}


def _periodic_text(item: Mapping[str, Any]) -> str:
    """ "Face1 Edge2 move x y z", "Face1 turn x y z x y z angle", or both motions."""
    words = [*item["faces"], *item["edges"]]
    for word, keys in _MOTIONS.items():
        values = [np.atleast_1d(item.get(key) or default) for key, default in keys]
        if values[-1].any():
            words += [word, *(f"{number:.17g}" for number in np.concatenate(values).tolist())]
    return " ".join(words)


def _periodic(key: str, text: str) -> Dict[str, Any]:
    """From such a text."""
    words = text.split()
    names = list(itertools.takewhile(lambda word: word not in _MOTIONS, words))
    found: Dict[str, Any] = {"faces": [name for name in names if name.startswith("Face")],
                             "edges": [name for name in names if not name.startswith("Face")]}
    rest = words[len(names):]
    try:
        while rest:
            for part, default in _MOTIONS[rest.pop(0)]:
                numbers = [float(rest.pop(0)) for _number in default]
                found[part] = numbers if len(numbers) > 1 else numbers[0]
    except (KeyError, IndexError, ValueError) as error:
        raise InputError(key, 'must hold texts like "Face1 move x y z", got {}',
                         repr(text)) from error
    return found


def plain_values(values: Mapping[str, Any], table: Iterable[Setting]) -> Dict[str, Any]:
    """Numbers in mm and degrees for texts and quantities with a unit. Raises InputError."""
    plain = dict(values)
    for entry in table:
        value = plain.get(entry.key)
        if entry.kind == "number" and isinstance(value, (str, FreeCAD.Units.Quantity)):
            plain[entry.key] = _in_unit(entry.key, value, entry.unit)
    return plain


def _in_unit(key: str, value, unit: str) -> float:
    try:
        quantity = FreeCAD.Units.Quantity(value)
        plain = quantity.Unit == FreeCAD.Units.Unit()
        return quantity.Value if plain or not unit else float(quantity.getValueAs(unit))
    except (ValueError, ArithmeticError, SyntaxError, TypeError) as error:
        what = Sentence("in {}", (unit,)) if unit else Sentence("without a unit")
        raise InputError(key, "must be a number {}, got {}", what, repr(str(value))) from error

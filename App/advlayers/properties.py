"""Settings of the table as FreeCAD properties, and back."""
from __future__ import annotations

from typing import Any, Dict, Iterable, Mapping

import FreeCAD

from advlayers.errors import InputError
from advlayers.sentence import Sentence
from advlayers.settings_table import Setting, property_name

READ_ONLY, HIDDEN = 1, 2  # editor modes

_NUMBERS = {"mm": "App::PropertyLength", "deg": "App::PropertyAngle", "": "App::PropertyFloat"}
_TYPES = {"count": "App::PropertyInteger", "layers": "App::PropertyString",
          "choice": "App::PropertyEnumeration", "flag": "App::PropertyBool",
          "faces": "App::PropertyStringList", "refinements": "App::PropertyStringList",
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
    if entry.kind == "refinements":
        return [" ".join(f"{number:.17g}" for number in
                         (*item["point"], item["size"], item["radius"])) for item in value]
    return value


def from_property(entry: Setting, value: Any) -> Any:
    if entry.kind == "number":
        return getattr(value, "Value", value)
    if entry.kind == "layers":
        return int(value) if value.strip().isdigit() else value
    if entry.kind == "faces":
        return list(value) or "all"
    if entry.kind == "refinements":
        return [_refinement(entry.key, text) for text in value]
    return value


def _refinement(key: str, text: str) -> Dict[str, Any]:
    """From "x y z size radius", the radius optional."""
    try:
        x, y, z, size, *radius = (float(word) for word in text.split())
    except ValueError as error:
        raise InputError(key, 'must hold texts like "x y z size radius", got {}',
                         repr(text)) from error
    if len(radius) > 1:
        raise InputError(key, "holds more than five numbers: {}", repr(text))
    return {"point": [x, y, z], "size": size, "radius": radius[0] if radius else 0.0}


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

"""Values that a job gives a FreeCAD document before its shape is taken: one document, many shapes.

"Spreadsheet.chord" is a cell by its alias or its place, "Sketch.Radius" a constraint by its name,
"Box.Length" a property; objects go by name or label.
"""
from __future__ import annotations

from typing import Any, Mapping

from advlayers.errors import InputError

KEY = "parameters"


def set_values(document, values: Mapping[str, Any]) -> None:
    """Sets them all and recomputes. Raises InputError for a name that leads to nothing, a value
    that cannot be set, or a model that does not come out of it whole."""
    if not values:
        return
    broken = {entry.Name for entry in document.Objects if _is_broken(entry)}
    for name, value in values.items():
        owner, _point, item = name.partition(".")
        try:
            _set(_object(document, name, owner), name, item, value)
        except (TypeError, ValueError, RuntimeError, ReferenceError) as error:
            if isinstance(error, InputError):
                raise
            raise InputError(f"{KEY}.{name}", "cannot be set to {}: {}", repr(value),
                             str(error)) from error
    document.recompute()
    for entry in document.Objects:
        if _is_broken(entry) and entry.Name not in broken:
            raise InputError(KEY, "give a model in which {} fails", entry.Label)


def _object(document, name: str, owner: str):
    found = document.getObject(owner)
    if found is not None:
        return found
    same_label = document.getObjectsByLabel(owner)
    if len(same_label) != 1:
        raise InputError(f"{KEY}.{name}", "names no object of the document, or several")
    return same_label[0]


def _set(document_object, name: str, item: str, value: Any) -> None:
    if document_object.isDerivedFrom("Spreadsheet::Sheet"):
        cell = document_object.getCellFromAlias(item) or item
        document_object.set(cell, str(value))
    elif item in [entry.Name for entry in getattr(document_object, "Constraints", ())]:
        import FreeCAD

        document_object.setDatum(item, FreeCAD.Units.Quantity(value) if isinstance(value, str)
                                 else float(value))
    elif item in document_object.PropertiesList:
        setattr(document_object, item, value)
    else:
        raise InputError(f"{KEY}.{name}", "is neither cell, constraint nor property of {}",
                         document_object.Label)


def _is_broken(document_object) -> bool:
    return "Invalid" in document_object.State

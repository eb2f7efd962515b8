"""Tells the macro recorder what was done in a panel, as lines that do the same when run again."""
from __future__ import annotations

from typing import Any, Dict, List

import advlayers
from advlayers import controls
from advlayers.mesh_properties import property_settings
from advlayers.settings_table import property_name, value_settings
from advlayers_gui.command import do, in_code


class Recording:
    """Of one mesh object with its children, or of one child; begins when it is made."""

    def __init__(self, document_object) -> None:
        self._object = document_object
        self._before = {thing.Name: _properties(thing) for thing in self._things()}
        self._codes = {thing.Name: in_code(thing) for thing in self._things()}
        self._mesh_id = self._id()

    @property
    def empty(self) -> bool:
        """Whether nothing has changed since."""
        return not self._lines()

    def tell(self) -> None:
        """All that has changed since."""
        lines = self._lines()
        if lines:
            with advlayers.done_already():
                for line in ["import advlayers"] + lines:
                    do(line)

    def _lines(self) -> List[str]:
        now = {thing.Name: thing for thing in self._things()}
        lines = [f"advlayers.remove({self._codes[name]})"
                 for name in self._before if name not in now]
        for name, thing in now.items():
            if name in self._before:
                lines += _changes(thing, self._before[name])
            else:
                lines.append(_making(self._object, thing))
        if self._id() != self._mesh_id:
            lines.append(f"advlayers.update({in_code(self._object)})")
        return lines

    def _things(self) -> List[Any]:
        if controls.is_control(self._object):
            return [self._object]
        return [self._object] + controls.children(self._object)

    def _id(self) -> str:
        return "" if controls.is_control(self._object) else self._object.MeshId


def _properties(thing) -> Dict[str, str]:
    """What a user may set, as code has it."""
    if controls.is_control(thing):
        names = [property_name(entry) for entry in value_settings(thing.Proxy.TABLE)]
        names += [name for name in ("Condition", "Label") if hasattr(thing, name)]
        return {**{name: _code(getattr(thing, name)) for name in names},
                "References": _references(thing)}
    names = [property_name(entry) for entry in property_settings()]
    return {name: _code(getattr(thing, name)) for name in names + ["GrowFromAll", "AutoUpdate"]}


def _changes(thing, before: Dict[str, str]) -> List[str]:
    return [f"{in_code(thing)}.{name} = {code}"
            for name, code in _properties(thing).items() if before[name] != code]


def _making(mesh_object, control) -> str:
    start = f"{in_code(mesh_object)}, "
    if isinstance(control.Proxy, controls.Group):
        return f"advlayers.make_group({start}{control.GroupName!r}, {_references(control)})"
    given = {"label": control.Label, **controls.values(control)}
    if isinstance(control.Proxy, controls.Wall):
        given["condition"] = control.Condition
    words = "".join(f", {key}={value!r}" for key, value in given.items())
    kind = type(control.Proxy).__name__.lower()
    return f"advlayers.make_{kind}({start}{_references(control)}{words})"


def _references(control) -> str:
    return "[" + ", ".join(f"({in_code(owner)}, {tuple(names)!r})"
                           for owner, names in control.References) + "]"


def _code(value: Any) -> str:
    if hasattr(value, "isDerivedFrom"):
        return in_code(value)
    return repr(getattr(value, "Value", value))

"""Checks values against the table of settings, whichever way they came in."""
from __future__ import annotations

import difflib
import math
import re
from typing import Any, Callable, Dict, Iterable, Mapping, Tuple

from advlayers.errors import InputError
from advlayers.features import is_feature
from advlayers.settings_table import (
    EXTRUDE_SETTINGS, PERIODIC_SETTINGS, REFINEMENT_SETTINGS, SIZE_SETTINGS, VOLUME_SETTINGS,
    WALL_SETTINGS, Y_PLUS_SETTINGS, Setting, range_said)

_NAME = re.compile(r"(Face|Edge)([1-9][0-9]*)")
_UNV_MARK = "-1"
# Names that the mesh gives to groups by itself.
_OWN_GROUP = re.compile(r"(Face|Edge|Layer)[0-9]+|Core")


def check_all(values: Mapping[str, Any], table: Tuple[Setting, ...], where: str = "") -> Dict:
    """Returns every setting of the table, checked, with defaults filled in.

    Raises InputError for an unknown key, a missing one, or a value out of its range.
    """
    known = {entry.key: entry for entry in table}
    for key in values:
        if key not in known:
            close = difflib.get_close_matches(str(key), known, n=1)
            if close:
                raise InputError(f"{where}{key}", "is no known key (did you mean {}?)", close[0])
            raise InputError(f"{where}{key}", "is no known key")
    checked = {}
    for key, entry in known.items():
        if key not in values and entry.required:
            raise InputError(f"{where}{key}", "is missing")
        if key not in values or (values[key] is None and entry.default is None
                                 and not entry.required):
            checked[key] = entry.default
        else:
            checked[key] = CHECKS[entry.kind](f"{where}{key}", values[key], entry)
    return checked


def check_names(settings: Mapping[str, Any], faces: int, edges: int, what: str) -> None:
    """Raises InputError where a setting names a face or an edge that the model does not have."""
    def check(key: str, names: Iterable[str]) -> None:
        for name in names:
            kind, number = _NAME.fullmatch(name).groups()
            count = faces if kind == "Face" else edges
            if int(number) > count:
                raise InputError(key, "names {}, but {} has {} faces" if kind == "Face"
                                 else "names {}, but {} has {} edges", name, what, count)

    if settings["faces"] != "all":
        check("faces", settings["faces"])
    if settings["walls"] != "all":
        for i, wall in enumerate(settings["walls"]):
            check(f"walls[{i}].edges", wall["edges"])
            check(f"walls[{i}].faces", wall["faces"])
    for i, size in enumerate(settings["sizes"]):
        check(f"sizes[{i}].edges", size["edges"])
        check(f"sizes[{i}].faces", size["faces"])
    for i, entry in enumerate(settings["periodic"]):
        check(f"periodic[{i}].edges", entry["edges"])
        check(f"periodic[{i}].faces", entry["faces"])
    for key in ("match", "off", "boundary", "smooth", "mapped"):
        check(key, settings[key])
    meshed = None if settings["faces"] in ("all", ()) else set(settings["faces"])
    for group, names in settings["groups"].items():
        check(f"groups.{group}", names)
        for name in names:
            if name.startswith("Face") and meshed is not None and name not in meshed:
                raise InputError(f"groups.{group}", "names {}, which is not in faces", name)


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _number(key: str, value: Any, entry: Setting) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise InputError(key, "must be a number, got {}", _shown(value))
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise InputError(key, "must be a finite number, got {}", _shown(value))
    _check_range(key, number, entry)
    return number


def _check_range(key: str, number: float, entry: Setting) -> None:
    too_low = entry.low is not None and (
        number <= entry.low if entry.low_open else number < entry.low)
    too_high = entry.high is not None and (
        number >= entry.high if entry.high_open else number > entry.high)
    if too_low or too_high:
        raise InputError(key, "must be {}, got {}", range_said(entry), f"{number:g}")


def _count(key: str, value: Any, entry: Setting) -> int:
    # A whole number may be written 3.0: JSON makes no difference between the two.
    if isinstance(value, bool) or not isinstance(value, (int, float)) or value != value // 1:
        raise InputError(key, "must be a whole number, got {}", _shown(value))
    _number(key, value, entry)
    if value > 1_000_000:
        raise InputError(key, "must be at most 1000000, got {}", _shown(value))
    return int(value)


def _layers(key: str, value: Any, entry: Setting):
    if value == "isotropic":
        return value
    if isinstance(value, str):
        raise InputError(key, 'must be a whole number or "isotropic", got {}', _shown(value))
    return _count(key, value, entry)


def _choice(key: str, value: Any, entry: Setting) -> str:
    if value not in entry.choices:
        allowed = " or ".join(f'"{choice}"' for choice in entry.choices)
        raise InputError(key, "must be {}, got {}", allowed, _shown(value))
    return value


def _flag(key: str, value: Any, _entry: Setting) -> bool:
    if not isinstance(value, bool):
        raise InputError(key, "must be true or false, got {}", _shown(value))
    return value


def _text(key: str, value: Any, _entry: Setting) -> str:
    if not isinstance(value, str) or not value or "\0" in value or not _is_text(value):
        raise InputError(key, "must be a text, got {}", _shown(value))
    return value


def _is_text(value: str) -> bool:
    """Bytes of a name that are no UTF-8 have a place of their own; half a character has none."""
    try:
        value.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return False
    return True


def _mesh(key: str, value: Any, entry: Setting) -> Any:
    """A path; or, in Python, a mesh object of the document, or a pair of arrays."""
    in_python = hasattr(value, "isDerivedFrom") or (isinstance(value, tuple) and len(value) == 2)
    return value if in_python else _text(key, value, entry)


def _paths(key: str, value: Any, entry: Setting) -> Tuple[str, ...]:
    if not isinstance(value, (list, tuple)):
        raise InputError(key, "must be a list of files, got {}", _shown(value))
    return tuple(_text(f"{key}[{i}]", item, entry) for i, item in enumerate(value))


def _names(key: str, value: Any, kinds: Tuple[str, ...], empty: bool) -> Tuple[str, ...]:
    examples = " or ".join(f'"{kind}1"' for kind in kinds)
    if not isinstance(value, (list, tuple)):
        raise InputError(key, "must be a list of names like {}, got {}", examples, _shown(value))
    seen = set()
    for name in value:
        match = _NAME.fullmatch(name) if isinstance(name, str) else None
        if not match or match.group(1) not in kinds:
            raise InputError(key, "holds {}, which is no name like {}", _shown(name), examples)
        if name in seen:
            raise InputError(key, "names {} twice", name)
        seen.add(name)
    if not value and not empty:
        raise InputError(key, "must not be empty")
    return tuple(value)


def _faces(key: str, value: Any, _entry: Setting):
    return "all" if value == "all" else _names(key, value, ("Face",), empty=False)


def _faces_only(key: str, value: Any, _entry: Setting) -> Tuple[str, ...]:
    return _names(key, value, ("Face",), empty=True)


def _edges(key: str, value: Any, entry: Setting) -> Tuple[str, ...]:
    """Names, and features that stand for edges."""
    if not isinstance(value, (list, tuple)):
        return _names(key, value, ("Edge",), empty=True)  # says what is wrong
    named = [name for name in value if not is_feature(name)]
    _names(key, named, ("Edge",), empty=not entry.required or bool(value))
    return tuple(dict.fromkeys(value))


def _walls(key: str, value: Any, _entry: Setting):
    if value == "all":
        return value
    if not isinstance(value, (list, tuple)):
        raise InputError(key, 'must be "all" or a list of walls, got {}', _shown(value))
    return _entries(key, value, WALL_SETTINGS)


def _entries(key: str, value: Any, table: Tuple[Setting, ...]) -> Tuple[Dict, ...]:
    if not isinstance(value, (list, tuple)):
        raise InputError(key, "must be a list, got {}", _shown(value))
    entries = []
    for i, item in enumerate(value):
        if not isinstance(item, dict):
            raise InputError(f"{key}[{i}]", "must be an object, got {}", _shown(item))
        entries.append(check_all(item, table, where=f"{key}[{i}]."))
    return tuple(entries)


def _sizes(key: str, value: Any, _entry: Setting) -> Tuple[Dict, ...]:
    return _entries(key, value, SIZE_SETTINGS)


def _refinements(key: str, value: Any, _entry: Setting) -> Tuple[Dict, ...]:
    return _entries(key, value, REFINEMENT_SETTINGS)


def _periodic(key: str, value: Any, _entry: Setting) -> Tuple[Dict, ...]:
    return _entries(key, value, PERIODIC_SETTINGS)


def _y_plus(key: str, value: Any, _entry: Setting) -> Dict[str, Any]:
    return _block(key, value, Y_PLUS_SETTINGS)


def _extrude(key: str, value: Any, _entry: Setting) -> Dict:
    return _block(key, value, EXTRUDE_SETTINGS)


def _volume(key: str, value: Any, _entry: Setting) -> Dict:
    return _block(key, value, VOLUME_SETTINGS)


def _block(key: str, value: Any, table: Tuple[Setting, ...]) -> Dict:
    if not isinstance(value, dict):
        raise InputError(key, "must be an object, got {}", _shown(value))
    return check_all(value, table, where=f"{key}.")


def _words(key: str, value: Any, entry: Setting) -> Dict[str, str]:
    if not isinstance(value, dict):
        raise InputError(key, "must be an object of names and words, got {}", _shown(value))
    return {name: _text(f"{key}.{name}", word, entry) for name, word in value.items()}


def _values(key: str, value: Any, entry: Setting) -> Dict[str, Any]:
    if not isinstance(value, dict):
        raise InputError(key, "must be an object of names and values, got {}", _shown(value))
    for name, item in value.items():
        if "." not in name.strip("."):
            raise InputError(f"{key}.{name}", "is no name like {}", '"Spreadsheet.chord"')
        if not isinstance(item, (int, float, str)):
            raise InputError(f"{key}.{name}", "must be a number or a text, got {}", _shown(item))
    return dict(value)


def _point(key: str, value: Any, entry: Setting) -> Tuple[float, ...]:
    if not isinstance(value, (list, tuple)) or len(value) != 3:
        raise InputError(key, "must be three numbers, got {}", _shown(value))
    return tuple(_number(f"{key}[{i}]", item, entry) for i, item in enumerate(value))


def _groups(key: str, value: Any, _entry: Setting) -> Dict[str, Tuple[str, ...]]:
    if not isinstance(value, dict):
        raise InputError(key, "must be an object of names and lists, got {}", _shown(value))
    groups = {}
    for name, members in value.items():
        if not isinstance(name, str) or not name.strip() or not name.isprintable():
            raise InputError(key, "holds the name {}, which cannot be written", _shown(name))
        if name.strip() == _UNV_MARK:
            raise InputError(key, "holds the name {}, which ends a part of an I-DEAS file",
                             _shown(name))
        if _OWN_GROUP.fullmatch(name):
            raise InputError(f"{key}.{name}", "is a name that the mesh itself gives to a group")
        groups[name] = _names(f"{key}.{name}", members, ("Face", "Edge"), empty=False)
    return groups


CHECKS: Dict[str, Callable[[str, Any, Setting], Any]] = {
    "number": _number, "count": _count, "layers": _layers, "choice": _choice, "flag": _flag,
    "text": _text, "path": _text, "mesh": _mesh, "paths": _paths, "faces": _faces,
    "faces_only": _faces_only, "periodic": _periodic, "edges": _edges,
    "walls": _walls, "groups": _groups,
    "sizes": _sizes, "refinements": _refinements, "point": _point, "y_plus": _y_plus,
    "extrude": _extrude, "volume": _volume, "words": _words,
    "values": _values,
}

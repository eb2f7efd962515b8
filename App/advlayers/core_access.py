"""The one door to the compiled core."""
from __future__ import annotations

import importlib
import json
import os
import sys
from typing import Any, Dict

import advlayers
from advlayers.errors import CoreMissing


def load_core():
    """Imports advlayers_core. Raises CoreMissing with the remedy."""
    try:
        core = importlib.import_module("advlayers_core")
        _check_version(core)
        return core
    except ImportError as error:
        root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
        version = ".".join(str(part) for part in sys.version_info[:3])
        raise CoreMissing(
            "the meshing core is not built for this FreeCAD (Python {}): run \"./dev build\" in {} "
            "and start FreeCAD again ({})", version, root, error) from error


def _check_version(core) -> None:
    """A core of another version has other settings, or other words for the same."""
    version = getattr(core, "__version__", "0")
    if _series(version) != _series(advlayers.__version__):
        raise CoreMissing(
            "the meshing core is of version {}, but this add-on needs {}: install the core of the "
            "same version ({})", version, advlayers.__version__, os.path.dirname(core.__file__))


def _series(version: str) -> str:
    """What add-on and core have to share: docs/promises.md."""
    return ".".join(version.split(".")[:2])


# Its copy, for a FreeCAD without a core: documents keep their objects and the commands their words.
SCHEMA_FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "schema.json")


def core_schema() -> Dict[str, Any]:
    """The rows of all settings that the core knows."""
    try:
        return load_core().schema()
    except CoreMissing:
        with open(SCHEMA_FILE, encoding="utf-8") as file:
            return json.load(file)

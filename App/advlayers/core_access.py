"""The one door to the compiled core."""
from __future__ import annotations

import importlib
import json
import os
import sys
from typing import Any, Dict

from advlayers.errors import CoreMissing


def load_core():
    """Imports advlayers_core. Raises CoreMissing with the remedy."""
    try:
        return importlib.import_module("advlayers_core")
    except ImportError as error:
        root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
        version = ".".join(str(part) for part in sys.version_info[:3])
        raise CoreMissing(
            "the meshing core is not built for this FreeCAD (Python {}): run \"./dev build\" in {} "
            "and start FreeCAD again ({})", version, root, error) from error


# Its copy, for a FreeCAD without a core: documents keep their objects and the commands their words.
SCHEMA_FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "schema.json")


def core_schema() -> Dict[str, Any]:
    """The rows of all settings that the core knows."""
    try:
        return load_core().schema()
    except CoreMissing:
        with open(SCHEMA_FILE, encoding="utf-8") as file:
            return json.load(file)

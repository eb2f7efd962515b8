"""The one door to the compiled core."""
from __future__ import annotations

import importlib
import os
import sys

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

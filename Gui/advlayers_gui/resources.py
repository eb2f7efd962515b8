"""Pictures and words of the window."""
from __future__ import annotations

import os

import FreeCAD

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
_CONTEXT = "AdvancingLayers"  # of the translations


def folder(name: str) -> str:
    return os.path.join(ROOT, "Resources", name)


def icon(name: str) -> str:
    return os.path.join(folder("icons"), f"{name}.svg")


def tr(text: str) -> str:
    """The text in the user's language; `./dev translations` finds it where it stands as a literal.
    """
    return FreeCAD.Qt.translate(_CONTEXT, text)

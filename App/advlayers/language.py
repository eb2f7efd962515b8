"""The user's language, for texts of ours that a window shows."""
from __future__ import annotations

import FreeCAD

_CONTEXT = "AdvancingLayers"  # of the translations


def tr(text: str) -> str:
    """The text in the user's language; `./dev translations` finds it where it stands as a literal.
    """
    return FreeCAD.Qt.translate(_CONTEXT, text)

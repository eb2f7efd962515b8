"""The user's language, for texts of ours that a window shows."""
from __future__ import annotations

import FreeCAD

# Contexts of the translations; FreeCAD itself looks up tooltips of properties in the second.
_CONTEXT, _PROPERTIES = "AdvancingLayers", "App::Property"


def tr(text: str) -> str:
    """The text in the user's language; `./dev translations` finds it where it stands as a literal.
    """
    return FreeCAD.Qt.translate(_CONTEXT, text)


def tr_doc(text: str) -> str:
    """The same of what a setting or a property is there for."""
    return FreeCAD.Qt.translate(_PROPERTIES, text)

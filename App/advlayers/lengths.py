"""Lengths in the user's units, with digits that mean something: FreeCAD's own words for 0.1 mm are
"0.00 in"."""
from __future__ import annotations

import FreeCAD

_DIGITS = 3
_FEW = 1e-3  # below, numbers are told by powers of ten


def length_text(millimetres: float, digits: int = _DIGITS) -> str:
    """ "0.1 mm", "0.00394 in"."""
    quantity = FreeCAD.Units.Quantity(float(millimetres), FreeCAD.Units.Length)
    _text, factor, unit = quantity.getUserPreferred()
    return f"{rounded(millimetres / factor, digits)} {unit}"


def rounded(number: float, digits: int = _DIGITS) -> str:
    """With so many digits that mean something, but none of a whole number left out."""
    if number == 0.0 or abs(number) >= 10.0 ** digits:
        return f"{number:.0f}"
    text = f"{number:.{digits}g}"
    return text if "e" not in text or abs(number) < _FEW else f"{number:f}"

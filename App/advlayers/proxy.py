"""What every Python object behind a FreeCAD object has in common."""
from __future__ import annotations


class Stateless:
    """Saves nothing of its own: all data lies in properties.

    FreeCAD 0.20 calls the second pair, later versions the first.
    """

    def dumps(self):
        return None

    def loads(self, _state) -> None:
        return None

    def __getstate__(self):
        return None

    def __setstate__(self, _state) -> None:
        return None

"""Whether what is meshed is itself in order. FreeCAD does not recompute what hangs on an object in
error, so nothing else would tell the mesh."""
from __future__ import annotations

from typing import Any, Callable, List

import FreeCAD

_observers: List[Any] = []


def in_error(source) -> bool:
    """Whether its shape may not be the one that is meant: it, or something it is made of, could not
    be computed."""
    return source is not None and any(
        "Invalid" in part.State for part in (source, *source.OutListRecursive))


def watch(refresh: Callable[[Any], None]) -> None:
    """Calls `refresh` with each object of a document that was recomputed."""
    if not _observers:
        _observers.append(_Observer(refresh))
        FreeCAD.addDocumentObserver(_observers[0])


class _Observer:
    def __init__(self, refresh: Callable[[Any], None]) -> None:
        self._refresh = refresh

    def slotRecomputedDocument(self, document) -> None:
        for entry in document.Objects:
            self._refresh(entry)

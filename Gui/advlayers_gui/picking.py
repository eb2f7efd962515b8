"""Picking faces, edges and vertices of one object in the 3D view."""
from __future__ import annotations

from typing import Callable, Iterable, List, Tuple

import FreeCADGui

from advlayers.errors import InputError
from advlayers.language import tr
from advlayers.picked_names import names_on


class PickSession:
    """While it lasts, only what is of one of the kinds ("Face", "Edge", "Vertex") and of the object
    can be picked; `on_refused` gets the reason for anything else, `on_change` is called when the
    selection has changed."""

    def __init__(self, source, kinds: Tuple[str, ...], on_change: Callable[[], None],
                 on_refused: Callable[[str], None]) -> None:
        self._source, self._on_change, self._on_refused = source, on_change, on_refused
        self._gate = _Gate(source, kinds, on_refused)
        self._active = self._silent = False

    def begin(self) -> None:
        if not self._active:
            self._active = True
            FreeCADGui.Selection.addSelectionGate(self._gate)
            FreeCADGui.Selection.addObserver(self)

    def end(self) -> None:
        if self._active:
            self._active = False
            FreeCADGui.Selection.removeObserver(self)
            FreeCADGui.Selection.removeSelectionGate()

    def names(self) -> List[str]:
        """What is selected, by its names on the object."""
        picked = [(entry.Object, tuple(sub for sub in entry.SubElementNames if sub))
                  for entry in FreeCADGui.Selection.getSelectionEx(self._source.Document.Name)]
        try:
            return names_on(self._source, [pair for pair in picked if pair[1]])
        except InputError as error:
            self._on_refused(error.sentence.translated)
            return []

    def select(self, names: Iterable[str]) -> None:
        """Selects these of the object, and nothing else."""
        self._silent = True  # one word for all of them: each would count them all
        try:
            FreeCADGui.Selection.clearSelection()
            for name in names:
                FreeCADGui.Selection.addSelection(
                    self._source.Document.Name, self._source.Name, name)
        finally:
            self._silent = False
        self._on_change()

    def _changed(self) -> None:
        if not self._silent:
            self._on_change()

    # --- what FreeCAD calls -------------------------------------------------------------------

    def addSelection(self, _document, _object, _sub, _point) -> None:
        self._changed()

    def removeSelection(self, _document, _object, _sub) -> None:
        self._changed()

    def setSelection(self, _document) -> None:
        self._changed()

    def clearSelection(self, _document) -> None:
        self._changed()


class _Gate:
    """FreeCAD asks it before it selects, and while the pointer hovers."""

    def __init__(self, source, kinds: Tuple[str, ...],
                 on_refused: Callable[[str], None]) -> None:
        self._source, self._kinds, self._on_refused = source, kinds, on_refused

    def allow(self, _document, document_object, sub: str) -> bool:
        reason = _refusal(self._source, self._kinds, document_object, sub)
        if reason:
            self._on_refused(reason)
        return not reason


def _refusal(source, kinds: Tuple[str, ...], document_object, sub: str) -> str:
    """Why a pick is of no use; empty if it is."""
    if document_object is not source and document_object not in source.OutListRecursive:
        return tr("{} is no part of {}, which is meshed").format(
            document_object.Label, source.Label)
    kind = sub.rsplit(".", 1)[-1].rstrip("0123456789")
    if kind not in kinds:
        wanted = tr("pick a face, an edge or a vertex of {}") if "Vertex" in kinds \
            else tr("pick a face or an edge of {}")
        return wanted.format(source.Label)
    return ""

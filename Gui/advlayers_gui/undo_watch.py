"""Undo while a panel is open: FreeCAD closes the panel's transaction and takes all of it back."""
from __future__ import annotations

from typing import Callable

import FreeCAD
from PySide import QtCore


class UndoWatch:
    """`act` is called in the turn of the event loop after an undo in the document. Within the undo
    itself the document must not be touched."""

    def __init__(self, document, act: Callable[[], None]) -> None:
        self._name = document.Name
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(act)
        FreeCAD.addDocumentObserver(self)

    def release(self) -> None:
        """An undo that removes the panel's object tells of itself after that: then in a later turn.
        """
        undoing = self._name in FreeCAD.listDocuments() \
            and FreeCAD.getDocument(self._name).Transacting
        if undoing:
            QtCore.QTimer.singleShot(0, self._leave)
        else:
            self._leave()

    def slotUndoDocument(self, document) -> None:
        if document.Name == self._name:
            self._timer.start(0)

    def _leave(self) -> None:
        if self._name:
            self._name = ""
            FreeCAD.removeDocumentObserver(self)

"""Esc in the 3D view while a panel is open: FreeCAD would end the edit there and then, with all
that the panel has not handed over; here it asks the panel, as its Cancel button does."""
from __future__ import annotations

from typing import Any, Callable, List

import FreeCADGui
from PySide import QtCore, QtGui


class EscapeKey(QtCore.QObject):
    def __init__(self, act: Callable[[], None]) -> None:
        super().__init__()
        self._act = act
        self._views: List[Any] = FreeCADGui.getMainWindow().findChildren(QtGui.QGraphicsView)
        for view in self._views:
            view.installEventFilter(self)

    def release(self) -> None:
        for view in self._views:
            try:
                view.removeEventFilter(self)
            except RuntimeError:  # its window was closed
                continue
        self._views = []

    def eventFilter(self, _view, event) -> bool:
        # The release as well: it is what FreeCAD acts upon.
        if event.type() not in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease) \
                or event.key() != QtCore.Qt.Key_Escape:
            return False
        if event.type() == QtCore.QEvent.KeyPress:
            QtCore.QTimer.singleShot(0, self._act)
        return True

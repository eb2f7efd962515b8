"""Comma and point both begin the decimals of a number that is typed. Qt and FreeCAD take the one
that is not the language's for a mark of thousands: "0,5" would be 5."""
from __future__ import annotations

from typing import Any, List

from PySide import QtCore, QtGui

_SIGNS = (",", ".")
_filter: List[Any] = []  # one for all fields; Qt does not keep it


def accept_both(spin_box) -> None:
    if not _filter:
        _filter.append(_DecimalSign())
    spin_box.findChild(QtGui.QLineEdit).installEventFilter(_filter[0])


class _DecimalSign(QtCore.QObject):
    def eventFilter(self, line, event) -> bool:
        if event.type() != QtCore.QEvent.KeyPress or event.text() not in _SIGNS:
            return False
        sign = str(line.locale().decimalPoint())
        if event.text() == sign or sign not in _SIGNS:
            return False
        QtGui.QApplication.sendEvent(
            line, QtGui.QKeyEvent(event.type(), 0, QtCore.Qt.NoModifier, sign))
        return True

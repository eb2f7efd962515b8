"""The line of a panel that says how things stand, and what is wrong."""
from __future__ import annotations

from PySide import QtGui

_WRONG_COLOUR = "#c8202c"  # to be read on light and on dark


class StatusLine:
    def __init__(self, text: str = "") -> None:
        self.widget = QtGui.QLabel(text)
        self.widget.setObjectName("AdvLayersStatus")
        self.widget.setWordWrap(True)

    def say(self, text: str, wrong: bool = False) -> None:
        self.widget.setStyleSheet(f"color: {_WRONG_COLOUR}" if wrong else "")
        self.widget.setText(text)

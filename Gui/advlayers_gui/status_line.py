"""The line of a panel that says how things stand, and what is wrong."""
from __future__ import annotations

from PySide import QtGui

# On a ground of its own: themes are light, dark and in between.
_WRONG = "color: #8f1018; background-color: #fbe3e4; padding: 2px"


class StatusLine:
    def __init__(self, text: str = "") -> None:
        self.widget = QtGui.QLabel(text)
        self.widget.setObjectName("AdvLayersStatus")
        self.widget.setWordWrap(True)

    def say(self, text: str, wrong: bool = False) -> None:
        self.widget.setStyleSheet(_WRONG if wrong else "")
        self.widget.setText(text)

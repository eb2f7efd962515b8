"""Keep, discard or go on: asked within a panel that a key or a click would close with work in it.

No window of its own: nothing waits for the answer, and Esc does not answer it."""
from __future__ import annotations

from typing import Callable

from PySide import QtCore, QtGui

from advlayers.language import tr

_GROUND = "color: #3a2c00; background-color: #fdf1cf; padding: 2px"  # whatever the theme


class LeaveQuestion:
    def __init__(self, keep: Callable[[], None], discard: Callable[[], None]) -> None:
        self.widget = QtGui.QWidget()
        self.widget.setObjectName("AdvLayersQuestion")
        self._text = QtGui.QLabel()
        self._text.setObjectName("AdvLayersQuestionText")
        self._text.setWordWrap(True)
        self._text.setStyleSheet(_GROUND)
        layout, row = QtGui.QVBoxLayout(self.widget), QtGui.QHBoxLayout()
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._text)
        layout.addLayout(row)
        self._buttons = [
            self._button("Keep", tr("Keep"), tr("Puts what is there into the document and closes"),
                         keep),
            self._button("Discard", tr("Discard"),
                         tr("Closes, and leaves everything as it was before"), discard),
            self._button("GoOn", tr("Go on"), tr("Leaves the panel open"), self.hide)]
        for button in self._buttons:
            row.addWidget(button)
        self.widget.hide()

    def ask(self, text: str) -> None:
        self._text.setText(text)
        self.widget.show()
        self._buttons[0].setFocus()

    def hide(self) -> None:
        self.widget.hide()

    def _button(self, name: str, text: str, doc: str, act: Callable[[], None]):
        button = QtGui.QPushButton(text)
        button.setObjectName(f"AdvLayers{name}")
        button.setToolTip(doc)
        # Not within the click: to act may delete the button.
        button.clicked.connect(lambda _checked=False: QtCore.QTimer.singleShot(0, act))
        return button

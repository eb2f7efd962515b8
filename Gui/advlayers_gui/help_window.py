"""The pages of docs/ in a window of their own, without a network."""
from __future__ import annotations

import os
from typing import Any, List

import FreeCADGui
from PySide import QtCore, QtGui

from advlayers.language import tr
from advlayers_gui.resources import ROOT

_DOCS = os.path.join(ROOT, "docs")
_PAGES = ("tutorial.md", "settings.md", "method.md", "compare.md", "downstream.md", "python.md",
          "trust.md")
_open: List[Any] = []  # one at most; Qt would delete it with the last name that Python has for it


def show(page: str = _PAGES[0]) -> None:
    if not _open:
        _open.append(HelpWindow())
    window = _open[0]
    window.turn_to(page)
    window.show()
    window.raise_()


def titles() -> List[str]:
    """In the order of the pages, in the user's language."""
    return [tr("First steps"), tr("Settings"), tr("Method"), tr("Beside other meshers"),
            tr("Solvers and file formats"), tr("Python"), tr("What is checked")]


class HelpWindow(QtGui.QDialog):
    def __init__(self) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.setObjectName("AdvLayersHelp")
        self.setWindowTitle(tr("Help on Advancing Layers"))
        self.resize(860, 640)
        self._pages = QtGui.QListWidget()
        self._pages.addItems(titles())
        self._pages.setMaximumWidth(210)
        self._text = QtGui.QTextBrowser()
        self._text.setObjectName("AdvLayersHelpText")
        self._text.setOpenExternalLinks(True)
        layout = QtGui.QHBoxLayout(self)
        layout.addWidget(self._pages)
        layout.addWidget(self._text, 1)
        self._pages.currentRowChanged.connect(lambda row: self._read(_PAGES[row]))
        self._text.sourceChanged.connect(self._turned)

    def turn_to(self, page: str) -> None:
        self._pages.setCurrentRow(_PAGES.index(page))

    def _read(self, page: str) -> None:
        if os.path.basename(self._text.source().path()) != page:
            self._text.setSource(QtCore.QUrl.fromLocalFile(os.path.join(_DOCS, page)))

    def _turned(self, url) -> None:
        """By a link within a page."""
        page = os.path.basename(url.path())
        if page in _PAGES:
            self.turn_to(page)

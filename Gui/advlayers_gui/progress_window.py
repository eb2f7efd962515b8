"""A small window that shows how a run goes on, and can stop it."""
from __future__ import annotations

import contextlib
import time
from typing import Any, Iterator, List

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from advlayers.errors import Stopped
from advlayers.language import tr
from advlayers.layer_mesh import window_watch
from advlayers_gui.command import TITLE

_DELAY = 500  # [ms] that a run may take without the window


def make_window(label: str, modality):
    """Comes up by itself when the run takes longer than a moment."""
    window = QtGui.QProgressDialog(FreeCADGui.getMainWindow())
    window.setWindowTitle(TITLE)
    window.setLabelText(label)
    window.setCancelButtonText(tr("Stop"))
    window.setWindowModality(modality)
    window.setMinimumDuration(_DELAY)
    window.setValue(0)  # the delay begins; without it Qt waits for four seconds
    window.setRange(0, 0)
    window.setAttribute(QtCore.Qt.WA_ShowWithoutActivating)
    return window


@contextlib.contextmanager
def shown_progress(mesh_object) -> Iterator[None]:
    """While the block runs, layer_mesh.update() shows its progress. Raises Stopped where the user
    stops it, or closes the document."""
    window = make_window(mesh_object.Label, QtCore.Qt.ApplicationModal)
    token = window_watch.set(_Watch(window, mesh_object))
    try:
        yield
    finally:
        window_watch.reset(token)
        window.close()
        window.deleteLater()


class _Watch:
    def __init__(self, window, mesh_object) -> None:
        self._window, self._label = window, mesh_object.Label
        self._document = mesh_object.Document.Name
        self._start = time.monotonic()
        self._layers = self._elements = 0

    def __call__(self, reports: List[Any]) -> None:
        self._layers = max([self._layers] + [report.layer for report in reports])
        self._elements += sum(report.quads + report.triangles for report in reports)
        seconds = f"{time.monotonic() - self._start:.1f}"
        text = tr("{label}: layer {layer}, {elements} elements, {seconds} s") if self._elements \
            else tr("{label}: {seconds} s")
        self._window.setLabelText(text.format(
            label=self._label, layer=self._layers, elements=self._elements, seconds=seconds))
        QtCore.QCoreApplication.processEvents()
        if self._window.wasCanceled() or self._document not in FreeCAD.listDocuments():
            raise Stopped()

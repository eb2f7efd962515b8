"""Meshes that update themselves: a recompute asks for the run, which begins once it is over and
goes on beside the window. FreeCAD may crash where a window lives on within a recompute."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import FreeCAD
from PySide import QtCore

from advlayers import layer_mesh
from advlayers_gui.mesh_task import MeshTask, Outcome, Progress
from advlayers_gui.progress_window import make_window
from advlayers_gui.run_box import status_text

_Key = Tuple[str, str]  # names of document and object
_updates: Dict[_Key, "_Update"] = {}  # asked for or under way


def ask(mesh_object, task: layer_mesh.Task) -> None:
    """Takes the place of an update of the same mesh that is under way."""
    key = (mesh_object.Document.Name, mesh_object.Name)
    if key in _updates:
        _updates[key].leave()
    _updates[key] = _Update(key, mesh_object, task)


def under_way(mesh_object) -> bool:
    return (mesh_object.Document.Name, mesh_object.Name) in _updates


class _Update:
    """Given up without a word where the mesh has gone, is edited in its panel, or is not to update
    itself any more; begun anew where shape or settings have changed meanwhile."""

    def __init__(self, key: _Key, mesh_object, task: layer_mesh.Task) -> None:
        self._key, self._object, self._asked = key, mesh_object, task
        self._label = mesh_object.Label
        self._task: Optional[MeshTask] = None
        self._window: Any = None
        self._after_recompute = QtCore.QTimer()
        self._after_recompute.setSingleShot(True)
        self._after_recompute.timeout.connect(self._start)
        self._after_recompute.start(0)

    def leave(self) -> None:
        self._after_recompute.stop()
        _updates.pop(self._key, None)
        if self._task is not None:
            self._task.abandon()
        if self._window is not None:
            self._window.canceled.disconnect(self._stop)
            self._window.close()
            self._window.deleteLater()
            self._window = None

    def _start(self) -> None:
        if not self._wanted():
            self.leave()
            return
        self._task = MeshTask(self._asked, self._progressed, self._done, self._failed, self.leave)
        self._window = make_window(self._label, QtCore.Qt.NonModal)
        self._window.canceled.connect(self._stop)
        self._task.start()

    def _wanted(self) -> bool:
        document, name = self._key
        if document not in FreeCAD.listDocuments() \
                or FreeCAD.getDocument(document).getObject(name) is not self._object:
            return False
        return self._object.AutoUpdate and self._object.ViewObject.Proxy.panel is None

    def _stop(self) -> None:
        if self._task is not None:
            self._task.stop()

    def _progressed(self, progress: Progress) -> None:
        if self._wanted():
            self._window.setLabelText(f"{self._label}\n{status_text(progress)}")
        else:
            self.leave()

    def _done(self, outcome: Outcome) -> None:
        wanted, mesh_object = self._wanted(), self._object
        self.leave()
        if not wanted:
            return
        if layer_mesh.fits(mesh_object, outcome.task.made_from):
            outcome.store(mesh_object)
        else:
            mesh_object.touch()
        mesh_object.Document.recompute()

    def _failed(self, reason: str) -> None:
        self.leave()
        FreeCAD.Console.PrintError(f"Advancing Layers: {self._label}: {reason}\n")

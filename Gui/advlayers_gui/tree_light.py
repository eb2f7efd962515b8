"""A wall, a size or a group that is selected in the tree lights up on its shape."""
from __future__ import annotations

import contextlib
from typing import Any, List

import FreeCAD
import FreeCADGui
from PySide import QtCore

from advlayers import cad_input, controls
from advlayers.edge_outlines import outlines_of
from advlayers_gui.conditions_view import ConditionsView
from advlayers_gui.control_editor import references_of
from advlayers_gui.view_3d import Overlay

_kept: List[Any] = []  # FreeCAD does not keep its observers


def watch() -> None:
    if not _kept:
        _kept.append(TreeLight())
        FreeCADGui.Selection.addObserver(_kept[0])


class TreeLight:
    def __init__(self) -> None:
        self.lines: List[Any] = []  # lit
        self._view, self._overlay = ConditionsView(), None
        # In a turn of its own: many may be selected at once.
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._show)

    def _soon(self) -> None:
        self._timer.start(0)

    def _show(self) -> None:
        if self._overlay is not None:
            with contextlib.suppress(RuntimeError):  # the view was closed
                self._overlay.remove()
            self._overlay, self.lines = None, []
        self._view.clear()
        if FreeCAD.ActiveDocument is None or FreeCADGui.Control.activeDialog():
            return  # a panel shows its own
        for entry in FreeCADGui.Selection.getSelection():
            if controls.is_control(entry):
                self.lines += _lines_of(entry)
        if self.lines:
            self._view.light(self.lines)
            self._overlay = Overlay(FreeCAD.ActiveDocument, self._view.root)

    # --- what FreeCAD calls -------------------------------------------------------------------

    def addSelection(self, _document, _object, _sub, _point) -> None:
        self._soon()

    def removeSelection(self, _document, _object, _sub) -> None:
        self._soon()

    def setSelection(self, _document) -> None:
        self._soon()

    def clearSelection(self, _document) -> None:
        self._soon()


def _lines_of(control) -> List[Any]:
    mesh = controls.mesh_of(control)
    if mesh is None or mesh.Part is None:
        return []
    return outlines_of(cad_input.global_shape(mesh.Part), references_of(control, mesh.Part))

"""Display modes of a layer mesh that colour its elements: by layer, by quality, and so on.

FreeCAD's own element colours take time with the square of the elements; these take it in
proportion, and piece by piece.
"""
from __future__ import annotations

import contextlib
from typing import Generator, Optional

from PySide import QtCore

from advlayers import mesh_data
from advlayers.mesh_data import FIELDS, MeshData
from advlayers_gui.field_scene import FieldScene
from advlayers_gui.turns import Turns


class FieldModes:
    """The scene that all the modes share; it is filled when one of them is first asked for."""

    def __init__(self, view_object) -> None:
        self._object = view_object.Object
        self._scene = FieldScene()
        self._data: Optional[MeshData] = None
        self._reading = Turns()
        self._shown = ""
        self._redraw = QtCore.QTimer()
        self._redraw.setSingleShot(True)
        self._redraw.timeout.connect(self._draw_again)
        for name in FIELDS:
            view_object.addDisplayMode(self._scene.root, name)

    @property
    def element_count(self) -> int:
        """Elements shown at this moment."""
        return self._scene.element_count

    @property
    def busy(self) -> bool:
        """Whether some of them are still to be shown."""
        return self._scene.busy or self._reading.busy or self._redraw.isActive()

    def show(self, mode: str) -> None:
        """Another mode of the view: FreeCAD's own ones need nothing of this scene."""
        self._shown = mode if mode in FIELDS else ""
        if not self._shown:
            return
        if self._data is not None:
            self._scene.show(self._data, mode)
        elif not self._reading.busy:
            self._reading.start(self._read())

    def forget(self) -> None:
        """The object has another mesh. It is drawn once the change is complete: the properties
        that go with the mesh are set one after the other."""
        self._data = None
        self._reading.stop()
        if self._shown:
            self._redraw.start()

    def _draw_again(self) -> None:
        self.show(self._shown)

    def _read(self) -> Generator[None, None, None]:
        with contextlib.suppress(ReferenceError):  # its document was closed meanwhile
            self._data = yield from mesh_data.reading(self._object)
            self.show(self._shown)


class FieldView:
    """The part of a view provider that FreeCAD asks about display modes."""

    modes: Optional[FieldModes] = None

    def attach(self, view_object) -> None:
        self.modes = FieldModes(view_object)

    def getDisplayModes(self, _view_object):
        return list(FIELDS)

    def setDisplayMode(self, mode: str) -> str:
        if self.modes is not None:
            self.modes.show(mode)
        return mode

    def updateData(self, _mesh_object, name: str) -> None:
        if self.modes is not None and name in ("FemMesh", "MeshId", "HeightErrors", "Details"):
            self.modes.forget()

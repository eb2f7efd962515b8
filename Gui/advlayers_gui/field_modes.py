"""Display modes of a layer mesh that colour its elements: by layer, by quality, and so on.

FreeCAD's own element colours take time with the square of the elements; these take it in
proportion, and piece by piece.
"""
from __future__ import annotations

import json
from typing import Any, Dict, List, Optional, Tuple

import numpy as np
from pivy import coin
from PySide import QtCore

from advlayers import element_mesh
from advlayers.element_mesh import ElementMesh
from advlayers_gui import colours
from advlayers_gui.legend import Legend
from advlayers_gui.mesh_drawing import MeshDrawing, pieces_of

LAYERS, QUALITY, ASPECT, HEIGHT, DIAGNOSTICS = MODES = (
    "Layers", "Quality", "Aspect Ratio", "Height Error", "Diagnostics")
# Below this an element shows among the diagnostics; a corner is some 25 or 155 degrees then.
POOR_QUALITY = 0.3

_SEVERITY_COLOURS = {"error": (0.80, 0.05, 0.10), "warning": (0.95, 0.55, 0.05),
                     "info": (0.15, 0.45, 0.75)}


class FieldModes:
    """The scene that all the modes share; it is filled when one of them is first asked for."""

    def __init__(self, view_object) -> None:
        self._object = view_object.Object
        self._drawing, self._legend, self._marks = MeshDrawing(), Legend(), coin.SoSeparator()
        self._mesh: Optional[ElementMesh] = None
        self._fields: Dict[str, Any] = {}
        self._shown = ""
        self._redraw = QtCore.QTimer()
        self._redraw.setSingleShot(True)
        self._redraw.timeout.connect(self._draw_again)
        root = coin.SoSeparator()
        for node in (self._drawing.root, self._marks, self._legend.root):
            root.addChild(node)
        for name in MODES:
            view_object.addDisplayMode(root, name)

    @property
    def element_count(self) -> int:
        """Elements shown at this moment."""
        return self._drawing.element_count

    @property
    def busy(self) -> bool:
        return self._drawing.busy

    def show(self, mode: str) -> None:
        """Another mode of the view: FreeCAD's own ones need nothing of this scene."""
        self._shown = mode if mode in MODES else ""
        if not self._shown:
            return
        if self._mesh is None:
            self._mesh = element_mesh.of_fem(self._object.FemMesh)
        self._paint()

    def forget(self) -> None:
        """The object has another mesh. It is drawn once the change is complete: the properties
        that go with the mesh are set one after the other."""
        self._mesh = None
        self._fields.clear()
        if self._shown:
            self._redraw.start()

    def _draw_again(self) -> None:
        self.show(self._shown)

    def field(self, mode: str):
        """The values of one mode, by element."""
        if mode not in self._fields:
            self._fields[mode] = self._values(mode)
        return self._fields[mode]

    def _values(self, mode: str):
        if mode == LAYERS:
            return np.where(self._mesh.layers > 0, self._mesh.layers, np.nan)
        if mode == ASPECT:
            return element_mesh.aspect_ratio(self._mesh)
        if mode == HEIGHT:
            errors = np.array(self._object.HeightErrors)
            known = len(errors) == self._mesh.count
            return 100.0 * errors if known else np.full(self._mesh.count, np.nan)
        return element_mesh.quality(self._mesh)

    def _scale(self, mode: str, values) -> colours.Scale:
        if mode == LAYERS:
            return colours.layer_scale(int(np.nanmax(values, initial=1.0)))
        if mode == ASPECT:
            return colours.aspect_scale(np.max(values, initial=2.0))
        return colours.height_scale() if mode == HEIGHT else colours.quality_scale()

    def _paint(self) -> None:
        values = self.field(self._shown)
        scale = self._scale(self._shown, values)
        if self._shown == DIAGNOSTICS:
            values = np.where(values < POOR_QUALITY, values, np.nan)
        self._drawing.show(pieces_of(self._mesh, colours.packed(scale.rgb(values))))
        self._legend.show(scale)
        self._marks.removeAllChildren()
        if self._shown == DIAGNOSTICS:
            self._mark()

    def _mark(self) -> None:
        for severity, points in _places(self._object).items():
            self._marks.addChild(markers(points, _SEVERITY_COLOURS[severity]))


class FieldView:
    """The part of a view provider that FreeCAD asks about display modes."""

    modes: Optional[FieldModes] = None

    def attach(self, view_object) -> None:
        self.modes = FieldModes(view_object)

    def getDisplayModes(self, _view_object):
        return list(MODES)

    def setDisplayMode(self, mode: str) -> str:
        if self.modes is not None:
            self.modes.show(mode)
        return mode

    def updateData(self, _mesh_object, name: str) -> None:
        if self.modes is not None and name in ("FemMesh", "HeightErrors", "Details"):
            self.modes.forget()


def _places(mesh_object) -> Dict[str, List[Tuple[float, float, float]]]:
    """Where the report of the mesh points at, by severity."""
    found: Dict[str, List[Tuple[float, float, float]]] = {}
    if mesh_object.Details:
        for entry in json.loads(mesh_object.Details)["diagnostics"]:
            if entry["point"] and any(entry["point"]):
                found.setdefault(entry["severity"], []).append(tuple(entry["point"]))
    return found


def markers(points, colour):
    """Round marks on the points, the same size from any distance, never hidden."""
    separator = coin.SoAnnotation()
    paint = coin.SoBaseColor()
    paint.rgb = colour
    flat = coin.SoLightModel()
    flat.model = coin.SoLightModel.BASE_COLOR
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), [tuple(point) for point in points])
    marks = coin.SoMarkerSet()
    marks.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_9_9
    for node in (flat, paint, coordinates, marks):
        separator.addChild(node)
    return separator

"""A mesh in the 3D view, coloured by one of its fields, with a legend and marks."""
from __future__ import annotations

from typing import Any, Iterable, Iterator

import numpy as np
from pivy import coin

from advlayers.element_mesh import ElementMesh
from advlayers.mesh_data import ASPECT, DIAGNOSTICS, HEIGHT, LAYERS, MeshData
from advlayers_gui import colours
from advlayers_gui.legend import Legend
from advlayers_gui.mesh_drawing import MeshDrawing, Piece, pieces_of
from advlayers_gui.view_box import ViewOptions

MARK_COLOUR = (0.85, 0.10, 0.15)
_SEVERITY_COLOURS = {"error": (0.80, 0.05, 0.10), "warning": (0.95, 0.55, 0.05),
                     "info": (0.15, 0.45, 0.75)}


class FieldScene:
    def __init__(self) -> None:
        self._drawing, self._legend, self._marks = MeshDrawing(), Legend(), coin.SoSeparator()
        self.options, self._extent = ViewOptions(), None
        self.root = coin.SoSeparator()
        for node in (self._drawing.root, self._marks, self._legend.root):
            self.root.addChild(node)

    @property
    def element_count(self) -> int:
        """Elements shown at this moment."""
        return self._drawing.element_count

    @property
    def layer_element_count(self) -> int:
        """Those of them that are not of the core."""
        return self._drawing.layer_element_count

    def clear(self) -> None:
        self._drawing.clear()
        self._legend.hide()
        self._marks.removeAllChildren()

    @property
    def busy(self) -> bool:
        """Whether some of the elements are still to be shown."""
        return self._drawing.busy

    def grow(self, pieces: Iterable[Piece]) -> None:
        """Shows a mesh that still grows."""
        self._drawing.show(iter(pieces))

    def set_options(self, options: ViewOptions) -> None:
        """How it is to be looked at; the colours follow with the next show()."""
        self.options = options
        self._drawing.draw_edges(options.edges)
        self._cut()

    def _cut(self) -> None:
        axis = self.options.cut_axis if self._extent is not None else -1
        low, high = self._extent if axis >= 0 else (None, None)
        self._drawing.cut(axis, 0.0 if axis < 0 else float(
            low[axis] + self.options.cut_share * (high[axis] - low[axis])))

    def show(self, data: MeshData, field: str) -> colours.Scale:
        values = data.field(field)
        scale = _scale(field, values).ranged(self.options.span, self.options.logarithmic)
        if data.mesh.count:
            self._extent = data.mesh.nodes.min(axis=0), data.mesh.nodes.max(axis=0)
        self._cut()
        self._drawing.show(pieces_of(data.mesh, colours.packed(scale.rgb(values))))
        self._legend.show(scale)
        self._marks.removeAllChildren()
        if field == DIAGNOSTICS:
            for severity, points in data.diagnostic_points().items():
                self._marks.addChild(markers(points, _SEVERITY_COLOURS[severity]))
        return scale


def growing_pieces(mesh: ElementMesh) -> Iterator[Piece]:
    """A mesh that still grows, by layer; may run in any thread."""
    highest = int(np.max(mesh.layers, initial=1))
    return pieces_of(mesh, colours.layer_colours(mesh.layers, highest))


def _scale(field: str, values) -> colours.Scale:
    highest = float(np.max(values, where=np.isfinite(values), initial=2.0))
    if field == LAYERS:
        return colours.layer_scale(int(highest))
    if field == ASPECT:
        return colours.aspect_scale(highest)
    return colours.height_scale() if field == HEIGHT else colours.quality_scale()


def markers(points, colour) -> Any:
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

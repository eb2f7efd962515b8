"""What the settings of a layer mesh ask for, drawn on its shape: conditions of edges and heights of
layers. Found in turns of the event loop; the next change begins anew."""
from __future__ import annotations

from typing import Any, Callable, Iterator, List, Mapping, Optional

from advlayers import cad_input
from advlayers.edge_outlines import EdgeOutlines
from advlayers.errors import CoreMissing, InputError
from advlayers.freecad_versions import global_placement
from advlayers.height_lines import WallLines, face_by_face
from advlayers.layer_mesh import settings_of
from advlayers.sentence import of_error
from advlayers_gui.conditions_view import ConditionsView
from advlayers_gui.height_preview import HeightPreview
from advlayers_gui.turns import Turns


class SettingsPreview:
    """`on_drawn` gets what is wrong with the walls, or an empty text."""

    def __init__(self, on_drawn: Callable[[str], None]) -> None:
        self._on_drawn = on_drawn
        self.heights, self.conditions = HeightPreview(), ConditionsView()
        self.lit: Callable[[], List[str]] = list  # names of what is to stand out
        # What the outlines are of, as it is in the document, and where it stands.
        self._shape = self._origin = self._placement = None
        self._outlines: Optional[EdgeOutlines] = None
        self._turns = Turns()

    @property
    def roots(self) -> List[Any]:
        return [self.heights.root, self.conditions.root]

    @property
    def busy(self) -> bool:
        return self._turns.busy

    def show(self, mesh_object) -> str:
        """Returns what is wrong with the settings; then nothing is drawn."""
        self._turns.stop()
        if mesh_object is None or mesh_object.Part is None:
            self.clear()
            return ""
        try:
            settings = settings_of(mesh_object)
        except InputError as error:
            self.clear()
            return error.sentence.translated
        self._turns.start(self._draw(mesh_object.Part, settings), self._on_drawn)
        return ""

    def hide(self) -> None:
        for view in (self.heights, self.conditions):
            view.hide()

    def unhide(self) -> None:
        for view in (self.heights, self.conditions):
            view.unhide()

    def clear(self) -> None:
        self._turns.stop()
        for view in (self.heights, self.conditions):
            view.clear()

    def _draw(self, source, settings: Mapping[str, Any]) -> Iterator[None]:
        import Part

        origin, placement = Part.getShape(source), global_placement(source)
        if self._outlines is None or not origin.isPartner(self._origin) \
                or placement != self._placement:
            self._shape = cad_input.global_shape(source)
            outlines = EdgeOutlines(self._shape)
            yield from outlines.steps()
            self._outlines, self._origin, self._placement = outlines, origin, placement
        shape = self._shape
        walls: List[WallLines] = []
        wrong = ""
        try:
            for lines in face_by_face(shape, settings, self._outlines.smooth(settings)):
                walls += lines
                yield
        except (ValueError, CoreMissing) as error:  # a wall that contradicts itself
            walls, wrong = [], of_error(error).translated
        self.heights.show(walls)
        yield
        self.conditions.show(self._outlines, settings, walls, shape.BoundBox.DiagonalLength)
        self.conditions.light(self._outlines.of(self.lit()))
        return wrong

"""A menu that selects edges and faces by what they have in common."""
from __future__ import annotations

from typing import Any, Callable, List, Mapping

from PySide import QtGui

from advlayers import cad_input
from advlayers.edge_sets import EdgeSets
from advlayers.errors import CoreMissing
from advlayers.language import tr
from advlayers.sentence import of_error
from advlayers.lengths import length_text
from advlayers_gui.picking import PickSession

_MOST_DIAMETERS = 12  # that the menu lists


class PickMenu:
    """`groups` gives named lists of faces and edges. What belongs to the shape is looked up when
    the menu opens: the shape may have changed."""

    def __init__(self, source, picks: PickSession, groups: Callable[[], Mapping[str, List[str]]],
                 on_refused: Callable[[str], None]) -> None:
        self._source, self._picks, self._groups = source, picks, groups
        self._on_refused = on_refused
        self._sets: Any = None
        self.button = QtGui.QToolButton()
        self.button.setObjectName("AdvLayersPickMenu")
        self.button.setText(tr("Select"))
        self.button.setToolTip(tr("Selects holes, sharp edges, similar edges, groups"))
        self.button.setPopupMode(QtGui.QToolButton.InstantPopup)
        self._menu = QtGui.QMenu(self.button)
        self._menu.aboutToShow.connect(self.fill)
        self.button.setMenu(self._menu)

    def fill(self) -> None:
        """Offers what there is to select now."""
        self._menu.clear()
        self._sets = EdgeSets(cad_input.global_shape(self._source))
        self._offer("Holes", tr("All holes"), lambda: self._sets.feature("holes"))
        self._offer_diameters()
        self._offer("InnerLoops", tr("Inner loops of the selected faces, or of all"),
                    lambda: self._sets.inner_loops(self._selected("Face")))
        self._offer("Sharp", tr("Sharp edges"), lambda: self._sets.feature("sharp"))
        self._menu.addSeparator()
        self._offer("SimilarLength", tr("Edges as long as the selected ones"),
                    lambda: self._sets.similar_length(self._selected("Edge")))
        self._offer("SimilarRadius", tr("Arcs with the radius of the selected ones"),
                    lambda: self._sets.similar_radius(self._selected("Edge")))
        self._offer("Invert", tr("All that are not selected"),
                    lambda: self._sets.inverted(self._picks.names()))
        groups = self._groups()
        if groups:
            menu = self._menu.addMenu(tr("By group"))
            for name, names in groups.items():
                self._add(menu, f"Group_{name}", name, lambda names=names: names)

    def _offer_diameters(self) -> None:
        try:
            diameters = self._sets.hole_diameters()
        except (ValueError, RuntimeError, CoreMissing) as error:
            self._on_refused(of_error(error).translated)
            return
        if len(diameters) > 1:
            menu = self._menu.addMenu(tr("Holes by diameter"))
            for diameter, count in diameters[:_MOST_DIAMETERS]:
                self._add(menu, f"Hole{len(menu.actions())}",
                          f"⌀ {length_text(diameter)}  ({count})",
                          lambda diameter=diameter: self._sets.holes_of(diameter))

    def _offer(self, name: str, text: str, find: Callable[[], List[str]]) -> None:
        self._add(self._menu, name, text, find)

    def _add(self, menu, name: str, text: str, find: Callable[[], List[str]]) -> None:
        action = menu.addAction(text)
        action.setObjectName(f"AdvLayersPick_{name}")
        action.triggered.connect(lambda _checked=False: self._select(find))

    def _select(self, find: Callable[[], List[str]]) -> None:
        try:
            found = find()
        except (ValueError, RuntimeError, CoreMissing) as error:
            self._on_refused(of_error(error).translated)
            return
        if found:
            self._picks.select(found)
        else:
            self._on_refused(tr("{} has none of these").format(self._source.Label))

    def _selected(self, kind: str) -> List[str]:
        return [name for name in self._picks.names() if name.startswith(kind)]

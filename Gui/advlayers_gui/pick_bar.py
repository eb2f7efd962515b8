"""What is selected in the 3D view, and buttons that select what belongs to it."""
from __future__ import annotations

from typing import Callable, List, Mapping, Optional, Tuple

from PySide import QtGui

from advlayers import cad_input
from advlayers.edge_chains import EdgeChains
from advlayers.language import tr
from advlayers_gui.pick_menu import PickMenu
from advlayers_gui.picking import PickSession
from advlayers_gui.reference_list import tool_button

_THROUGH = 70  # [%]


class PickBar:
    """`groups` gives named lists of faces and edges to select by."""

    def __init__(self, source, kinds: Tuple[str, ...], on_refused: Callable[[str], None],
                 groups: Callable[[], Mapping[str, List[str]]]) -> None:
        self._source, self._on_refused = source, on_refused
        self._transparency: Optional[int] = None  # of the shape, while one sees through it
        self._nothing = tr("Select faces, edges and vertices in the 3D view.") \
            if "Vertex" in kinds else tr("Select faces and edges in the 3D view.")
        self.picks = PickSession(source, kinds, self._selection_changed, on_refused)
        self.widget = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(self.widget)
        layout.setContentsMargins(0, 0, 0, 0)
        self._label = QtGui.QLabel()
        self._label.setObjectName("AdvLayersSelected")
        self._label.setWordWrap(True)
        layout.addWidget(self._label)
        row = QtGui.QHBoxLayout()
        layout.addLayout(row)
        for name, text, doc, act in (
                ("Tangent", tr("Tangent"),
                 tr("Selects the edges that go on from the selected ones without a corner"),
                 self._tangent),
                ("Loop", tr("Loop"),
                 tr("Selects the whole loop of the selected edges; with a face selected too, "
                    "that on the face"), self._loop),
                ("FaceEdges", tr("Face edges"),
                 tr("Selects all edges of the selected faces"),
                 self._of_faces)):
            button = tool_button(text, doc, act)
            button.setObjectName(f"AdvLayersPick{name}")
            row.addWidget(button)
        row.addStretch()
        row = QtGui.QHBoxLayout()  # one would be wider than the panel
        layout.addLayout(row)
        self._menu = PickMenu(source, self.picks, groups, on_refused)
        row.addWidget(self._menu.button)
        row.addWidget(self._see_through())
        row.addStretch()
        self._selection_changed()

    def _selection_changed(self) -> None:
        names = self.picks.names()
        shown = ", ".join(names[:8]) + (" …" if len(names) > 8 else "")
        self._label.setText(
            tr("Selected: {}").format(shown) if names else self._nothing)

    def _see_through(self):
        """For edges behind faces."""
        button = tool_button(tr("See through"), tr("Shows what is behind the faces"), lambda: None)
        button.setObjectName("AdvLayersSeeThrough")
        button.setCheckable(True)
        button.toggled.connect(self._set_through)
        return button

    def _set_through(self, on: bool) -> None:
        view = self._source.ViewObject
        if on:
            self._transparency = view.Transparency
            view.Transparency = max(_THROUGH, view.Transparency)
        elif self._transparency is not None:
            view.Transparency, self._transparency = self._transparency, None

    def end(self) -> None:
        """The panel is left."""
        self.picks.end()
        self._set_through(False)

    def _chains(self) -> EdgeChains:
        return EdgeChains(cad_input.global_shape(self._source))

    def _picked(self, kind: str) -> List[str]:
        names = [name for name in self.picks.names() if name.startswith(kind)]
        if not names:
            wanted = tr("an edge") if kind == "Edge" \
                else tr("a face")
            self._on_refused(tr("select {} first").format(wanted))
        return names

    def _tangent(self) -> None:
        edges = self._picked("Edge")
        if edges:
            self.picks.select(self._chains().tangent(edges))

    def _loop(self) -> None:
        edges = self._picked("Edge")
        if edges:
            faces = [name for name in self.picks.names() if name.startswith("Face")]
            self.picks.select(self._chains().loop(edges, faces))

    def _of_faces(self) -> None:
        faces = self._picked("Face")
        if faces:
            self.picks.select(self._chains().of_faces(faces))

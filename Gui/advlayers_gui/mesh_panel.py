"""The task panel of a layer mesh: what to mesh and how, the mesh as it grows, and what came out."""
from __future__ import annotations

import contextlib
from typing import Any, Callable, Dict, Iterator, List, Optional

import FreeCAD
from pivy import coin
from PySide import QtCore, QtGui

from advlayers import check, controls, hints, layer_mesh, mesh_data
from advlayers.element_mesh import ElementMesh
from advlayers.errors import InputError
from advlayers.language import tr, tr_doc
from advlayers.mesh_data import MeshData, Place
from advlayers.mesh_properties import property_settings
from advlayers.settings_table import setting
from advlayers.sentence import Sentence
from advlayers_gui import view_provider
from advlayers_gui.control_editor import groups_of
from advlayers_gui.control_table import ControlTable
from advlayers_gui.field_scene import MARK_COLOUR, FieldScene, growing_pieces, markers
from advlayers_gui.flow_box import FlowBox
from advlayers_gui.mesh_task import Canvas, Outcome
from advlayers_gui.pick_bar import PickBar
from advlayers_gui.reference_list import ReferenceList
from advlayers_gui.results_page import ResultsPage
from advlayers_gui.run_box import RunBox, state_text
from advlayers_gui.setting_fields import SettingsForm
from advlayers_gui.task_panel import TaskPanel
from advlayers_gui.turns import Turns
from advlayers_gui.view_box import ViewOptions
from advlayers_gui.view_3d import Overlay, look_at

# The settings asked for most, in this order; the others stand under Advanced.
_FIRST = ("size", "first_height", "growth", "layers")
_RESULTS_TAB = 2
_TITLE_WIDTH = 190  # [pixels] that fit into the panel at its narrowest


class _Canvas(Canvas):
    """The panel's scene; it takes the place of the shape with the first picture."""

    def __init__(self, scene: FieldScene, before_drawing: Callable[[], None]) -> None:
        self._scene, self._before_drawing = scene, before_drawing

    @property
    def busy(self) -> bool:
        return self._scene.busy

    @staticmethod
    def prepare(mesh: ElementMesh):
        return growing_pieces(mesh)

    def draw(self, picture) -> None:
        self._before_drawing()
        self._scene.grow(picture)


@contextlib.contextmanager
def _busy_pointer() -> Iterator[None]:
    """FreeCAD copies a mesh at one go: some 0.1 s per 100 000 elements."""
    QtGui.QApplication.setOverrideCursor(QtGui.QCursor(QtCore.Qt.WaitCursor))
    try:
        yield
    finally:
        QtGui.QApplication.restoreOverrideCursor()


class MeshPanel(TaskPanel):
    """A finished mesh goes to the document with OK: until then the panel has it, and shows it."""

    TITLE = "Edit Layer Mesh"

    def __init__(self, mesh_object) -> None:
        super().__init__(mesh_object)
        self._outcome: Optional[Outcome] = None
        self._data: Optional[MeshData] = None
        self._close_when_done = False
        self._scene, self._mark = FieldScene(), coin.SoSeparator()
        self._overlays += [Overlay(mesh_object.Document, node)
                           for node in (self._scene.root, self._mark)]
        self._remember_visibility(mesh_object.Part, mesh_object)
        self._reading = Turns()
        self._build()
        self._results.show(None, check.of_object(mesh_object))
        self._pick_bar.picks.begin()
        self._show_shape()
        # The window shows the panel first.
        QtCore.QTimer.singleShot(0, self._begin)
        if mesh_object.FemMesh.NodeCount:
            self._reading.start(mesh_data.reading(mesh_object), self._have_read)

    def _begin(self) -> None:
        if not self._left:
            self._look_at(self._object.Part)
            self._changed()

    @property
    def scene(self) -> FieldScene:
        """What the panel shows in the 3D view."""
        return self._scene

    @property
    def meshing(self) -> bool:
        return self._run.running

    def show_results(self) -> None:
        self._tabs.setCurrentIndex(_RESULTS_TAB)

    # --- what FreeCAD calls -------------------------------------------------------------------

    def modifyStandardButtons(self, box) -> None:
        box.button(QtGui.QDialogButtonBox.Ok).setToolTip(
            tr("Meshes what is out of date, puts the mesh into the document and closes"))

    def accept(self) -> bool:
        """Meshes what is out of date, then closes."""
        if self._run.running:
            self._close_when_done = True
            return False
        if not self._stored():
            return False
        if self._out_of_date():
            self._close_when_done = self._run.start()
            return False
        return self._hand_over()

    def at_stake(self) -> str:
        if self._outcome is not None:
            return tr("The finished mesh is not in the document yet.")
        if self._run.running:
            return tr("The mesher is still at work.")
        return super().at_stake()

    def leave_unasked(self) -> None:
        """With a finished mesh in the document, where nobody could be asked."""
        super().leave_unasked()
        document = FreeCAD.listDocuments().get(self._document_name)
        if self._outcome is None or document is None or document.Transacting:
            return
        mesh_object = document.getObject(self._object_name)
        if mesh_object is not None:
            self._outcome.store(mesh_object)
            self._outcome = None
            FreeCAD.Console.PrintWarning(tr(
                "{}: the panel was closed from outside; its finished mesh was kept.").format(
                    mesh_object.Label) + "\n")

    def _keep(self) -> None:
        if self._stored():
            self._hand_over()

    def _discard(self) -> None:
        self._outcome = None
        super()._discard()

    def _take_over(self, other: MeshPanel) -> None:
        super()._take_over(other)
        if other._outcome is not None:
            self._done(other._outcome)

    def _reload(self) -> None:
        for form in self._forms:
            form.load()
        self._table.load()
        self._faces.show(self._object.Faces)
        for name, box in self._flags.items():
            box.blockSignals(True)
            box.setChecked(getattr(self._object, name))
            box.blockSignals(False)
        self._changed()

    def _stored(self) -> bool:
        """Whether what the fields say makes sense, and is in the properties now."""
        try:
            self._store()
        except InputError as error:
            self._run.fail(error.sentence.translated)
            return False
        return True

    def _out_of_date(self) -> bool:
        if self._outcome is not None:
            return not layer_mesh.fits(self._object, self._outcome.task.made_from)
        layer_mesh.refresh_state(self._object)
        return self._object.State != layer_mesh.UP_TO_DATE

    def _hand_over(self) -> bool:
        """Puts the finished mesh into the document, and closes."""
        outcome, self._outcome = self._outcome, None
        if outcome is not None:
            with _busy_pointer():
                outcome.store(self._object)
        self.leave()
        if outcome is not None:
            self._object.ViewObject.DisplayMode = self._results.field
        if self._object.AutoUpdate:
            self._object.touch()
        if self._object.FemMesh.NodeCount:
            view_provider.show_mesh(self._object)
        return super().accept()

    def _clean_up(self) -> None:
        self._run.abandon()
        self._reading.stop()
        self._scene.clear()
        self._pick_bar.end()
        for form in self._forms:
            form.release()
        self._table.release()
        self._flow.release()

    # --- the form -----------------------------------------------------------------------------

    def _build(self) -> None:
        self.form.setWindowTitle(tr("Layer Mesh"))
        layout = QtGui.QVBoxLayout(self.form)
        layout.setContentsMargins(4, 4, 4, 4)
        self._run = RunBox(self._object, self._store,
                           _Canvas(self._scene, self._make_room), self._done, self._ended)
        self._pick_bar = PickBar(self._object.Part, controls.Size.KINDS, self._run.say,
                                 lambda: groups_of(self._object))
        self._forms: List[SettingsForm] = []
        self._flags: Dict[str, Any] = {}
        self._tabs = QtGui.QTabWidget()
        self._tabs.setObjectName("AdvLayersTabs")
        self._tabs.setUsesScrollButtons(False)
        self._tabs.setElideMode(QtCore.Qt.ElideRight)
        self._tabs.addTab(self._settings_tab(), tr("General"))
        self._table = ControlTable(self._object, self._pick_bar.picks, self._changed,
                                   self._run.say)
        self._tabs.addTab(self._table.widget, tr("Walls"))
        self._results = ResultsPage(self._colour_by, self._look, {
            check.LOST: (tr("Follow References"), self._follow_references),
            check.STALE: (tr("Mesh"), self._mesh_again)}, self._set_view)
        self._tabs.addTab(self._results.widget, tr("Results"))
        self._tabs.currentChanged.connect(self._turned_to)
        # On top: a small window must not scroll away Stop and what the mesher says.
        layout.addWidget(self._question.widget)
        layout.addWidget(self._run.widget)
        layout.addWidget(self._pick_bar.widget)
        layout.addWidget(self._tabs)
        layout.addWidget(self._later())  # beside OK it would be wider than the panel

    def _later(self):
        button = QtGui.QPushButton(tr("Mesh later"))
        button.setObjectName("AdvLayersLater")
        button.setToolTip(tr("Keeps the settings, and a mesh that is finished, and closes"))
        # Not within the click: the button goes with the panel.
        button.clicked.connect(lambda _checked=False: QtCore.QTimer.singleShot(0, self._keep))
        return button

    def _settings_tab(self):
        tab = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(tab)
        layout.setContentsMargins(4, 4, 4, 4)
        faces = QtGui.QGroupBox()
        title = tr("Faces of {}").format(self._object.Part.Label)
        faces.setTitle(faces.fontMetrics().elidedText(title, QtCore.Qt.ElideRight, _TITLE_WIDTH))
        faces.setToolTip(title)
        inside = QtGui.QVBoxLayout(faces)
        self._faces = ReferenceList("faces", ("Face",), self._pick_bar.picks, self._set_faces,
                                    self._run.say, tr("all faces"))
        self._faces.show(self._object.Faces)
        inside.addWidget(self._faces.widget)
        layout.addWidget(faces)
        entries = {entry.key: entry for entry in property_settings()
                   if entry.key != "faces"}
        layout.addWidget(self._presets())
        form = QtGui.QFormLayout()
        layout.addLayout(form)
        self._forms.append(SettingsForm(
            self._object, [entries.pop(key) for key in _FIRST], form, self._changed,
            self._run.say, self._typed))
        self._flow = FlowBox(lambda: self._object.Growth, self._use_height)
        layout.addWidget(self._flow.widget)
        layout.addWidget(self._flag("GrowFromAll", tr("Layers from all edges")))
        layout.addWidget(self._flag("AutoUpdate", tr("Update automatically")))
        layout.addWidget(self._advanced(entries.values()))
        layout.addStretch()
        return tab

    def _use_height(self, height: float) -> None:
        self._object.FirstHeight = height
        for form in self._forms:
            form.load()
        self._changed()

    def _presets(self):
        """A choice that is made at once, and not kept."""
        box = QtGui.QComboBox()
        box.setObjectName("AdvLayersPreset")
        entry = setting("preset")
        box.setToolTip(tr_doc(entry.doc))
        box.addItems([tr("Preset…"), tr("CFD: layers from all sharp edges"), tr("FEM: no layers"),
                      tr("Washers: rings about every hole")])
        box.setMinimumContentsLength(8)
        box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        box.activated.connect(
            lambda index: self._apply_preset(entry.choices[index - 1]) if index else None)
        return box

    def _apply_preset(self, word: str) -> None:
        try:
            layer_mesh.apply_preset(self._object, word)
        except InputError as error:
            self._run.say(error.sentence.translated, wrong=True)
            return
        self._reload()

    def _flag(self, name: str, text: str):
        """A box to tick for a property that is no setting of a job."""
        box = QtGui.QCheckBox(text)
        box.setObjectName(f"AdvLayers_{name}")
        box.setToolTip(tr_doc(self._object.getDocumentationOfProperty(name)))
        box.setChecked(getattr(self._object, name))
        box.toggled.connect(lambda on: self._set_flag(name, on))
        self._flags[name] = box
        return box

    def _advanced(self, entries):
        group = QtGui.QGroupBox(tr("Advanced"))
        group.setObjectName("AdvLayersAdvanced")
        group.setCheckable(True)
        group.setChecked(False)
        inside = QtGui.QWidget()
        around, form = QtGui.QVBoxLayout(group), QtGui.QFormLayout(inside)
        around.setContentsMargins(2, 10, 2, 0)
        form.setContentsMargins(2, 0, 2, 0)
        around.addWidget(inside)
        self._forms.append(SettingsForm(self._object, entries, form, self._changed,
                                        self._run.say, self._typed))
        inside.setVisible(False)
        group.toggled.connect(inside.setVisible)
        return group

    # --- settings -----------------------------------------------------------------------------

    def _store(self) -> None:
        for form in self._forms:
            form.store()
        self._table.store()

    def _set_faces(self, names: List[str]) -> None:
        self._object.Faces = names
        self._changed()

    def _set_flag(self, name: str, on: bool) -> None:
        setattr(self._object, name, on)
        self._changed()

    def _changed(self) -> None:
        self._altered = not self._recording.empty
        if not self._run.running:
            layer_mesh.refresh_state(self._object)
        wrong = self.preview.show(self._object)
        if wrong or self.preview.busy:
            self._previewed(wrong)

    def _typed(self, typed: Dict[str, Any]) -> None:
        said = self._hint(typed)
        if said is not None:
            self._run.say(said.translated, wrong=True)
        elif not self._run.running:
            self._say_state("")

    def _hint(self, typed: Dict[str, Any]) -> Optional[Sentence]:
        mesh = self._object
        return hints.of_mesh({"size": mesh.Size.Value, "first_height": mesh.FirstHeight.Value,
                              **typed})

    def _previewed(self, wrong: str) -> None:
        if not self._run.running:
            self._say_state(wrong)

    def _say_state(self, wrong: str) -> None:
        hint = self._hint({})
        wrong = wrong or (hint.translated if hint is not None else "")
        lines = (state_text(self._object), self.preview.heights.caption())
        self._run.say(wrong or "\n".join(filter(None, lines)), wrong=bool(wrong))

    # --- meshing ------------------------------------------------------------------------------

    def _mesh_again(self) -> None:
        if not self._run.running:
            self._run.start()

    def _follow_references(self) -> None:
        layer_mesh.follow_references(self._object)
        self._reload()
        self._results.show(self._data, check.of_object(self._object))

    def _make_room(self) -> None:
        self.preview.hide()
        self._set_visible(False)

    def _have_read(self, data: MeshData) -> None:
        """Of the mesh that is there already."""
        self._data = data
        self._results.show(data, check.of_object(self._object))
        if self._tabs.currentIndex() == _RESULTS_TAB:
            self._show_mesh()

    def _done(self, outcome: Outcome) -> None:
        self._reading.stop()
        self._outcome = outcome
        self._data = outcome.data
        self._results.show(self._data)
        self.show_results()
        self._show_mesh()

    def _ended(self, meshed: bool) -> None:
        if self._close_when_done and meshed:
            self.accept()
        elif not meshed:
            self._turned_to(self._tabs.currentIndex())
        self._close_when_done = False

    # --- the view -----------------------------------------------------------------------------

    def _turned_to(self, tab: int) -> None:
        self._pick_bar.widget.setVisible(tab != _RESULTS_TAB)
        if tab == _RESULTS_TAB and self._data is not None:
            self._show_mesh()
        elif not self._run.running:
            self._show_shape()

    def _show_shape(self) -> None:
        """The shape, to pick from it."""
        self._scene.clear()
        self._mark.removeAllChildren()
        self.preview.unhide()
        self._set_visible(True)

    def _show_mesh(self) -> None:
        self._show_field()
        self._make_room()

    def _set_visible(self, shape: bool) -> None:
        self._object.Part.ViewObject.Visibility = shape
        self._object.ViewObject.Visibility = False

    def _show_field(self) -> None:
        scale = self._scene.show(self._data, self._results.field)
        self._results.view.offer_range(scale.low, scale.high)

    def _colour_by(self, _field: str) -> None:
        if self._data is not None:
            self._show_field()

    def _set_view(self, options: ViewOptions) -> None:
        colours_differ = options.colours != self._scene.options.colours
        self._scene.set_options(options)
        if self._data is not None and colours_differ:
            self._show_field()

    def _look(self, place: Optional[Place], text: str) -> None:
        self._run.say(text)
        self._mark.removeAllChildren()
        if place is not None:
            look_at(self._object.Document, place.point, place.normal, place.width)
            self._mark.addChild(markers([place.point], MARK_COLOUR))

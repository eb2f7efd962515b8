"""The task panel of a layer mesh: what to mesh and how, the mesh as it grows, and what came out."""
from __future__ import annotations

import contextlib
from typing import Callable, Iterator, List, Optional

from pivy import coin
from PySide import QtCore, QtGui

from advlayers import check, controls, layer_mesh, mesh_data
from advlayers.element_mesh import ElementMesh
from advlayers.errors import InputError
from advlayers.language import tr, tr_doc
from advlayers.mesh_data import MeshData, Place
from advlayers.mesh_properties import property_settings
from advlayers.settings_table import setting
from advlayers_gui import view_provider
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
from advlayers_gui.view_3d import Overlay, look_at

# The settings asked for most, in this order; the others stand under Advanced.
_FIRST = ("size", "first_height", "growth", "layers")
_RESULTS_TAB = 2


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
        self._changed()
        if mesh_object.FemMesh.NodeCount:
            self._reading.start(mesh_data.reading(mesh_object), self._have_read)

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

    def accept(self) -> bool:
        if self._run.running or (self._outcome is None
                                 and self._object.State == layer_mesh.NOT_MESHED):
            self._close_when_done = self._run.running or self._run.start()
            return False
        try:
            self._store()
        except InputError as error:
            self._run.fail(error.sentence.translated)
            return False
        if self._outcome is not None:
            with _busy_pointer():
                self._outcome.store(self._object)
        self.leave()
        if self._object.AutoUpdate:
            self._object.touch()
        if self._object.FemMesh.NodeCount:
            view_provider.show_mesh(self._object)
        return super().accept()

    def _clean_up(self) -> None:
        self._run.abandon()
        self._reading.stop()
        self._scene.clear()
        self._pick_bar.picks.end()
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
        self._pick_bar = PickBar(self._object.Part, controls.Size.KINDS, self._run.say)
        self._forms: List[SettingsForm] = []
        self._tabs = QtGui.QTabWidget()
        self._tabs.setObjectName("AdvLayersTabs")
        self._tabs.setUsesScrollButtons(False)
        self._tabs.setElideMode(QtCore.Qt.ElideRight)
        self._tabs.addTab(self._settings_tab(), tr("General"))
        self._table = ControlTable(self._object, self._pick_bar.picks, self._changed,
                                   self._run.say)
        self._tabs.addTab(self._table.widget, tr("Walls"))
        self._results = ResultsPage(self._colour_by, self._look)
        self._tabs.addTab(self._results.widget, tr("Results"))
        self._tabs.currentChanged.connect(self._turned_to)
        # On top: a small window must not scroll away Stop and what the mesher says.
        layout.addWidget(self._run.widget)
        layout.addWidget(self._pick_bar.widget)
        layout.addWidget(self._tabs)

    def _settings_tab(self):
        tab = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(tab)
        layout.setContentsMargins(4, 4, 4, 4)
        faces = QtGui.QGroupBox(tr("Faces of {}").format(
            self._object.Part.Label))
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
            self._run.say))
        self._flow = FlowBox(lambda: self._object.Growth, self._use_height)
        layout.addWidget(self._flow.widget)
        self._grow_from_all = self._flag("GrowFromAll", tr("Layers from all edges"))
        layout.addWidget(self._grow_from_all)
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
        for form in self._forms:
            form.load()
        self._table.load()
        self._grow_from_all.blockSignals(True)
        self._grow_from_all.setChecked(self._object.GrowFromAll)
        self._grow_from_all.blockSignals(False)
        self._changed()

    def _flag(self, name: str, text: str):
        """A box to tick for a property that is no setting of a job."""
        box = QtGui.QCheckBox(text)
        box.setObjectName(f"AdvLayers_{name}")
        box.setToolTip(tr_doc(self._object.getDocumentationOfProperty(name)))
        box.setChecked(getattr(self._object, name))
        box.toggled.connect(lambda on: self._set_flag(name, on))
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
                                        self._run.say))
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
        wrong = self._preview_heights(self._object)
        if wrong:
            self._run.say(wrong, wrong=True)
        elif not self._run.running:
            layer_mesh.refresh_state(self._object)
            lines = (state_text(self._object), self.heights.caption())
            self._run.say("\n".join(filter(None, lines)))

    # --- meshing ------------------------------------------------------------------------------

    def _make_room(self) -> None:
        self.heights.hide()
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
        self.heights.unhide()
        self._set_visible(True)

    def _show_mesh(self) -> None:
        self._scene.show(self._data, self._results.field)
        self._make_room()

    def _set_visible(self, shape: bool) -> None:
        self._object.Part.ViewObject.Visibility = shape
        self._object.ViewObject.Visibility = False

    def _colour_by(self, field: str) -> None:
        if self._data is not None:
            self._scene.show(self._data, field)

    def _look(self, place: Optional[Place], text: str) -> None:
        self._run.say(text)
        self._mark.removeAllChildren()
        if place is not None:
            look_at(self._object.Document, place.point, place.normal, place.width)
            self._mark.addChild(markers([place.point], MARK_COLOUR))

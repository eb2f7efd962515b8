"""The task panel of a wall, a size or a group."""
from __future__ import annotations

from PySide import QtGui

from advlayers import controls
from advlayers_gui.control_editor import ControlEditor, groups_of, references_of
from advlayers_gui.pick_bar import PickBar
from advlayers_gui.status_line import StatusLine
from advlayers_gui.task_panel import TaskPanel


class ControlPanel(TaskPanel):
    TITLE = "Edit Wall, Size or Group"

    def __init__(self, control) -> None:
        super().__init__(control)
        self._mesh_object = controls.mesh_of(control)
        source = self._mesh_object.Part
        self._remember_visibility(source, self._mesh_object)
        self.form.setWindowTitle(control.Label)
        layout = QtGui.QVBoxLayout(self.form)
        layout.setContentsMargins(4, 4, 4, 4)
        self._status = StatusLine()
        self._pick_bar = PickBar(source, control.Proxy.KINDS, self._status.say,
                                 lambda: groups_of(self._mesh_object))
        self._editor = ControlEditor(control, source, self._pick_bar.picks, self._changed,
                                     self._status.say)
        # On top, as in the panel of the mesh: a small window must not scroll away what is wrong.
        for part in (self._question, self._status, self._pick_bar, self._editor):
            layout.addWidget(part.widget)
        self.preview.lit = lambda: references_of(control, source)
        self._pick_bar.picks.begin()
        source.ViewObject.Visibility, self._mesh_object.ViewObject.Visibility = True, False
        self._look_at(source)
        self._show_state()

    def accept(self) -> bool:
        self._editor.store()
        return super().accept()

    def _changed(self) -> None:
        self._altered = not self._recording.empty
        self._show_state()

    def _show_state(self) -> None:
        wrong = self.preview.show(self._mesh_object)
        if wrong:
            self._previewed(wrong)

    def _previewed(self, wrong: str) -> None:
        self._status.say(wrong or self.preview.heights.caption(), wrong=bool(wrong))

    def _clean_up(self) -> None:
        self._pick_bar.end()
        self._editor.release()

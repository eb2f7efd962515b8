"""Mesh and Stop, a progress bar, and what the mesher is at."""
from __future__ import annotations

from typing import Callable, Optional

import FreeCAD
from PySide import QtGui

from advlayers import layer_mesh
from advlayers.errors import CoreMissing
from advlayers.language import tr
from advlayers.sentence import of_diagnostic, of_error
from advlayers_gui.mesh_task import Canvas, MeshTask, Outcome, Progress
from advlayers_gui.status_line import StatusLine

_STEPS = 1000  # of the progress bar


class RunBox:
    """Meshes one object on request. `before` stores what the fields say; the growing mesh is
    drawn on the canvas; `on_done` gets the finished one; `on_end` follows every run, whether it was
    finished, stopped or failed."""

    def __init__(self, mesh_object, before: Callable[[], None],
                 canvas: Optional[Canvas],
                 on_done: Callable[[Outcome], None], on_end: Callable[[bool], None]) -> None:
        self._mesh_object, self._before = mesh_object, before
        self._canvas, self._on_done, self._on_end = canvas, on_done, on_end
        self._task: Optional[MeshTask] = None
        self.widget = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(self.widget)
        layout.setContentsMargins(0, 0, 0, 0)
        self._button = QtGui.QPushButton(tr("Mesh"))
        self._button.setObjectName("AdvLayersMeshButton")
        self._button.setToolTip(tr("Meshes with the settings below; OK then puts the mesh into the "
                                   "document"))
        self._button.clicked.connect(self._start_or_stop)
        self._bar = QtGui.QProgressBar()
        self._bar.setObjectName("AdvLayersProgress")
        self._bar.setTextVisible(False)
        self._bar.hide()
        self._status = StatusLine(state_text(mesh_object))
        for part in (self._button, self._bar, self._status.widget):
            layout.addWidget(part)

    @property
    def running(self) -> bool:
        return self._task is not None

    def say(self, text: str, wrong: bool = False) -> None:
        self._status.say(text, wrong)

    def fail(self, text: str) -> None:
        """Tells an error where the user looks, and in the report view."""
        FreeCAD.Console.PrintError(f"Advancing Layers: {text}\n")
        self.say(text, wrong=True)

    def start(self) -> bool:
        """Whether the run is under way; if not, the status line says why."""
        try:
            self._before()
            self._task = MeshTask(layer_mesh.prepare(self._mesh_object), self._progressed,
                                  self._done, self._failed, self._stopped, self._canvas)
        except (ValueError, RuntimeError, CoreMissing) as error:
            self.fail(of_error(error).translated)
            return False
        self._button.setText(tr("Stop"))
        self._bar.setRange(0, 0)
        self._bar.show()
        self._task.start()
        return True

    def abandon(self) -> None:
        """Ends a run without a further word."""
        if self._task is not None:
            self._task.abandon()
            self._task = None

    def _start_or_stop(self) -> None:
        if self._task is None:
            self.start()
        else:
            self.say(tr("Stopping…"))
            self._task.stop()

    def _progressed(self, progress: Progress) -> None:
        busy = progress.share <= 0.0
        if busy != (self._bar.maximum() == 0):
            self._bar.setRange(0, 0 if busy else _STEPS)
        if not busy:
            self._bar.setValue(int(_STEPS * progress.share))
        self.say(status_text(progress))

    def _done(self, outcome: Outcome) -> None:
        seconds = self._end()
        self.say(summary(outcome, seconds))
        self._on_done(outcome)
        self._on_end(True)

    def _failed(self, reason: str) -> None:
        self._end()
        self.fail(reason)
        self._on_end(False)

    def _stopped(self) -> None:
        self._end()
        self.say(tr("Stopped; the mesh is the one before."))
        self._on_end(False)

    def _end(self) -> float:
        seconds = self._task.progress.seconds
        self._task = None
        self._button.setText(tr("Mesh"))
        self._bar.hide()
        return seconds


def state_text(mesh_object) -> str:
    """In the user's language."""
    return {layer_mesh.NOT_MESHED: tr("Not meshed"), layer_mesh.UP_TO_DATE: tr("Up to date"),
            layer_mesh.OUT_OF_DATE: tr("Out of date"),
            layer_mesh.LOST_REFERENCES: tr("Lost references"),
            layer_mesh.SOURCE_IN_ERROR: tr("The shape is in error: mend it first")}[
                mesh_object.State]


def status_text(progress: Progress) -> str:
    if not progress.elements:
        return tr("{stage} · {seconds:.1f} s").format(
            stage=_stage_text(progress), seconds=progress.seconds)
    text = tr("{stage} · {elements} elements · {percent:.1f} % quads · {seconds:.1f} s")
    return text.format(
        stage=_stage_text(progress), elements=progress.elements, percent=progress.quad_percent,
        seconds=progress.seconds)


def _stage_text(progress: Progress) -> str:
    if progress.stage == "layers" and progress.patch >= 0:
        return tr("Patch {patch} of {patches} · layer {layer}").format(
            patch=progress.patch + 1, patches=max(progress.patches, progress.patch + 1),
            layer=progress.layer)
    return {"boundary": tr("Cutting the edges"), "triangulate": tr("Triangulating"),
            "layers": tr("Growing layers"), "core": tr("Finishing the core")}.get(
                progress.stage, tr("Reading the shape"))


def summary(outcome: Outcome, seconds: float) -> str:
    figures = outcome.mesh.figures
    line = tr("{quads} quads and {triangles} triangles ({percent:.1f} % quads) in "
              "{seconds:.1f} s").format(
        quads=figures["quads"], triangles=figures["triangles"],
        percent=figures["quad_percent"], seconds=seconds)
    grave = [of_diagnostic(entry).translated for entry in outcome.mesh.diagnostics
             if entry["severity"] == "error"]
    return "\n".join([line] + grave[:5])

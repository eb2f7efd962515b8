"""Meshing beside the window: a worker thread runs the core, a timer brings its news."""
from __future__ import annotations

import threading
import time
from dataclasses import dataclass, field
from typing import Any, Callable, Iterable, List, Optional, Set

from PySide import QtCore

from advlayers import layer_mesh, mesh_data, preferences
from advlayers.core_access import load_core
from advlayers.element_mesh import ElementMesh, of_core
from advlayers.errors import Stopped
from advlayers.mesh_data import MeshData
from advlayers.meshing import Run
from advlayers.sentence import of_error

_POLL = 20  # [ms] between two looks at the worker
# Time that a run may wait, all in all, for pictures to be drawn, so that a run too short to be
# watched is seen to grow as well: seconds, and a share of what it has taken before the first layer.
# The waits lie at layers 1, 3, 6, 10, 16, ...
_PATIENCE, _PATIENCE_SHARE = 0.5, 0.3
_NEXT_WAIT = 1.5
# A picture may take this share of the time of the run.
_PICTURE_SHARE = 0.2
# [s] that stop() waits for the worker: its last picture might keep the window busy for longer.
_STOP_WAIT = 0.1


@dataclass
class Progress:
    """What the run has told so far."""

    stage: str = ""  # of the core's context; "": before the first
    share: float = 0.0  # of it, 0 to 1
    patch: int = -1  # that reported last
    layer: int = 0  # of that patch
    quads: int = 0
    triangles: int = 0
    start: float = field(default_factory=time.monotonic)
    _grown: Set[int] = field(default_factory=set)

    @property
    def patches(self) -> int:
        """That have grown a layer."""
        return len(self._grown)

    @property
    def elements(self) -> int:
        return self.quads + self.triangles

    @property
    def quad_percent(self) -> float:
        return 100.0 * self.quads / self.elements if self.elements else 0.0

    @property
    def seconds(self) -> float:
        return time.monotonic() - self.start

    def add(self, reports: List[Any]) -> None:
        for report in reports:
            self.patch, self.layer = report.patch, report.layer
            self._grown.add(report.patch)
            self.quads += report.quads
            self.triangles += report.triangles


@dataclass(frozen=True)
class Outcome:
    """A finished mesh that the document does not have yet."""

    task: layer_mesh.Task
    mesh: Any  # the core's
    fem: Any  # Fem.FemMesh
    data: MeshData

    def store(self, mesh_object) -> None:
        layer_mesh.set_mesh(mesh_object, self.mesh, self.fem, self.task.made_from, self.data)


class Canvas:
    """Where a growing mesh is drawn."""

    busy = False  # not ready for the next picture

    @staticmethod
    def prepare(mesh: ElementMesh) -> Iterable[Any]:
        """Makes a picture, in pieces between which the run may be stopped; in the worker, which is
        to hold nothing of the window: it may be the last to let go."""
        raise NotImplementedError

    def draw(self, picture: List[Any]) -> None:
        """Called in the window's thread."""
        raise NotImplementedError


class MeshTask:
    """One run for one mesh object. The functions handed in are called in the window's thread:
    `on_progress` at every look, and in the end one of `on_done`, `on_failed` (with the reason) and
    `on_stopped`. The mesh is drawn on the canvas as it grows."""

    def __init__(self, task: layer_mesh.Task, on_progress: Callable[[Progress], None],
                 on_done: Callable[[Outcome], None], on_failed: Callable[[str], None],
                 on_stopped: Callable[[], None],
                 canvas: Optional[Canvas] = None) -> None:
        core = load_core()
        self._on_progress, self._canvas = on_progress, canvas
        self._on_done, self._on_failed, self._on_stopped = on_done, on_failed, on_stopped
        self.progress = Progress()
        shown = canvas is not None and preferences.live_preview()
        self._pictures = _Pictures(canvas.prepare) if shown else None
        self._drawing_since: Optional[float] = None
        context = core.RunContext()
        self._run = Run(context, lambda: task.make_mesher(core, context),
                        self._pictures.offer if self._pictures else None,
                        lambda mesh, check: _outcome(task, mesh, check))
        self._cancelled = False
        self._timer = QtCore.QTimer()
        self._timer.setInterval(_POLL)
        self._timer.timeout.connect(self._look)

    def start(self) -> None:
        self._run.start()
        self._timer.start()

    @property
    def running(self) -> bool:
        return self._timer.isActive()

    def stop(self) -> None:
        """Ends the run, as a rule before it returns; on_stopped is called when it has ended."""
        self._cancel()
        self._run.wait(_STOP_WAIT)
        self._look()

    def abandon(self) -> None:
        """Ends the run without a further word: its object or its panel is going away."""
        self._timer.stop()
        self._cancel()

    def _cancel(self) -> None:
        self._cancelled = True
        self._run.cancel()
        if self._pictures is not None:
            self._pictures.give_up()

    def _look(self) -> None:
        running = self._run.running  # asked first, so that no report after it is missed
        if not self._cancelled:
            self._show_progress(running)
        if not running and self._timer.isActive():
            self._timer.stop()
            self._end()

    def _show_progress(self, running: bool) -> None:
        self.progress.add(self._run.reports())
        self.progress.stage, self.progress.share = self._run.progress
        self._on_progress(self.progress)
        if running and self._pictures and not self._canvas.busy:
            self._draw()

    def _draw(self) -> None:
        if self._drawing_since is not None:
            self._pictures.drawn(time.monotonic() - self._drawing_since)
            self._drawing_since = None
        picture = self._pictures.take()
        if picture is not None:
            self._drawing_since = time.monotonic()
            self._canvas.draw(picture)

    def _end(self) -> None:
        try:
            outcome = self._run.outcome()
        except Stopped:
            self._on_stopped()
        except Exception as error:  # whatever the run raised is told where the user looks
            self._on_failed(of_error(error).translated)
        else:
            self._on_done(outcome)


def _outcome(task: layer_mesh.Task, mesh, check: Callable[[], None]) -> Outcome:
    """In the worker."""
    data = mesh_data.of_core(task.label, mesh)
    check()
    data.prepare(check)  # better here than in the window
    return Outcome(task, mesh, task.make_fem_mesh(mesh, check), data)


class _Pictures:
    """Hands the growing mesh from the worker to the window: the newest alone, now and then."""

    def __init__(self, prepare: Callable[[ElementMesh], Iterable[Any]]) -> None:
        self._prepare, self._rate = prepare, preferences.preview_rate()
        self._lock = threading.Lock()
        self._newest: Any = None
        self._taken = threading.Event()
        self._start = time.monotonic()
        self._patience = 0.0
        self._round, self._next_wait = 0, 1
        self._due = 0.0
        self._cost = 0.0  # [s] of the last picture, in both threads
        self._last_patch = -1

    def offer(self, mesher, report, check: Callable[[], None]) -> None:
        """In the worker. All patches grow by one layer before the first of them reports it."""
        start = time.monotonic()
        if self._last_patch < 0:
            self._patience = _PATIENCE + _PATIENCE_SHARE * (start - self._start)
        new_round = report.patch <= self._last_patch or self._last_patch < 0
        self._last_patch = report.patch
        self._round += new_round
        waits = self._patience > 0.0 and self._round >= self._next_wait
        if not new_round or (start < self._due and not waits):
            return
        picture = []
        for piece in self._prepare(of_core(mesher.snapshot())):
            check()
            picture.append(piece)
        self._taken.clear()
        check()  # after clear(): what give_up() sets from now on ends the wait below
        with self._lock:
            self._newest = picture
        self._cost = time.monotonic() - start
        if waits:
            self._next_wait = int(_NEXT_WAIT * self._round) + 2
            start = time.monotonic()
            self._taken.wait(self._patience)
            self._patience -= time.monotonic() - start
        self._due = time.monotonic() + max(1.0 / self._rate, self._cost / _PICTURE_SHARE)

    def give_up(self) -> None:
        """The run was cancelled: a worker that waits for its picture to be drawn goes on."""
        self._taken.set()

    def take(self) -> Any:
        """In the window's thread."""
        with self._lock:
            picture, self._newest = self._newest, None
        return picture

    def drawn(self, seconds: float) -> None:
        self._cost += seconds
        self._taken.set()

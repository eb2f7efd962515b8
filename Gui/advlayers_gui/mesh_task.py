"""Meshing beside the window: a worker thread runs the core, a timer brings its news."""
from __future__ import annotations

import threading
import time
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Optional

from PySide import QtCore

from advlayers import layer_mesh
from advlayers.core_access import load_core
from advlayers.element_mesh import ElementMesh, of_core
from advlayers.errors import Stopped
from advlayers.meshing import Run

_POLL = 20  # [ms] between two looks at the worker
# Seconds that a run may wait, all in all, for its pictures to be drawn: so that a run too short to
# be watched is seen to grow as well.
_PATIENCE = 0.4
# A picture may take this share of the time of the run, and come this often at most.
_PICTURE_SHARE = 0.2
_PICTURE_INTERVAL = 0.1  # [s]


@dataclass
class Progress:
    """What the run has told so far."""

    patches: Dict[int, int] = field(default_factory=dict)  # patch -> its last layer
    patch: int = -1  # that reported last; -1: triangulating
    quads: int = 0
    triangles: int = 0
    start: float = field(default_factory=time.monotonic)
    growing: bool = True  # False: the layers have ended, the core is finished

    @property
    def layer(self) -> int:
        return self.patches.get(self.patch, 0)

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
            self.patch, self.patches[report.patch] = report.patch, report.layer
            self.quads += report.quads
            self.triangles += report.triangles


@dataclass(frozen=True)
class Outcome:
    """A finished mesh that the document does not have yet."""

    task: layer_mesh.Task
    mesh: Any  # the core's
    fem: Any  # Fem.FemMesh

    def store(self, mesh_object) -> None:
        layer_mesh.set_mesh(mesh_object, self.mesh, self.fem, self.task.made_from)


class MeshTask:
    """One run for one mesh object. The functions handed in are called in the window's thread:
    `on_progress` at every look, `on_picture` with the mesh as it grows, and in the end one of
    `on_done`, `on_failed` (with the reason) and `on_stopped`."""

    def __init__(self, task: layer_mesh.Task, on_progress: Callable[[Progress], None],
                 on_done: Callable[[Outcome], None], on_failed: Callable[[str], None],
                 on_stopped: Callable[[], None],
                 on_picture: Optional[Callable[[ElementMesh], None]] = None) -> None:
        core = load_core()
        self._task = task
        self._on_progress, self._on_picture = on_progress, on_picture
        self._on_done, self._on_failed, self._on_stopped = on_done, on_failed, on_stopped
        self.progress = Progress()
        self._pictures = _Pictures() if on_picture else None
        self._run = Run(lambda: task.make_mesher(core),
                        self._pictures.offer if self._pictures else None, self._finish)
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
        """Asks for the end; on_stopped follows."""
        self._run.cancel()

    def abandon(self) -> None:
        """Ends the run without a further word: its object or its panel is going away."""
        self._timer.stop()
        self._run.cancel()

    def _finish(self, mesh, check) -> Outcome:
        self.progress.growing = False
        return Outcome(self._task, mesh, self._task.make_fem_mesh(mesh, check))

    def _look(self) -> None:
        running = self._run.running  # asked first, so that no report after it is missed
        self.progress.add(self._run.reports())
        self._on_progress(self.progress)
        if self._pictures:
            picture = self._pictures.take()
            if picture is not None and running:
                start = time.monotonic()
                self._on_picture(picture)
                self._pictures.drawn(time.monotonic() - start)
        if not running and self._timer.isActive():
            self._timer.stop()
            self._end()

    def _end(self) -> None:
        try:
            outcome = self._run.outcome()
        except Stopped:
            self._on_stopped()
        except Exception as error:  # whatever the run raised is told where the user looks
            self._on_failed(str(error) or type(error).__name__)
        else:
            self._on_done(outcome)


class _Pictures:
    """Hands the growing mesh from the worker to the window: the newest alone, now and then."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._newest: Optional[ElementMesh] = None
        self._taken = threading.Event()
        self._patience = _PATIENCE
        self._due = 0.0
        self._cost = 0.0  # [s] of the last picture, in both threads
        self._last_patch = -1

    def offer(self, mesher, report) -> None:
        """In the worker. All patches grow by one layer before the first of them reports it."""
        new_round = report.patch <= self._last_patch or self._last_patch < 0
        self._last_patch = report.patch
        if not new_round or (time.monotonic() < self._due and self._patience <= 0.0):
            return
        start = time.monotonic()
        picture = of_core(mesher.snapshot())
        self._taken.clear()
        with self._lock:
            self._newest = picture
        self._cost = time.monotonic() - start
        if self._patience > 0.0:
            self._taken.wait(self._patience)
            self._patience -= time.monotonic() - start
        self._due = time.monotonic() + max(_PICTURE_INTERVAL, self._cost / _PICTURE_SHARE)

    def take(self) -> Optional[ElementMesh]:
        """In the window's thread."""
        with self._lock:
            picture, self._newest = self._newest, None
        return picture

    def drawn(self, seconds: float) -> None:
        self._cost += seconds
        self._taken.set()

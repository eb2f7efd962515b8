"""Checked settings to the core's, and the core's loop."""
from __future__ import annotations

import atexit
import queue
import threading
import weakref
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple

from advlayers import collector, flow_height
from advlayers.errors import Stopped
from advlayers.settings_table import OWN_SETTINGS

_OWN = {entry.key for entry in OWN_SETTINGS}  # of other stages than the core


def core_settings(core, settings: Mapping[str, Any], diagonal: float):
    """The core's Settings from every key of MESH_SETTINGS, lengths filled in."""
    values: Dict[str, Any] = {key: value for key, value in settings.items()
                              if key not in _OWN}
    values.update(default_lengths(settings, diagonal))
    for key in ("match", "off", "boundary", "smooth", "mapped"):
        values[key] = list(values[key])
    if values["faces"] != "all":
        values["faces"] = list(values["faces"])
    if values["walls"] != "all":
        values["walls"] = [_given(wall) for wall in values["walls"]]
    for key in ("sizes", "refinements", "periodic"):
        values[key] = [_given(entry) for entry in values[key]]
    return core.Settings(**values)


_CELLS_ACROSS = 10  # elements over each face, where nothing is said


def default_lengths(settings: Mapping[str, Any], diagonal: float) -> Dict[str, float]:
    """Size and first height [mm], where not given, from y+, or from the model's diagonal to two
    digits; where neither is given, small parts get sizes of their own. Raises InputError where
    y_plus and first_height are both given."""
    size, height, across = settings["size"], settings["first_height"], settings["cells_across"]
    if size is None:
        size = float(f"{diagonal / 40.0:.2g}")
        across = across or (_CELLS_ACROSS if height is None else 0)
    flow = flow_height.of_settings(settings)
    if flow is not None:
        height = flow.first_height
    elif height is None:
        height = float(f"{size / 10.0:.2g}")
    return {"size": size, "first_height": height, "cells_across": across}


def _given(entry: Mapping[str, Any]) -> Dict[str, Any]:
    return {key: list(value) if isinstance(value, tuple) else value
            for key, value in entry.items() if value not in (None, ())}


# [s] that the end of the program waits for a run to stop, which takes well under 0.1 as a rule.
_LAST_WAIT = 5.0
_runs: "weakref.WeakSet[Run]" = weakref.WeakSet()


class Run:
    """Pulls the layers out of a core Mesher in a thread of its own, so that the calling thread
    stays free for Ctrl-C, a progress line or a window's events.

    `context` is the core's RunContext of what is handed in, and that runs in the thread:
    `make_mesher` reads and checks; `on_layer` gets the mesher and each report, `on_mesh` the
    finished mesh, and both a check() that raises once the run was cancelled. What `on_mesh` returns
    is the outcome of the run.
    """

    def __init__(self, context: Any, make_mesher: Callable[[], Any],
                 on_layer: Optional[Callable[[Any, Any, Callable[[], None]], None]] = None,
                 on_mesh: Optional[Callable[[Any, Callable[[], None]], Any]] = None) -> None:
        self._context = context
        self._make_mesher, self._on_layer, self._on_mesh = make_mesher, on_layer, on_mesh
        self._reports: "queue.Queue[Any]" = queue.Queue()
        self._thread = threading.Thread(target=self._pull, name="advlayers", daemon=True)
        self._outcome: Any = None
        self._error: Optional[BaseException] = None

    def start(self) -> None:
        collector.keep_out_of_threads()
        _runs.add(self)
        self._thread.start()

    @property
    def running(self) -> bool:
        return self._thread.is_alive()

    @property
    def progress(self) -> Tuple[str, float]:
        """The core's stage, and the share of it that is done."""
        return self._context.progress

    def cancel(self) -> None:
        """Stops the work soon; returns at once."""
        self._context.cancel()

    def wait(self, seconds: float) -> None:
        """For the end of the run, but no longer than that."""
        self._thread.join(seconds)

    def reports(self, wait: float = 0.0) -> List[Any]:
        """The reports since the last call; waits up to `wait` seconds for the first of them."""
        reports = []
        try:
            reports.append(self._reports.get(timeout=wait) if wait else self._reports.get_nowait())
            while True:
                reports.append(self._reports.get_nowait())
        except queue.Empty:
            pass
        return [report for report in reports if report is not None]

    def outcome(self):
        """Waits for the end; the mesh, or what `on_mesh` made of it. Raises what the core or one
        of the functions handed in raised, Stopped after cancel()."""
        self._thread.join()
        self._check()
        if self._error is not None:
            raise self._error
        return self._outcome

    def finish(self, watch: Callable[[List[Any]], None], interval: float = 0.1):
        """Meshes to the end and returns the outcome. `watch` is called with the reports that came
        in since its last call, every `interval` seconds or sooner; what it raises cancels the run.
        """
        self.start()
        try:
            while self.running:
                watch(self.reports(interval))
            watch(self.reports())
        except BaseException:
            self.cancel()
            self._thread.join()
            raise
        return self.outcome()

    def _pull(self) -> None:
        try:
            mesher = self._make_mesher()
            self._check()
            for report in mesher:
                self._reports.put(report)
                if self._on_layer:
                    self._on_layer(mesher, report, self._check)
                self._check()
            mesh = mesher.result()
            self._outcome = self._on_mesh(mesh, self._check) if self._on_mesh else mesh
        except BaseException as error:  # handed to the calling thread, whatever it is
            self._error = error
        self._reports.put(None)

    def _check(self) -> None:
        if self._context.cancelled:
            raise Stopped()


@atexit.register
def _stop_all() -> None:
    """Python ends the threads that are left, and C++ calls that for a crash."""
    for run in list(_runs):
        if run.running:
            run.cancel()
            run.wait(_LAST_WAIT)

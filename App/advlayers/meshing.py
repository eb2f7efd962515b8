"""Checked settings to the core's, and the core's loop."""
from __future__ import annotations

import queue
import threading
from typing import Any, Callable, Dict, List, Mapping, Optional


def core_settings(core, settings: Mapping[str, Any], diagonal: float):
    """The core's Settings from every key of MESH_SETTINGS but groups, lengths filled in."""
    values: Dict[str, Any] = {key: value for key, value in settings.items() if key != "groups"}
    values.update(default_lengths(settings, diagonal))
    values["match"], values["off"] = list(values["match"]), list(values["off"])
    if values["faces"] != "all":
        values["faces"] = list(values["faces"])
    if values["walls"] != "all":
        values["walls"] = [_wall(wall) for wall in values["walls"]]
    return core.Settings(**values)


def default_lengths(settings: Mapping[str, Any], diagonal: float) -> Dict[str, float]:
    """Size and first height [mm]; where not given, from the model's diagonal, to two digits."""
    size, height = settings["size"], settings["first_height"]
    if size is None:
        size = float(f"{diagonal / 40.0:.2g}")
    if height is None:
        height = float(f"{size / 10.0:.2g}")
    return {"size": size, "first_height": height}


def _wall(wall: Mapping[str, Any]) -> Dict[str, Any]:
    return {key: list(value) if isinstance(value, tuple) else value
            for key, value in wall.items() if value not in (None, ())}


class Run:
    """Pulls the layers out of a core Mesher in a thread of its own, so that the calling thread
    stays free for Ctrl-C, a progress line or a window's events."""

    def __init__(self, mesher) -> None:
        self._mesher = mesher
        self._reports: "queue.Queue[Any]" = queue.Queue()
        self._thread = threading.Thread(target=self._pull, name="advlayers", daemon=True)
        self._mesh: Any = None
        self._error: Optional[BaseException] = None

    def finish(self, watch: Callable[[List[Any]], None], interval: float = 0.1):
        """Meshes to the end and returns the core's result. `watch` is called with the reports
        that came in since its last call, every `interval` seconds or sooner; what it raises
        cancels the run. Raises what the core raises."""
        self._thread.start()
        try:
            while self._thread.is_alive():
                watch(self._collect(interval))
            watch(self._collect(0.0))
        except BaseException:
            self._mesher.cancel()
            self._thread.join()
            raise
        if self._error is not None:
            raise self._error
        return self._mesh

    def _pull(self) -> None:
        try:
            for report in self._mesher:
                self._reports.put(report)
            self._mesh = self._mesher.result()
        except BaseException as error:  # handed to the calling thread, whatever it is
            self._error = error
        self._reports.put(None)

    def _collect(self, wait: float) -> List[Any]:
        reports = []
        try:
            reports.append(self._reports.get(timeout=wait) if wait else self._reports.get_nowait())
            while True:
                reports.append(self._reports.get_nowait())
        except queue.Empty:
            pass
        return [report for report in reports if report is not None]

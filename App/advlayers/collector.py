"""Keeps Python's collector of cycles out of worker threads.

It runs in whichever thread happens to allocate, and deletes there what it finds: closed panels with
their widgets, timers and nodes of the 3D view. A timer that Qt is to delete in a thread that is not
its own stays in the window's list, and the window's next event crashes FreeCAD.
"""
from __future__ import annotations

import gc
import threading
from typing import Any, Mapping


def keep_out_of_threads() -> None:
    """From now on a collection outside the main thread finds nothing; the main thread's next one
    makes up for it."""
    if _hold not in gc.callbacks:
        gc.callbacks.append(_hold)


def _hold(phase: str, _info: Mapping[str, Any]) -> None:
    """Python calls this at the "start" and the "stop" of every collection."""
    if threading.get_ident() != threading.main_thread().ident:
        (gc.freeze if phase == "start" else gc.unfreeze)()

"""What may crash, or never end, in a process of its own: readers of other programs."""
from __future__ import annotations

import pickle
from typing import Any, Callable

from advlayers.core_access import load_core
from advlayers.errors import InputError

# What sound files take, ten times over.
_SECONDS, _SECONDS_PER_MEGABYTE = 20.0, 5.0
_MEGABYTES, _MEGABYTES_PER_MEGABYTE = 1024.0, 300.0


def call(key: str, path: str, size: int, act: Callable[[], Any]) -> Any:
    """What act() returns in a copy of this process, or raises there: plain values that pickle takes
    along. `size` [bytes] of the file sets the limits. Raises InputError about key and path where
    the copy crashes, or passes them."""
    core = load_core()
    megabytes = size / 2 ** 20
    seconds = _SECONDS + _SECONDS_PER_MEGABYTE * megabytes
    most = _MEGABYTES + _MEGABYTES_PER_MEGABYTE * megabytes
    try:
        done, outcome = pickle.loads(core.in_child(lambda: _answer(act), seconds, most))
    except core.ChildFailed as error:
        raise _refusal(key, path, error, seconds, most) from error
    if done:
        return outcome
    raise outcome


def _answer(act: Callable[[], Any]) -> bytes:
    try:
        return pickle.dumps((True, act()))
    except MemoryError:
        raise
    except Exception as error:
        return pickle.dumps((False, _plain(error)))


def _plain(error: Exception) -> Exception:
    """The error itself, where its copy says the same."""
    if isinstance(error, InputError):
        return error
    try:
        same = pickle.loads(pickle.dumps(error))
        if type(same) is type(error) and str(same) == str(error):
            return error
    except Exception:
        pass
    return RuntimeError(str(error) or type(error).__name__)


def _refusal(key: str, path: str, error, seconds: float, megabytes: float) -> InputError:
    if error.reason == "crashed":
        return InputError(key, "is damaged: its reader crashes on it ({}): {}", error, path)
    if error.reason == "seconds":
        return InputError(key, "cannot be read: it does not end within {} s: {}",
                          f"{seconds:.0f}", path)
    if error.reason == "megabytes":
        return InputError(key, "cannot be read: it takes more than {} MB: {}",
                          f"{megabytes:.0f}", path)
    return InputError(key, "cannot be read: no process can be started for it: {}: {}", error, path)

"""What may crash, or never end, in a process of its own: readers of other programs."""
from __future__ import annotations

import io
import os
import pickle
import sys
from typing import Any, Callable, List

from advlayers.core_access import load_core
from advlayers.errors import InputError

# What sound files take, ten times over.
_SECONDS, _SECONDS_PER_MEGABYTE = 20.0, 5.0
_MEGABYTES, _MEGABYTES_PER_MEGABYTE = 1024.0, 300.0


# A program started with -c runs these words; App and core need not be on its path.
_BEGIN = "import sys; sys.path[:0] = {!r}; from advlayers import child; child.answer()"


def call(key: str, path: str, size: int, act: Callable[..., Any], *given: Any) -> Any:
    """What act(*given) returns in a Python of its own, or raises there: a function of a module and
    plain values, which pickle takes along. `size` [bytes] of the file sets the limits. Raises
    InputError about key and path where the child crashes, or passes them."""
    core = load_core()
    megabytes = size / 2 ** 20
    seconds = _SECONDS + _SECONDS_PER_MEGABYTE * megabytes
    most = _MEGABYTES + _MEGABYTES_PER_MEGABYTE * megabytes
    request = pickle.dumps(sys.path) + pickle.dumps((act, given))
    try:
        answer = core.answer_of_child(_command(core), request, seconds, most)
    except core.ChildFailed as error:
        raise _refusal(key, path, error, seconds, most) from error
    done, outcome = pickle.loads(answer)
    if done:
        return outcome
    raise outcome


def answer() -> None:
    """The child's whole work. Does not return."""
    load_core().answer_parent(_answer)


def _command(core) -> List[str]:
    homes = [os.path.dirname(os.path.dirname(os.path.abspath(file)))
             for file in (__file__, core.__file__)]
    return [_program(), "-c", _BEGIN.format(homes)]


def _program() -> str:
    """A Python that has what this one has: FreeCAD's own without a window, where this is FreeCAD.
    """
    here = sys.executable or ""
    if os.path.basename(here).lower().startswith("python"):
        return here
    folders = [os.path.dirname(here)]
    if "FreeCAD" in sys.modules:
        home = sys.modules["FreeCAD"].getHomePath()
        folders += [os.path.join(home, "bin"), home]
    for folder in folders:
        for name in ("freecadcmd", "FreeCADCmd", "FreeCADCmd.exe"):
            path = os.path.join(folder, name)
            if os.path.isfile(path) and os.access(path, os.X_OK):
                return path
    return here or "python3"


def _answer(request: bytes) -> bytes:
    try:
        file = io.BytesIO(request)
        sys.path[:] = pickle.load(file)
        act, given = pickle.load(file)
        return pickle.dumps((True, act(*given)))
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

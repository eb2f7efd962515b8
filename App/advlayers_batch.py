"""Runs batch jobs: freecadcmd advlayers_batch.py job.json [more.json ...]

Exit status: 0 all meshed; 1 bad input or failure, with one line on stderr for each failed job;
2 meshed, with error-level diagnostics in the report; 130 stopped by Ctrl-C. Plain Python serves
too, for what needs no FreeCAD.

FreeCAD imports this file by its name, runs it again if it raises, ignores errors, and then opens
every other argument as a document: so it always ends in os._exit.
"""
from __future__ import annotations

import os
import signal
import sys
import time
import traceback

_NAME = "advlayers_batch.py"
_FOLDER = os.path.dirname(os.path.realpath(__file__))
_CORE = os.path.join(os.path.dirname(_FOLDER), "mesher_core", "python")
_INTERRUPTED = 130


class _Refused(Exception):
    """The command line or the installation does not allow a run."""


class _Progress:
    """A line that stays in place on a terminal; otherwise a line on stdout every few seconds."""

    def __init__(self, terminal, name: str) -> None:
        self._terminal = terminal if terminal.isatty() else None
        self._name = name
        self._start = time.monotonic()
        self._last = 0.0 if self._terminal else self._start
        self._layers = self._quads = self._triangles = 0
        self._patches = set()

    def watch(self, stage: str, reports) -> None:
        for report in reports:
            self._patches.add(report.patch)
            self._layers += 1
            self._quads += report.quads
            self._triangles += report.triangles
        now = time.monotonic()
        if now - self._last < (0.1 if self._terminal else 5.0):
            return
        self._last = now
        text = (f"{self._name}: {stage}, {len(self._patches)} patches, {self._layers} layers, "
                f"{self._quads} quads, {now - self._start:.1f} s")
        if self._terminal:
            self._terminal.write(f"\r\x1b[K{text}")
            self._terminal.flush()
        else:
            print(text, flush=True)

    def close(self) -> None:
        if self._terminal:
            self._terminal.write("\r\x1b[K")
            self._terminal.flush()


def _jobs():
    """The arguments after this script's own name: FreeCAD 1.0 puts its own name first."""
    names = [os.path.basename(argument) for argument in sys.argv]
    if _NAME not in names:
        raise _Refused(f"cannot find {_NAME} among the arguments")
    jobs = sys.argv[names.index(_NAME) + 1:]
    if not jobs:
        raise _Refused(f"no job given: freecadcmd {_NAME} job.json [more.json ...]")
    return jobs


def _load_own_packages():
    """Imports advlayers from beside this script; an add-on of another version may be installed."""
    own_core = _has_core()
    for folder in (_CORE, _FOLDER) if own_core else (_FOLDER,):
        if folder in sys.path:
            sys.path.remove(folder)
        sys.path.insert(0, folder)
    try:
        import advlayers

        _check_origin("advlayers", advlayers, _FOLDER)
        from advlayers import core_access, job, job_run
        from advlayers.errors import CoreMissing
    except ModuleNotFoundError as error:
        raise _Refused(f"the Python package {error.name} is missing") from error
    try:
        core = core_access.load_core()
        if own_core:
            _check_origin("advlayers_core", core, _CORE)
    except CoreMissing as error:
        raise _Refused(str(error)) from error
    return job, job_run


def _has_core() -> bool:
    """Whether a core was built here, or a wheel of it put here; else Python's own is taken."""
    try:
        return any(name.startswith("_core.") and not name.endswith(".pyi")
                   for name in os.listdir(os.path.join(_CORE, "advlayers_core")))
    except FileNotFoundError:
        return False


def _check_origin(name: str, module, folder: str) -> None:
    origin = os.path.realpath(os.path.dirname(module.__file__))
    expected = os.path.join(folder, name)
    if origin != expected:
        raise _Refused(f"{name} was loaded from {origin}, not from {expected}")


def _run(path: str, job_module, run_module, stderr) -> int:
    progress = _Progress(stderr, path)
    try:
        job = job_module.read_job(path)
        report = run_module.run_job(job, progress.watch)
        status = run_module.exit_status(report)
        print(f"{path}: {report['quads']} quads, {report['triangles']} triangles, "
              f"{report['seconds']['total']:.2f} s, exit status {status}", flush=True)
        return status
    except (ValueError, RuntimeError, OSError) as error:
        progress.close()
        _say(stderr, f"{path}: {error}")
    except Exception as error:  # ours: still one line, the rest on stdout
        progress.close()
        traceback.print_exc(file=sys.stdout)
        _say(stderr, f"{path}: internal error, please report: {type(error).__name__}: {error}")
    finally:
        progress.close()
    return 1


def _say(stderr, text: str) -> None:
    stderr.write(" ".join(text.split()) + "\n")
    stderr.flush()


def _open_streams() -> None:
    """A daemon may have closed them: without, the first file opened takes their place."""
    for number, name in ((0, "stdin"), (1, "stdout"), (2, "stderr")):
        try:
            os.fstat(number)
        except OSError:
            os.dup2(os.open(os.devnull, os.O_RDWR), number)
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(number, "w" if number else "r", closefd=False))
    # A path may be no text.
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


def _own_stderr():
    """stderr for us alone: what FreeCAD and its libraries print there goes to stdout instead."""
    sys.stderr.flush()
    stderr = os.fdopen(os.dup(2), "w", encoding="utf-8", errors="backslashreplace")
    os.dup2(1, 2)
    return stderr


def _interrupt(_signal, _frame) -> None:
    raise KeyboardInterrupt


def main() -> int:
    _open_streams()
    stderr = _own_stderr()
    signal.signal(signal.SIGINT, _interrupt)
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        jobs = _jobs()
        modules = _load_own_packages()
        statuses = [_run(path, *modules, stderr) for path in jobs]
    except _Refused as error:
        _say(stderr, f"advlayers: {error}")
        return 1
    except KeyboardInterrupt:
        _say(stderr, "advlayers: stopped")
        return _INTERRUPTED
    return 1 if 1 in statuses else max(statuses)


def _end(status: int) -> None:
    sys.stdout.flush()
    os._exit(status)


try:
    _end(main())
except BaseException:
    traceback.print_exc()
    _end(1)

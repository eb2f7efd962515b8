"""Does one row of a sweep: `python3 row.py ORDER`. Needs nothing but Python and the order.

Whoever starts it may start it again while it runs, on this machine or another that sees the same
folder: the second waits for the first, finds the row done, and leaves it at that.
"""
from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import subprocess
import sys
import time
from typing import Any, Dict, Iterator, List, Tuple

DONE, STOPPED = 0, 130
_FIGURES = ("nodes", "quads", "triangles", "quad_percent", "layer_quad_percent",
            "angles_45_135_percent", "min_angle", "max_angle", "inverted")


def main(order_file: str) -> int:
    with open(order_file, encoding="utf-8") as file:
        order = json.load(file)
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        with only_one(order["record"] + ".lock"):
            if not _is_done(order):
                _do(order)
    except KeyboardInterrupt:
        return STOPPED
    return DONE


def _interrupt(_signal, _frame) -> None:
    raise KeyboardInterrupt


@contextlib.contextmanager
def only_one(path: str) -> Iterator[None]:
    """Waits for others in the block with the same path. The lock ends with its process."""
    with open(path, "a+b") as file:
        if os.name == "nt":
            import msvcrt

            while True:
                try:
                    msvcrt.locking(file.fileno(), msvcrt.LK_LOCK, 1)
                    break
                except OSError:  # after ten seconds
                    continue
        else:
            import fcntl

            fcntl.lockf(file, fcntl.LOCK_EX)
        yield


def _is_done(order: Dict[str, Any]) -> bool:
    try:
        with open(order["record"], encoding="utf-8") as file:
            record = json.load(file)
        return record["digest"] == order["digest"] and record["status"] in (0, 2) and all(
            _stamp(path) == stamp for path, stamp in record["files"].items())
    except (OSError, ValueError, KeyError):
        return False


def _do(order: Dict[str, Any]) -> None:
    with contextlib.suppress(FileNotFoundError):
        os.remove(order["record"])
    for path in order["files"]:
        os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(order["job_file"], "w", encoding="utf-8") as file:
        json.dump(order["job"], file, indent=1)
    start = time.monotonic()
    status, message = _run([*order["command"], order["job_file"]], order["seconds"],
                           order["megabytes"])
    record = {"name": order["name"], "digest": order["digest"], "status": status,
              "message": message, "seconds": round(time.monotonic() - start, 3),
              "host": socket.gethostname(), "figures": {}, "files": {}}
    if status in (0, 2):
        with open(order["job"]["report"], encoding="utf-8") as file:
            report = json.load(file)
        record["figures"] = {key: report[key] for key in _FIGURES}
        record["files"] = {path: _stamp(path) for path in order["files"]}
    temporary = f"{order['record']}.{os.getpid()}"
    with open(temporary, "w", encoding="utf-8") as file:
        json.dump(record, file, indent=1)
    os.replace(temporary, order["record"])
    _note(order["journal"], f"{order['name']},{status},{record['host']},{os.getpid()}\n")


def _note(path: str, line: str) -> None:
    """One write at the end of the file, so that lines of others stay whole."""
    handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o666)
    try:
        os.write(handle, line.encode())
    finally:
        os.close(handle)


def _stamp(path: str) -> List[int]:
    found = os.stat(path)
    return [found.st_size, found.st_mtime_ns]


def _run(command: List[str], seconds, megabytes) -> Tuple[int, str]:
    """Exit status and what was said; 1 where a limit or a signal ended it."""
    options: Dict[str, Any] = {}
    if os.name == "nt":
        options["creationflags"] = subprocess.CREATE_NEW_PROCESS_GROUP
    else:
        options["preexec_fn"] = lambda: _limit(megabytes)
        options["start_new_session"] = True
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True, errors="replace", **options)
    try:
        said = process.communicate(timeout=seconds)[1]
    except subprocess.TimeoutExpired:
        _kill(process)
        return 1, f"takes longer than its limit of {seconds:g} s"
    except BaseException:
        _kill(process)
        raise
    status = process.returncode
    if status in (0, 1, 2):
        return status, " ".join(said.split())
    limited = f" (with {megabytes:g} MB at most)" if megabytes else ""
    return 1, f"its process ended with status {status}{limited}: {' '.join(said.split())[-300:]}"


def _limit(megabytes) -> None:
    if megabytes:
        import resource

        size = int(megabytes * 2 ** 20)
        resource.setrlimit(resource.RLIMIT_AS, (size, size))


def _kill(process: subprocess.Popen) -> None:
    with contextlib.suppress(ProcessLookupError):
        if os.name == "nt":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)
    process.wait()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

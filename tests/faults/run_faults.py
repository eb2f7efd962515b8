"""Lets calls of a job fail one after the other, as a full or broken disk or a lack of memory would:
no output may be lost or half there, and no job may end with 0 without what was asked for.

    run_faults.py [--group files|mmap|malloc] [--child] [--kill] [--freecad] [--sample N]
                  [--first N] [--last N] [--full]

Of the group, each call fails in turn, or N of them. --child: in the program that reads the CAD file
instead. --kill: the job is killed there (SIGKILL). --freecad: by freecadcmd, with a document
among the outputs. --full: on a disk that has room for 4 kB more each time. Exit status 1 where
a promise is broken. One line for each call that failed, then the sums.
"""
from __future__ import annotations

import argparse
import errno
import json
import os
import random
import struct
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

ROOT = Path(__file__).resolve().parents[2]
OUTPUTS = ["a.vtu", "b.unv", "c.obj", "d.msh", "e.su2", "f.ply"]
OLD = b"older"
PAGE = 4096
Files = Dict[str, Optional[bytes]]


def outputs(freecad: bool) -> List[str]:
    return OUTPUTS[:-1] + ["f.FCStd"] if freecad else OUTPUTS


def build(folder: str) -> str:
    library = os.path.join(folder, "fail_nth.so")
    subprocess.run(["cc", "-shared", "-fPIC", "-o", library,
                    str(Path(__file__).with_name("fail_nth.c")), "-ldl"], check=True)
    return library


def write_job(made: str, freecad: bool) -> List[str]:
    """The command of the job in the folder, which holds older files under every other name."""
    os.makedirs(made, exist_ok=True)
    names = outputs(freecad)
    for name in names[::2]:
        Path(made, name).write_bytes(OLD)
    job = {"input": str(ROOT / "tests" / "data" / "square.brep"), "size": 5.0, "first_height": 0.5,
           "layers": 2, "outputs": names, "report": "r.json"}
    path = Path(made, "job.json")
    path.write_text(json.dumps(job))
    program = "freecadcmd" if freecad else "/usr/bin/python3"
    return [program, str(ROOT / "App" / "advlayers_batch.py"), str(path)]


def files_of(made: str) -> Files:
    return {name: Path(made, name).read_bytes() if Path(made, name).is_file() else None
            for name in os.listdir(made) if name != "job.json"}


class Injected:
    """Runs of the job in which one call fails."""

    def __init__(self, top: str, asked: argparse.Namespace) -> None:
        self._top, self._asked = top, asked
        self._library = build(top)

    def run(self, number: int) -> Tuple[Optional[str], Any, Files, int, str]:
        """Name of the call that failed or None, the ended process, the files, the number of calls
        made, the error."""
        error = errno.ENOMEM if self._asked.group != "files" else \
            (errno.ENOSPC, errno.EIO)[number % 2]
        error = -1 if self._asked.kill else error
        with tempfile.TemporaryDirectory(dir=self._top) as folder:
            made, said = os.path.join(folder, "made"), os.path.join(folder, "said")
            count = Path(folder, "count")
            count.write_bytes(bytes(8))
            command = write_job(made, self._asked.freecad)
            values = {"LD_PRELOAD": self._library, "FAULT_FOLDER": made, "FAULT_NAME": said,
                      "FAULT_GROUP": self._asked.group, "FAULT_COUNT": str(count),
                      "FAULT_CALL": str(number), "FAULT_ERROR": str(error),
                      "FAULT_CHILD": "1" if self._asked.child else ""}
            done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True,
                                  env={**os.environ, **values})
            name = Path(said).read_text().strip() if os.path.exists(said) else None
            return (name, done, files_of(made), struct.unpack("q", count.read_bytes())[0],
                    errno.errorcode.get(error, "killed"))


def fault(status: int, lines: Optional[int], files: Files, names: List[str],
          whole: Files) -> str:
    """What is wrong, or nothing. `lines`: on stderr; None where nobody promises one."""
    shown = {name: content for name, content in files.items()
             if not name.startswith(".advlayers-")}
    if status == 0:
        good = set(shown) == set(whole) and all(
            content and len(content) > 0.9 * len(whole[name] or b"")
            for name, content in shown.items())
        return "" if good else "status 0 without all that was asked for"
    if shown != {name: OLD for name in names[::2]}:
        return f"status {status}, and the files have changed"
    if lines is not None and lines != 1:
        return f"status {status}, {lines} lines"
    return ""


def mixed(files: Files, names: List[str], whole: Files) -> str:
    """What is wrong with the files after a kill, or nothing: all are older ones, or all new."""
    shown = {name: content for name, content in files.items() if not name.startswith(".")}
    if shown == {name: OLD for name in names[::2]}:
        return ""
    parts = [name for name, content in shown.items()
             if content != OLD and len(content or b"") < 0.9 * len(whole[name] or b"")]
    if parts:
        return f"half a file: {' '.join(parts)}"
    new = set(shown) == set(whole) and OLD not in shown.values()
    return "" if new else "some files are older, some new"


def inject(asked: argparse.Namespace, top: str) -> int:
    injected = Injected(top, asked)
    _none, sound, whole, calls, _error = injected.run(0)
    if sound.returncode != 0:
        print(sound.stderr.decode())
        return 1
    last = min(asked.last or calls, calls)
    numbers = list(range(asked.first, last + 1))
    if asked.sample and asked.sample < len(numbers):
        numbers = sorted(random.Random(1).sample(numbers, asked.sample))
    tried: Counter = Counter()
    wrong = 0
    for number in numbers:
        name, done, files, _calls, error = injected.run(number)
        if name is None:
            continue
        # Programs that are not ours may die of a lack of memory; the files are what counts then.
        lines = len(done.stderr.strip().splitlines()) if asked.group == "files" else None
        if asked.kill:
            found = mixed(files, outputs(asked.freecad), whole)
        else:
            found = fault(done.returncode, lines, files, outputs(asked.freecad), whole)
        wrong += bool(found)
        tried[f"{name}, status {done.returncode}"] += 1
        print(number, name, error, done.returncode, found or "holds", flush=True)
    print(f"{calls} calls, {sum(tried.values())} let fail: {dict(tried)}; {wrong} wrong")
    return 1 if wrong else 0


def fill(asked: argparse.Namespace, top: str) -> int:
    """On a disk of its own, which root may mount, with 4 kB more room each time."""
    disk = os.path.join(top, "disk")
    os.mkdir(disk)
    command = write_job(os.path.join(top, "whole"), asked.freecad)
    subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=True)
    whole = files_of(os.path.join(top, "whole"))
    wrong, pages, statuses = 0, 12, Counter()
    while True:
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={PAGE * pages}", "tmpfs", disk],
                       check=True)
        try:
            command = write_job(disk, asked.freecad)
            done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True)
            lines = len(done.stderr.strip().splitlines())
            found = fault(done.returncode, lines, files_of(disk), outputs(asked.freecad), whole)
        finally:
            subprocess.run(["umount", disk], check=True)
        wrong += bool(found)
        statuses[done.returncode] += 1
        print(f"{4 * pages} kB: status {done.returncode}, {found or 'holds'}", flush=True)
        if done.returncode == 0:
            break
        pages += 1
    print(f"{sum(statuses.values())} sizes: {dict(statuses)}; {wrong} wrong")
    return 1 if wrong else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--group", choices=("files", "mmap", "malloc"), default="files")
    parser.add_argument("--child", action="store_true")
    parser.add_argument("--freecad", action="store_true")
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--last", type=int, default=0)
    parser.add_argument("--kill", action="store_true")
    parser.add_argument("--full", action="store_true")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as top:
        return fill(asked, top) if asked.full else inject(asked, top)


if __name__ == "__main__":
    sys.exit(main())

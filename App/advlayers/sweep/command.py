"""`advlayers sweep table.csv job.json`: the command line, progress, and the way out."""
from __future__ import annotations

import argparse
import os
import sys
import time
from typing import List, Sequence

from advlayers.sweep import places, plan, report, table
from advlayers.sweep.errors import SweepError
from advlayers.sweep.plan import Limits, Task

_INTERRUPTED = 130


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="advlayers sweep",
        description="Meshes one job for every row of a table. Rows that are up to date are left "
                    "alone: run it again to go on after a stop.")
    made.add_argument("table", help="CSV: name, keys of the job, cad.OBJECT.NAME, words of paths")
    made.add_argument("job", help="the job file; its paths may hold {name} and other columns")
    made.add_argument("--folder", help="of records, pictures and results (default: TABLE-sweep)")
    made.add_argument("--workers", type=int, default=0, metavar="N",
                      help="rows at a time, here or in a Slurm array (default: as many as there "
                           "are cores, or as Slurm allows)")
    where = made.add_mutually_exclusive_group()
    where.add_argument("--dask", metavar="ADDRESS", help="of a scheduler: tcp://host:8786")
    where.add_argument("--dask-file", metavar="FILE", help="that a scheduler has written")
    where.add_argument("--slurm", action="store_true", help="as an array of Slurm")
    made.add_argument("--slurm-option", action="append", default=[], metavar="OPTION",
                      help='a line of the script: "--time=00:10:00"; may be repeated')
    made.add_argument("--row-seconds", type=float, metavar="S", help="limit of a row")
    made.add_argument("--row-megabytes", type=float, metavar="MB", help="limit of a row")
    return made


def main(arguments: List[str]) -> int:
    """Exit status: 0 all meshed; 1 some failed, or bad input; 2 meshed, some with error-level
    diagnostics; 130 stopped."""
    given = parser().parse_args(arguments)
    try:
        return _sweep(given)
    except SweepError as error:
        print(f"advlayers sweep: {error}", file=sys.stderr)
        return 1


def _sweep(given: argparse.Namespace) -> int:
    folder = os.path.abspath(given.folder or os.path.splitext(given.table)[0] + "-sweep")
    columns, rows = table.read(given.table)
    tasks = plan.plan(columns, rows, given.job, folder,
                      Limits(given.row_seconds, given.row_megabytes))
    left = [task for task in tasks if not plan.is_done(task)]
    if len(left) < len(tasks):
        print(f"{len(tasks) - len(left)} of {len(tasks)} rows are up to date", flush=True)
    stopped = False
    places.interruptible()
    try:
        if left:
            _run(_place(given, folder), left, Progress(len(left)))
    except KeyboardInterrupt:
        stopped = True
    lines = report.results(columns, tasks)
    title = f"{os.path.basename(given.table)}, {os.path.basename(given.job)}"
    report.write(folder, title, columns, lines)
    counts = [sum(line["state"] == state for line in lines)
              for state in (*report.STATES.values(), report.WAITING)]
    meshed, failed, doubtful, waiting = counts
    print(f"{meshed + doubtful} of {len(lines)} rows meshed, {failed} failed, {waiting} not done: "
          f"{os.path.join(folder, 'index.html')}", flush=True)
    if stopped:
        print("advlayers sweep: stopped; run it again to go on", file=sys.stderr)
        return _INTERRUPTED
    return 1 if failed or waiting else 2 if doubtful else 0


def _place(given: argparse.Namespace, folder: str) -> places.Place:
    if given.slurm:
        return places.Slurm(folder, given.slurm_option, given.workers)
    if given.dask or given.dask_file:
        return places.Dask(given.dask or "", given.dask_file or "")
    return places.Here(given.workers)


def _run(place: places.Place, tasks: Sequence[Task], progress: "Progress") -> None:
    running = place.run([task.order_file for task in tasks])
    try:
        for i in running:
            record = plan.record_of(tasks[i])
            progress.over(tasks[i].row.name, record)
    finally:
        running.close()
        progress.close()


class Progress:
    """A line that stays in place on a terminal; otherwise one for each failure, and one now and
    then."""

    def __init__(self, count: int) -> None:
        self._count, self._over, self._failed = count, 0, 0
        self._start = self._last = time.monotonic()
        self._in_place = sys.stdout.isatty()

    def over(self, name: str, record) -> None:
        self._over += 1
        if record is None or record["status"] == 1:
            self._failed += 1
            self._clear()
            why = record["message"] if record else "its process was lost"
            print(f"{name}: {why}", file=sys.stderr, flush=True)
        now = time.monotonic()
        if self._in_place or now - self._last >= 5.0 or self._over == self._count:
            self._last = now
            self._clear()
            print(self.text(now - self._start), end="" if self._in_place else "\n", flush=True)

    def text(self, seconds: float) -> str:
        rate = self._over / max(seconds, 1e-9)
        left = round((self._count - self._over) / rate) if rate else 0
        return (f"{self._over} of {self._count} rows, {self._failed} failed, "
                f"{60 * rate:.3g} rows/min, {left // 60}:{left % 60:02d} left")

    def _clear(self) -> None:
        if self._in_place:
            print("\r\x1b[K", end="")

    def close(self) -> None:
        self._clear()

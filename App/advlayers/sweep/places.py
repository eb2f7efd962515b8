"""Where rows are done: in processes here, on a Dask cluster, as a Slurm array.

Each place takes the files of the orders and yields the number of each row once its process is over;
what became of it stands in its record. A row whose process is lost with its machine is given to
another, `_TRIES` times in all.
"""
from __future__ import annotations

import concurrent.futures
import contextlib
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
from typing import Any, Dict, Iterator, Protocol, Sequence, Set

from advlayers.sweep.errors import SweepError
from advlayers.sweep.plan import ROW_PROGRAM

_TRIES = 4
_POLL = 1.0  # [s]
_CONNECT = 20  # [s] for a scheduler to answer


class Place(Protocol):
    def run(self, orders: Sequence[str]) -> Iterator[int]:
        """Numbers of rows, each once. Closing the iterator stops what is running."""


class Here:
    """Processes of this machine."""

    def __init__(self, workers: int) -> None:
        self._workers = max(1, workers or os.cpu_count() or 1)
        self._running: Set[subprocess.Popen] = set()
        self._stopped = False

    def run(self, orders: Sequence[str]) -> Iterator[int]:
        with concurrent.futures.ThreadPoolExecutor(self._workers) as pool:
            futures = {pool.submit(self._do, order): i for i, order in enumerate(orders)}
            try:
                for future in concurrent.futures.as_completed(futures):
                    future.result()
                    yield futures[future]
            finally:
                self._stopped = True
                for process in list(self._running):
                    process.terminate()

    def _do(self, order: str) -> None:
        for _ in range(_TRIES):
            if self._stopped:
                return
            process = subprocess.Popen([sys.executable, ROW_PROGRAM, order],
                                       stdin=subprocess.DEVNULL)
            self._running.add(process)
            process.wait()
            self._running.discard(process)
            if process.returncode >= 0:
                return


class Dask:
    """A cluster, by the address of its scheduler or by its file. Its workers see this folder and
    have Python under the same path."""

    def __init__(self, address: str = "", scheduler_file: str = "") -> None:
        try:
            import distributed
        except ImportError as error:
            raise SweepError("Dask is not there: install python3-distributed") from error
        self._distributed = distributed
        self._where = {"scheduler_file": scheduler_file} if scheduler_file else {
            "address": address}

    def run(self, orders: Sequence[str]) -> Iterator[int]:
        tries = dict.fromkeys(range(len(orders)), 0)
        while tries:
            client = self._connect()
            try:
                yield from self._run_while_connected(client, orders, tries)
            finally:
                # Rows that are running come to their end; nobody waits for them.
                with contextlib.suppress(Exception):
                    client.close(timeout=2)

    def _connect(self):
        for last in (False, False, True):
            try:
                return self._distributed.Client(timeout=_CONNECT, set_as_default=False,
                                                **self._where)
            except (OSError, TimeoutError, ValueError) as error:
                if last:
                    raise SweepError(f"cannot reach the Dask scheduler: {error}") from error
                time.sleep(_POLL)
        raise AssertionError

    def _run_while_connected(self, client, orders: Sequence[str],
                             tries: Dict[int, int]) -> Iterator[int]:
        """Takes those that are over out of `tries`; returns where the connection is lost."""
        futures = {client.submit(subprocess.run, [sys.executable, ROW_PROGRAM, orders[i]],
                                 stdin=subprocess.DEVNULL, pure=False, retries=_TRIES): i
                   for i in tries}
        waiting = set(futures)
        while waiting:
            over = {future for future in waiting if future.done()}
            waiting -= over
            for future in over:
                i = futures[future]
                lost = future.status != "finished"
                tries[i] += lost
                if not lost or tries[i] >= _TRIES:
                    del tries[i]
                    yield i
            if any(futures[future] in tries for future in over) or client.status != "running":
                return  # what is left is submitted again, by a new client
            time.sleep(0.05 if over else 0.2)


class Slurm:
    """An array of jobs; the script stays in the sweep's folder."""

    def __init__(self, folder: str, options: Sequence[str] = (), at_once: int = 0) -> None:
        for program in ("sbatch", "squeue", "scancel"):
            if shutil.which(program) is None:
                raise SweepError(f"Slurm is not there: no {program} on the path")
        self._folder, self._options, self._at_once = folder, options, at_once

    def run(self, orders: Sequence[str]) -> Iterator[int]:
        left = list(range(len(orders)))
        for _ in range(_TRIES):
            job = self._submit([orders[i] for i in left])
            try:
                over: Set[int] = set()
                while self._runs(job) or self._finished(left) - over:
                    for i in sorted(self._finished(left) - over):
                        over.add(i)
                        yield left[i]
                    time.sleep(_POLL)
            finally:
                if self._runs(job):
                    subprocess.run(["scancel", job], check=False)
            left = [left[i] for i in range(len(left)) if i not in over]
            if not left:
                return
        yield from left

    def _mark(self, i: int) -> str:
        return os.path.join(self._folder, "slurm", f"{i}.over")

    def _submit(self, orders: Sequence[str]) -> str:
        shutil.rmtree(os.path.join(self._folder, "slurm"), ignore_errors=True)
        os.makedirs(os.path.join(self._folder, "slurm"))
        listed = os.path.join(self._folder, "slurm", "orders.txt")
        with open(listed, "w", encoding="utf-8") as file:
            file.writelines(order + "\n" for order in orders)
        script = os.path.join(self._folder, "slurm", "sweep.sh")
        with open(script, "w", encoding="utf-8") as file:
            file.write(self._script(len(orders), listed))
        done = subprocess.run(["sbatch", "--parsable", script], capture_output=True, text=True,
                              check=False)
        if done.returncode:
            raise SweepError(f"sbatch refuses {script}: {' '.join(done.stderr.split())}")
        return re.split(r"[;\s]", done.stdout.strip())[0]

    def _script(self, count: int, listed: str) -> str:
        at_once = f"%{self._at_once}" if self._at_once else ""
        options = "".join(f"#SBATCH {option}\n" for option in self._options)
        folder = os.path.join(self._folder, "slurm")
        return (
            "#!/bin/sh\n#SBATCH --job-name=advlayers-sweep\n"
            f"#SBATCH --array=0-{count - 1}{at_once}\n#SBATCH --ntasks=1 --requeue\n"
            f"#SBATCH --output={folder}/%a.log\n{options}"
            f"order=$(sed -n \"$((SLURM_ARRAY_TASK_ID + 1))p\" {shlex.quote(listed)})\n"
            f"{shlex.quote(sys.executable)} {shlex.quote(ROW_PROGRAM)} \"$order\" &&\n"
            f"  touch {shlex.quote(folder)}/\"$SLURM_ARRAY_TASK_ID\".over\n")

    def _finished(self, left: Sequence[int]) -> Set[int]:
        return {i for i in range(len(left)) if os.path.exists(self._mark(i))}

    @staticmethod
    def _runs(job: str) -> bool:
        done = subprocess.run(["squeue", "--noheader", "--jobs", job], capture_output=True,
                              text=True, check=False)
        return done.returncode == 0 and bool(done.stdout.strip())


def interruptible() -> None:
    """A stop from outside ends the sweep as Ctrl-C does."""
    def stop(_signal: int, _frame: Any) -> None:
        raise KeyboardInterrupt

    signal.signal(signal.SIGTERM, stop)

"""Runs cases in processes of their own, so that a crash or a hang is one row of the table.

A worker is this program's own script with --worker; it reads case numbers from stdin, and writes
one line of JSON for each to stdout.
"""
from __future__ import annotations

import json
import os
import queue
import subprocess
import sys
import threading
from typing import Any, Callable, Dict, Iterator, List


def serve(run: Callable[[int], Dict[str, Any]]) -> None:
    """A worker's loop."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # libraries that print must not spoil the answers
    for line in sys.stdin:
        answers.write(json.dumps(run(int(line))) + "\n")
        answers.flush()


class _Worker:
    def __init__(self, command: List[str]) -> None:
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, text=True)

    def ask(self, number: int, seconds: float) -> Dict[str, Any]:
        """The row of a case, or one that says how the worker ended."""
        late = threading.Timer(seconds, self.process.kill)
        late.start()
        try:
            self.process.stdin.write(f"{number}\n")
            self.process.stdin.flush()
            answer = self.process.stdout.readline()
        except BrokenPipeError:
            answer = ""
        hung = not late.is_alive()
        late.cancel()
        if answer:
            return json.loads(answer)
        status = self.process.wait()
        fault = f"no answer within {seconds:g} s" if hung else f"the process ended with {status}"
        return {"number": number, "name": "?", "faults": [fault]}

    def ended(self) -> bool:
        return self.process.poll() is not None

    def stop(self) -> None:
        self.process.stdin.close()
        self.process.wait()


def run_cases(command: List[str], numbers: List[int], processes: int,
              seconds: float) -> Iterator[Dict[str, Any]]:
    """The rows of the cases, in the order in which they end."""
    waiting: "queue.Queue[int]" = queue.Queue()
    rows: "queue.Queue[Dict[str, Any]]" = queue.Queue()
    for number in numbers:
        waiting.put(number)

    def work() -> None:
        worker = _Worker(command)
        while True:
            try:
                number = waiting.get_nowait()
            except queue.Empty:
                break
            rows.put(worker.ask(number, seconds))
            if worker.ended():
                worker = _Worker(command)
        worker.stop()

    threads = [threading.Thread(target=work, daemon=True) for _ in range(processes)]
    for thread in threads:
        thread.start()
    for _ in numbers:
        yield rows.get()

"""Coverage-guided fuzzing: ./dev soak fuzz [MINUTES]

libFuzzer on our checks of CAD files (what passes them goes on through the gate) and on sequences of
mesh operations, and a fuzzer of our own for the readers in Python, in turn, for so many minutes by
the clock in all. What was learnt stays in out/fuzz/corpus, what was found in out/fuzz/finds; exit
status 1 where there is something.
"""
from __future__ import annotations

import os
import re
import resource
import shutil
import subprocess
import sys
from typing import List, Tuple

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
OUT = os.path.join(ROOT, "out", "fuzz")
COMPILED = ("brep", "step", "iges", "stl", "mesh")
PYTHON = ("unv", "job")
LONGEST = 20_000  # bytes of an input
SLOW = 10  # [s] for one input


def corpus_of(target: str) -> str:
    """The one that grows, with the seeds of the checkout in it."""
    folder = os.path.join(OUT, "corpus", target)
    seeds = os.path.join(HERE, "corpus", target)
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(seeds) if os.path.isdir(seeds) else ():
        shutil.copy(os.path.join(seeds, name), folder)
    return folder


def command(target: str, seconds: int, finds: str) -> List[str]:
    corpus = corpus_of(target)
    if target in PYTHON:
        return [sys.executable, os.path.join(HERE, "python_fuzzer.py"), target, str(seconds),
                corpus, finds]
    return [os.path.join(ROOT, "build", "fuzz", f"fuzz_{target}"), f"-max_total_time={seconds}",
            f"-max_len={LONGEST}", f"-timeout={SLOW}", f"-artifact_prefix={finds}/{target}-",
            "-print_final_stats=1", corpus]


def run(target: str, seconds: int, finds: str) -> Tuple[int, str]:
    """Status and a line of the table."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command(target, seconds, finds), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    computed = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    with open(os.path.join(OUT, f"{target}.log"), "w", encoding="utf-8") as file:
        file.write(done.stdout)
    units = re.search(r"number_of_executed_units: (\d+)", done.stdout)
    said = f"{units.group(1)} runs" if units else done.stdout.strip().rsplit("\n", 1)[-1]
    reached = re.findall(r"cov: (\d+)", done.stdout)
    if reached:
        said += f", {reached[-1]} places reached"
    return done.returncode, f"{target:5s} {computed:7.0f} s of computing, {said}"


def main() -> int:
    minutes = float(sys.argv[1]) if len(sys.argv) > 1 else 7.0
    finds = os.path.join(OUT, "finds")
    os.makedirs(finds, exist_ok=True)
    seconds = max(1, round(60.0 * minutes / len(COMPILED + PYTHON)))
    bad = 0
    for target in COMPILED + PYTHON:
        status, line = run(target, seconds, finds)
        bad += status != 0
        print(line + ("   FOUND: see out/fuzz" if status else ""), flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())

"""Coverage-guided fuzzing of our own readers in Python: of UNV meshes and of job files.

    python_fuzzer.py unv|job SECONDS CORPUS FINDS    exit status 1 where there was a find

An input that reaches a line of the reader by a way that no other has joins the corpus. A find is
any error that is not the reader's own way to refuse; it is kept in the folder FINDS.
"""
from __future__ import annotations

import os
import sys
import tempfile
import time
import traceback
from random import Random
from typing import Callable, Dict, List, Set, Tuple

from advlayers import job, unv_file
from advlayers.errors import InputError

_LONGEST = 4096  # bytes of an input
_WORDS = {
    "unv": [b"-1", b"2411", b"2412", b"2467", b"    -1\n", b"41", b"44", b"111", b"11", b"1D+10",
            b"nan", b"1e999", b"\n", b"99999999999999999999"],
    "job": [b"{", b"}", b"[", b"]", b'"', b",", b":", b"null", b"true", b"1e999", b"NaN", b"-1",
            b'"edges"', b'"size"', b'"walls"', b'"sizes"', b'"groups"', b'"extrude"', b'"volume"',
            b'"Edge1"', b'"Face0"', b"\\u0000", b"\\ud800", b"9" * 400],
}
_SOUND = {
    "unv": [b"    -1\n  2411\n" + b"".join(
        b"%10d         1         1        11\n  %.16E  %.16E  0.0D+00\n" % (k, k // 2, k % 2)
        for k in range(1, 5)) + b"    -1\n    -1\n  2412\n         1        91         1         1"
        b"         7         3\n         1         2         3\n    -1\n"],
    "job": [b'{"input": "box.brep", "size": 3.0, "first_height": 0.3, "layers": 4,\n "walls": '
            b'[{"edges": ["Edge1"], "first_height": 0.2}], "groups": {"inlet": ["Face1"]},\n'
            b' "outputs": ["mesh.vtu"], "report": "report.json"}'],
}


def _read_unv(path: str) -> None:
    try:
        unv_file.read_unv(path)
    except ValueError:
        pass


def _read_job(path: str) -> None:
    try:
        job.read_job(path)
    except InputError:
        pass


_READ: Dict[str, Callable[[str], None]] = {"unv": _read_unv, "job": _read_job}


class _Coverage:
    """Which line followed which, in the files of our own package."""

    def __init__(self) -> None:
        self.seen: Set[Tuple[str, int, int]] = set()
        self._steps: Set[Tuple[str, int, int]] = set()

    def run(self, act: Callable[[], None]) -> bool:
        """Whether a step was new."""
        self._steps = set()
        sys.settrace(self._enter)
        try:
            act()
        finally:
            sys.settrace(None)
        new = self._steps - self.seen
        self.seen |= new
        return bool(new)

    def _enter(self, frame, _event, _given):
        name = frame.f_code.co_filename
        if os.sep + "advlayers" + os.sep not in name:
            return None
        last = 0

        def line(inner, _kind, _value):
            nonlocal last
            self._steps.add((name, last, inner.f_lineno))
            last = inner.f_lineno
            return line

        return line


def _mutant(rng: Random, corpus: List[bytes], words: List[bytes]) -> bytes:
    data = bytearray(rng.choice(corpus))
    for _ in range(rng.randint(1, 4)):
        at = rng.randrange(len(data) + 1)
        way = rng.randrange(6)
        if way == 0:
            del data[at:at + rng.randint(1, 16)]
        elif way == 1 and data:
            data[min(at, len(data) - 1)] = rng.randrange(256)
        elif way == 2:
            data[at:at] = rng.choice(words)
        elif way == 3:
            data[at:at] = data[at:at + rng.randint(1, 40)]
        elif way == 4:
            other = rng.choice(corpus)
            data[at:] = other[rng.randrange(len(other) + 1):]
        else:
            data[at:at + rng.randint(1, 8)] = rng.choice(words)
    return bytes(data[:_LONGEST])


def fuzz(target: str, seconds: float, corpus_folder: str, finds: str) -> int:
    rng, coverage = Random(time.time_ns()), _Coverage()
    corpus = list(_SOUND[target])
    for name in sorted(os.listdir(corpus_folder)):
        with open(os.path.join(corpus_folder, name), "rb") as file:
            corpus.append(file.read())
    runs, found, kept = 0, 0, len(corpus)
    end = time.monotonic() + seconds
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "input." + target)
        while time.monotonic() < end:
            data = corpus[runs] if runs < kept else _mutant(rng, corpus, _WORDS[target])
            with open(path, "wb") as file:
                file.write(data)
            runs += 1
            try:
                if coverage.run(lambda: _READ[target](path)) and runs > kept:
                    corpus.append(data)
            except Exception:
                found += 1
                with open(os.path.join(finds, f"{target}-{found}"), "wb") as file:
                    file.write(data)
                traceback.print_exc()
    for number, data in enumerate(corpus[kept:]):
        with open(os.path.join(corpus_folder, f"{time.time_ns():x}-{number}"), "wb") as file:
            file.write(data)
    print(f"{runs} runs, {len(coverage.seen)} steps reached, {found} finds")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(fuzz(sys.argv[1], float(sys.argv[2]), sys.argv[3], sys.argv[4]))

"""Files that appear together or not at all."""
from __future__ import annotations

import errno
import os
import shutil
import tempfile
from typing import Callable, List, Tuple


class Outputs:
    """Each is written under its own name in a folder beside its target, because some formats have
    the file's name inside, and takes its place in publish(). What a writer puts beside it goes the
    same way. Leaving the `with` block removes what is left."""

    def __init__(self) -> None:
        self._pending: List[Tuple[str, str]] = []  # folder, target

    def __enter__(self) -> "Outputs":
        return self

    def __exit__(self, *_error) -> None:
        for folder, _target in self._pending:
            shutil.rmtree(folder, ignore_errors=True)

    def write(self, target: str, writer: Callable[[str], None]) -> None:
        where, name = os.path.split(target)
        folder = tempfile.mkdtemp(prefix=".advlayers-", dir=where or ".")
        self._pending.append((folder, target))
        temporary = os.path.join(folder, name)
        writer(temporary)
        # FreeCAD's writers say nothing when the disk is full.
        if not os.path.exists(temporary):
            raise OSError(errno.EIO, "nothing was written", target)
        for made in os.listdir(folder):
            path = os.path.join(folder, made)
            if os.path.isfile(path) and not os.path.getsize(path):
                raise OSError(errno.EIO, "nothing was written", target)

    def publish(self) -> None:
        for folder, target in self._pending:
            for made in sorted(os.listdir(folder)):
                os.replace(os.path.join(folder, made),
                           os.path.join(os.path.dirname(target), made))
            os.rmdir(folder)
        self._pending.clear()

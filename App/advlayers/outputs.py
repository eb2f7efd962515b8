"""Files that appear together or not at all, each read by its structure before it is seen."""
from __future__ import annotations

import contextlib
import errno
import os
import re
import shutil
import socket
import stat
import tempfile
from typing import Callable, List, Optional, Tuple

from advlayers import written_file

# Host and process of whoever made the folder, so that the next run may clean up after one that was
# killed.
_OURS = re.compile(r"\.advlayers-(?P<host>.+)-(?P<process>[0-9]+)-[^-]+")


class Outputs:
    """Each is written under its own name in a folder beside its target, because some formats have
    the file's name inside, and takes its place in publish(). What a writer puts beside it goes the
    same way. Leaving the `with` block removes what is left."""

    def __init__(self) -> None:
        self._pending: List[Tuple[str, str]] = []  # folder, target
        self._made: List[str] = []  # folders that were not there

    def __enter__(self) -> "Outputs":
        return self

    def __exit__(self, *_error) -> None:
        for folder, _target in self._pending:
            shutil.rmtree(folder, ignore_errors=True)
        for folder in self._made:
            with contextlib.suppress(OSError):
                os.rmdir(folder)

    def make_folder(self, path: str) -> None:
        """For a target, where it is not there."""
        if not os.path.isdir(path):
            os.mkdir(path)
            self._made.append(path)

    def write(self, target: str, writer: Callable[[str], None]) -> None:
        """Raises OSError with the target, for whatever goes wrong with the file."""
        where, name = os.path.split(target)
        where = where or "."
        try:
            _clean_up(where)
            folder = _new_folder(where)
            self._pending.append((folder, target))
            temporary = os.path.join(folder, name)
            writer(temporary)
            if not os.path.exists(temporary):
                raise OSError(errno.EIO, "nothing was written")
            for path in _files_below(folder):
                written_file.check(path)
                _to_disk(path)
            _to_disk(folder)
        except OSError as error:
            raise _about(target, error, where) from error

    def publish(self) -> None:
        """Raises OSError with the target whose turn failed; all are as they were before then."""
        moves = [(os.path.join(folder, name), os.path.join(os.path.dirname(target), name))
                 for folder, target in self._pending for name in sorted(os.listdir(folder))]
        done: List[Tuple[str, Optional[str]]] = []  # target, and where its older file is
        for temporary, target in moves:
            try:
                older = _keep(target, os.path.dirname(temporary))
                done.append((target, older))
                os.replace(temporary, target)
            except OSError as error:
                _take_back(done)
                raise _about(target, error, os.path.dirname(target) or ".") from error
        for where in {os.path.dirname(target) or "." for _temporary, target in moves}:
            _to_disk(where)
        for folder, _target in self._pending:
            shutil.rmtree(folder, ignore_errors=True)
        self._made.clear()
        self._pending.clear()


def _new_folder(where: str) -> str:
    """Nobody else can know its name, nor put anything into it."""
    return tempfile.mkdtemp(prefix=f".advlayers-{socket.gethostname()}-{os.getpid()}-", dir=where)


def _clean_up(where: str) -> None:
    """Takes away what runs of this machine left that have not come to their end."""
    for name in os.listdir(where):
        made = _OURS.fullmatch(name)
        if made is None or made["host"] != socket.gethostname():
            continue
        path = os.path.join(where, name)
        kind = os.lstat(path)
        if stat.S_ISDIR(kind.st_mode) and kind.st_uid == os.getuid() and \
                not _running(int(made["process"])):
            shutil.rmtree(path, ignore_errors=True)


def _running(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        pass
    return True


def _files_below(folder: str) -> List[str]:
    return [os.path.join(where, name) for where, _folders, names in os.walk(folder)
            for name in names]


def _to_disk(path: str) -> None:
    """Errors that the system has kept to itself so far come up here."""
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _keep(target: str, folder: str) -> Optional[str]:
    """A second name for what stands there, to put it back by; None: there is nothing. A folder is
    moved away, since none takes the place of another."""
    if not os.path.lexists(target):
        return None
    kept = os.path.join(tempfile.mkdtemp(dir=folder), "older")
    if os.path.isdir(target) and not os.path.islink(target):
        os.rename(target, kept)
        return kept
    try:
        os.link(target, kept, follow_symlinks=False)
    except OSError:  # not every file system has second names
        shutil.copy2(target, kept, follow_symlinks=False)
    return kept


def _take_back(done: List[Tuple[str, Optional[str]]]) -> None:
    for target, older in reversed(done):
        if older is not None:
            os.replace(older, target)
        elif os.path.isdir(target):
            shutil.rmtree(target, ignore_errors=True)
        elif os.path.lexists(target):
            os.remove(target)


def _about(target: str, error: OSError, where: str) -> OSError:
    """The same about the file that was asked for. Writers that are not ours do not say that the
    disk is full; they leave a part of the file behind."""
    number, text = error.errno or errno.EIO, error.strerror or str(error)
    if number == errno.EIO and _is_full(where):
        number, text = errno.ENOSPC, os.strerror(errno.ENOSPC)
    return OSError(number, text, target)


def _is_full(where: str) -> bool:
    disk = os.statvfs(where)
    return disk.f_bavail * disk.f_frsize < 2 ** 16

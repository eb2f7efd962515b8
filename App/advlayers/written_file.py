"""Whether a file that was just written is whole, by its structure: not every writer says so when
the disk is full."""
from __future__ import annotations

import errno
import os
import struct
import zipfile
from typing import Callable, Dict

_HDF = b"\x89HDF\r\n\x1a\n"
# What the last line of a text is in a format; of others it ends with the line.
_LAST_LINES = {".vtu": b"</VTKFile>", ".unv": b"    -1", ".bdf": b"ENDDATA", ".mesh": b"End"}
_TEXTS = (".inp", ".obj", ".su2", ".json", ".mapbc")


def check(path: str) -> None:
    """Raises OSError where a part of the file is missing."""
    if not os.path.getsize(path):
        raise OSError(errno.EIO, "nothing was written", path)
    ending = os.path.splitext(path)[1].lower()
    _CHECKS.get(ending, lambda _path: None)(path)


def _cut_off(path: str, what: str) -> OSError:
    return OSError(errno.EIO, f"it was not written whole ({what})", path)


def _zip(path: str) -> None:
    try:
        with zipfile.ZipFile(path) as archive:
            bad = archive.testzip()
            names = archive.namelist()
    except (zipfile.BadZipFile, EOFError) as error:
        raise _cut_off(path, str(error)) from error
    if bad is not None or "Document.xml" not in names:
        raise _cut_off(path, f"{bad or 'Document.xml'} is damaged")


def _hdf(path: str) -> None:
    """The first block of an HDF5 file says where the file ends (HDF5 File Format Specification 3.0,
    II.A), and versions from 3 whether it was closed by its writer."""
    with open(path, "rb") as file:
        block = file.read(128)
    if not block.startswith(_HDF) or len(block) < 64:
        raise _cut_off(path, "no HDF5 file")
    version = block[8]
    if version < 2:
        width = block[13]
        begin = 24 + (4 if version == 1 else 0)
    else:
        width = block[9]
        begin = 12
    # Addresses: of the base, of free space or an extension, of the end.
    base, _other, end = struct.unpack_from("<3Q" if width == 8 else "<3I", block, begin)
    opened = version >= 3 and block[11] & 1
    if base or end > os.path.getsize(path) or opened:
        raise _cut_off(path, f"{os.path.getsize(path)} of {end} bytes")


def _text(path: str) -> None:
    with open(path, "rb") as file:
        file.seek(max(0, os.path.getsize(path) - 200))
        lines = file.read().splitlines(keepends=True)
    wanted = _LAST_LINES.get(os.path.splitext(path)[1].lower())
    last = lines[-1]
    if wanted is not None and last.strip(b"\r\n") != wanted:
        raise _cut_off(path, "its last line is missing")
    if wanted is None and not last.endswith(b"\n"):
        raise _cut_off(path, "its last line has no end")


def _png(path: str) -> None:
    with open(path, "rb") as file:
        file.seek(max(0, os.path.getsize(path) - 12))
        if file.read()[4:8] != b"IEND":
            raise _cut_off(path, "its end is missing")


_CHECKS: Dict[str, Callable[[str], None]] = {
    ".fcstd": _zip, ".med": _hdf, ".cgns": _hdf, ".png": _png,
    **{ending: _text for ending in (*_LAST_LINES, *_TEXTS)},
}

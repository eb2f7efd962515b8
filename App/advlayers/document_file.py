"""What a FreeCAD document is as a file: a zip archive, checked before FreeCAD opens it."""
from __future__ import annotations

import os
import zipfile
import zlib
from typing import List

from advlayers.errors import InputError

# Expanded: so much more than the file itself, or this in any case [bytes].
_EXPANDED, _LEAST_EXPANDED = 200, 2 ** 30
_MEMBERS = 100_000
_CHUNK = 2 ** 20
MAIN = "Document.xml"


def check(path: str) -> None:
    """Raises InputError naming the file unless each of its members is whole, has a name of its own
    that stays in the archive, and all of them together are of a sensible size."""
    try:
        with zipfile.ZipFile(path) as archive:
            members = archive.infolist()
            _check_members(path, members)
            for member in members:
                with archive.open(member) as file:
                    while file.read(_CHUNK):  # to its end, where its check sum is compared
                        pass
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError,
            OSError, UnicodeDecodeError) as error:
        raise InputError("input", "is damaged, or no FreeCAD document: {}: {}",
                         " ".join(str(error).split()), path) from error


def _check_members(path: str, members: List[zipfile.ZipInfo]) -> None:
    names = [member.filename for member in members]
    if MAIN not in names:
        raise InputError("input", "is no FreeCAD document: it lacks {}: {}", MAIN, path)
    if len(names) > _MEMBERS or len(set(names)) < len(names):
        raise InputError("input", "is damaged: it has too many members, or one twice: {}", path)
    for name in names:
        if os.path.isabs(name) or ".." in name.split("/"):
            raise InputError("input", "has a member outside of itself, {}: {}", name, path)
    expanded = sum(member.file_size for member in members)
    most = max(_LEAST_EXPANDED, _EXPANDED * os.path.getsize(path))
    if expanded > most:
        raise InputError("input", "expands to {} MB: {}", expanded >> 20, path)

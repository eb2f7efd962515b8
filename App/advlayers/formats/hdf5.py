"""New HDF5 files, for the formats that build on them."""
from __future__ import annotations

import contextlib
import errno
from typing import Any, Iterator


@contextlib.contextmanager
def open_new(path: str) -> Iterator[Any]:
    """A file to fill. Raises OSError where it cannot be written whole."""
    import h5py

    try:
        with h5py.File(path, "w", track_order=True) as file:
            yield file
    except RuntimeError as error:  # h5py's word for a full disk when the file is closed
        raise OSError(errno.EIO, f"it could not be written whole: {error}", path) from error


def folder(parent, name):
    """A new group. The libraries of MED and CGNS go through its members as they were made."""
    return parent.create_group(name, track_order=True)

"""New HDF5 files, for the formats that build on them."""
from __future__ import annotations

import contextlib
from typing import Any, Iterator


@contextlib.contextmanager
def open_new(path: str) -> Iterator[Any]:
    """A file to fill: in memory, and written at once in the end. On a full disk the library itself
    ends the whole program. Raises OSError."""
    import h5py

    with h5py.File(path, "w", driver="core", backing_store=False, track_order=True) as file:
        yield file
        file.flush()
        image = file.id.get_file_image()
    with open(path, "wb") as written:
        written.write(image)


def folder(parent, name):
    """A new group. The libraries of MED and CGNS go through its members as they were made."""
    return parent.create_group(name, track_order=True)

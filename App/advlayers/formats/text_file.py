"""A text file that is written in rows of numbers, some ten thousand at a time."""
from __future__ import annotations

from typing import Any, BinaryIO

import numpy as np

from advlayers.core_access import load_core

_ROWS = 20_000  # at a time: what is formatted at once takes some megabytes


class TextFile:
    """Used in a `with` block. Leaving it raises what the system says of a full disk."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._file: BinaryIO
        self._format_rows = load_core().number_rows

    def __enter__(self) -> "TextFile":
        self._file = open(self._path, "wb")
        return self

    def __exit__(self, *_error) -> None:
        self._file.close()

    def text(self, text: str) -> None:
        self._file.write(text.encode("utf-8"))

    def rows(self, form: str, *arrays: Any) -> None:
        """`form` is that of one row, as core.number_rows() has it; the arrays give its numbers."""
        for start in range(0, len(arrays[0]), _ROWS):
            self._file.write(self._format_rows(
                form, *(array[start:start + _ROWS] for array in arrays)))

    def numbered(self, form: str, first: int, *arrays: Any) -> None:
        """rows() with a number in front that counts from `first`."""
        for start in range(0, len(arrays[0]), _ROWS):
            parts = [array[start:start + _ROWS] for array in arrays]
            numbers = np.arange(first + start, first + start + len(parts[0]))
            self._file.write(self._format_rows(form, numbers, *parts))

    def listed(self, numbers: Any, each: str, per_row: int, between: str = "") -> None:
        """Whole numbers, `per_row` of them in a row and the rest in the last one."""
        numbers = np.ascontiguousarray(numbers)
        full = len(numbers) // per_row * per_row
        for part in (numbers[:full].reshape(-1, per_row), numbers[full:].reshape(1, -1)):
            if part.size:
                self.rows(between.join([each] * part.shape[1]) + "\n", part)

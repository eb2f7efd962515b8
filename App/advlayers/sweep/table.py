"""The table of a sweep: a CSV file with one row for each mesh.

Columns: `name`; keys of the job ("size", "walls[0].layers", "y_plus.speed"); parameters of a
FreeCAD document as "cad.OBJECT.NAME"; whatever the job's paths name in braces; and "info.ANYTHING"
for the results alone.
"""
from __future__ import annotations

import csv
import json
import re
from dataclasses import dataclass
from typing import Any, Dict, List, Tuple

from advlayers.sweep.errors import SweepError

NAME = "name"
_PLAIN_NAME = re.compile(r"[\w.+=-]+")  # it becomes a part of file names


@dataclass(frozen=True)
class Row:
    name: str
    values: Dict[str, Any]  # of the columns that have one, `name` left out


def read(path: str) -> Tuple[List[str], List[Row]]:
    """The columns, `name` first, and the rows. Raises SweepError."""
    try:
        with open(path, encoding="utf-8-sig", newline="") as file:
            lines = [line for line in csv.reader(file) if any(cell.strip() for cell in line)]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise SweepError(f"cannot read the table {path}: {error}") from error
    if len(lines) < 2:
        raise SweepError(f"the table {path} has no row")
    columns = [cell.strip() for cell in lines[0]]
    for column in columns:
        if not column or columns.count(column) > 1:
            raise SweepError(f"the table {path} has the column {column!r} twice or without a name")
    width = len(str(len(lines) - 1))
    rows = [_row(path, number, width, columns, line) for number, line in enumerate(lines[1:], 1)]
    names = [row.name for row in rows]
    for name in names:
        if names.count(name) > 1:
            raise SweepError(f"the table {path} has two rows of the name {name}")
    return [NAME] + [column for column in columns if column != NAME], rows


def _row(path: str, number: int, width: int, columns: List[str], line: List[str]) -> Row:
    if len(line) > len(columns):
        raise SweepError(f"row {number} of {path} has {len(line)} cells, the table has "
                         f"{len(columns)} columns")
    cells = {column: cell.strip() for column, cell in zip(columns, line) if cell.strip()}
    name = cells.pop(NAME, f"row-{number:0{width}d}")
    if not _PLAIN_NAME.fullmatch(name) or name.startswith("."):
        raise SweepError(f"row {number} of {path}: the name {name!r} is none for a file: letters, "
                         "digits and _ . + = - may be in it")
    return Row(name, {column: _value(cell) for column, cell in cells.items()})


def _value(cell: str) -> Any:
    """Numbers, true, false and lists as JSON has them; all else is text."""
    try:
        return json.loads(cell, parse_constant=str)
    except ValueError:
        return cell

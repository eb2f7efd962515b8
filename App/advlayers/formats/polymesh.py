"""OpenFOAM's polyMesh: a folder of the files points, faces, owner, neighbour and boundary.

Faces between cells come first, in the upper-triangular order that OpenFOAM asks for, then patch by
patch those on the border; each face's normal points out of the cell that owns it.
"""
from __future__ import annotations

import os
import re
from typing import Any, Dict, List, Tuple

import numpy as np

from advlayers.errors import InputError
from advlayers.formats.mesh_parts import KINDS as ALL_KINDS, MeshParts
from advlayers.formats.sides import SIDES

NAME = "polyMesh"  # of the folder
# Surface elements and lines only name what they bound.
KINDS = frozenset(kind for kind, entry in ALL_KINDS.items() if not entry.sides)
_NO_NODE = -1  # in the fourth place of a triangle
# What the name of a patch says of its type, where the job says nothing.
_BY_NAME = ((re.compile("wall", re.I), "wall"), (re.compile("symm", re.I), "symmetry"))
_REST = "rest"  # border faces of no named part
_BANNER = "// Written by Advancing Layers\n"


def write(folder: str, parts: MeshParts) -> None:
    """Coordinates are written as they are: OpenFOAM takes them for metres. Raises InputError for a
    mesh without cells, or of second order."""
    volume = parts.of(3)
    if not volume:
        raise InputError("outputs", "OpenFOAM needs cells: ask for extrude or volume")
    if parts.second_order:
        raise InputError("outputs", "OpenFOAM has no cells of second order: ask for order 1")
    faces, owner, neighbour, patches = _faces(parts, volume)
    os.makedirs(folder, exist_ok=True)
    cells = sum(map(len, volume))
    note = (f"nPoints:{len(parts.nodes)} nCells:{cells} nFaces:{len(faces)} "
            f"nInternalFaces:{len(neighbour)}")
    _write(folder, "points", "vectorField", "", len(parts.nodes),
           ["(%.17g %.17g %.17g)" % tuple(row) for row in parts.nodes.tolist()])
    _write(folder, "faces", "faceList", "", len(faces), [
        "3(%d %d %d)" % tuple(row[:3]) if row[3] == _NO_NODE else "4(%d %d %d %d)" % tuple(row)
        for row in faces.tolist()])
    _write(folder, "owner", "labelList", note, len(owner), map(str, owner.tolist()))
    _write(folder, "neighbour", "labelList", note, len(neighbour), map(str, neighbour.tolist()))
    _write(folder, "boundary", "polyBoundaryMesh", "", len(patches), [
        f"    {_word(name)}\n    {{\n        type {_type(parts, name)};\n"
        f"        nFaces {count};\n        startFace {start};\n    }}"
        for name, start, count in patches])


def _faces(parts: MeshParts, volume) -> Tuple[Any, Any, Any, List[Tuple[str, int, int]]]:
    """Faces as rows of four nodes, owner, neighbour, and the patches: name, first face, number."""
    rows, cell = _sides(volume)
    keys = np.sort(rows, axis=1)
    order = np.lexsort([cell, *keys.T[::-1]])
    same = (keys[order][1:] == keys[order][:-1]).all(axis=1)
    if (same[1:] & same[:-1]).any():
        raise InputError("outputs", "polyMesh: three cells share a face")
    first = np.flatnonzero(np.append(same, False))
    inner, other = order[first], order[first + 1]
    alone = np.ones(len(order), bool)
    alone[first] = alone[first + 1] = False
    border = np.sort(order[alone])
    by_cells = np.lexsort([cell[other], cell[inner]])
    inner, other = inner[by_cells], other[by_cells]

    patch, names = _patch_of(parts, keys[border])
    by_patch = np.argsort(patch, kind="stable")
    border, patch = border[by_patch], patch[by_patch]
    counts = np.bincount(patch, minlength=len(names)).tolist()
    starts = (len(inner) + np.cumsum([0] + counts[:-1])).tolist()
    patches = [entry for entry in zip(names, starts, counts) if entry[2]]
    chosen = np.concatenate([inner, border])
    return rows[chosen], cell[chosen], cell[other], patches


def _sides(volume):
    """Rows of four nodes, of a triangle three and _NO_NODE, and the cell of each."""
    rows, cells = [], []
    start = 0
    for block in volume:
        numbers = np.arange(start, start + len(block))
        for side in SIDES[block.kind]:
            row = np.full((len(block), 4), _NO_NODE, np.int64)
            row[:, :len(side)] = block.cells[:, side]
            rows.append(row)
            cells.append(numbers)
        start += len(block)
    return np.concatenate(rows), np.concatenate(cells)


def _patch_of(parts: MeshParts, keys) -> Tuple[Any, List[str]]:
    """Which of the named patches each border face belongs to; the last one takes the rest."""
    owners = parts.owners(2)
    names = list(dict.fromkeys(owners.values())) + [_REST]
    place = {number: names.index(name) for number, name in owners.items()}
    known: Dict[Any, int] = {}
    for block in parts.of(2):
        rows = np.full((len(block), 4), _NO_NODE, np.int64)
        rows[:, :block.cells.shape[1]] = block.cells
        known.update(zip(map(tuple, np.sort(rows, axis=1).tolist()),
                         (place[number] for number in block.part.tolist())))
    rest = len(names) - 1
    return np.array([known.get(tuple(key), rest) for key in keys.tolist()], np.int64), names


def _type(parts: MeshParts, name: str) -> str:
    if name in parts.patch_types:
        return parts.patch_types[name]
    return next((kind for pattern, kind in _BY_NAME if pattern.search(name)), "patch")


def _word(name: str) -> str:
    """As OpenFOAM reads names: no space, quote, slash, semicolon or brace."""
    return re.sub(r"[\s\"'/;{}()$#]", "_", name)


def _write(folder: str, name: str, kind: str, note: str, count: int, rows) -> None:
    with open(os.path.join(folder, name), "w", encoding="utf-8", newline="\n") as file:
        file.write(f"FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {kind};\n")
        file.write(f'    note "{note}";\n' if note else "")
        file.write(f'    location "constant/polyMesh";\n    object {name};\n}}\n{_BANNER}')
        file.write(f"{count}\n(\n")
        file.write("\n".join(rows))
        file.write("\n)\n")

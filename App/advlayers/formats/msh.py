"""Gmsh's MSH files, versions 4.1 and 2.2, as text.

The entities are the CAD faces, edges and solids under their own numbers; each has one physical
name, that of its first group or else its own. In 4.1 an entity also has the names of its other
groups.
"""
from __future__ import annotations

import re
from typing import Dict, List, Tuple

import numpy as np

from advlayers.formats.mesh_parts import MeshParts, order_of, periodic_parts
from advlayers.formats.text_file import TextFile

# By kind Gmsh's number and order of the nodes.
_ELEMENTS: Dict[str, Tuple[int, Tuple[int, ...]]] = {
    "line2": (1, (0, 1)), "line3": (8, (0, 1, 2)),
    "tri3": (2, (0, 1, 2)), "tri6": (9, tuple(range(6))),
    "quad4": (3, (0, 1, 2, 3)), "quad8": (16, tuple(range(8))), "quad9": (10, tuple(range(9))),
    "tet4": (4, (0, 1, 2, 3)), "tet10": (11, (0, 1, 2, 3, 4, 5, 6, 7, 9, 8)),
    "pyramid5": (7, tuple(range(5))), "prism6": (6, tuple(range(6))), "hex8": (5, tuple(range(8))),
    "pyramid13": (19, order_of("pyramid13", range(5), (
        (0, 1), (0, 3), (0, 4), (1, 2), (1, 4), (2, 3), (2, 4), (3, 4)))),
    "prism15": (18, order_of("prism15", range(6), (
        (0, 1), (0, 2), (0, 3), (1, 2), (1, 4), (2, 5), (3, 4), (3, 5), (4, 5)))),
    "hex20": (17, order_of("hex20", range(8), (
        (0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6),
        (6, 7)))),
}
KINDS = frozenset(_ELEMENTS)
VERSIONS = ("4.1", "2.2")
_DIMENSIONS = (1, 2, 3)


def write(path: str, parts: MeshParts, version: str = VERSIONS[0]) -> None:
    with TextFile(path) as file:
        file.text(f"$MeshFormat\n{version} 0 8\n$EndMeshFormat\n")
        tags = _write_names(file, parts)
        if version == "2.2":
            _write_nodes_2(file, parts)
            _write_elements_2(file, parts, tags)
        else:
            _write_entities(file, parts, tags)
            _write_nodes_4(file, parts)
            _write_elements_4(file, parts)
        if not parts.second_order:
            _write_periodic(file, parts, affine=version != "2.2")


Tags = Dict[Tuple[int, int], List[int]]  # (dimension, part) -> its physical groups, first its own


def _write_names(file: TextFile, parts: MeshParts) -> Tags:
    numbers: Dict[Tuple[int, str], int] = {}
    tags: Tags = {}

    def tag(dimension: int, name: str) -> int:
        return numbers.setdefault((dimension, name), len(numbers) + 1)

    for dimension in _DIMENSIONS:
        for part, owner in parts.owners(dimension).items():
            tags[dimension, part] = [tag(dimension, owner)]
    for group in parts.groups:
        for part in group.parts:
            known = tags.get((group.dimension, part))
            if known is not None and tag(group.dimension, group.name) not in known:
                known.append(tag(group.dimension, group.name))
    file.text(f"$PhysicalNames\n{len(numbers)}\n")
    for (dimension, name), number in numbers.items():
        # OpenFOAM's reader loses a name with a blank.
        plain = re.sub(r"\s", "_", name).replace('"', "'")
        file.text(f'{dimension} {number} "{plain}"\n')
    file.text("$EndPhysicalNames\n")
    return tags


def _write_entities(file: TextFile, parts: MeshParts, tags: Tags) -> None:
    boxes: Dict[Tuple[int, int], np.ndarray] = {}
    for dimension in _DIMENSIONS:
        for run in parts.by_part(dimension):
            points = parts.nodes[np.unique(run.cells)]
            box = np.array([points.min(axis=0), points.max(axis=0)])
            known = boxes.get((dimension, run.part))
            if known is not None:
                box = np.array([np.minimum(box[0], known[0]), np.maximum(box[1], known[1])])
            boxes[dimension, run.part] = box
    counts = [sum(key[0] == dimension for key in boxes) for dimension in _DIMENSIONS]
    file.text("$Entities\n0 {} {} {}\n".format(*counts))
    for dimension, part in sorted(boxes):
        box = " ".join(f"{value:.16g}" for value in boxes[dimension, part].ravel().tolist())
        physical = " ".join(map(str, tags[dimension, part]))
        file.text(f"{part} {box} {len(tags[dimension, part])} {physical} 0\n")
    file.text("$EndEntities\n")


def _write_nodes_4(file: TextFile, parts: MeshParts) -> None:
    """Each on the entity of least dimension that has an element there."""
    dimension = np.zeros(len(parts.nodes), np.int32)
    entity = np.zeros(len(parts.nodes), np.int32)
    for block in sorted(parts.blocks, key=lambda block: -block.dimension):
        dimension[block.cells] = block.dimension
        entity[block.cells] = block.part[:, None]
    key = dimension.astype(np.int64) * 2**32 + entity
    order = np.argsort(key, kind="stable")
    found, first = np.unique(key[order], return_index=True)
    file.text(f"$Nodes\n{len(found)} {len(key)} 1 {len(key)}\n")
    for value, nodes in zip(found.tolist(), np.split(order, first[1:])):
        file.text("{} {} 0 {}\n".format(*divmod(value, 2**32), len(nodes)))
        file.rows("%d\n", nodes + 1)
        file.rows("%r %r %r\n", parts.nodes[nodes])
    file.text("$EndNodes\n")


def _write_elements_4(file: TextFile, parts: MeshParts) -> None:
    count = sum(len(block) for block in parts.blocks)
    runs = [sum(1 for _run in parts.by_part(dimension)) for dimension in _DIMENSIONS]
    file.text(f"$Elements\n{sum(runs)} {count} 1 {count}\n")
    for dimension in _DIMENSIONS:
        for run in parts.by_part(dimension):
            kind, order = _ELEMENTS[run.kind]
            file.text(f"{dimension} {run.part} {kind} {len(run.cells)}\n")
            file.rows("%d" + " %d" * len(order) + "\n", run.elements, run.cells[:, order] + 1)
    file.text("$EndElements\n")


def _write_periodic(file: TextFile, parts: MeshParts, affine: bool) -> None:
    links = [(dimension, *link) for dimension in (1, 2)
             for link in periodic_parts(parts, dimension)]
    if not links:
        return
    file.text(f"$Periodic\n{len(links)}\n")
    for dimension, part, master, nodes in links:
        file.text(f"{dimension} {part} {master}\n" + "0\n" * affine + f"{len(nodes)}\n")
        file.rows("%d %d\n", nodes + 1)
    file.text("$EndPeriodic\n")


def _write_nodes_2(file: TextFile, parts: MeshParts) -> None:
    file.text(f"$Nodes\n{len(parts.nodes)}\n")
    file.numbered("%d %r %r %r\n", 1, parts.nodes)
    file.text("$EndNodes\n")


def _write_elements_2(file: TextFile, parts: MeshParts, tags: Tags) -> None:
    file.text(f"$Elements\n{sum(len(block) for block in parts.blocks)}\n")
    for start, block in zip(parts.starts, parts.blocks):
        kind, order = _ELEMENTS[block.kind]
        physical = np.zeros(int(block.part.max()) + 1, np.int32)
        for (dimension, part), known in tags.items():
            if dimension == block.dimension and part < len(physical):
                physical[part] = known[0]
        file.numbered(f"%d {kind} 2 %d %d" + " %d" * len(order) + "\n", start + 1,
                      physical[block.part], block.part, block.cells[:, order] + 1)
    file.text("$EndElements\n")

"""Groups of a finished mesh, as FreeCAD objects and mesh files carry them.

Nodes are numbered from 1; elements too, the quads first, then the triangles.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Sequence

import numpy as np


@dataclass(frozen=True)
class Group:
    name: str
    of_nodes: bool  # else of elements
    ids: Any  # (n,) integers from 1, ascending


def face_of_element(mesh):
    return np.concatenate([mesh.face_of_quad, mesh.face_of_triangle]).astype(np.int32)


def layer_of_element(mesh):
    return np.concatenate([mesh.layer_of_quad, mesh.layer_of_triangle]).astype(np.int32)


def mesh_groups(mesh, named: Mapping[str, Sequence[str]]) -> List[Group]:
    """FaceN of elements, EdgeN of nodes, Core and LayerN of elements, then the named ones.

    A named group of both faces and edges becomes two groups of that name. Empty ones are left out.
    """
    elements = _by_value("Face", face_of_element(mesh))
    nodes = {f"Edge{number}": np.unique(segments) + 1
             for number, segments in sorted(mesh.edge_segments.items()) if len(segments)}
    layers = _by_value("Layer", layer_of_element(mesh))
    core = layers.pop("Layer0", None)
    groups = [Group(name, False, ids) for name, ids in elements.items()]
    groups += [Group(name, True, ids) for name, ids in nodes.items()]
    groups += [Group("Core", False, core)] if core is not None else []
    groups += [Group(name, False, ids) for name, ids in layers.items()]
    for name, members in named.items():
        for of_nodes, source in ((False, elements), (True, nodes)):
            parts = [source[member] for member in members if member in source]
            if parts:
                groups.append(Group(name, of_nodes, np.unique(np.concatenate(parts))))
    return groups


def _by_value(prefix: str, values) -> Dict[str, Any]:
    """Splits the element ids 1..n by their values, ascending."""
    order = np.argsort(values, kind="stable")
    numbers, starts = np.unique(values[order], return_index=True)
    return {f"{prefix}{number}": part + 1
            for number, part in zip(numbers.tolist(), np.split(order, starts[1:]))}

"""The mesh that a document object holds, in the arrays that the core's meshes have."""
from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, List

import numpy as np

from advlayers import element_mesh
from advlayers.errors import InputError
from advlayers.mesh_groups import Group

_FACE = re.compile(r"Face([0-9]+)")


@dataclass(frozen=True)
class StoredMesh:
    """Quads before triangles; indices count from 0. What the core's Mesh says, as far as the
    writers of mesh files need it."""

    nodes: Any  # (n, 3) [mm]
    quads: Any
    triangles: Any
    face_of_quad: Any
    face_of_triangle: Any
    layer_of_quad: Any
    layer_of_triangle: Any
    node_layer: Any
    node_parent: Any
    groups: List[Group]  # as the object has them


def read(mesh_object) -> StoredMesh:
    """Raises InputError where the object has not been meshed."""
    fem = mesh_object.FemMesh
    if not fem.FaceCount:
        raise InputError("", "{} has no mesh yet: mesh it first", mesh_object.Label)
    groups = _groups(fem)
    elements = element_mesh.of_fem(fem)
    quads, nodes = len(elements.quads), len(elements.nodes)
    faces = np.zeros(elements.count, np.int32)
    for group in groups:
        match = _FACE.fullmatch(group.name)
        if match and not group.of_nodes:
            faces[group.ids - 1] = int(match.group(1))
    return StoredMesh(
        elements.nodes, elements.quads, elements.triangles, faces[:quads], faces[quads:],
        elements.layers[:quads], elements.layers[quads:],
        _node_values(mesh_object.NodeLayers, nodes, 0),
        _node_values(mesh_object.NodeParents, nodes, -1), groups)


def _groups(fem) -> List[Group]:
    return [Group(fem.getGroupName(number), fem.getGroupElementType(number) == "Node",
                  np.array(sorted(fem.getGroupElements(number)), np.int64))
            for number in fem.Groups]


def _node_values(values, count: int, unknown: int):
    """A mesh that was made before they were kept has none."""
    if len(values) != count:
        return np.full(count, unknown, np.int32)
    return np.array(values, np.int32)

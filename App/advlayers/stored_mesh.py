"""The mesh that a document object holds, in the arrays that the core's meshes have."""
from __future__ import annotations

import json
import re
from dataclasses import dataclass
from typing import Any, Dict, List

import numpy as np

from advlayers import element_mesh
from advlayers.errors import InputError

_OWN_NAME = re.compile(r"(Face|Edge|Layer)[0-9]+|Core")


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
    edge_segments: Dict[int, Any]
    named: Dict[str, List[str]]  # the groups of the object and of its analysis
    mid_nodes: Any
    mids_of_quad: Any
    mids_of_triangle: Any
    mids_of_segment: Dict[int, Any]


def read(mesh_object) -> StoredMesh:
    """Raises InputError where the object has not been meshed."""
    fem = mesh_object.FemMesh
    if not fem.FaceCount:
        raise InputError("", "{} has no mesh yet: mesh it first", mesh_object.Label)
    elements = element_mesh.of_object(mesh_object)
    quads, nodes = len(elements.quads), len(elements.nodes)
    segments = segments_of(mesh_object.EdgeSegments)
    return StoredMesh(
        elements.nodes, elements.quads, elements.triangles,
        elements.faces[:quads], elements.faces[quads:],
        elements.layers[:quads], elements.layers[quads:],
        _node_values(mesh_object.NodeLayers, nodes, 0),
        _node_values(mesh_object.NodeParents, nodes, -1),
        segments, _named(mesh_object, elements.faces), elements.mid_nodes, elements.mids_of_quad,
        elements.mids_of_triangle, _mids_of(segments, elements))


def _mids_of(segments: Dict[int, Any], elements) -> Dict[int, Any]:
    """The mid node of each segment, as the elements beside it have it."""
    if not len(elements.mid_nodes):
        return {}
    ends = np.concatenate([cells[:, [k, (k + 1) % cells.shape[1]]] for cells in
                           (elements.quads, elements.triangles) for k in range(cells.shape[1])])
    mids = np.concatenate([part[:, k] for part in (elements.mids_of_quad, elements.mids_of_triangle)
                           for k in range(part.shape[1])])
    keys, first = np.unique(_keys(ends), return_index=True)
    return {edge: mids[first[np.searchsorted(keys, _keys(pairs))]]
            for edge, pairs in segments.items()}


def _keys(pairs):
    """One number for the ends of a mesh edge, whichever comes first."""
    return (pairs.min(axis=1).astype(np.int64) << 32) + pairs.max(axis=1)


def segments_of(numbers) -> Dict[int, Any]:
    """From a row of edge, node, node, edge, node, node, … (nodes from 0)."""
    rows = np.array(numbers, np.int32).reshape(-1, 3)
    order = np.argsort(rows[:, 0], kind="stable")
    found, first = np.unique(rows[order, 0], return_index=True)
    return dict(zip(found.tolist(), np.split(rows[order, 1:], first[1:])))


def row_of_segments(segments: Dict[int, Any]) -> List[float]:
    """What segments_of() takes."""
    rows = [np.column_stack([np.full(len(pairs), number), pairs])
            for number, pairs in sorted(segments.items()) if len(pairs)]
    return np.concatenate(rows).ravel().tolist() if rows else []


def _named(mesh_object, faces) -> Dict[str, List[str]]:
    """As the mesh was made; the groups that an analysis asked for are of faces, and known by their
    elements."""
    fem = mesh_object.FemMesh
    kept = json.loads(mesh_object.MeshedSettings or "{}")
    named = {name: list(members) for name, members in kept.get("groups", {}).items()}
    for group in fem.Groups:
        name = fem.getGroupName(group)
        if name in named or _OWN_NAME.fullmatch(name) or fem.getGroupElementType(group) != "Face":
            continue
        ids = np.array(fem.getGroupElements(group), np.int64)
        named[name] = [f"Face{number}" for number in np.unique(faces[ids - 1]).tolist()]
    return named


def _node_values(values, count: int, unknown: int):
    """A mesh that was made before they were kept has none."""
    if len(values) != count:
        return np.full(count, unknown, np.int32)
    return np.array(values, np.int32)

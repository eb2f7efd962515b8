"""Measurements of a finished mesh that take nothing from the mesher's word."""
from __future__ import annotations

from typing import Callable, List, Optional, Tuple

import numpy as np


class Elements:
    """Quads and triangles of a mesh in one list, quads first, triangles with their corner 3 = 2."""

    def __init__(self, nodes: np.ndarray, quads: np.ndarray, triangles: np.ndarray) -> None:
        self.nodes = np.asarray(nodes, float)
        self.quad_count = len(quads)
        self.corners = np.vstack([np.asarray(quads, int).reshape(-1, 4),
                                  np.asarray(triangles, int).reshape(-1, 3)[:, [0, 1, 2, 2]]])

    def __len__(self) -> int:
        return len(self.corners)

    def is_quad(self) -> np.ndarray:
        return np.arange(len(self)) < self.quad_count

    def centroids(self) -> np.ndarray:
        quad, tri = self.corners[:self.quad_count], self.corners[self.quad_count:, :3]
        return np.vstack([self.nodes[quad].mean(axis=1), self.nodes[tri].mean(axis=1)])

    def area(self) -> float:
        """[mm^2], of quads cut along a diagonal."""
        p = self.nodes[self.corners]
        first = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1)
        second = np.linalg.norm(np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 0]), axis=1)
        return float(0.5 * (first + second).sum())

    def volume(self) -> float:
        """[mm^3], enclosed by a closed mesh that faces outward."""
        p = self.nodes[self.corners]
        first = np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 1], p[:, 2]))
        second = np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 2], p[:, 3]))
        return float((first + second).sum() / 6.0)

    def directed_edges(self) -> Tuple[np.ndarray, np.ndarray]:
        """(m, 2) in the element's sense, and the element of each."""
        edges = np.stack([self.corners, np.roll(self.corners, -1, axis=1)], axis=2)
        owners = np.repeat(np.arange(len(self)), 4)
        edges = edges.reshape(-1, 2)
        real = edges[:, 0] != edges[:, 1]
        return edges[real], owners[real]

    def border(self) -> np.ndarray:
        """(b, 2) directed edges without a partner, the mesh on their left."""
        edges, _ = self.directed_edges()
        there = {tuple(edge) for edge in edges.tolist()}
        return np.array([edge for edge in edges.tolist() if (edge[1], edge[0]) not in there],
                        int).reshape(-1, 2)

    def angles(self) -> np.ndarray:
        """All interior angles [deg], reflex ones as more than 180; quads' corners first."""
        p = self.nodes[self.corners]
        quad, triangle = p[:self.quad_count], p[self.quad_count:, :3]
        found = []
        for shapes in (quad, triangle):
            up = np.cross(shapes[:, 2] - shapes[:, 0], shapes[:, -1] - shapes[:, 1])
            for k in range(shapes.shape[1]):
                ahead = np.roll(shapes, -1, axis=1)[:, k] - shapes[:, k]
                back = shapes[:, k - 1] - shapes[:, k]
                turn = np.cross(ahead, back)
                angle = np.degrees(np.arctan2(np.linalg.norm(turn, axis=1),
                                              (ahead * back).sum(axis=1)))
                found.append(np.where((turn * up).sum(axis=1) < 0.0, 360.0 - angle, angle))
        return np.concatenate(found)

    def euler(self) -> int:
        edges, _ = self.directed_edges()
        count = len(np.unique(np.sort(edges, axis=1), axis=0))
        return len(np.unique(self.corners)) - count + len(self)


def turned_corners(elements: Elements, normals: np.ndarray) -> int:
    """Elements with a corner that turns against `normals`, (nodes, 3), at its node."""
    p = elements.nodes[elements.corners]
    triangle = ~elements.is_quad()
    bad = np.zeros(len(elements), bool)
    for k in range(4):
        ahead, back = p[:, (k + 1) % 4] - p[:, k], p[:, k - 1] - p[:, k]
        if k == 0:  # a triangle's corner 3 is its corner 2
            back[triangle] = p[triangle, 2] - p[triangle, 0]
        if k == 2:
            ahead[triangle] = p[triangle, 0] - p[triangle, 2]
        up = normals[elements.corners[:, k]]
        turned = (np.cross(ahead, back) * up).sum(axis=1) <= 0.0
        bad |= turned & ~(triangle & (k == 3))
    return int(bad.sum())


def conformity_faults(elements: Elements, closed: Optional[bool] = None) -> List[str]:
    """What keeps the elements from being a conforming, oriented surface with manifold border."""
    faults = []
    edges, _ = elements.directed_edges()
    if len(np.unique(edges, axis=0)) != len(edges):
        faults.append("an edge is used twice in one direction")
    border = elements.border()
    if closed and len(border):
        faults.append(f"{len(border)} open edges of a closed shape")
    starts, counts = np.unique(border[:, 0], return_counts=True)
    if len(counts) and counts.max() > 1:
        faults.append(f"the border touches itself at node {int(starts[counts.argmax()])}")
    used = len(np.unique(elements.corners))
    if used != len(elements.nodes):
        faults.append(f"{len(elements.nodes) - used} nodes without element")
    return faults


def folds(elements: Elements, faces: np.ndarray, tips: np.ndarray,
          turn_under: Callable[[int, np.ndarray], float]) -> int:
    """Edges whose two elements, of one CAD face, look more than 120 degrees apart, and 60 more than
    the surface turns under them: turn_under(face, points) [deg]. Those that end in one of the
    `tips`, (n, 3), where a surface may be as sharp as that, do not count."""
    at_tip = np.zeros(len(elements.nodes), bool)
    for tip in tips:
        at_tip |= np.linalg.norm(elements.nodes - tip, axis=1) < 1e-6
    p = elements.nodes[elements.corners]
    normals = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
    triangle = ~elements.is_quad()
    normals[triangle] = np.cross(p[triangle, 1] - p[triangle, 0], p[triangle, 2] - p[triangle, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None] + 1e-300
    edges, owners = elements.directed_edges()
    owner_of = {tuple(edge): owner for edge, owner in zip(edges.tolist(), owners.tolist())}
    count = 0
    for (a, b), one in owner_of.items():
        other = owner_of.get((b, a)) if a < b else None
        if other is None or faces[one] != faces[other] or at_tip[a] or at_tip[b]:
            continue
        cosine = float(normals[one] @ normals[other])
        if cosine < -0.5:
            under = turn_under(int(faces[one]), np.vstack([p[one], p[other]]))
            count += np.degrees(np.arccos(max(-1.0, cosine))) - under > 60.0
    return int(count)

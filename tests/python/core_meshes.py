"""Shapes to mesh, and what must hold of every mesh of the core."""
import os

import advlayers_core as core
import numpy as np

DATA = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "data")
# Faces, edges, vertices; Euler number of the surface; volume [mm^3] of what it encloses.
SOLIDS = {
    "box": (6, 12, 8, 2, 480.0),
    "cylinder": (3, 3, 2, 2, np.pi * 25 * 12),
    "cone": (3, 3, 2, 2, np.pi * 8 / 3 * (25 + 10 + 4)),
    "sphere": (1, 3, 2, 2, 4 / 3 * np.pi * 216),
    "torus": (1, 2, 1, 0, 2 * np.pi ** 2 * 10 * 9),
    "drilled_plate": (7, 15, 10, 0, 20 * 12 * 4 - np.pi * 9 * 4),
    "bracket": (8, 18, 12, 2, 12 * 10 * 8 - 9 * 10 * 5),
}


def shape_text(name):
    with open(os.path.join(DATA, name + ".brep"), encoding="ascii") as file:
        return file.read()


def model(name):
    return core.read_brep(shape_text(name))


def mesher(name, **settings):
    """Of few elements, and each face a patch of its own, unless the settings say otherwise."""
    return core.Mesher(model(name), core.Settings(**{
        "size": 1.0, "first_height": 0.1, "feature_angle": 0.0, "curvature_angle": 20.0,
        **settings}))


def mesh(name, **settings):
    run = mesher(name, **settings)
    for _ in run:
        pass
    return run.result()


def directed_edges(result):
    """(m, 2): every element's sides, in its own direction of turning."""
    sides = [np.column_stack((cells[:, k], np.roll(cells, -1, axis=1)[:, k]))
             for cells in (result.quads, result.triangles) for k in range(cells.shape[1])]
    return np.concatenate(sides)


def side_uses(result):
    """How many elements use each undirected side."""
    return np.unique(np.sort(directed_edges(result), axis=1), axis=0, return_counts=True)


def area_vectors(result):
    x = result.nodes
    quads, triangles = x[result.quads], x[result.triangles]
    return (np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1]) / 2,
            np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]) / 2)


def enclosed_volume(result):
    """By the divergence theorem; positive where the elements turn outward."""
    quads, triangles = area_vectors(result)
    x = result.nodes
    return (np.einsum("ij,ij", quads, x[result.quads].mean(axis=1))
            + np.einsum("ij,ij", triangles, x[result.triangles].mean(axis=1))) / 3

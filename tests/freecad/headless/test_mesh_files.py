"""Mesh files as FreeCAD reads them, and the meshes of documents, which come the same way."""
import os
import sys

import Fem
import Mesh
import numpy as np
import pytest
from advlayers import fem_mesh
from advlayers.formats import inp, med, obj, stl, unv, vtk, vtu

TESTS = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path += [os.path.join(TESTS, "readers"), os.path.join(TESTS, "python")]

from mesh_cases import NAMES, case  # noqa: E402

# FreeCAD's order of the nodes of volume elements.
ORDERS = {("Volume", 4): [0, 2, 1, 3], ("Volume", 5): [0, 3, 2, 1, 4],
          ("Volume", 10): [0, 2, 1, 3, 6, 5, 4, 7, 9, 8], ("Volume", 6): [0, 2, 1, 3, 5, 4],
          ("Volume", 8): [0, 3, 2, 1, 4, 7, 6, 5],
          ("Volume", 13): [0, 3, 2, 1, 4, 8, 7, 6, 5, 9, 12, 11, 10],
          ("Volume", 15): [0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13],
          ("Volume", 20): [0, 3, 2, 1, 4, 7, 6, 5, 11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17]}


def elements_of(fem):
    """By number: what kind of element, and its nodes from 0."""
    return {number: (kind, [node - 1 for node in fem.getElementNodes(number)])
            for kind, numbers in (("Edge", fem.Edges), ("Face", fem.Faces),
                                  ("Volume", fem.Volumes)) for number in numbers}


def same(parts, fem, numbered=True):
    """Node for node, element for element, and no volume turned inside out."""
    points = np.array([tuple(fem.Nodes[i]) for i in range(1, fem.NodeCount + 1)])
    assert np.array_equal(points, parts.nodes)
    wanted = {}
    for start, block in zip(parts.starts, parts.blocks):
        kind = ("Edge", "Face", "Volume")[block.dimension - 1]
        order = ORDERS.get((kind, block.cells.shape[1]), list(range(block.cells.shape[1])))
        for i, cell in enumerate(block.cells[:, order].tolist(), start + 1):
            wanted[i] = (kind, cell)
    seen = elements_of(fem)
    assert sorted(seen.values()) == sorted(wanted.values())
    assert seen == wanted or not numbered


def groups_of(fem):
    return {(fem.getGroupName(i), fem.getGroupElementType(i)): sorted(fem.getGroupElements(i))
            for i in fem.Groups}


def wanted_groups(parts, dimensions):
    kinds = {1: "Edge", 2: "Face", 3: "Volume"}
    found = {(name, kinds[dimension]): ids.tolist()
             for name, dimension, ids in parts.element_sets(*dimensions)}
    found.update({(name, "Node"): (nodes + 1).tolist() for name, nodes in parts.node_sets(1)})
    return found


@pytest.mark.parametrize("name", NAMES)
def test_med(tmp_path, name):
    pytest.importorskip("h5py")
    parts, path = case(name), str(tmp_path / "a mesh.med")
    med.write(path, parts)
    fem = Fem.read(path)
    same(parts, fem)
    assert groups_of(fem) == wanted_groups(parts, (1, 2, 3))


@pytest.mark.parametrize("name", ["solid", "plane", "facets", "second", "extruded",
                                  "extruded second", "filled second"])
def test_unv(tmp_path, name):
    parts, path = case(name), str(tmp_path / "mesh.unv")
    unv.write(path, parts)
    fem = Fem.read(path)
    same(parts, fem, numbered=False)
    if parts.dimension == 2:
        assert groups_of(fem) == wanted_groups(parts, (1, 2, 3))
    else:
        names = {owner.replace(" ", "_") for owner in parts.owners(2).values()}
        assert {name for name, kind in groups_of(fem) if kind == "Face"} == names


@pytest.mark.parametrize("name", ["solid", "facets"])
def test_decks_and_vtk(tmp_path, name):
    """FreeCAD reads no lines from these."""
    parts = case(name)
    for ending, write in (("inp", inp.write), ("vtu", vtu.write), ("vtk", vtk.write)):
        path = str(tmp_path / f"mesh.{ending}")
        write(path, parts)
        fem = Fem.read(path)
        points = np.array([tuple(fem.Nodes[i]) for i in range(1, fem.NodeCount + 1)])
        assert np.allclose(points, parts.nodes, rtol=1e-15, atol=1e-15)
        cells = [cell for kind, cell in elements_of(fem).values() if kind == "Face"]
        assert sorted(cells) == sorted(
            cell for block in parts.of(2) for cell in block.cells.tolist())


@pytest.mark.parametrize("name", ["solid", "facets"])
def test_facets(tmp_path, name):
    parts = case(name)
    for ending, write in (("stl", stl.write), ("obj", obj.write)):
        path = str(tmp_path / f"mesh.{ending}")
        write(path, parts)
        mesh = Mesh.Mesh(path)
        assert mesh.isSolid() and not mesh.hasNonManifolds() and mesh.Volume > 0.0
        assert mesh.CountPoints == len(parts.nodes)


@pytest.mark.parametrize("name", ["solid", "second", "extruded", "extruded second",
                                  "turned second", "filled", "filled second"])
def test_both_ways_to_a_document_are_one(name):
    """Through a file, and node by node with a look at the request to stop."""
    parts = case(name)
    watched, unwatched = fem_mesh.to_fem_mesh(parts, lambda: None), fem_mesh.to_fem_mesh(parts)
    surface = parts.only(2, 3)
    for fem in (watched, unwatched):
        same(surface, fem)
        assert groups_of(fem) == {**wanted_groups(surface, (2, 3)),
                                  **wanted_groups(parts, ())}


def test_without_h5py_it_is_another_file(monkeypatch):
    import importlib.util

    parts = case("solid")
    found = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec",
                        lambda name: None if name == "h5py" else found(name))
    same(parts.only(2, 3), fem_mesh.to_fem_mesh(parts))

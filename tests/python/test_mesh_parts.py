"""The description of a mesh that the writers of files share."""
import numpy as np
import pytest

import core_meshes
from advlayers.formats import mesh_parts


@pytest.fixture(scope="module")
def bracket():
    return core_meshes.mesh("bracket")


@pytest.fixture(scope="module")
def parts(bracket):
    return mesh_parts.of_mesh(
        bracket, {"inlet": ["Face1", "Face2"], "rim": ["Edge3", "Edge5"], "both": ["Face2"]}, True)


def test_every_element_is_in_one_part_and_one_layer(bracket, parts):
    surface = np.arange(1, 1 + len(bracket.quads) + len(bracket.triangles))
    for sets in (parts.elements_by_part(2), parts.elements_by_layer):
        assert np.array_equal(np.sort(np.concatenate(list(sets.values()))), surface)
    faces = np.concatenate([bracket.face_of_quad, bracket.face_of_triangle])
    for number, elements in parts.elements_by_part(2).items():
        assert (faces[elements - 1] == number).all()


def test_groups_are_their_parts_together(parts):
    sets = {name: elements for name, _dimension, elements in parts.element_sets(1, 2)}
    for group, members in (("inlet", ("Face1", "Face2")), ("rim", ("Edge3", "Edge5"))):
        assert np.array_equal(sets[group], np.sort(np.concatenate([sets[m] for m in members])))
    nodes = dict(parts.node_sets(1))
    assert np.array_equal(nodes["rim"], np.union1d(nodes["Edge3"], nodes["Edge5"]))


def test_lines_lie_on_the_nodes_of_their_edges(bracket, parts):
    lines, = parts.of(1)
    for number, segments in bracket.edge_segments.items():
        assert np.array_equal(lines.cells[lines.part == number], segments)
        assert np.array_equal(parts.nodes_by_part(1)[number], np.unique(segments))


def test_a_part_has_one_owner(parts):
    owners = parts.owners(2)
    assert owners[1] == owners[2] == "inlet" and owners[3] == "Face3"
    assert parts.owners(1)[5] == "rim"
    assert parts.grouped(2) == [1, 2]


def test_another_unit_is_another_scale(bracket, parts):
    metres = parts.scaled(0.001)
    assert metres.metre == 1.0
    assert np.array_equal(metres.nodes, bracket.nodes * 0.001)

"""What must hold of every finished mesh, on solids with plane and curved faces, poles and seams."""
import numpy as np
import pytest
from core_meshes import (SOLIDS, directed_edges, enclosed_volume, mesh, model, side_uses)

ARRAYS = ("nodes", "quads", "triangles", "face_of_quad", "face_of_triangle", "layer_of_quad",
          "layer_of_triangle", "node_parent", "node_layer")


@pytest.fixture(scope="module", params=sorted(SOLIDS))
def solid(request):
    return request.param


@pytest.fixture(scope="module")
def result(solid):
    return mesh(solid)


def test_model_is_numbered_as_the_cad(solid):
    faces, edges, vertices = SOLIDS[solid][:3]
    shape = model(solid)
    assert (shape.face_count, shape.edge_count, shape.vertex_count) == (faces, edges, vertices)
    assert shape.closed


def test_shell_is_watertight_and_oriented(result):
    _, uses = side_uses(result)
    assert (uses == 2).all()
    assert len(np.unique(directed_edges(result), axis=0)) == 2 * len(uses)


def test_euler_number_is_the_surface_s(solid, result):
    sides, _ = side_uses(result)
    elements = len(result.quads) + len(result.triangles)
    assert len(result.nodes) - len(sides) + elements == SOLIDS[solid][3]


def test_every_node_is_used(result):
    used = np.union1d(result.quads, result.triangles)
    assert np.array_equal(used, np.arange(len(result.nodes)))


def test_elements_turn_outward(solid, result):
    volume = SOLIDS[solid][4]
    assert enclosed_volume(result) == pytest.approx(volume, rel=0.03)
    assert result.figures["inverted"] == 0


def test_edge_segments_are_sides_of_elements_on_both_faces(result):
    face_of = np.concatenate([np.tile(result.face_of_quad, 4), np.tile(result.face_of_triangle, 3)])
    sides = np.sort(directed_edges(result), axis=1)
    faces_of_side = {}
    for side, face in zip(map(tuple, sides), face_of):
        faces_of_side.setdefault(side, set()).add(face)
    between_faces = {side for side, faces in faces_of_side.items() if len(faces) > 1}
    segments = [tuple(sorted(pair)) for pairs in result.edge_segments.values() for pair in pairs]
    assert len(segments) == len(set(segments))
    assert between_faces <= set(segments) <= set(faces_of_side)


def test_edge_segments_run_on_end_to_end(result):
    for pairs in result.edge_segments.values():
        assert np.array_equal(pairs[1:, 0], pairs[:-1, 1])


def test_a_quad_of_a_layer_has_a_parent_kid_side(result):
    parent = result.node_parent
    quads = result.quads[result.layer_of_quad > 0]
    ahead = np.roll(quads, -1, axis=1)
    assert ((parent[quads] == ahead) | (parent[ahead] == quads)).any(axis=1).all()


def test_a_kid_is_one_layer_above_its_parent(result):
    kids = np.flatnonzero(result.node_parent >= 0)
    assert np.array_equal(result.node_layer[kids],
                          result.node_layer[result.node_parent[kids]] + 1)


def test_arrays_are_read_only_and_typed(result):
    for name in ARRAYS:
        array = getattr(result, name)
        assert array.dtype == (np.float64 if name == "nodes" else np.int32), name
        assert not array.flags.writeable, name
        if array.size:
            with pytest.raises(ValueError):
                array[0] = 0


def test_views_outlive_the_mesh():
    nodes = mesh("box").nodes
    copy = nodes.copy()
    mesh("box", size=0.7)
    assert np.array_equal(nodes, copy)


def test_figures_count_the_arrays(result):
    figures = result.figures
    assert figures["nodes"] == len(result.nodes)
    assert figures["quads"] == len(result.quads)
    assert figures["triangles"] == len(result.triangles)
    total = figures["quads"] + figures["triangles"]
    assert figures["quad_percent"] == pytest.approx(100 * figures["quads"] / total)
    assert sum(patch["quads"] for patch in result.patches) == figures["quads"]


def test_nodes_lie_on_the_exact_surface():
    x = mesh("cylinder").nodes
    radius = np.hypot(x[:, 0], x[:, 1])
    on_side = np.abs(radius - 5) < 1e-8
    on_lids = (np.abs(x[:, 2]) < 1e-8) | (np.abs(x[:, 2] - 12) < 1e-8)
    assert (on_side | (on_lids & (radius < 5))).all()
    assert np.abs(np.linalg.norm(mesh("sphere").nodes, axis=1) - 6).max() < 1e-8

"""Faces filled with rows and columns of quads from side to side."""
import numpy as np
import pytest
from core_meshes import mesh


def corner_angles(result):
    """(quads, 4) [deg]"""
    corners = result.nodes[result.quads]
    on = np.roll(corners, -1, axis=1) - corners
    back = np.roll(corners, 1, axis=1) - corners
    cosine = (on * back).sum(axis=2) / (np.linalg.norm(on, axis=2) * np.linalg.norm(back, axis=2))
    return np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))


def valences(result):
    return np.bincount(result.quads.ravel(), minlength=len(result.nodes))


def border_nodes(result):
    return np.unique(np.concatenate([np.ravel(part) for part in result.edge_segments.values()]))


def test_a_square_becomes_a_plain_grid():
    result = mesh("square", walls=[], mapped=["Face1"])
    assert len(result.triangles) == 0 and len(result.quads) == 100
    np.testing.assert_allclose(corner_angles(result), 90.0, atol=1e-6)
    assert set(valences(result)[np.setdiff1d(np.arange(len(result.nodes)),
                                             border_nodes(result))]) == {4}


@pytest.mark.parametrize("growth, layers", [(1.2, 5), (1.5, 3), (1.0, 4)])
def test_layers_of_all_sides_have_their_heights(growth, layers):
    result = mesh("square", first_height=0.05, growth=growth, layers=layers, mapped=["Face1"])
    assert len(result.triangles) == 0
    assert len(result.walls) == 4
    for wall in result.walls:
        assert wall["layers"] == layers, wall
        achieved = wall["achieved_first_height"]
        assert achieved["min"] == pytest.approx(0.05, rel=0.01)
        assert achieved["max"] == pytest.approx(0.05, rel=0.01)
        assert wall["achieved_growth"] == pytest.approx(growth, rel=0.01)
    # Each element of a layer lies beside an extrusion.
    parents = result.node_parent
    for quad, layer in zip(result.quads, result.layer_of_quad):
        own = set(quad.tolist())
        assert layer == 0 or any(parents[node] in own for node in own)


@pytest.mark.parametrize("shape, faces", [
    ("box", [f"Face{i}" for i in range(1, 7)]), ("bracket", ["Face1", "Face2"]),
    ("quarter_plate", ["Face1"])])
def test_facing_sides_agree_over_neighbours(shape, faces):
    result = mesh(shape, walls=[], size=1.3, mapped=faces, sizes=[
        {"edges": ["Edge1"], "segments": 13}])
    numbers = [int(name[4:]) for name in faces]
    missing = {entry["code"] for entry in result.diagnostics} & {"not-mapped"}
    if not missing:
        assert not np.isin(result.face_of_triangle, numbers).any()
    assert result.figures["inverted"] == 0


def test_a_cylinder_is_a_grid_around():
    result = mesh("cylinder", size=2.0, layers=3, first_height=0.2, walls=[
        {"edges": ["Edge1", "Edge3"]}], mapped=["Face1"])
    side = result.face_of_quad == 1
    assert side.any() and not (result.face_of_triangle == 1).any()
    assert {wall["layers"] for wall in result.walls if wall["face"] == "Face1"} == {3}
    nodes = result.nodes[np.unique(result.quads[side])]
    radius = np.hypot(nodes[:, 0], nodes[:, 1])
    np.testing.assert_allclose(radius, radius[0], rtol=1e-9)


def test_a_plate_about_a_hole_is_a_ring():
    result = mesh("drilled_plate", walls=[], size=1.0, mapped=["Face5", "Face6"], layers=0)
    rings = [number for number in (5, 6) if (result.face_of_quad == number).any()]
    told = [entry for entry in result.diagnostics if entry["code"] == "not-mapped"]
    assert not told and not np.isin(result.face_of_triangle, rings).any()


def test_what_cannot_be_mapped_is_told_and_meshed_all_the_same():
    result = mesh("sphere", walls=[], size=2.0, mapped=["Face1"])
    assert "not-mapped" in {entry["code"] for entry in result.diagnostics}
    assert len(result.quads) > 50

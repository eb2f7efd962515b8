"""Edges and faces that a motion brings onto others have the same nodes."""
import advlayers_core as core
import numpy as np
import pytest
from core_meshes import mesh, mesher, model


def turned(points, angle, axis_point=(0, 0, 0)):
    """About z."""
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    about = points - axis_point
    return np.column_stack((c * about[:, 0] - s * about[:, 1], s * about[:, 0] + c * about[:, 1],
                            about[:, 2])) + axis_point


def box_face_at(result_model, axis, value):
    boxes = result_model.face_boxes
    return next(f"Face{i}" for i, (low, high) in enumerate(boxes, 1)
                if abs(low[axis] - value) < 1e-6 and abs(high[axis] - value) < 1e-6)


def test_opposite_faces_of_a_box_have_the_same_nodes():
    box = model("box")
    low = np.min([corners[0] for corners in box.face_boxes], axis=0)
    high = np.max([corners[1] for corners in box.face_boxes], axis=0)
    face = box_face_at(box, 2, low[2])
    shift = (0.0, 0.0, round(high[2] - low[2], 4))  # boxes are a little too large
    # Finer at one of the two: both become so.
    result = mesh("box", layers=2, periodic=[{"faces": [face], "translation": shift}],
                  sizes=[{"faces": [face], "size": 0.7}])
    (pairs,) = result.periodic_nodes
    pairs = np.array(pairs)
    np.testing.assert_allclose(result.nodes[pairs[:, 0]] + shift, result.nodes[pairs[:, 1]],
                               rtol=0, atol=1e-12)
    on_face = {number: np.concatenate([
        result.quads[result.face_of_quad == number].ravel(),
        result.triangles[result.face_of_triangle == number].ravel()])
        for number in range(1, 7)}
    given = np.unique(on_face[int(face[4:])])
    assert set(given) == set(pairs[:, 0])
    # The elements are copies, too, turned to the other side.
    image = dict(pairs.tolist())
    other = int(box_face_at(box, 2, high[2])[4:])
    there = {frozenset(quad) for quad in result.quads[result.face_of_quad == other].tolist()}
    here = {frozenset(image[node] for node in quad)
            for quad in result.quads[result.face_of_quad == int(face[4:])].tolist()}
    assert here == there
    assert result.figures["inverted"] == 0


def test_edges_may_be_periodic_alone():
    result = mesh("square", walls=[], core="triangles", refinements=[
        {"point": (0, 3, 0), "size": 0.2}], periodic=[
        {"edges": ["Edge4"], "translation": (10, 0, 0)}])
    (pairs,) = result.periodic_nodes
    pairs = np.array(pairs)
    assert len(pairs) > 15
    np.testing.assert_allclose(result.nodes[pairs[:, 0]] + (10, 0, 0), result.nodes[pairs[:, 1]],
                               rtol=0, atol=1e-12)


@pytest.mark.parametrize("entry, text", [
    ({"edges": ["Edge1"], "translation": (0, 0, 3)}, "no edge lies where Edge1 comes to lie"),
    ({"edges": ["Edge1"]}, "needs a translation or an angle"),
    ({"translation": (1, 0, 0)}, "lists neither edge nor face"),
    ({"faces": ["Face9"], "translation": (1, 0, 0)}, "Face9"),
    ({"edges": ["Edge1"], "angle": 90, "axis_direction": (0, 0, 0)}, "axis_direction"),
])
def test_what_is_wrong_with_an_entry_is_told(entry, text):
    with pytest.raises(core.InvalidInput, match=text):
        mesher("square", periodic=[entry])


def test_a_quarter_turn_brings_one_side_of_a_square_onto_the_next():
    result = mesh("square", layers=3, periodic=[
        {"edges": ["Edge1"], "angle": 90, "axis_point": (5, 5, 0)}])
    (pairs,) = result.periodic_nodes
    pairs = np.array(pairs)
    assert len(pairs) >= 11
    np.testing.assert_allclose(turned(result.nodes[pairs[:, 0]], 90, np.array((5, 5, 0))),
                               result.nodes[pairs[:, 1]], rtol=0, atol=1e-12)

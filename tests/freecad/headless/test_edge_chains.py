"""Chains of edges, and the lines where layers would end."""
import FreeCAD
import numpy as np
import Part
import pytest

from advlayers.edge_chains import EdgeChains
from advlayers.height_lines import wall_lines

SETTINGS = {"faces": "all", "walls": "all", "match": (), "off": (), "boundary": (),
            "smooth": (), "first_height": 0.1, "growth": 1.5, "layers": 3, "size": 1.0}


@pytest.fixture
def rounded():
    """A box with four rounded edges along z."""
    box = Part.makeBox(10, 10, 10)
    upright = [edge for edge in box.Edges if abs(edge.tangentAt(edge.FirstParameter).z) > 0.9]
    return box.makeFillet(2.0, upright)


def name_of(shape, edge):
    return f"Edge{1 + [edge.isSame(other) for other in shape.Edges].index(True)}"


def test_a_tangent_chain_runs_around_the_rounded_rim(rounded):
    top = [edge for edge in rounded.Edges if edge.BoundBox.ZMin > 9.99]
    assert len(top) == 8
    names = sorted(name_of(rounded, edge) for edge in top)
    for edge in top:
        assert sorted(EdgeChains(rounded).tangent([name_of(rounded, edge)])) == names


def test_a_tangent_chain_ends_at_corners():
    box = Part.makeBox(1, 2, 3)
    assert EdgeChains(box).tangent(["Edge3"]) == ["Edge3"]


def test_the_loop_around_a_hole_and_around_a_face():
    plate = Part.makeBox(10, 10, 1).cut(Part.makeCylinder(2, 1, FreeCAD.Vector(5, 5, 0)))
    chains = EdgeChains(plate)
    flat = [(number, face) for number, face in enumerate(plate.Faces, 1)
            if isinstance(face.Surface, Part.Plane)]
    assert sorted(len(face.Wires) for _number, face in flat) == [1, 1, 1, 1, 2, 2]
    for number, face in flat:
        for wire in face.Wires:
            edges = sorted(name_of(plate, edge) for edge in wire.Edges)
            assert sorted(chains.loop(edges[:1], [f"Face{number}"])) == edges


def test_all_edges_of_faces_leave_seams_out():
    cylinder = Part.makeCylinder(1, 2)
    side = 1 + [type(face.Surface) for face in cylinder.Faces].index(Part.Cylinder)
    names = EdgeChains(cylinder).of_faces([f"Face{side}"])
    assert len(names) == 2
    assert all(isinstance(cylinder.Edges[int(name[4:]) - 1].Curve, Part.Circle) for name in names)


@pytest.mark.parametrize("shape", [
    Part.makeBox(5, 6, 7), Part.makeCylinder(3, 4),
    Part.makeBox(9, 9, 9).cut(Part.makeCylinder(2, 9, FreeCAD.Vector(4, 4, 0)))])
def test_lines_lie_on_the_faces_at_the_heights_asked_for(shape):
    lines = list(wall_lines(shape, SETTINGS))
    assert {line.face for line in lines} == {f"Face{i + 1}" for i in range(len(shape.Faces))}
    for line in lines:
        face = shape.Faces[int(line.face[4:]) - 1]
        rise = np.linalg.norm(line.first - line.foot, axis=1)
        total = np.linalg.norm(line.last - line.foot, axis=1)
        np.testing.assert_allclose(rise, 0.1, rtol=1e-9)
        np.testing.assert_allclose(total, 0.1 * (1 + 1.5 + 2.25), rtol=1e-9)
        middle = Part.Vertex(*line.first[len(line.first) // 2])
        assert face.distToShape(middle)[0] < 0.02


def test_walls_of_their_own():
    box = Part.makeBox(10, 10, 10)
    walls = ({"edges": ("Edge1",), "faces": ("Face1",), "first_height": 0.2, "growth": None,
              "layers": 0, "end_height": 0.4},
             {"edges": ("Edge2",), "faces": (), "first_height": None, "growth": None,
              "layers": 2, "thickness": 1.0},
             {"edges": ("Edge3",), "faces": (), "aspect_ratio": 5.0, "layers": None})
    lines = list(wall_lines(box, {**SETTINGS, "walls": walls}))
    assert [(line.edge, line.face) for line in lines if line.edge == "Edge1"] == [
        ("Edge1", "Face1")]
    one = next(line for line in lines if line.edge == "Edge1")
    rise = np.linalg.norm(one.first - one.foot, axis=1)
    assert one.last is None and rise[0] == pytest.approx(0.2) and rise[-1] == pytest.approx(0.4)
    two = next(line for line in lines if line.edge == "Edge2")
    np.testing.assert_allclose(np.linalg.norm(two.last - two.foot, axis=1), 1.0, rtol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(two.first - two.foot, axis=1), 0.4, rtol=1e-9)
    assert not [line for line in lines if line.edge == "Edge3"]


def test_lines_show_what_the_core_makes():
    """Of a thickness and the whole mesh's other values layers are worked out first."""
    walls = ({"edges": ("Edge1",), "faces": ("Face1",), "thickness": 1.0},)
    (line,) = wall_lines(Part.makeBox(10, 10, 10), {**SETTINGS, "layers": 10, "walls": walls})
    np.testing.assert_allclose(line.first_heights, 0.1, rtol=1e-9)


def test_the_height_of_layers_until_isotropic():
    (line,) = wall_lines(Part.makeBox(10, 10, 10), {
        **SETTINGS, "layers": "isotropic", "growth": 2.0,
        "walls": ({"edges": ("Edge1",), "faces": ("Face1",)},)})
    np.testing.assert_allclose(line.totals, 0.1 * (1 + 2 + 4 + 8), rtol=1e-9)  # the next: 1.6 > 1

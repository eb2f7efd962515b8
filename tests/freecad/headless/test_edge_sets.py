"""Edges picked by what they have in common."""
import FreeCAD
import Part
import pytest

from advlayers.edge_sets import EdgeSets


@pytest.fixture(scope="module")
def plate():
    shape = Part.makeBox(40, 24, 2)
    for x, y, radius in ((10, 6, 2.0), (10, 18, 2.0), (30, 12, 4.0)):
        shape = shape.cut(Part.makeCylinder(radius, 2, FreeCAD.Vector(x, y, 0)))
    return shape


def radii(shape, names):
    return [shape.getElement(name).Curve.Radius for name in names]


def test_holes_by_diameter(plate):
    sets = EdgeSets(plate)
    assert [(pytest.approx(diameter), count) for diameter, count in sets.hole_diameters()] \
        == [(4.0, 4), (8.0, 2)]
    assert sorted(radii(plate, sets.feature("holes"))) == [2.0] * 4 + [4.0] * 2
    assert radii(plate, sets.holes_of(8.0)) == [4.0, 4.0]
    assert sets.holes_of(sets.hole_diameters()[0][0]) == sets.feature("holes 3 5")
    assert not EdgeSets(Part.makeBox(1, 1, 1)).hole_diameters()


def test_inner_loops_of_a_face_and_of_all(plate):
    sets = EdgeSets(plate)
    holed = [number for number, face in enumerate(plate.Faces, 1) if len(face.Wires) == 4]
    assert len(holed) == 2
    first = sets.inner_loops([f"Face{holed[0]}"])
    assert len(first) == 3
    assert sorted(first + sets.inner_loops([f"Face{holed[1]}"])) == sorted(sets.inner_loops([]))
    assert sets.inner_loops([]) == sets.feature("holes")


def test_sharp_edges_are_those_of_the_box_and_the_rims(plate):
    sharp = EdgeSets(plate).feature("sharp")
    assert len(sharp) == 12 + 6
    box = Part.makeBox(10, 10, 10)
    rounded = box.makeFillet(1.0, box.Edges[:1])
    assert len(EdgeSets(rounded).feature("sharp")) < len(rounded.Edges)


def test_of_similar_length_and_radius(plate):
    sets = EdgeSets(plate)
    longest = max(enumerate(plate.Edges, 1), key=lambda pair: pair[1].Length)[0]
    same = sets.similar_length([f"Edge{longest}"])
    assert len(same) == 4 and all(plate.getElement(name).Length == pytest.approx(40)
                                  for name in same)
    small = sets.holes_of(4.0)
    assert sets.similar_radius(small[:1]) == small
    assert sets.similar_radius([f"Edge{longest}"]) == []


def test_what_is_not_selected(plate):
    sets = EdgeSets(plate)
    assert sets.inverted(["Face1"]) == [f"Face{n}" for n in range(2, len(plate.Faces) + 1)]
    sharp = sets.feature("sharp")
    rest = sets.inverted(sharp)
    assert not set(rest) & set(sharp)
    assert sorted(sets.inverted(rest)) == sorted(sharp)

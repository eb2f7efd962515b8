"""Plane meshes made solid: cells upright, patches named, whatever the normal of the CAD."""
import core_meshes
import numpy as np
import pytest
from advlayers.errors import InputError
from advlayers.extrusion import Extrusion, extrude, of_settings
from advlayers.formats import mesh_parts
from advlayers.settings_check import check_all
from advlayers.settings_table import JOB_SETTINGS
from cell_measures import border, same_turn, volumes

GROUPS = {"wall": ["Edge1", "Edge3"], "fluid": ["Face1"]}


def square_parts(turned=False, **settings):
    result = core_meshes.mesh("square", **{"layers": 3, **settings})
    parts = mesh_parts.of_mesh(result, GROUPS)
    if turned:  # as of a face whose normal is -z
        parts = mesh_parts.replace(parts, blocks=tuple(
            mesh_parts.replace(block, cells=block.cells[:, ::-1]) if block.dimension == 2
            else block for block in parts.blocks))
    return parts


def check_solid(made):
    """Cells upright; the elements of the surface are the sides that one cell has, each once."""
    for block in made.of(3):
        assert (volumes(made.nodes, block.kind, block.cells) > 0.0).all()
    outside = border(made)
    surface = [tuple(row) for block in made.of(2) for row in block.cells.tolist()]
    assert len(surface) == len(outside)
    for row in surface:
        assert same_turn(row, outside[tuple(sorted(row))])


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("direction", [None, (0, 0, 1), (0, 0, -2.0)])
def test_a_plate(turned, direction):
    made = extrude(square_parts(turned), Extrusion(thickness=2.0, cells=3, direction=direction))
    check_solid(made)
    total = sum(volumes(made.nodes, block.kind, block.cells).sum() for block in made.of(3))
    assert total == pytest.approx(10.0 * 10.0 * 2.0)
    names = {made.name(2, number) for number in made.part_numbers(2)}
    assert names == {"Edge1", "Edge2", "Edge3", "Edge4", "front", "back"}
    levels = set(np.round(made.nodes[:, 2], 9))
    down = direction is not None and direction[2] < 0 or direction is None and turned
    assert levels == {round(k * (-2.0 if down else 2.0) / 3, 9) for k in range(4)}


def test_patches_lie_where_their_names_say():
    result = core_meshes.mesh("square", layers=3)
    made = extrude(mesh_parts.of_mesh(result, GROUPS), Extrusion(thickness=1.0))
    for block in made.of(2):
        for part in np.unique(block.part):
            at = made.nodes[np.unique(block.cells[block.part == part])]
            name = made.name(2, part)
            if name in ("front", "back"):
                assert (at[:, 2] == (1.0 if name == "front" else 0.0)).all()
            else:
                flat = result.nodes[np.unique(result.edge_segments[int(name[4:])])]
                assert ({tuple(point[:2]) for point in at.tolist()}
                        == {tuple(point[:2]) for point in flat.tolist()})
    groups = {(group.name, group.dimension): group.parts for group in made.groups}
    assert groups == {("wall", 2): (1, 3), ("fluid", 3): (1,)}
    assert made.patch_types == {"front": "empty", "back": "empty"}


@pytest.mark.parametrize("core", ["quads", "triangles"])
@pytest.mark.parametrize("axis", [((0, 0, 0), (1, 0, 0)), ((10, 10, 0), (-3, 0, 0)),
                                  ((0, 0, 0), (0, -1, 0)), ((-4, 1, 0), (0, 1, 0))])
def test_a_wedge(core, axis):
    """Also where the axis is an edge of the mesh: nodes there are single, and cells have fewer."""
    made = extrude(square_parts(core=core, layers=1), Extrusion(axis=axis, angle=6.0, cells=2))
    check_solid(made)
    total = sum(volumes(made.nodes, block.kind, block.cells).sum() for block in made.of(3))
    middle = 9.0 if axis[0][0] == -4 else 5.0  # Guldin: the way of the square's middle
    # Of chords instead of arcs.
    assert total == pytest.approx(100.0 * middle * 2 * np.sin(np.radians(3.0) / 2) * 2
                                  * np.cos(np.radians(3.0) / 2), rel=1e-9)
    assert len(np.unique(made.nodes, axis=0)) == len(made.nodes)
    assert made.patch_types["front"] == made.patch_types["back"] == "wedge"


def same_corners(curved, straight):
    for one, other in zip(curved.blocks, straight.blocks):
        corners = mesh_parts.KINDS[one.kind].corners
        assert one.kind == mesh_parts.SECOND_ORDER[other.kind]
        assert np.array_equal(one.part, other.part)
        assert np.array_equal(curved.nodes[one.cells[:, :corners]], straight.nodes[other.cells])


def mids_off_chords(made):
    """By kind (m, sides): how far from the middle between its ends, of the distance of the ends."""
    for block in made.blocks:
        kind = mesh_parts.KINDS[block.kind]
        x = made.nodes[block.cells]
        for k, (a, b) in enumerate(kind.sides):
            chord = np.linalg.norm(x[:, a] - x[:, b], axis=1)
            yield np.linalg.norm(x[:, kind.corners + k] - (x[:, a] + x[:, b]) / 2, axis=1) / chord


def test_second_order_stays_on_the_hole():
    settings = {"size": 3.0, "first_height": 0.5, "layers": 2, "walls": [{"edges": ["Edge5"]}]}
    made, straight = (extrude(mesh_parts.of_mesh(core_meshes.mesh(
        "quarter_plate", order=order, **settings), {"hole": ["Edge5"]}),
        Extrusion(thickness=2.0, cells=2)) for order in (2, 1))
    same_corners(made, straight)
    assert {block.kind for block in made.of(3)} <= {"hex20", "prism15"}
    hole, = (group.parts for group in made.groups)
    at = np.unique(np.concatenate([block.cells[np.isin(block.part, hole)].ravel()
                                   for block in made.of(2)]))
    assert np.allclose(np.hypot(*made.nodes[at, :2].T), 2.0, atol=1e-12)
    assert set(np.round(made.nodes[:, 2], 12)) == {0.0, 0.5, 1.0, 1.5, 2.0}
    assert max(off.max() for off in mids_off_chords(made)) < 0.1
    assert len(np.unique(made.nodes.round(9), axis=0)) == len(made.nodes)


@pytest.mark.parametrize("core", ["quads", "triangles"])
@pytest.mark.parametrize("axis", [((0, 0, 0), (1, 0, 0)), ((-4, 1, 0), (0, 1, 0))])
def test_second_order_is_turned_along_arcs(core, axis):
    how = Extrusion(axis=axis, angle=30.0, cells=2)
    made, straight = (extrude(square_parts(core=core, layers=1, order=order), how)
                      for order in (2, 1))
    same_corners(made, straight)
    # The chord of 15 degrees lies 3.3 % of its length within the arc.
    assert max(off.max() for off in mids_off_chords(made)) == pytest.approx(0.0328, abs=1e-3)
    far = made.nodes - axis[0]
    radius = np.linalg.norm(np.cross(far, axis[1]), axis=1)
    assert np.isclose(radius.max(), 10.0 if axis[0][0] == 0 else 14.0, atol=1e-12)
    outermost = [block.cells[block.part == (3 if axis[0][0] == 0 else 2)] for block in made.of(2)]
    for cells in outermost:
        assert np.allclose(radius[cells], radius.max(), atol=1e-12)
    assert sum(len(cells) for cells in outermost)
    assert len(np.unique(made.nodes.round(9), axis=0)) == len(made.nodes)


@pytest.mark.parametrize("how, said", [
    (Extrusion(thickness=1.0, direction=(1, 0, 0)), "right angles to the plane"),
    (Extrusion(axis=((5, 0, 0), (0, 1, 0)), angle=5.0), "lies on both sides"),
    (Extrusion(axis=((0, 0, 0), (0, 0, 1)), angle=5.0), "must lie in the plane"),
])
def test_what_cannot_be_extruded_is_refused(how, said):
    with pytest.raises(InputError, match=said):
        extrude(square_parts(), how)


def test_a_mesh_that_is_not_plane_is_refused():
    parts = mesh_parts.of_mesh(core_meshes.mesh("box"), {})
    with pytest.raises(InputError, match="needs plane faces: a node lies .* mm off their plane"):
        extrude(parts, Extrusion(thickness=1.0))


@pytest.mark.parametrize("block, said", [
    ({}, "extrude.thickness is missing"),
    ({"axis_direction": [1, 0, 0]}, "extrude.angle is missing"),
    ({"thickness": 1, "angle": 5}, "extrude.angle goes with axis_direction only"),
    ({"thickness": 1, "axis_direction": [1, 0, 0], "angle": 5},
     "extrude.thickness does not go with axis_direction"),
    ({"thickness": 1, "front": "back"}, "extrude.back is the name of the front, too: back"),
    ({"thickness": 0}, "extrude.thickness must be > 0 mm, got 0"),
    ({"thickness": 1, "layers": 2}, "extrude.layers is no known key"),
    ({"thickness": 1, "patch_types": ["wall"]}, "extrude.patch_types must be an object of names"),
    ("plate", "extrude must be an object"),
])
def test_a_block_that_contradicts_itself_is_refused(block, said):
    with pytest.raises(InputError) as error:
        of_settings(check_all({"input": "a.step", "extrude": block}, JOB_SETTINGS)["extrude"])
    assert said in str(error.value)

"""Bounds of sizes, segments at ends, regions, other edges, features, presets, expected elements."""
import math

import advlayers_core as core
import numpy as np
import pytest
from advlayers import features, limits, presets
from advlayers.errors import InputError
from advlayers.meshing import core_settings
from advlayers.settings_check import check_all
from advlayers.settings_table import MESH_SETTINGS
from core_meshes import mesh, mesher, model


def lengths(result, edge):
    segments = np.asarray(result.edge_segments[edge])
    return np.linalg.norm(result.nodes[segments[:, 1]] - result.nodes[segments[:, 0]], axis=1)


def worst_ratio(steps):
    return math.exp(np.abs(np.diff(np.log(steps))).max())


def test_size_growth_holds_from_one_edge_to_the_next():
    """A bracket's edges have many lengths; its short ones shorten their neighbours."""
    result = mesh("bracket", walls=[], size=2.0, size_growth=1.2,
                  sizes=[{"edges": ["Edge1"], "size": 0.2}])
    at_node = {}
    for edge in result.edge_segments:
        steps, segments = lengths(result, edge), np.asarray(result.edge_segments[edge])
        assert len(steps) < 2 or worst_ratio(steps) <= 1.2 * 1.1
        for node, step in ((segments[0][0], steps[0]), (segments[-1][1], steps[-1])):
            at_node.setdefault(node, []).append(step)
    for steps in at_node.values():
        assert max(steps) <= 1.2 * 1.1 * min(steps)


@pytest.mark.parametrize("distribution", ["tanh", "geometric", "constant"])
@pytest.mark.parametrize("ends", [{"first_segment": 0.05}, {"last_segment": 0.02},
                                  {"first_segment": 0.1, "last_segment": 0.02}])
def test_segments_at_the_ends_are_as_long_as_asked(distribution, ends):
    for more in ({"segments": 40}, {}):
        result = mesh("square", walls=[], sizes=[
            {"edges": ["Edge1"], "distribution": distribution, **ends, **more}])
        steps = lengths(result, 1)
        assert len(steps) == 40 or not more
        for at, key in ((0, "first_segment"), (-1, "last_segment")):
            if key in ends:
                assert steps[at] == pytest.approx(ends[key], rel=0.02)
        if not more and distribution != "constant":
            assert steps.max() <= 1.101  # a segment may be a tenth longer than the size
        assert steps.sum() == pytest.approx(10.0)


def test_hyperbolic_tangents_change_least_from_step_to_step():
    kinds = {}
    for distribution in ("tanh", "constant"):
        result = mesh("square", walls=[], sizes=[
            {"edges": ["Edge1"], "distribution": distribution, "segments": 40,
             "first_segment": 0.05, "last_segment": 0.05}])
        kinds[distribution] = worst_ratio(lengths(result, 1))
    assert kinds["tanh"] < 1.3 < kinds["constant"]


def test_ends_and_cluster_exclude_each_other():
    with pytest.raises(core.InvalidInput, match="exclude each other"):
        mesher("square", sizes=[{"edges": ["Edge1"], "cluster": 3.0, "first_segment": 0.1}])


@pytest.mark.parametrize("region, inside", [
    ({"point": (2, 2, 0), "corner": (8, 3, 0)},
     lambda x, y: (2 <= x) & (x <= 8) & (2 <= y) & (y <= 3)),
    ({"point": (2, 2, 0), "end": (8, 8, 0), "radius": 0.5},
     lambda x, y: (abs(x - y) < 0.7) & (2 <= x) & (x <= 8)),
])
def test_regions_are_as_fine_as_asked(region, inside):
    result = mesh("square", walls=[], core="triangles", refinements=[{**region, "size": 0.15}])
    corners = result.nodes[result.triangles]
    middle = corners.mean(axis=1)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    chosen = inside(middle[:, 0], middle[:, 1])
    assert chosen.sum() > 50 and np.median(longest[chosen]) < 0.2
    far = np.hypot(middle[:, 0] - 9.5, middle[:, 1] - 5.0) < 0.5
    assert longest[far].max() > 0.3


def test_a_region_is_a_line_or_a_box():
    with pytest.raises(core.InvalidInput, match="end and corner exclude each other"):
        mesher("square", refinements=[{"point": (0, 0, 0), "size": 1.0, "end": (1, 0, 0),
                                       "corner": (1, 1, 0)}])


def circle_segments(**settings):
    """Of the cylinder's longest closed edge, and its radius."""
    result = mesh("cylinder", walls=[], size=50.0, **settings)
    for edge in result.edge_segments:
        segments = np.asarray(result.edge_segments[edge])
        if segments[0][0] == segments[-1][1]:
            points = result.nodes[segments[:, 0]]
            return len(segments), np.linalg.norm(points - points.mean(axis=0), axis=1).max()
    raise AssertionError("no closed edge")


def test_chords_keep_their_distance():
    wide, radius = circle_segments(curvature_angle=90.0)
    near, _radius = circle_segments(curvature_angle=90.0, chord_deviation=0.001 * radius)
    # The sagitta of n segments is r (1 - cos(pi / n)).
    assert wide < 10 and radius * (1 - math.cos(math.pi / near)) <= 0.0011 * radius
    assert radius * (1 - math.cos(math.pi / (near - 2))) > 0.001 * radius
    relative, _radius = circle_segments(curvature_angle=90.0, relative_chord=0.02)
    turn = 2 * math.pi / relative
    assert 0.5 * math.tan(turn / 4) <= 0.0205


def test_curvature_asks_for_no_less_than_the_least_size():
    fine, radius = circle_segments(curvature_angle=2.0)
    least, _radius = circle_segments(curvature_angle=2.0, min_size=0.3 * radius)
    assert fine >= 180 and 18 <= least <= 2 * math.pi / 0.3 + 2


def test_what_becomes_of_the_other_edges():
    """Of a square's edges one is listed: the two beside it touch it, the fourth does not."""
    walls = [{"edges": ["Edge1"]}]
    found = {others: mesh("square", walls=walls, layers=3, others=others)
             for others in ("match", "off", "wall")}
    assert {wall["edge"] for wall in found["match"].walls} == {"Edge1"}
    assert {wall["edge"] for wall in found["wall"].walls} == {f"Edge{i}" for i in range(1, 5)}
    assert {wall["edge"] for wall in found["off"].walls} == {"Edge1"}
    # Only where layers run along them the sides are cut by the layers' heights.
    shortest = {others: min(lengths(result, edge).min() for edge in range(1, 5))
                for others, result in found.items()}
    assert shortest["match"] < 0.5 * shortest["off"]


def test_holes_and_sharp_edges_stand_for_names():
    plate = model("drilled_plate")
    holes = plate.holes
    assert holes and all(face.startswith("Face") and edges for face, edges, _d in holes)
    diameter = holes[0][2]
    wall = {"edges": [f"holes {0.9 * diameter} {1.1 * diameter}"], "layers": 2}
    checked = check_all({"size": 2.0, "first_height": 0.2, "walls": [wall]}, MESH_SETTINGS)
    (found,) = features.expanded(checked, plate)["walls"]
    assert set(found["edges"]) == {edge for _f, edges, d in holes
                                   if abs(d - diameter) < 0.05 * diameter for edge in edges}
    sharp = features.expanded(check_all({"off": ["sharp"]}, MESH_SETTINGS), model("box"))["off"]
    assert len(sharp) == 12
    with pytest.raises(InputError, match="finds no edge for 'holes'"):
        features.expanded(check_all({"off": ["holes"]}, MESH_SETTINGS), model("box"))


def test_presets_give_way_to_what_is_said():
    for word in presets.PRESETS:
        assert check_all(presets.applied({"preset": word}), MESH_SETTINGS)
    assert presets.applied({"preset": "cfd", "layers": 3})["layers"] == 3
    with pytest.raises(InputError, match='"cfd" or "fem" or "washers"'):
        presets.applied({"preset": "cdf"})


def test_washers_are_rings_about_every_hole():
    plate = model("drilled_plate")
    settings = features.expanded(
        check_all(presets.applied({"preset": "washers", "size": 2.0}), MESH_SETTINGS), plate)
    run = core.Mesher(plate, core_settings(core, settings, plate.diagonal))
    for _report in run:
        pass
    result = run.result()
    assert {wall["edge"] for wall in result.walls} == {
        edge for _face, edges, _diameter in plate.holes for edge in edges}
    assert all(wall["layers"] == 2 for wall in result.walls)


def test_many_elements_are_told_before_they_are_made():
    plate = model("square")
    settings = check_all({}, MESH_SETTINGS)
    for size, said in ((0.5, False), (0.015, True)):
        asked = core.Settings(size=size, first_height=0.1 * size, walls=[])
        told = limits.check(core, plate, asked, settings)
        assert (told is not None) == said


def test_layers_may_be_as_thick_as_a_share_of_the_size():
    wall = {"edges": ["Edge1"], "thickness_share": 0.5, "layers": 4, "growth": 1.0}
    result = mesh("square", size=0.5, walls=[wall], sizes=[{"edges": ["Edge1"], "size": 0.8}])
    (report,) = result.walls
    assert report["achieved_first_height"]["mean"] == pytest.approx(0.8 * 0.5 / 4, rel=0.02)
    with pytest.raises(core.InvalidInput, match="exclude each other"):
        mesher("square", walls=[{**wall, "thickness": 0.2}])


def first_try(shape, **given):
    """The settings of a job that says nothing else."""
    asked = check_all(presets.applied(given), MESH_SETTINGS)
    return core_settings(core, asked, shape.diagonal)


def test_an_airfoil_in_its_domain_is_resolved_without_being_asked_for():
    shape = model("airfoil")  # a chord of 1000 in a circle of 20 chords
    run = core.Mesher(shape, first_try(shape, layers=1))
    next(run)
    cut = run.snapshot()
    of_airfoil = [edge for edge in cut.edge_segments
                  if np.abs(cut.nodes[np.asarray(cut.edge_segments[edge])]).max() < 2000]
    steps = [lengths(cut, edge) for edge in of_airfoil]
    assert sum(map(len, steps)) >= 100
    ends = [cut.nodes[np.asarray(cut.edge_segments[edge])[[0, -1]]] for edge in of_airfoil]
    # The trailing edge lies at x = 1000.
    at_tail = [step[0 if end[0][0][0] > 999 else -1] for step, end in zip(steps, ends)]
    assert max(at_tail) <= 20.0
    assert worst_ratio(np.concatenate(steps[:1])) <= 1.4 * 1.1
    # And its layers are in proportion.
    wall = next(wall for wall in run.result().walls if int(wall["edge"][4:]) in of_airfoil)
    assert wall["first_height"] < 5.0


def test_a_circle_turns_by_ten_degrees_per_mesh_edge():
    shape = model("cylinder")
    result = core.Mesher(shape, first_try(shape, layers=1))
    next(result)
    cut = result.snapshot()
    circles = [len(segments) for segments in cut.edge_segments.values()
               if tuple(np.asarray(segments)[0][:1]) == tuple(np.asarray(segments)[-1][1:])]
    assert circles and min(circles) >= 36


def test_sizes_that_are_given_hold_without_sizes_of_small_parts():
    shape = model("drilled_plate")
    for given in ({"size": 4.0}, {"first_height": 0.2}):
        assert first_try(shape, **given).cells_across == 0
    assert first_try(shape).cells_across == 10
    assert first_try(shape).curvature_angle == 10.0
    assert first_try(shape, size=4.0).curvature_angle == 20.0
    assert first_try(shape, curvature_angle=30.0).curvature_angle == 30.0
    assert first_try(shape, y_plus={"speed": 1.0, "length": 10.0}).cells_across == 10

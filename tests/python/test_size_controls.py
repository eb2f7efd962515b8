"""Sizes that grow slowly, edges by what they are, presets, the number of elements beforehand."""
import math

import advlayers_core as core
import numpy as np
import pytest
from advlayers import features, limits, presets
from advlayers.errors import InputError
from advlayers.meshing import core_settings
from advlayers.settings_check import check_all
from advlayers.settings_table import MESH_SETTINGS
from core_meshes import mesh, model


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

"""The table of settings and the checks that read it."""
import math

import pytest

from advlayers.errors import InputError
from advlayers.settings_check import CHECKS, check_all, check_names
from advlayers.settings_table import (
    EXTRUDE_SETTINGS, JOB_SETTINGS, MESH_SETTINGS, REFINEMENT_SETTINGS, SIZE_SETTINGS,
    VOLUME_SETTINGS, WALL_SETTINGS, Y_PLUS_SETTINGS, property_name, range_said, setting)

EVERY_SETTING = (MESH_SETTINGS + JOB_SETTINGS + WALL_SETTINGS + SIZE_SETTINGS + REFINEMENT_SETTINGS
                 + Y_PLUS_SETTINGS + EXTRUDE_SETTINGS + VOLUME_SETTINGS)


@pytest.mark.parametrize("entry", EVERY_SETTING, ids=lambda entry: entry.key)
def test_every_entry_is_complete(entry):
    assert entry.kind in CHECKS
    assert entry.doc.endswith((".", ".stl.")) and len(entry.doc) > 10
    assert not entry.choices or entry.default in (None, *entry.choices)


@pytest.mark.parametrize("entry", MESH_SETTINGS, ids=lambda entry: entry.key)
def test_every_mesh_setting_has_a_property_or_child_objects(entry):
    if entry.child:
        assert not entry.group
    elif entry.becomes:
        assert setting(entry.becomes).group
    else:
        assert entry.group and property_name(entry).isalnum()


def test_keys_and_properties_are_unique():
    keys = [entry.key for entry in MESH_SETTINGS + JOB_SETTINGS]
    properties = [property_name(entry) for entry in MESH_SETTINGS if entry.group]
    assert len(set(keys)) == len(keys)
    assert len(set(properties)) == len(properties)


def test_defaults_pass_their_own_check():
    values = {entry.key: entry.default for entry in MESH_SETTINGS if entry.default is not None}
    assert check_all(values, MESH_SETTINGS) == check_all({}, MESH_SETTINGS)


@pytest.mark.parametrize("key, value, words", [
    ("growth", 0.5, "growth must be >= 1 and <= 10, got 0.5"),
    ("growth", "1.2", "growth must be a number"),
    ("growth", True, "growth must be a number"),
    ("growth", math.nan, "finite"),
    ("growth", 10 ** 400, "finite"),
    ("first_height", -1, "first_height must be > 0 mm, got -1"),
    ("first_height", 0.0, "got 0"),
    ("size", math.inf, "finite"),
    ("size", [1.0], "size must be a number"),
    ("growth", None, "growth must be a number"),
    ("layers", 2.5, "whole number"),
    ("layers", -1, "layers must be >= 0"),
    ("layers", "many", "isotropic"),
    ("layers", False, "whole number"),
    ("feature_angle", 180, "< 180"),
    ("core", "hexes", '"quads" or "triangles"'),
    ("core", ["quads"], '"quads" or "triangles"'),
    ("threads", 1e300, "at most"),
    ("faces", "Face1", "list of names"),
    ("faces", [], "empty"),
    ("faces", ["Edge1"], "no name like"),
    ("faces", ["Face0"], "no name like"),
    ("faces", ["Face1", "Face1"], "twice"),
    ("faces", [1], "no name like"),
    ("walls", "none", '"all" or a list'),
    ("walls", [{"edges": []}], "walls[0].edges must not be empty"),
    ("walls", [{"faces": ["Face1"]}], "walls[0].edges is missing"),
    ("walls", [{"edges": ["Edge1"], "growth": 0.9}], "walls[0].growth must be >= 1"),
    ("walls", [{"edges": ["Edge1"], "height": 1}], "walls[0].height is no known key"),
    ("walls", [{"edges": ["Edge1"], "thickness": 0}], "walls[0].thickness must be > 0 mm"),
    ("walls", [{"edges": ["Edge1"], "turning_angle": 91}], "walls[0].turning_angle must be"),
    ("sizes", "Edge1", "sizes must be a list"),
    ("sizes", ["Edge1"], "sizes[0] must be an object"),
    ("sizes", [{"edges": ["Edge1"], "segments": 2.5}], "sizes[0].segments must be a whole"),
    ("sizes", [{"edges": ["Edge1"], "both_ends": 1}], "sizes[0].both_ends must be true or false"),
    ("refinements", [{"point": [1, 2]}], "refinements[0].point must be three numbers"),
    ("refinements", [{"point": [1, 2, "3"], "size": 1}], "refinements[0].point[2] must be a num"),
    ("refinements", [{"point": [1, 2, 3]}], "refinements[0].size is missing"),
    ("size_growth", 1.0, "size_growth must be > 1 and <= 3"),
    ("match", "Edge1", "list of names"),
    ("groups", {"Face1": ["Face1"]}, "the mesh itself"),
    ("groups", {"a\nb": ["Face1"]}, "cannot be written"),
    ("groups", {"inlet": "Face1"}, "groups.inlet must be a list"),
    ("growht", 1.2, "growht is no known key (did you mean growth?)"),
])
def test_bad_values_are_named(key, value, words):
    with pytest.raises(InputError) as error:
        check_all({key: value}, MESH_SETTINGS)
    assert words in str(error.value)
    assert "\n" not in str(error.value)


def test_whole_numbers_may_be_written_with_a_point():
    layers = check_all({"layers": 3.0}, MESH_SETTINGS)["layers"]
    assert layers == 3 and isinstance(layers, int)


@pytest.mark.parametrize("values, words", [
    ({"faces": ["Face7"]}, "faces names Face7, but box has 6 faces"),
    ({"off": ["Edge13"]}, "off names Edge13, but box has 12 edges"),
    ({"walls": [{"edges": ["Edge1"], "faces": ["Face9"]}]}, "walls[0].faces names Face9"),
    ({"sizes": [{"edges": ["Edge99"], "size": 1}]}, "sizes[0].edges names Edge99"),
    ({"groups": {"inlet": ["Face99"]}}, "groups.inlet names Face99"),
    ({"groups": {"inlet": ["Face2"]}, "faces": ["Face1"]}, "which is not in faces"),
])
def test_names_that_the_model_does_not_have(values, words):
    with pytest.raises(InputError) as error:
        check_names(check_all(values, MESH_SETTINGS), 6, 12, "box")
    assert words in str(error.value)


def test_ranges_in_words():
    assert range_said(setting("feature_angle")).english == ">= 0 and < 180 deg"
    assert range_said(setting("size")).english == "> 0 mm"
    assert range_said(setting("core")).english == ""

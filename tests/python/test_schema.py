"""The core's rows of settings, and what Python makes of them."""
import math

import advlayers_core as core
import numpy as np
import pytest
from advlayers.errors import InputError
from advlayers.settings_check import check_all
from advlayers.settings_table import MESH_SETTINGS, WALL_SETTINGS, range_said
from core_meshes import model

LENGTHS = {"size": 2.0, "first_height": 0.1}
ROWS = {name: {row["key"]: row for row in rows} for name, rows in core.schema().items()}


def refusal(act):
    try:
        act()
    except (InputError, core.InvalidInput) as error:
        return str(error)
    return ""


def beyond(row):
    """Values just out of the row's range."""
    for bound, away, itself in ((row["lowest"], -math.inf, row["above"]),
                                (row["highest"], math.inf, row["below"])):
        if bound is not None:
            yield bound if itself else np.nextafter(bound, away) if row["kind"] == "number" else \
                bound + math.copysign(1, away)


TABLES = {"mesh": MESH_SETTINGS, "walls": WALL_SETTINGS}
NUMBERS = [(table, entry.key, value) for table, entries in TABLES.items() for entry in entries
           if entry.kind in ("number", "count", "layers") and entry.key in ROWS[table]
           for value in beyond(ROWS[table][entry.key])]


@pytest.mark.parametrize("table, key, value", NUMBERS)
def test_the_table_and_the_core_refuse_the_same(table, key, value):
    """In the same words, but for the place."""
    value = float(value) if ROWS[table][key]["kind"] == "number" else int(value)
    given = {**LENGTHS, key: value} if table == "mesh" else {
        **LENGTHS, "walls": [{"edges": ["Edge1"], key: value}]}
    by_table = refusal(lambda: check_all(given, MESH_SETTINGS))
    by_core = refusal(lambda: core.Mesher(model("box"), core.Settings(**given)))
    said = range_said(next(entry for entry in TABLES[table] if entry.key == key)).english
    assert f"{key} must be {said}, got" in by_table
    assert f"{key} must be {said}, got" in by_core


def test_bounds_themselves_are_taken():
    for row in ROWS["mesh"].values():
        if row["kind"] == "number" and row["highest"] is not None and not row["below"]:
            assert not refusal(lambda: core.Mesher(
                model("box"), core.Settings(**{**LENGTHS, row["key"]: row["highest"]})))


def test_settings_have_their_rows_defaults():
    settings = core.Settings(**LENGTHS)
    for row in ROWS["mesh"].values():
        if not row["required"] and hasattr(settings, row["key"]):
            assert getattr(settings, row["key"]) == row["default"], row["key"]
    assert settings.size == 2.0


@pytest.mark.parametrize("number", [3, np.int64(3), np.uint8(3)])
def test_whole_numbers_of_any_kind(number):
    assert core.Settings(**LENGTHS, layers=number).layers == 3


@pytest.mark.parametrize("key, value", [
    ("size", 1j), ("size", "1"), ("size", None), ("growth", [1.2]), ("layers", 2.5),
    ("layers", 2**40), ("layers", True), ("core", "hexes"), ("threads", "2")])
def test_values_of_another_kind_are_named(key, value):
    assert refusal(lambda: core.Settings(**{**LENGTHS, key: value})).startswith(key)


def test_a_wall_comes_to_what_the_mesh_has():
    settings = core.Settings(**LENGTHS, layers=10)
    wall = core.resolve_wall(settings, {"thickness": 1.0})
    assert wall["first_height"] == 0.1 and wall["layers"] == wall["expected_layers"] == 6
    assert wall["thickness"] == pytest.approx(0.1 * (1.2**6 - 1) / 0.2)
    assert core.resolve_wall(settings)["layers"] == 10
    assert core.resolve_wall(settings, {"aspect_ratio": 5.0})["first_height"] is None
    assert core.resolve_wall(core.Settings(**LENGTHS, layers="isotropic"))["layers"] == "isotropic"
    with pytest.raises(core.InvalidInput, match="less than the first height"):
        core.resolve_wall(settings, {"thickness": 0.01})

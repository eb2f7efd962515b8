"""First heights from y+."""
import math

import advlayers
import advlayers_core as core
import pytest
from advlayers.errors import InputError
from advlayers.meshing import core_settings
from advlayers.settings_check import check_all
from advlayers.settings_table import MESH_SETTINGS
from core_meshes import model

AIR = {"speed": 50.0, "length": 1000.0}


def test_a_turbulent_plate_by_hand():
    """Air at 50 m/s, 1 m behind the leading edge."""
    found = advlayers.y_plus(**AIR)
    nu = 1.789e-5 / 1.225
    reynolds = 50.0 / nu
    friction = (2 * math.log10(reynolds) - 0.65) ** -2.3
    assert found.reynolds == pytest.approx(reynolds)
    assert found.first_height == pytest.approx(1000 * nu / (50 * math.sqrt(friction / 2)))
    assert found.boundary_layer == pytest.approx(0.37 * 1000 / reynolds ** 0.2)
    assert 0.0065 < found.first_height < 0.0085 and 15 < found.boundary_layer < 20


def test_the_height_goes_with_y_plus_and_shrinks_with_speed():
    one, thirty = advlayers.y_plus(**AIR), advlayers.y_plus(y_plus=30, **AIR)
    assert thirty.first_height == pytest.approx(30 * one.first_height)
    assert advlayers.y_plus(speed=100, length=1000).first_height < one.first_height


def test_a_laminar_plate_is_that_of_blasius():
    found = advlayers.y_plus(speed=1.0, length=100.0)
    assert found.reynolds < 5e5
    assert found.boundary_layer == pytest.approx(5 * 100 / math.sqrt(found.reynolds))


@pytest.mark.parametrize("speed", [0.01, 0.5, 5.0])
def test_a_pipe_has_the_pressure_loss_of_its_law(speed):
    """The friction velocity gives the friction factor back: 64 / Re, or Prandtl's law."""
    found = advlayers.y_plus(speed=speed, length=50.0, flow="pipe", fluid="water")
    nu = 1.002e-3 / 998.2
    velocity = nu / (found.first_height / 1000)
    factor = 8 * (velocity / speed) ** 2
    if found.reynolds < 2300:
        assert factor == pytest.approx(64 / found.reynolds)
    else:
        assert 1 / math.sqrt(factor) == pytest.approx(
            2 * math.log10(found.reynolds * math.sqrt(factor)) - 0.8)
    assert found.boundary_layer == 25.0


def test_layers_reach_through_the_boundary_layer():
    found = advlayers.y_plus(**AIR)
    for growth in (1.0, 1.1, 1.4):
        layers = found.layers(growth)
        heights = [found.first_height * growth ** k for k in range(layers)]
        assert sum(heights) >= found.boundary_layer * (1 - 1e-9) > sum(heights[:-1])


def test_the_mesh_has_that_height():
    settings = check_all({"size": 2.0, "layers": 4, "y_plus": {**AIR, "y_plus": 100.0}},
                         MESH_SETTINGS)
    asked = advlayers.y_plus(y_plus=100.0, **AIR).first_height
    mesher = core.Mesher(model("box"), core_settings(core, settings, 17.0))
    for _report in mesher:
        pass
    for wall in mesher.result().walls:
        assert wall["first_height"] == asked
        assert wall["achieved_first_height"]["mean"] == pytest.approx(asked, rel=0.02)


@pytest.mark.parametrize("flow, words", [
    ({"length": 1.0}, "speed is missing"),
    ({**AIR, "density": 1.0}, "needs both density and viscosity"),
    ({**AIR, "fluid": "oil"}, '"air" or "water"'),
    ({**AIR, "speed": 0}, "speed must be > 0"),
])
def test_flows_that_are_not_whole_are_refused(flow, words):
    with pytest.raises(InputError) as error:
        advlayers.y_plus(**flow)
    assert words in str(error.value)


def test_either_y_plus_or_a_height():
    settings = check_all({"size": 2.0, "first_height": 0.1, "y_plus": AIR}, MESH_SETTINGS)
    with pytest.raises(InputError, match="y_plus and first_height exclude each other"):
        core_settings(core, settings, 17.0)

"""The heights of layers as the window shows them."""
import numpy as np
from advlayers.layer_heights import height_errors
from core_meshes import mesh


def test_corners_have_the_height_asked_for():
    """Columns lean there, and their edges are longer than the layers are high."""
    result = mesh("square", layers=4)
    errors = height_errors(result)
    layered = np.concatenate([result.layer_of_quad, result.layer_of_triangle]) > 0
    assert np.isfinite(errors[layered]).all() and not np.isfinite(errors[~layered]).any()
    assert np.abs(errors[layered]).max() < 0.03

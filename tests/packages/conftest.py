import glob
import os
import sys

import pytest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "mesher_core", "packaging"))
DIST = os.path.join(ROOT, "out", "dist")


@pytest.fixture(scope="session")
def wheel():
    """The one that `./dev wheel` has made last."""
    found = glob.glob(os.path.join(DIST, "advlayers_core-*.whl"))
    assert len(found) == 1, "run ./dev wheel"
    return found[0]

"""The version stands in CMakeLists.txt; whoever else has to name it says the same."""
import os
import re

import advlayers
import advlayers_core
import pytest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def found_in(name, pattern):
    with open(os.path.join(ROOT, *name.split("/")), encoding="utf-8") as file:
        return re.search(pattern, file.read(), re.M).group(1)


VERSION = found_in("CMakeLists.txt", r"^project\(AdvancingLayers VERSION ([0-9.]+)")


@pytest.mark.parametrize("name, pattern", [
    ("package.xml", r"<version>(.*)</version>"),
    ("CITATION.cff", r"^version: (.*)$"),
    ("docs/CHANGELOG.md", r"^## (.*)$"),
    ("App/advlayers/__init__.py", r'^__version__ = "(.*)"$'),
])
def test_it_is_the_same_in(name, pattern):
    assert found_in(name, pattern) == VERSION


def test_the_modules_say_it():
    assert advlayers.__version__ == advlayers_core.__version__ == VERSION

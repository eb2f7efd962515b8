"""What the headless tests share."""
import FreeCAD
import pytest


@pytest.fixture
def box():
    """Of 30 x 20 x 10 mm, alone in a document."""
    document = FreeCAD.newDocument("Headless")
    made = document.addObject("Part::Box", "Box")
    made.Length, made.Width, made.Height = 30, 20, 10
    document.recompute()
    yield made
    FreeCAD.closeDocument(document.Name)

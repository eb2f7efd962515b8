import FreeCAD
import FreeCADGui
import pytest

from window import events


@pytest.fixture
def document():
    """A new document in the workbench; whatever is open is closed afterwards."""
    FreeCADGui.activateWorkbench("AdvancingLayersWorkbench")
    made = FreeCAD.newDocument("GuiTest")
    name = made.Name
    events()
    yield made
    if name in FreeCAD.listDocuments():
        if FreeCADGui.Control.activeDialog():
            FreeCADGui.getDocument(name).resetEdit()
            FreeCADGui.Control.closeDialog()
        events()
        FreeCAD.closeDocument(name)
    events()


@pytest.fixture
def box(document):
    made = document.addObject("Part::Box", "Box")
    made.Length, made.Width, made.Height = 30, 20, 10
    document.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    events()
    return made

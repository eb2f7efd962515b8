"""The workbench in a real window: it loads, its command makes a mesh, and the mesh is seen."""
import os
import subprocess
import time

import advlayers
import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from advlayers import core_access, layer_mesh
from advlayers.errors import CoreMissing

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__)))))
PICTURES = os.path.join(ROOT, "out", "gui")


def events(seconds=0.05):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()
        time.sleep(0.005)


def screenshot(name):
    """Of the whole screen: a widget's own grab leaves the 3D view blank in some versions."""
    os.makedirs(PICTURES, exist_ok=True)
    path = os.path.join(PICTURES, name)
    assert QtGui.QApplication.primaryScreen().grabWindow(0).save(path)
    return path


@pytest.fixture
def box():
    FreeCADGui.activateWorkbench("AdvancingLayersWorkbench")
    document = FreeCAD.newDocument("GuiTest")
    made = document.addObject("Part::Box", "Box")
    made.Length, made.Width, made.Height = 30, 20, 10
    document.recompute()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    events()
    yield made
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.ActiveDocument.resetEdit()
        FreeCADGui.Control.closeDialog()
    events()
    FreeCAD.closeDocument(document.Name)


def select(*names):
    FreeCADGui.Selection.clearSelection()
    for name in names or ("",):
        FreeCADGui.Selection.addSelection("GuiTest", "Box", name)
    events()


def child(kind, name):
    found = FreeCADGui.getMainWindow().findChild(kind, name)
    assert found is not None, name
    return found


def press(standard_button):
    """Presses a button of the task panel."""
    for box in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        button = box.button(standard_button)
        if button is not None and button.isVisible():
            button.click()
            events()
            return
    raise AssertionError("no such button in the task panel")


def test_the_workbench_is_there():
    assert "AdvancingLayersWorkbench" in FreeCADGui.listWorkbenches()
    workbench = FreeCADGui.getWorkbench("AdvancingLayersWorkbench")
    assert os.path.isfile(workbench.Icon)
    FreeCADGui.activateWorkbench("AdvancingLayersWorkbench")
    assert FreeCADGui.activeWorkbench().name() == "AdvancingLayersWorkbench"
    assert "AdvLayers_LayerMesh" in FreeCADGui.listCommands()


def test_the_command_opens_a_panel_that_meshes(box):
    select()
    FreeCADGui.runCommand("AdvLayers_LayerMesh")
    events()
    assert FreeCADGui.Control.activeDialog()
    made = box.Document.getObject("LayerMesh")
    assert made.State == layer_mesh.NOT_MESHED and made.FemMesh.NodeCount == 0
    child(QtGui.QPushButton, "AdvLayersMeshButton").click()
    events()
    status = child(QtGui.QLabel, "AdvLayersStatus").text()
    assert made.State == layer_mesh.UP_TO_DATE, status
    assert made.FemMesh.QuadrangleCount == made.QuadCount > 0
    assert str(made.QuadCount) in status
    screenshot("panel.png")
    press(QtGui.QDialogButtonBox.Ok)
    assert not FreeCADGui.Control.activeDialog()
    assert box.Document.getObject("LayerMesh").State == layer_mesh.UP_TO_DATE
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    events(0.2)
    screenshot("mesh.png")


def test_selected_faces_only(box):
    select("Face2", "Face6")
    FreeCADGui.runCommand("AdvLayers_LayerMesh")
    events()
    press(QtGui.QDialogButtonBox.Ok)
    made = box.Document.getObject("LayerMesh")
    assert made.Faces == ["Face2", "Face6"]
    names = [made.FemMesh.getGroupName(i) for i in made.FemMesh.Groups]
    assert "Face2" in names and "Face6" in names and "Face1" not in names


def test_cancel_takes_the_new_object_away(box):
    select()
    FreeCADGui.runCommand("AdvLayers_LayerMesh")
    events()
    press(QtGui.QDialogButtonBox.Cancel)
    assert not FreeCADGui.Control.activeDialog()
    assert [entry.Name for entry in box.Document.Objects] == ["Box"]


def test_cancel_of_a_later_edit_brings_the_mesh_back(box):
    made = advlayers.make_layer_mesh(box, size=5.0)
    quads, size = made.QuadCount, made.Size.Value
    FreeCADGui.ActiveDocument.setEdit(made.Name)
    events()
    child(QtGui.QWidget, "AdvLayers_size").setProperty("rawValue", 2.5)
    child(QtGui.QPushButton, "AdvLayersMeshButton").click()
    events()
    assert made.QuadCount != quads
    press(QtGui.QDialogButtonBox.Cancel)
    assert made.Size.Value == size
    assert made.QuadCount == made.FemMesh.QuadrangleCount == quads
    assert made.State == layer_mesh.UP_TO_DATE


def answer_message(seen):
    """Closes the message box that comes up next, and keeps its text."""
    def close():
        message = QtGui.QApplication.activeModalWidget()
        if message is None:
            QtCore.QTimer.singleShot(50, close)
            return
        seen.append(message.text())
        message.close()
    QtCore.QTimer.singleShot(50, close)


def test_nothing_selected_says_so(box):
    FreeCADGui.Selection.clearSelection()
    seen = []
    answer_message(seen)
    FreeCADGui.runCommand("AdvLayers_LayerMesh")
    assert len(seen) == 1 and "Select" in seen[0]
    assert [entry.Name for entry in box.Document.Objects] == ["Box"]


def test_a_missing_core_names_the_remedy(box, monkeypatch):
    def missing():
        raise CoreMissing('the meshing core is not built: run "./dev build"')

    monkeypatch.setattr(core_access, "load_core", missing)
    select()
    seen = []
    answer_message(seen)
    FreeCADGui.runCommand("AdvLayers_LayerMesh")
    assert len(seen) == 1 and "./dev build" in seen[0]
    assert [entry.Name for entry in box.Document.Objects] == ["Box"]


def test_a_file_made_without_a_window_gets_its_view_provider(box, tmp_path):
    from advlayers_gui.view_provider import LayerMeshView

    box.Shape.exportStep(str(tmp_path / "box.step"))
    job = tmp_path / "job.json"
    job.write_text('{"input": "box.step", "size": 5.0, "outputs": ["box.FCStd"]}')
    batch = os.path.join(ROOT, "App", "advlayers_batch.py")
    done = subprocess.run(["freecadcmd", batch, str(job)], stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    document = FreeCAD.openDocument(str(tmp_path / "box.FCStd"))
    events()
    try:
        restored = document.getObject("LayerMesh")
        assert isinstance(restored.ViewObject.Proxy, LayerMeshView)
        assert restored.QuadCount == restored.FemMesh.QuadrangleCount > 0
        assert restored.State == layer_mesh.UP_TO_DATE
        FreeCADGui.getDocument(document.Name).setEdit(restored.Name)
        events()
        assert FreeCADGui.Control.activeDialog()
        press(QtGui.QDialogButtonBox.Cancel)
        assert restored.QuadCount == restored.FemMesh.QuadrangleCount > 0
    finally:
        FreeCAD.closeDocument(document.Name)
        FreeCAD.setActiveDocument("GuiTest")

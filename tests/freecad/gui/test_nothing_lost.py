"""What would lose a finished mesh or changed settings asks first; OK means one thing."""
import advlayers
import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from advlayers import layer_mesh
from window import (
    answer_message, asked, child, click, edit, events, mesh_until_done, panel_of, press,
    press_cancel, press_ok, run, select, wait_for)


@pytest.fixture
def opened(box):
    """The mesh object of the box, with its panel open."""
    select((box, ""))
    run("LayerMesh")
    return box.Document.getObject("LayerMesh")


def question():
    return child(QtGui.QLabel, "AdvLayersQuestionText").text()


def set_size(value):
    child(QtGui.QWidget, "LayerMesh_size").setProperty("rawValue", value)
    child(QtGui.QWidget, "LayerMesh_size").editingFinished.emit()
    events()


def escape_in_the_view():
    (view,) = FreeCADGui.getMainWindow().findChildren(QtGui.QGraphicsView)
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtGui.QApplication.sendEvent(
            view, QtGui.QKeyEvent(kind, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier))
    events()


def test_cancel_and_escape_ask_for_a_finished_mesh(opened, box):
    assert not asked()
    mesh_until_done(opened)
    press(QtGui.QDialogButtonBox.Cancel)
    assert asked() and "not in the document" in question()
    click("AdvLayersGoOn")
    assert not asked() and FreeCADGui.Control.activeDialog()
    escape_in_the_view()
    assert asked() and panel_of(opened) is not None
    escape_in_the_view()  # does not answer
    assert asked() and opened.FemMesh.NodeCount == 0
    click("AdvLayersKeep")
    wait_for(lambda: not FreeCADGui.Control.activeDialog())
    assert opened.State == layer_mesh.UP_TO_DATE and opened.FemMesh.NodeCount > 0
    edit(opened)
    escape_in_the_view()  # nothing has changed
    assert not FreeCADGui.Control.activeDialog() and opened.FemMesh.NodeCount > 0
    edit(opened)
    set_size(opened.Size.Value / 2)
    size = opened.Size.Value
    press(QtGui.QDialogButtonBox.Cancel)
    assert asked() and "changes" in question()
    click("AdvLayersDiscard")
    assert not FreeCADGui.Control.activeDialog()
    assert opened.Size.Value == pytest.approx(2 * size)
    assert opened.State == layer_mesh.UP_TO_DATE


def test_undo_of_a_new_mesh_asks(opened, box):
    """FreeCAD takes the object away, and its panel with it: both come back."""
    mesh_until_done(opened)
    FreeCADGui.runCommand("Std_Undo")
    wait_for(asked)
    mesh = box.Document.getObject("LayerMesh")
    assert panel_of(mesh) is not None and "Undo" in question()
    click("AdvLayersKeep")
    wait_for(lambda: not FreeCADGui.Control.activeDialog())
    assert mesh.State == layer_mesh.UP_TO_DATE and mesh.FemMesh.NodeCount > 0


def test_undo_of_a_change_asks_and_discard_takes_all_back(box):
    made = advlayers.make_layer_mesh(box, size=5.0)
    events()
    edit(made)
    set_size(4.0)
    FreeCADGui.runCommand("Std_Undo")
    wait_for(asked)
    assert made.Size.Value == 4.0 and panel_of(made) is not None
    click("AdvLayersGoOn")
    set_size(3.0)
    press_cancel()
    assert made.Size.Value == 5.0 and made.State == layer_mesh.UP_TO_DATE


def test_undo_of_a_new_mesh_and_discard_leave_the_shape_alone(opened, box):
    mesh_until_done(opened)
    FreeCADGui.runCommand("Std_Undo")
    wait_for(asked)
    click("AdvLayersDiscard")
    assert not FreeCADGui.Control.activeDialog()
    assert [entry.Name for entry in box.Document.Objects] == ["Box"]
    assert box.ViewObject.Visibility


def test_a_panel_closed_from_outside_keeps_its_mesh(opened, capsys):
    mesh_until_done(opened)
    FreeCADGui.getDocument(opened.Document.Name).resetEdit()
    events()
    assert not FreeCADGui.Control.activeDialog()
    assert opened.State == layer_mesh.UP_TO_DATE and opened.FemMesh.NodeCount > 0


def test_ok_meshes_what_is_out_of_date_and_later_does_not(box):
    made = advlayers.make_layer_mesh(box, size=5.0)
    quads = made.QuadCount
    edit(made)
    set_size(2.5)
    click("AdvLayersLater")
    wait_for(lambda: not FreeCADGui.Control.activeDialog())
    assert made.Size.Value == 2.5 and made.QuadCount == quads
    assert made.State == layer_mesh.OUT_OF_DATE
    edit(made)
    mesh_until_done(made)
    set_size(2.0)  # after the run
    press_ok()
    assert made.State == layer_mesh.UP_TO_DATE and made.QuadCount > quads
    assert made.ViewObject.DisplayMode == "Layers"


def test_a_shape_in_error_is_not_meshed(box):
    document = box.Document
    tool = document.addObject("Part::Cylinder", "Tool")
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = box, tool
    document.recompute()
    made = advlayers.make_layer_mesh(cut, size=5.0)
    nodes = made.NodeCount
    cut.Tool = None
    document.recompute()
    assert made.State == layer_mesh.SOURCE_IN_ERROR
    seen = []
    answer_message(seen)
    select((made, ""))
    run("Update")
    assert len(seen) == 1 and "in error" in seen[0] and made.NodeCount == nodes
    edit(made)
    click("AdvLayersMeshButton")
    assert "in error" in child(QtGui.QLabel, "AdvLayersStatus").text()
    press_cancel()
    cut.Tool = tool
    document.recompute()
    assert made.State == layer_mesh.UP_TO_DATE
    FreeCAD.setActiveDocument(document.Name)

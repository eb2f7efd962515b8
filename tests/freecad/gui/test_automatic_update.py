"""Meshes that update themselves: beside the window, once the recompute is over."""
import advlayers
import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from advlayers import layer_mesh
from advlayers_gui import automatic_update
from window import (
    child, edit, events, press_cancel, press_ok, report_text, screenshot, wait_for)

FINE = 0.08  # [mm] a size that takes several seconds


@pytest.fixture
def mesh(box):
    """Of the box, and up to date."""
    made = advlayers.make_layer_mesh(box, size=4.0, first_height=0.4, layers=3)
    made.AutoUpdate = True
    box.Document.recompute()
    box.Document.clearUndos()
    events()
    return made


def change(box, length):
    """As a user does it in the property editor."""
    box.Document.openTransaction("Length")
    box.Length = length
    box.Document.commitTransaction()
    box.Document.recompute()


def begin_long_run(mesh):
    mesh.Size = FINE
    mesh.Document.recompute()
    wait_for(progress_windows)


def progress_windows():
    return [window for window in FreeCADGui.getMainWindow().findChildren(QtGui.QProgressDialog)
            if window.isVisible()]


def wait_until_done(mesh):
    wait_for(lambda: not automatic_update.under_way(mesh))


def assert_meshed(mesh):
    assert mesh.State == layer_mesh.UP_TO_DATE
    assert mesh.FemMesh.BoundBox.XMax == pytest.approx(mesh.Part.Length.Value)
    assert mesh.FemMesh.QuadrangleCount == mesh.QuadCount


def test_a_recompute_does_not_wait_for_the_mesh(mesh, box):
    """A window that handles its events in the midst of a recompute can crash FreeCAD."""
    change(box, 60)
    assert mesh.State == layer_mesh.OUT_OF_DATE and automatic_update.under_way(mesh)
    wait_until_done(mesh)
    assert_meshed(mesh)
    assert not mesh.Document.mustExecute()


def test_a_long_run_shows_itself_and_can_be_stopped(mesh):
    nodes = mesh.FemMesh.NodeCount
    begin_long_run(mesh)
    (window,) = progress_windows()
    assert not window.isModal()
    wait_for(lambda: "\n" in window.labelText())
    assert mesh.Label in window.labelText()
    screenshot("automatic-update.png")
    window.findChild(QtGui.QPushButton).click()
    wait_until_done(mesh)
    assert progress_windows() == []
    assert mesh.State == layer_mesh.OUT_OF_DATE and mesh.FemMesh.NodeCount == nodes


def test_the_latest_change_counts(mesh, box):
    begin_long_run(mesh)
    mesh.Size = 4.0
    change(box, 45)
    wait_until_done(mesh)
    assert_meshed(mesh)


def test_undo_while_meshing(mesh, box):
    before = (mesh.QuadCount, mesh.FemMesh.Nodes)
    change(box, 60)
    assert automatic_update.under_way(mesh)
    FreeCADGui.runCommand("Std_Undo")
    wait_until_done(mesh)
    box.Document.recompute()
    wait_until_done(mesh)
    assert_meshed(mesh)
    assert (mesh.QuadCount, mesh.FemMesh.Nodes) == before


def test_undo_afterwards(mesh, box):
    change(box, 60)
    wait_until_done(mesh)
    FreeCADGui.runCommand("Std_Undo")
    box.Document.recompute()
    wait_until_done(mesh)
    assert box.Length.Value == 30
    assert_meshed(mesh)
    FreeCADGui.runCommand("Std_Redo")
    box.Document.recompute()
    wait_until_done(mesh)
    assert box.Length.Value == 60
    assert_meshed(mesh)


def test_what_is_meshed_goes_away(mesh, box):
    begin_long_run(mesh)
    mesh.Document.removeObject(mesh.Name)
    wait_for(lambda: not automatic_update._updates)
    assert progress_windows() == []
    again = advlayers.make_layer_mesh(box, size=4.0)
    again.AutoUpdate = True
    begin_long_run(again)
    FreeCAD.closeDocument(box.Document.Name)
    wait_for(lambda: not automatic_update._updates)
    assert progress_windows() == []


def test_the_panel_goes_before(mesh):
    begin_long_run(mesh)
    edit(mesh)
    wait_until_done(mesh)
    child(QtGui.QWidget, "LayerMesh_size").setProperty("rawValue", 3.0)
    mesh.Document.recompute()
    events(0.2)
    assert not automatic_update.under_way(mesh)  # the panel has its own Mesh
    press_ok()
    wait_until_done(mesh)
    assert_meshed(mesh)
    assert mesh.Size.Value == 3.0
    edit(mesh)
    press_cancel()


def test_what_went_wrong_is_told(mesh, monkeypatch):
    from advlayers_gui import mesh_task

    class Broken:
        RunContext = mesh_task.load_core().RunContext

        def __getattr__(self, name):
            raise RuntimeError("the shape is broken")

    monkeypatch.setattr(mesh_task, "load_core", Broken)
    before = len(report_text())
    mesh.Size = 3.0
    mesh.Document.recompute()
    wait_until_done(mesh)
    events()
    assert f"{mesh.Label}: the shape is broken" in report_text()[before:]
    assert mesh.State == layer_mesh.OUT_OF_DATE
    monkeypatch.undo()
    mesh.Growth = 0.5
    mesh.Document.recompute()
    assert not mesh.isValid()
    assert not automatic_update.under_way(mesh)

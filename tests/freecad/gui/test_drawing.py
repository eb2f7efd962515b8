"""FreeCAD's own picture of a mesh is made a turn of the event loop after the mesh has changed, and
a large mesh is read back in many turns: whatever comes between, what is shown is the mesh."""
import advlayers
import FreeCAD
import pytest

from PySide import QtGui

from advlayers import element_mesh
from advlayers.mesh_data import QUALITY
from window import (
    child, edit, errors_since, events, mesh_until_done, panel_of, press_cancel, report_text,
    wait_for)


@pytest.fixture
def mesh(box):
    made = advlayers.make_layer_mesh(box, size=4.0, first_height=0.4, growth=1.3)
    settle(made)
    box.Document.clearUndos()
    return made


@pytest.fixture
def small_steps(monkeypatch):
    """Reading takes many turns even for a small mesh."""
    monkeypatch.setattr(element_mesh, "_BLOCK", 3)
    monkeypatch.setattr("advlayers_gui.turns._TURN", 0.0)


def shows(mesh):
    """FreeCAD's own picture is that of the mesh."""
    return ({element for element, _side in mesh.ViewObject.VisibleElementFaces}
            == set(mesh.FemMesh.Faces))


def is_seen(mesh):
    return mesh.ViewObject.SwitchNode.whichChild.getValue() >= 0


def mesh_anew(mesh, size):
    """Up to OK, after which the event loop has not had a turn yet. Returns the elements before."""
    before = mesh.FemMesh.FaceCount
    mesh.Size = size
    edit(mesh)
    mesh_until_done(mesh)
    panel_of(mesh).accept()
    assert mesh.FemMesh.FaceCount != before
    return before


def settle(mesh):
    for _turn in range(10):
        events(0.001)
    assert shows(mesh) and is_seen(mesh)


def test_the_mesh_shows_after_ok(mesh):
    mesh_anew(mesh, 2.0)
    assert not shows(mesh)
    settle(mesh)


def test_a_script_sees_its_mesh_at_once(mesh):
    mesh.Size = 2.0
    advlayers.update(mesh)
    assert shows(mesh) and is_seen(mesh)


def test_undo_and_redo_show_their_mesh(mesh):
    before = mesh_anew(mesh, 2.0)
    mesh.Document.undo()  # at once
    assert mesh.FemMesh.FaceCount == before
    settle(mesh)
    mesh.Document.redo()
    settle(mesh)
    mesh.Document.undo()
    mesh.Document.redo()
    assert mesh.FemMesh.FaceCount != before
    settle(mesh)


def test_a_mesh_hidden_at_once_stays_hidden(mesh):
    mesh_anew(mesh, 2.0)
    mesh.ViewObject.Visibility = False
    for _turn in range(10):
        events(0.001)
    assert shows(mesh) and not is_seen(mesh)


def test_saved_at_once(mesh, tmp_path):
    mesh_anew(mesh, 2.0)
    path = str(tmp_path / "at-once.FCStd")
    mesh.Document.saveCopy(path)
    opened = FreeCAD.openDocument(path)
    try:
        restored = opened.getObject(mesh.Name)
        assert restored.FemMesh.Nodes == mesh.FemMesh.Nodes
        assert restored.FemMesh.GroupCount == mesh.FemMesh.GroupCount
        settle(restored)
    finally:
        FreeCAD.closeDocument(opened.Name)


def test_closed_or_deleted_at_once(mesh):
    start = len(report_text())
    mesh_anew(mesh, 2.0)
    mesh.Document.removeObject(mesh.Name)
    events(0.2)
    document = FreeCAD.ActiveDocument
    document.undo()
    back = document.getObject("LayerMesh")
    settle(back)
    mesh_anew(back, 3.0)
    FreeCAD.closeDocument(document.Name)
    events(0.2)
    assert errors_since(start) == []


def reopened(mesh, tmp_path):
    path = str(tmp_path / "reopened.FCStd")
    mesh.Document.saveCopy(path)
    return FreeCAD.openDocument(path).getObject(mesh.Name)


def test_a_reopened_mesh_is_read_in_many_turns(mesh, tmp_path, small_steps):
    again = reopened(mesh, tmp_path)
    modes = again.ViewObject.Proxy.modes
    again.ViewObject.DisplayMode = QUALITY
    assert modes.busy and modes.element_count == 0
    wait_for(lambda: not modes.busy)
    assert modes.element_count == mesh.FemMesh.FaceCount
    FreeCAD.closeDocument(again.Document.Name)


def test_another_mesh_while_one_is_read(mesh, tmp_path, small_steps):
    again = reopened(mesh, tmp_path)
    modes = again.ViewObject.Proxy.modes
    again.ViewObject.DisplayMode = QUALITY
    again.Size = 2.0
    advlayers.update(again)
    assert again.FemMesh.FaceCount > mesh.FemMesh.FaceCount
    wait_for(lambda: not modes.busy)
    assert modes.element_count == again.FemMesh.FaceCount
    FreeCAD.closeDocument(again.Document.Name)


def test_closed_while_it_is_read(mesh, tmp_path, small_steps):
    start = len(report_text())
    again = reopened(mesh, tmp_path)
    again.ViewObject.DisplayMode = QUALITY
    FreeCAD.closeDocument(again.Document.Name)
    events(0.2)
    again = reopened(mesh, tmp_path)
    edit(again)
    press_cancel()
    FreeCAD.closeDocument(again.Document.Name)
    events(0.2)
    assert errors_since(start) == []


def test_the_panel_of_a_reopened_mesh_has_its_results(mesh, tmp_path, small_steps):
    again = reopened(mesh, tmp_path)
    edit(again)
    figures = child(QtGui.QLabel, "AdvLayersFigures")
    wait_for(lambda: str(mesh.QuadCount) in figures.text(), 10.0)
    child(QtGui.QTabWidget, "AdvLayersTabs").setCurrentIndex(2)
    wait_for(lambda: panel_of(again).scene.element_count == mesh.FemMesh.FaceCount, 10.0)
    press_cancel()
    FreeCAD.closeDocument(again.Document.Name)

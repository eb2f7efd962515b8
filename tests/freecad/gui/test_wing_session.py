"""A whole session with a wing, as the tutorial tells it; the pictures are the tutorial's."""
import os

import FreeCAD
import FreeCADGui
import Part
import pytest
from PySide import QtGui

from advlayers import layer_mesh
from window import (
    child, click, edit, errors_since, events, panel_of, press_cancel, press_ok,
    report_text, run, screenshot, select, wait_for)

# Half thickness of a NACA 0018 section over its chord; the last term closes the trailing edge.
_THICKNESS = ((0.5, 0.2969), (1.0, -0.1260), (2.0, -0.3516), (3.0, 0.2843), (4.0, -0.1036))
_CHORD, _SPAN = 1000.0, 1500.0  # [mm]


def wing_shape():
    def height(x):
        return 5.0 * 0.18 * sum(factor * x ** power for power, factor in _THICKNESS)

    stations = [(k / 30.0) ** 2 for k in range(31)]
    upper = [FreeCAD.Vector(_CHORD * x, _CHORD * height(x), 0.0) for x in stations]
    lower = [FreeCAD.Vector(point.x, -point.y, 0.0) for point in upper]
    edges = []
    for points in (upper, lower):
        curve = Part.BSplineCurve()
        curve.interpolate(points)
        edges.append(curve.toShape())
    return Part.Face(Part.Wire(edges)).extrude(FreeCAD.Vector(0.0, 0.0, _SPAN))


@pytest.fixture
def wing(document, tmp_path):
    """A document with a wing, saved and opened again as a user finds it."""
    made = document.addObject("Part::Feature", "Wing")
    made.Shape = wing_shape()
    document.recompute()
    path = str(tmp_path / "wing.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    opened = FreeCAD.openDocument(path)
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    events(0.3)
    yield opened.getObject("Wing")
    for name in ("wing", "Wing"):
        if name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(name)


def set_length(key, millimetres):
    child(QtGui.QWidget, f"LayerMesh_{key}").setProperty("rawValue", float(millimetres))


def watch_the_run(panel):
    """The numbers of elements in layers that the view showed, one after the other."""
    shown = [0]

    def look():
        count = panel.scene.layer_element_count
        if panel.meshing and not panel.scene.busy and count > shown[-1]:
            shown.append(count)
            if count < 0.8 * panel.scene.element_count:  # the last one that shows both
                screenshot("wing-growing.png", settle=0.01)
        return not panel.meshing and not panel.scene.busy

    wait_for(look)
    return shown[1:]


def test_a_session_with_a_wing(wing, tmp_path, monkeypatch):
    FreeCADGui.activateWorkbench("AdvancingLayersWorkbench")
    document, before = wing.Document, len(report_text())
    select((wing, ""))
    screenshot("wing-selected.png")
    run("LayerMesh")
    mesh = document.getObject("LayerMesh")
    set_length("size", 30.0)
    set_length("first_height", 3.0)
    child(QtGui.QDoubleSpinBox, "LayerMesh_growth").setValue(1.1)
    events(0.2)
    screenshot("wing-panel.png")
    panel = panel_of(mesh)
    click("AdvLayersMeshButton")
    assert len(watch_the_run(panel)) >= 3
    events(0.2)
    screenshot("wing-results.png")
    press_ok()
    assert mesh.State == layer_mesh.UP_TO_DATE and mesh.QuadPercent > 95.0
    first = (mesh.QuadCount, mesh.FemMesh.Nodes)
    mesh.ViewObject.DisplayMode = "Quality"
    wait_for(lambda: not mesh.ViewObject.Proxy.modes.busy)
    events(0.2)
    screenshot("wing-quality.png")

    document.save()
    path = document.FileName
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument(path)
    events(0.2)
    mesh = document.getObject("LayerMesh")
    assert mesh.State == layer_mesh.UP_TO_DATE
    assert (mesh.QuadCount, len(mesh.FemMesh.Nodes)) == (first[0], len(first[1]))
    assert mesh.ViewObject.DisplayMode == "Quality"

    document.openTransaction("Growth")
    mesh.Growth = 1.2
    document.commitTransaction()
    document.recompute()
    assert mesh.State == layer_mesh.OUT_OF_DATE
    select((mesh, ""))
    run("Update")
    assert mesh.State == layer_mesh.UP_TO_DATE and mesh.QuadCount < first[0]
    second = mesh.FemMesh.Nodes
    FreeCADGui.runCommand("Std_Undo")
    events()
    assert mesh.FemMesh.Nodes != second and mesh.QuadCount == first[0]
    assert mesh.FemMesh.QuadrangleCount == first[0]
    FreeCADGui.runCommand("Std_Redo")
    events()
    assert mesh.FemMesh.Nodes == second and mesh.State == layer_mesh.UP_TO_DATE

    target = str(tmp_path / "wing.vtu")
    monkeypatch.setattr(QtGui.QFileDialog, "getSaveFileName", lambda *_arguments: (target, ""))
    run("Export")
    assert os.path.getsize(target) > 10_000
    edit(mesh)
    press_cancel()
    assert mesh.FemMesh.Nodes == second
    assert errors_since(before) == []
    document.save()

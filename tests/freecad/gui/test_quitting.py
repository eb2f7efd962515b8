"""FreeCAD is quit while a mesh is being made: it ends at once, and as it should."""
import fresh_window
import pytest

# A run of minutes, so that it cannot end by itself while the test waits for FreeCAD.
_SESSION = """
import advlayers, FreeCAD, FreeCADGui
from PySide import QtCore, QtGui
FreeCADGui.activateWorkbench("AdvancingLayersWorkbench")
document = FreeCAD.newDocument("Quit")
plate = document.addObject("Part::Plane", "Plate")
plate.Length = plate.Width = 100
document.recompute()
mesh = advlayers.make_layer_mesh(
    plate, mesh_now=False, size=5, first_height=0.02, growth=1.05, layers=48,
    sizes=[{"edges": [f"Edge{k}" for k in (1, 2, 3, 4)], "segments": 20000}])
def answer():
    # The window of a command's progress may have come up over the question.
    boxes = [widget for widget in QtGui.QApplication.topLevelWidgets()
             if isinstance(widget, QtGui.QMessageBox) and widget.isVisible()]
    for box in boxes:
        for button in box.buttons():
            if box.buttonRole(button) == QtGui.QMessageBox.DestructiveRole:
                button.click()
    if not boxes:
        QtCore.QTimer.singleShot(50, answer)
def quit_amid(running):
    if running():
        print("running", flush=True)
        QtCore.QTimer.singleShot(100, answer)
        FreeCADGui.getMainWindow().close()
    else:
        QtCore.QTimer.singleShot(50, lambda: quit_amid(running))
"""
_RUNS = {
    "panel": """
mesh.ViewObject.Proxy.doubleClicked(mesh.ViewObject)
button = FreeCADGui.getMainWindow().findChildren(QtGui.QPushButton, "AdvLayersMeshButton")[-1]
button.click()
quit_amid(lambda: mesh.ViewObject.Proxy.panel.meshing)
""",
    "automatic update": """
from advlayers_gui import automatic_update
mesh.AutoUpdate = True
document.recompute()
quit_amid(lambda: automatic_update.under_way(mesh))
""",
    "command": """
FreeCADGui.Selection.addSelection(mesh)
QtCore.QTimer.singleShot(300, lambda: quit_amid(lambda: True))
FreeCADGui.runCommand("AdvLayers_Update")
""",
}


@pytest.mark.parametrize("way", _RUNS)
def test_quitting_amid_a_run(way, tmp_path):
    home = tmp_path / "home"
    fresh_window.link_add_on(home)
    status, printed = fresh_window.run_until_it_quits(home, _SESSION + _RUNS[way])
    assert "running" in printed, printed
    assert status == 0, printed
    assert "Traceback" not in printed and "advlayers" not in printed.lower(), printed

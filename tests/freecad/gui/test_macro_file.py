"""A macro as FreeCAD's own recorder writes it, run again without a window."""
import os
import shutil
import subprocess

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from window import close_panel, events, run, select


@pytest.fixture
def record(tmp_path):
    """Begins recording; calling what comes back ends it and gives the macro's path."""
    preferences = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Macro")
    kept = preferences.GetString("MacroPath")
    preferences.SetString("MacroPath", str(tmp_path))

    def start():
        dialog = QtGui.QApplication.activeModalWidget()
        dialog.findChild(QtGui.QLineEdit, "lineEditPath").setText("recorded")
        dialog.findChild(QtGui.QPushButton, "buttonStart").click()

    QtCore.QTimer.singleShot(500, start)
    FreeCADGui.runCommand("Std_DlgMacroRecord")
    events()

    def stop():
        known = FreeCADGui.listCommands()
        FreeCADGui.runCommand("Std_MacroStopRecord" if "Std_MacroStopRecord" in known
                              else "Std_DlgMacroRecord")
        events()
        return os.path.join(str(tmp_path), "recorded.FCMacro")

    yield stop
    preferences.SetString("MacroPath", kept)


def test_a_recorded_macro_runs_without_a_window(box, record, tmp_path):
    select((box, ""))
    run("LayerMesh")
    close_panel()
    select((box, "Edge1"))
    run("Wall")
    close_panel()
    select((box, "Face2"))
    run("Group")
    run("Update")
    with open(record(), encoding="utf-8") as file:
        macro = file.read()
    assert "make_layer_mesh" in macro and "make_wall" in macro

    saved = str(tmp_path / "again.FCStd")
    script = tmp_path / "again.py"
    script.write_text(
        "import FreeCAD\n"
        "import FreeCAD as App\n"
        f"document = App.newDocument({box.Document.Name!r})\n"
        "box = document.addObject('Part::Box', 'Box')\n"
        "box.Length, box.Width, box.Height = 30, 20, 10\n"
        f"document.recompute()\n{macro}\ndocument.saveAs({saved!r})\n")
    ran = subprocess.run([shutil.which("freecadcmd"), str(script)], stdin=subprocess.DEVNULL,
                         capture_output=True, text=True, timeout=120)
    assert os.path.exists(saved), ran.stdout + ran.stderr + macro
    made = FreeCAD.openDocument(saved, True)
    try:
        assert made.LayerMesh.FemMesh.FaceCount == box.Document.LayerMesh.FemMesh.FaceCount > 0
    finally:
        FreeCAD.closeDocument(made.Name)

"""The preferences page: it is there, it stores what it shows, and new meshes follow it."""
import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from advlayers import preferences
from advlayers.settings_table import setting
from window import close_panel, events, run, screenshot, select


@pytest.fixture
def kept():
    group = FreeCAD.ParamGet(preferences.PATH)
    yield group
    for kind, name, _value in group.GetContents() or []:
        {"Float": group.RemFloat, "Integer": group.RemInt, "Boolean": group.RemBool,
         "String": group.RemString}[kind](name)


def test_the_page_stores_what_it_shows(kept):
    seen = {}

    def act():
        window = QtGui.QApplication.activeModalWidget()
        if window is None:
            QtCore.QTimer.singleShot(50, act)
            return
        seen["growth"] = window.findChild(QtGui.QDoubleSpinBox, "growth").value()
        window.findChild(QtGui.QDoubleSpinBox, "growth").setValue(1.35)
        window.findChild(QtGui.QSpinBox, "layers").setValue(7)
        window.findChild(QtGui.QCheckBox, "isotropic").setChecked(False)
        window.findChild(QtGui.QComboBox, "core").setCurrentIndex(1)
        window.findChild(QtGui.QCheckBox, "livePreview").setChecked(False)
        screenshot("preferences.png")
        window.findChild(QtGui.QDialogButtonBox).button(QtGui.QDialogButtonBox.Ok).click()

    QtCore.QTimer.singleShot(100, act)
    FreeCADGui.showPreferences("Advancing Layers", 0)
    events()
    assert seen["growth"] == setting("growth").default
    assert preferences.settings() == {"growth": pytest.approx(1.35), "layers": 7,
                                      "core": "triangles"}
    assert not preferences.live_preview()


def test_a_new_mesh_follows_the_preferences(kept, box):
    assert preferences.settings() == {"layers": "isotropic"}
    kept.SetFloat("Growth", 1.35)
    select((box, ""))
    run("LayerMesh")
    mesh = box.Document.getObject("LayerMesh")
    assert (mesh.Growth, mesh.Layers) == (1.35, "isotropic")
    close_panel()

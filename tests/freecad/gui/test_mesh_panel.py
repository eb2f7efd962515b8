"""The panel of a layer mesh: settings, the run and its pictures, OK, Stop and Cancel."""
import time

import advlayers
import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from advlayers import layer_mesh
from advlayers.settings_table import MESH_SETTINGS
from window import (
    answer_message, child, click, edit, events, mesh_until_done, panel_of, press_cancel,
    press_ok, run, screenshot, select, status, wait_for)

FINE = {"size": 0.12, "first_height": 0.02, "layers": 3}  # some 10 s


@pytest.fixture
def opened(box):
    """The mesh object of the box, with its panel open."""
    select((box, ""))
    run("LayerMesh")
    return box.Document.getObject("LayerMesh")


def state_of(document):
    """Everything that a user could tell to have changed, as far as its text tells it."""
    return {f"{entry.Name}.{name}: {getattr(entry, name)}"
            for entry in document.Objects for name in entry.PropertiesList
            if name not in ("FemMesh", "Proxy", "Shape", "ShapeMaterial")}


def test_the_mesh_comes_with_ok(opened):
    assert opened.State == layer_mesh.NOT_MESHED
    mesh_until_done(opened)
    assert opened.FemMesh.NodeCount == 0  # the document has it with OK
    text = status()
    assert "quads" in text
    press_ok()
    assert opened.State == layer_mesh.UP_TO_DATE
    assert opened.FemMesh.QuadrangleCount == opened.QuadCount > 0
    assert str(opened.QuadCount) in text
    assert opened.ViewObject.Visibility and not opened.Part.ViewObject.Visibility


def test_ok_meshes_what_was_not_meshed(opened):
    press_ok()
    assert opened.State == layer_mesh.UP_TO_DATE and opened.FemMesh.QuadrangleCount > 0


def test_a_mesh_to_start_from_is_chosen_in_the_panel(opened):
    press_ok()
    coarse = opened.NodeCount
    start = advlayers.make_layer_mesh(opened.Part, size=opened.Size.Value / 3, walls=())
    edit(opened)
    child(QtGui.QGroupBox, "AdvLayersAdvanced").setChecked(True)
    meshes = child(QtGui.QComboBox, "LayerMesh_initial_mesh")
    # The mesh itself is not offered.
    assert [meshes.itemText(i) for i in range(meshes.count())] == ["none", start.Label]
    meshes.setCurrentIndex(1)
    events()
    assert opened.InitialMesh is start
    mesh_until_done(opened)
    press_ok()
    assert opened.State == layer_mesh.UP_TO_DATE and opened.NodeCount > 2 * coarse
    edit(opened)
    assert child(QtGui.QComboBox, "LayerMesh_initial_mesh").currentText() == start.Label
    press_cancel()


def test_every_setting_can_be_reached(opened):
    names = [entry.key for entry in MESH_SETTINGS if entry.group and entry.key != "faces"]
    for key in names:
        assert child(QtGui.QWidget, f"LayerMesh_{key}").toolTip()
    advanced = child(QtGui.QGroupBox, "AdvLayersAdvanced")
    assert not child(QtGui.QWidget, "LayerMesh_threads").isVisible()
    advanced.setChecked(True)
    events()
    assert child(QtGui.QWidget, "LayerMesh_threads").isVisible()
    child(QtGui.QSpinBox, "LayerMesh_threads").setValue(1)
    child(QtGui.QComboBox, "LayersEnd").setCurrentIndex(2)
    child(QtGui.QSpinBox, "LayersNumber").setValue(2)
    child(QtGui.QWidget, "LayerMesh_size").setProperty("rawValue", 4.0)
    points = child(QtGui.QPlainTextEdit, "LayerMesh_refinements")
    points.setPlainText("1 2 3")
    click("AdvLayersMeshButton")
    assert "x y z size radius" in status()
    points.setPlainText("30 20 10 1.5 2")
    mesh_until_done(opened)
    press_ok()
    assert opened.Refinements == ["30 20 10 1.5 2"]
    assert (opened.Threads, opened.Layers, opened.Size.Value) == (1, "2", 4.0)
    assert max(opened.ElementLayers) == 2


def test_a_first_height_may_come_from_a_flow(opened):
    flow = child(QtGui.QGroupBox, "AdvLayersFlow")
    flow.setChecked(True)
    events()
    child(QtGui.QDoubleSpinBox, "AdvLayersFlow_speed").setValue(50.0)
    child(QtGui.QWidget, "AdvLayersFlow_length").setProperty("rawValue", 500.0)
    child(QtGui.QComboBox, "AdvLayersFlow_fluid").setCurrentIndex(1)
    asked = advlayers.y_plus(speed=50.0, length=500.0, fluid="water")
    said = child(QtGui.QLabel, "AdvLayersFlowSaid")
    flow.setChecked(False)
    flow.setChecked(True)  # says it anew
    assert f"{asked.first_height:.4g} mm" in said.text()
    child(QtGui.QCheckBox, "AdvLayersFlow_density_given").setChecked(True)
    assert "viscosity" in said.text()
    assert not child(QtGui.QPushButton, "AdvLayersFlowUse").isEnabled()
    child(QtGui.QCheckBox, "AdvLayersFlow_density_given").setChecked(False)
    click("AdvLayersFlowUse")
    assert opened.FirstHeight.Value == pytest.approx(asked.first_height)
    press_cancel()


def test_a_preset_is_chosen_by_one_word(opened):
    presets = child(QtGui.QComboBox, "AdvLayersPreset")
    assert presets.toolTip()
    presets.activated.emit(2)  # fem
    assert not opened.GrowFromAll and opened.CurvatureAngle.Value == 10.0
    assert not child(QtGui.QCheckBox, "AdvLayers_GrowFromAll").isChecked()
    presets.activated.emit(1)  # cfd
    assert opened.GrowFromAll and opened.Layers == "isotropic"
    assert child(QtGui.QComboBox, "LayersEnd").currentIndex() == 1
    presets.activated.emit(3)  # washers, on a box without holes
    assert "holes" in status() and opened.GrowFromAll
    press_cancel()


def test_a_mesh_may_update_itself(opened, box):
    automatic = child(QtGui.QCheckBox, "AdvLayers_AutoUpdate")
    assert automatic.toolTip() and not automatic.isChecked()
    automatic.setChecked(True)
    press_ok()
    assert opened.AutoUpdate and opened.State == layer_mesh.UP_TO_DATE
    quads = opened.QuadCount
    box.Length = 60
    box.Document.recompute()
    wait_for(lambda: opened.State == layer_mesh.UP_TO_DATE)
    assert opened.QuadCount > quads


def test_an_expression_rules_a_field(opened, box):
    opened.setExpression("Size", "Box.Length / 10")
    box.Document.recompute()
    child(QtGui.QWidget, "LayerMesh_size").setProperty("rawValue", 7.0)
    press_ok()
    assert opened.Size.Value == pytest.approx(3.0)
    assert dict(opened.ExpressionEngine)["Size"]


def test_layers_are_drawn_as_they_grow(opened):
    child(QtGui.QWidget, "LayerMesh_size").setProperty("rawValue", 1.0)
    child(QtGui.QWidget, "LayerMesh_first_height").setProperty("rawValue", 0.1)
    panel = panel_of(opened)
    shown, texts = [], set()

    def watch():
        if panel.meshing and not panel.scene.busy:
            if panel.scene.layer_element_count > (shown[-1] if shown else 0):
                shown.append(panel.scene.layer_element_count)
                if len(shown) == 3:
                    screenshot("growing.png", settle=0.0)
        texts.add(status())
        return not panel.meshing

    click("AdvLayersMeshButton")
    assert child(QtGui.QPushButton, "AdvLayersMeshButton").text() == "Stop"
    wait_for(watch)
    assert len(shown) >= 3
    assert any("layer" in text and "elements" in text and "% quads" in text for text in texts)
    wait_for(lambda: not panel.scene.busy)
    press_ok()
    assert shown[-1] <= opened.FemMesh.FaceCount


def make_fine():
    for name, value in (("size", FINE["size"]), ("first_height", FINE["first_height"])):
        child(QtGui.QWidget, f"LayerMesh_{name}").setProperty("rawValue", value)


def seconds_of_stop(panel, run_for):
    """Meshes for a while; the clock's time from the click on Stop to the end of the run."""
    click("AdvLayersMeshButton")
    events(run_for)
    assert panel.meshing
    start = time.monotonic()
    child(QtGui.QPushButton, "AdvLayersMeshButton").click()
    wait_for(lambda: not panel.meshing)
    seconds = time.monotonic() - start
    assert "Stopped" in status()
    assert child(QtGui.QPushButton, "AdvLayersMeshButton").text() == "Mesh"
    return seconds


@pytest.mark.parametrize("run_for", (0.1, 0.5, 1.5))
def test_stop_takes_effect_at_once(opened, run_for):
    """The best of some tries counts: the clock also shows what else the machine is doing."""
    make_fine()
    panel = panel_of(opened)
    took = []
    while len(took) < 5 and min(took, default=1.0) >= 0.1:
        took.append(seconds_of_stop(panel, run_for))
    assert min(took) < 0.1, took
    press_cancel()


def test_stop_does_not_wait_for_a_picture(opened, monkeypatch):
    """A run waits for its first layers to be drawn. Here they never are."""
    from advlayers_gui import mesh_panel, mesh_task

    monkeypatch.setattr(mesh_task, "_PATIENCE", 3600.0)
    monkeypatch.setattr(mesh_panel._Canvas, "busy", True)
    make_fine()
    panel = panel_of(opened)
    click("AdvLayersMeshButton")
    wait_for(lambda: "layer 1" in status())
    events(0.2)
    click("AdvLayersMeshButton")
    wait_for(lambda: not panel.meshing, 60.0)
    assert "Stopped" in status()
    press_cancel()


def test_cancel_takes_the_new_object_away(opened, box):
    mesh_until_done(opened)
    press_cancel()
    assert [entry.Name for entry in box.Document.Objects] == ["Box"]
    assert box.ViewObject.Visibility


def test_cancel_of_a_later_edit_restores_everything(box):
    made = advlayers.make_layer_mesh(box, size=5.0, walls=[{"edges": ["Edge1"]}])
    events()
    before, nodes = state_of(box.Document), made.FemMesh.Nodes
    edit(made)
    child(QtGui.QWidget, "LayerMesh_size").setProperty("rawValue", 2.5)
    child(QtGui.QTabWidget, "AdvLayersTabs").setCurrentIndex(1)
    select((box, "Edge2"))
    click("AdvLayersAddWall")
    click("AdvLayersAddSize")
    child(QtGui.QTableWidget, "AdvLayersConditions").selectRow(0)
    click("AdvLayersRemoveControl")
    mesh_until_done(made)
    press_cancel()
    assert state_of(box.Document) ^ before == set()
    assert made.FemMesh.Nodes == nodes
    assert made.State == layer_mesh.UP_TO_DATE


def test_cancel_after_work_in_another_document(box):
    made = advlayers.make_layer_mesh(box, size=5.0)
    events()
    before = state_of(box.Document)
    edit(made)
    made.Size = 3.0
    other = FreeCAD.newDocument("Other")
    other.openTransaction("elsewhere")
    other.addObject("Part::Box", "There")
    other.commitTransaction()
    press_cancel()
    assert state_of(box.Document) ^ before == set()
    assert [entry.Name for entry in other.Objects] == ["There"]
    FreeCAD.closeDocument("Other")


def test_cancel_while_meshing_closes_at_once(box):
    made = advlayers.make_layer_mesh(box, size=5.0)
    events()
    before, nodes = state_of(box.Document), made.FemMesh.Nodes
    took = []
    while len(took) < 5 and min(took, default=1.0) >= 0.5:
        edit(made)
        make_fine()
        click("AdvLayersMeshButton")
        events(0.3)
        assert panel_of(made).meshing
        start = time.monotonic()
        press_cancel()
        took.append(time.monotonic() - start)
        events(0.3)
        assert state_of(box.Document) ^ before == set()
        assert made.FemMesh.Nodes == nodes
    assert min(took) < 0.5, took


def test_a_macro_closes_the_panel_while_meshing(opened, capsys):
    panel = panel_of(opened)
    make_fine()
    click("AdvLayersMeshButton")
    events(0.2)
    assert panel.meshing
    FreeCADGui.Control.closeDialog()
    events(0.2)
    assert not panel.meshing
    FreeCADGui.getDocument(opened.Document.Name).resetEdit()
    select((opened.Part, ""))  # the panel's gate would refuse it
    assert FreeCADGui.Selection.getSelection() == [opened.Part]
    assert "Traceback" not in capsys.readouterr().err


def test_closing_the_document_while_meshing(opened):
    document, panel = opened.Document, panel_of(opened)
    child(QtGui.QWidget, "LayerMesh_size").setProperty("rawValue", FINE["size"])
    click("AdvLayersMeshButton")
    events(0.3)
    assert panel.meshing
    FreeCAD.closeDocument(document.Name)
    events(0.3)
    assert not panel.meshing
    assert not FreeCADGui.Control.activeDialog()


def test_deleting_the_object_while_meshing(opened, box):
    panel = panel_of(opened)
    child(QtGui.QWidget, "LayerMesh_size").setProperty("rawValue", FINE["size"])
    click("AdvLayersMeshButton")
    events(0.2)
    box.Document.removeObject(opened.Name)
    events(0.3)
    assert not panel.meshing
    assert not FreeCADGui.Control.activeDialog()


def test_two_documents_at_once(opened, box):
    """One is meshed while a user works in the other; each keeps what is its own."""
    panel = panel_of(opened)
    child(QtGui.QWidget, "LayerMesh_size").setProperty("rawValue", 0.6)
    click("AdvLayersMeshButton")
    other = FreeCAD.newDocument("Other")
    there = other.addObject("Part::Cylinder", "Cylinder")
    other.recompute()
    meshed = advlayers.make_layer_mesh(there, size=1.0)
    assert FreeCAD.ActiveDocument is other
    wait_for(lambda: not panel.meshing and not panel.scene.busy)
    press_ok()
    assert opened.State == layer_mesh.UP_TO_DATE and meshed.State == layer_mesh.UP_TO_DATE
    assert opened.FemMesh.QuadrangleCount == opened.QuadCount
    assert meshed.FemMesh.QuadrangleCount == meshed.QuadCount
    assert len(other.Objects) == 2 and len(box.Document.Objects) == 2
    FreeCAD.closeDocument("Other")
    assert opened.FemMesh.QuadrangleCount == opened.QuadCount


def test_every_error_shows_in_the_panel(opened, box, monkeypatch):
    from advlayers import core_access
    from advlayers.errors import CoreMissing
    from advlayers_gui import mesh_task

    opened.Growth = 0.5
    click("AdvLayersMeshButton")  # the field brings growth back into its range
    wait_for(lambda: not panel_of(opened).meshing)
    opened.Faces = ["Face99"]
    click("AdvLayersMeshButton")
    assert "Face99" in status()
    opened.Faces = []
    child(QtGui.QWidget, "LayerMesh_first_height").setProperty("rawValue", 0.0)
    click("AdvLayersMeshButton")
    assert "First height must be > 0 mm" in status()
    child(QtGui.QWidget, "LayerMesh_first_height").setProperty("rawValue", 0.5)
    part, opened.Part = opened.Part, None
    click("AdvLayersMeshButton")
    assert "nothing to mesh" in status()
    opened.Part = part

    def missing():
        raise CoreMissing('the meshing core is not built: run "./dev build"')

    monkeypatch.setattr(mesh_task, "load_core", missing)
    click("AdvLayersMeshButton")
    assert "./dev build" in status()
    monkeypatch.setattr(mesh_task, "load_core", core_access.load_core)

    class Broken:
        def __getattr__(self, name):
            raise RuntimeError("the shape is broken")

    monkeypatch.setattr(mesh_task, "load_core", Broken)
    click("AdvLayersMeshButton")
    wait_for(lambda: not panel_of(opened).meshing)
    assert "the shape is broken" in status()
    assert FreeCADGui.Control.activeDialog()
    press_cancel()
    assert [entry.Name for entry in box.Document.Objects] == ["Box"]


def test_nothing_to_edit_says_so(box):
    made = advlayers.make_layer_mesh(box, mesh_now=False)
    wall = advlayers.make_wall(made, ["Edge1"])
    made.Part = None
    for thing, words in ((made, "nothing to mesh"), (wall, "no layer mesh")):
        seen = []
        answer_message(seen)
        thing.ViewObject.Proxy.doubleClicked(thing.ViewObject)
        events()
        assert len(seen) == 1 and words in seen[0]
        assert not FreeCADGui.Control.activeDialog()


def test_one_panel_at_a_time(opened, box):
    panel = panel_of(opened)
    opened.ViewObject.Proxy.doubleClicked(opened.ViewObject)
    events()
    assert panel_of(opened) is panel
    press_cancel()

"""What a new user meets: the shape in view, colours that say what edges are, help at hand, forms
that take what is typed."""
import advlayers
import FreeCAD
import FreeCADGui
import Part
import pytest
from PySide import QtCore, QtGui

from window import (
    child, click, edit, events, panel_of, press_cancel, press_ok, run, screenshot, select, status,
    wait_for)


@pytest.fixture
def plate(document):
    """With four holes of two diameters."""
    made = document.addObject("Part::Feature", "Plate")
    shape = Part.makeBox(60, 40, 3)
    for x, y, radius in ((15, 10, 3), (15, 30, 3), (45, 10, 5), (45, 30, 5)):
        shape = shape.cut(Part.makeCylinder(radius, 3, FreeCAD.Vector(x, y, 0)))
    made.Shape = shape
    document.recompute()
    return made


@pytest.fixture
def mesh(plate):
    made = advlayers.make_layer_mesh(plate, mesh_now=False, size=4, first_height=0.5)
    events()
    return made


def type_into(widget, text):
    line = widget.findChild(QtGui.QLineEdit)
    line.selectAll()
    for sign in text:
        QtGui.QApplication.sendEvent(line, QtGui.QKeyEvent(
            QtCore.QEvent.KeyPress, 0, QtCore.Qt.NoModifier, sign))


def test_the_panel_brings_the_shape_into_view(mesh):
    from advlayers_gui import view_3d

    view = FreeCADGui.ActiveDocument.ActiveView
    camera = view.getCameraNode()
    camera.position = (1e4, 1e4, 1e4)
    edit(mesh)
    corners = [tuple(mesh.Part.Shape.BoundBox.getPoint(k)) for k in range(8)]
    assert abs(view_3d._in_view(view.getCameraNode(), corners)).max() < 1.5
    height = view.getCameraNode().height.getValue()
    press_cancel()
    edit(mesh)  # it is in view: nothing moves
    assert view.getCameraNode().height.getValue() == height
    press_cancel()


def test_edges_show_what_they_are(mesh):
    sharp = len(mesh.Part.Shape.Edges) - 4  # the seams of the holes
    edit(mesh)
    preview = panel_of(mesh).preview
    wait_for(lambda: preview.conditions.shown and not preview.busy)
    shown = preview.conditions.shown
    assert shown["wall"] == sharp and shown["arrow"] > sharp
    child(QtGui.QTabWidget, "AdvLayersTabs").setCurrentIndex(1)
    assert child(QtGui.QLabel, "AdvLayersNoConditions").isVisible()
    menu = panel_of(mesh)._pick_bar._menu
    menu.fill()
    child(QtGui.QAction, "AdvLayersPick_Holes").trigger()
    events()
    click("AdvLayersAddWall")
    click("AdvLayersAddGroup")
    assert not child(QtGui.QLabel, "AdvLayersNoConditions").isVisible()
    wait_for(lambda: not preview.busy)
    shown = preview.conditions.shown
    assert shown["wall"] == 8 and shown["group"] == 8 and shown["off"] == sharp - 8
    menu.fill()
    child(QtGui.QAction, "AdvLayersPick_Hole1").trigger()  # the larger diameter
    events()
    names = FreeCADGui.Selection.getSelectionEx()[0].SubElementNames
    assert sorted(mesh.Part.Shape.getElement(name).Curve.Radius for name in names) == [5.0] * 4
    child(QtGui.QAction, "AdvLayersPick_SimilarLength").trigger()
    assert sorted(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames) == sorted(names)
    click("AdvLayersSeeThrough")
    assert mesh.Part.ViewObject.Transparency == 70
    screenshot("conditions.png")
    press_cancel()
    assert mesh.Part.ViewObject.Transparency == 0


def test_a_wall_in_the_tree_lights_up(mesh):
    from advlayers_gui import tree_light

    wall = advlayers.make_wall(mesh, ["Edge1", "Edge2"])
    select((wall, ""))
    assert len(tree_light._kept[0].lines) == 2
    select()
    assert tree_light._kept[0].lines == []


def test_selected_edges_are_the_walls_of_a_new_mesh(plate):
    select((plate, "Edge1"), (plate, "Face3"))
    run("LayerMesh")
    made = plate.Document.getObject("LayerMesh")
    assert made.Faces == ["Face3"]
    assert made.WallList[0].References == [(plate, ("Edge1",))]
    press_cancel()


def test_help_is_at_hand(mesh):
    run("Help")
    window = child(QtGui.QDialog, "AdvLayersHelp")
    text = window.findChild(QtGui.QTextBrowser)
    assert window.isVisible() and "Tutorial" in text.toPlainText()
    pages = window.findChild(QtGui.QListWidget)
    for row in range(pages.count()):
        pages.setCurrentRow(row)
        assert len(text.toPlainText()) > 500, pages.item(row).text()
    screenshot("help.png")
    window.close()
    edit(mesh)
    field = child(QtGui.QWidget, "LayerMesh_growth")
    assert "Growth" in field.whatsThis() and field.accessibleName() == "Growth"
    field.setFocus()
    QtGui.QApplication.sendEvent(field, QtGui.QKeyEvent(
        QtCore.QEvent.KeyPress, QtCore.Qt.Key_F1, QtCore.Qt.NoModifier))
    QtGui.QWhatsThis.hideText()
    press_cancel()


def test_comma_and_point_are_both_understood(mesh):
    edit(mesh)
    first, growth = (child(QtGui.QWidget, f"LayerMesh_{key}") for key in ("first_height", "growth"))
    for typed in ("0,25 mm", "0.25 mm"):
        type_into(first, typed)
        first.editingFinished.emit()
        assert mesh.FirstHeight.Value == pytest.approx(0.25)
        first.setProperty("rawValue", 0.5)
        first.editingFinished.emit()
    for typed in ("1,3", "1.3"):
        growth.setValue(1.1)
        type_into(growth, typed)
        growth.interpretText()
        assert growth.value() == pytest.approx(1.3)
    press_cancel()


def test_a_contradiction_is_told_while_it_is_typed(mesh):
    edit(mesh)
    type_into(child(QtGui.QWidget, "LayerMesh_first_height"), "9 mm")
    assert "9 mm is above the size 4 mm" in status() and mesh.FirstHeight.Value == 0.5
    press_cancel()


def test_heights_have_digits_in_every_system_of_units(mesh):
    mesh.FirstHeight = 0.1
    FreeCAD.Units.setSchema(3)  # inches
    try:
        edit(mesh)
        line = child(QtGui.QWidget, "LayerMesh_first_height").findChild(QtGui.QLineEdit)
        assert line.text().startswith("0.00393")
        wait_for(lambda: "0.00394 in" in status())
        press_cancel()
    finally:
        FreeCAD.Units.setSchema(0)
    assert mesh.FirstHeight.Value == pytest.approx(0.1)


def test_a_wall_shows_what_it_has_from_the_mesh(mesh):
    wall = advlayers.make_wall(mesh, ["Edge1"])
    edit(wall)
    height = child(QtGui.QWidget, "Wall_first_height")
    assert not height.isEnabled()
    assert height.findChild(QtGui.QLineEdit).text() == "0.5 mm"
    end = child(QtGui.QWidget, "Wall_end_height")
    assert "transparent" in end.styleSheet() and not height.styleSheet()
    child(QtGui.QCheckBox, "Wall_first_height_given").setChecked(True)
    assert height.isEnabled() and wall.FirstHeight.Value == 0.5
    press_ok()


def test_long_names_leave_the_panel_as_wide_as_it_is(mesh):
    mesh.Part.Label = "A plate with four holes and a name that goes on and on, revision 17, final"
    edit(mesh)
    form = panel_of(mesh).form
    assert form.visibleRegion().boundingRect().width() == form.width()
    press_cancel()

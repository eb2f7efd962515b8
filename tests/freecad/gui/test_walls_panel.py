"""Picking faces and edges, the table of conditions, and the panels of walls, sizes and groups."""
import advlayers
import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from window import (
    child, choose, click, edit, events, mesh_until_done, panel_of, press_cancel, press_ok,
    screenshot, select, status, wait_for)


@pytest.fixture
def mesh(box):
    """A layer mesh of the box, with its panel open."""
    made = advlayers.make_layer_mesh(box, mesh_now=False, size=3.0, first_height=0.4, layers=3)
    box.Document.clearUndos()
    edit(made)
    return made


def table():
    return child(QtGui.QTableWidget, "AdvLayersConditions")


def selected_names():
    return [name for entry in FreeCADGui.Selection.getSelectionEx()
            for name in entry.SubElementNames]


def test_only_what_the_panel_can_use_can_be_picked(mesh, box):
    other = box.Document.addObject("Part::Cylinder", "Other")
    box.Document.recompute()
    select((other, "Face1"))
    assert selected_names() == []
    assert "Other is no part of Box" in status()
    select((box, ""))
    assert selected_names() == []
    assert "pick a face, an edge or a vertex" in status()
    select((box, "Edge1"), (box, "Face2"), (box, "Vertex3"))
    assert selected_names() == ["Edge1", "Face2", "Vertex3"]
    assert "Edge1, Face2, Vertex3" in child(QtGui.QLabel, "AdvLayersSelected").text()
    press_ok()
    select((other, "Face1"))  # the gate is gone with the panel
    assert selected_names() == ["Face1"]
    wall = advlayers.make_wall(mesh, ["Edge1"])
    edit(wall)
    select((box, "Vertex1"))
    assert selected_names() == []
    assert "pick a face or an edge" in status()
    press_cancel()


def test_a_size_about_a_vertex(mesh, box):
    child(QtGui.QTabWidget, "AdvLayersTabs").setCurrentIndex(1)
    select((box, "Vertex3"))
    click("AdvLayersAddWall")
    assert "a Wall cannot hold Vertex3" in status() and mesh.WallList == []
    click("AdvLayersAddSize")
    assert "surroundings of Vertex3" in status()
    child(QtGui.QCheckBox, "Size_size_given").setChecked(True)
    child(QtGui.QWidget, "Size_size").setProperty("rawValue", 0.5)
    child(QtGui.QCheckBox, "Size_radius_given").setChecked(True)
    child(QtGui.QWidget, "Size_radius").setProperty("rawValue", 4.0)
    mesh_until_done(mesh)
    press_ok()
    corner = box.Shape.Vertexes[2].Point
    near = [length for length, middle in edge_lengths(mesh.FemMesh)
            if (middle - corner).Length < 2.0]
    assert max(near) < 1.0


def edge_lengths(fem):
    """Of every side of the elements, and their middles."""
    nodes = fem.Nodes
    for element in fem.Faces:
        corners = [nodes[number] for number in fem.getElementNodes(element)]
        for one, other in zip(corners, corners[1:] + corners[:1]):
            yield (other - one).Length, (one + other) * 0.5


def test_what_belongs_to_the_selection(mesh, box):
    click("AdvLayersPickLoop")
    assert "select an edge first" in status()
    select((box, "Face1"))
    click("AdvLayersPickFaceEdges")
    around = selected_names()
    assert len(around) == 4 and all(name.startswith("Edge") for name in around)
    select((box, around[0]), (box, "Face1"))
    click("AdvLayersPickLoop")
    assert sorted(selected_names()) == sorted(around)
    select((box, "Edge1"))
    click("AdvLayersPickTangent")
    assert selected_names() == ["Edge1"]


def test_the_list_of_faces(mesh, box):
    click("AdvLayers_faces_add")
    assert "select in the 3D view first" in status()
    select((box, "Face2"), (box, "Face5"), (box, "Edge1"))
    click("AdvLayers_faces_add")
    assert mesh.Faces == ["Face2", "Face5"]
    click("AdvLayers_faces_add")
    assert "on the list already" in status() and mesh.Faces == ["Face2", "Face5"]
    names = child(QtGui.QListWidget, "AdvLayers_faces_list")
    names.setCurrentRow(1)
    names.itemClicked.emit(names.item(1))
    assert selected_names() == ["Face5"]
    click("AdvLayers_faces_remove")
    assert mesh.Faces == ["Face2"]


def test_conditions_in_the_table(mesh, box):
    child(QtGui.QTabWidget, "AdvLayersTabs").setCurrentIndex(1)
    click("AdvLayersAddWall")
    assert "select faces or edges" in status() and mesh.WallList == []
    select((box, "Edge1"), (box, "Edge2"))
    click("AdvLayersAddWall")
    select((box, "Edge5"))
    choose("AdvLayersAddOff")
    select((box, "Face6"))
    click("AdvLayersAddGroup")
    assert table().rowCount() == 3
    assert [wall.Condition for wall in mesh.WallList] == ["Wall", "Off"]
    table().cellWidget(1, 0).setCurrentIndex(1)
    assert (mesh.WallList[1].Condition, mesh.WallList[1].Label) == ("Match", "Match")
    select((box, "Edge7"))
    choose("AdvLayersAddBoundary")
    assert mesh.WallList[2].Condition == "Boundary"
    click("AdvLayersRemoveControl")
    table().item(2, 1).setText("inlet")
    assert mesh.GroupList[0].Label == "inlet"
    table().selectRow(0)
    events()
    child(QtGui.QCheckBox, "Wall_first_height_given").setChecked(True)
    child(QtGui.QWidget, "Wall_first_height").setProperty("rawValue", 0.3)
    child(QtGui.QCheckBox, "Wall_layers_given").setChecked(True)
    child(QtGui.QSpinBox, "Wall_layers").setValue(4)
    assert "Layers 4" in table().item(0, 3).text()
    table().itemClicked.emit(table().item(0, 2))
    assert selected_names() == ["Edge1", "Edge2"]
    screenshot("walls.png")
    mesh_until_done(mesh)
    screenshot("walls-meshed.png")
    press_ok()
    assert mesh.WallList[0].FirstHeight.Value == pytest.approx(0.3)
    groups = [mesh.FemMesh.getGroupName(number) for number in mesh.FemMesh.Groups]
    assert "inlet" in groups and max(mesh.ElementLayers) == 4


def test_a_removed_row_removes_the_wall(mesh, box):
    child(QtGui.QTabWidget, "AdvLayersTabs").setCurrentIndex(1)
    select((box, "Edge1"))
    click("AdvLayersAddWall")
    assert len(mesh.WallList) == 1
    click("AdvLayersRemoveControl")
    assert mesh.WallList == [] and table().rowCount() == 0
    press_ok()
    assert not [entry for entry in box.Document.Objects if entry.Name.startswith("Wall")]


def test_the_table_and_the_fields_below_it_agree(mesh, box):
    child(QtGui.QTabWidget, "AdvLayersTabs").setCurrentIndex(1)
    for edge in ("Edge1", "Edge5"):
        select((box, edge))
        click("AdvLayersAddWall")
    first, second = mesh.WallList
    table().selectRow(0)
    table().cellWidget(0, 0).setCurrentIndex(2)
    assert first.Condition == "Off"
    assert child(QtGui.QComboBox, "AdvLayers_condition").currentIndex() == 2
    table().item(0, 1).setText("slip")
    assert child(QtGui.QLineEdit, "AdvLayers_control_name").text() == "slip"
    child(QtGui.QComboBox, "AdvLayers_condition").setCurrentIndex(1)
    assert table().cellWidget(0, 0).currentIndex() == 1
    click("AdvLayersRemoveControl")
    assert mesh.WallList == [second] and table().selectedRanges() == []
    assert table().cellWidget(0, 0).currentIndex() == 0
    table().selectRow(0)
    events()
    assert child(QtGui.QLineEdit, "AdvLayers_control_name").text() == second.Label
    press_cancel()


def test_heights_are_shown_before_meshing(mesh, box):
    heights = panel_of(mesh).preview.heights
    child(QtGui.QTabWidget, "AdvLayersTabs").setCurrentIndex(1)
    wait_for(lambda: heights.lines)
    assert len(heights.lines) == 24  # 12 edges on 2 faces each
    select((box, "Edge1"))
    click("AdvLayersAddWall")
    wait_for(lambda: heights.lines and len(heights.lines) != 24)
    assert {line.edge for line in heights.lines} == {"Edge1"} and len(heights.lines) == 2
    select((box, "Edge1"), (box, "Face1"))
    press_cancel()
    assert heights.lines == []


def test_the_panel_of_a_wall(box):
    made = advlayers.make_layer_mesh(box, size=3.0)
    wall = advlayers.make_wall(made, ["Edge1"], first_height=0.2)
    box.Document.recompute()
    edit(wall)
    select((box, "Edge3"))
    click("AdvLayers_wall_add")
    child(QtGui.QComboBox, "AdvLayers_condition").setCurrentIndex(2)
    screenshot("wall-panel.png")
    press_cancel()
    assert wall.References == [(box, ("Edge1",))] and wall.Condition == "Wall"
    assert made.ViewObject.Visibility
    edit(wall)
    child(QtGui.QCheckBox, "Wall_growth_given").setChecked(True)
    child(QtGui.QDoubleSpinBox, "Wall_growth").setValue(1.3)
    press_ok()
    assert wall.Growth == pytest.approx(1.3) and made.State == "Out of date"
    assert FreeCAD.ActiveDocument.UndoNames

"""The commands of the workbench, run as a user runs them: select, press, see what came of it."""
import os

import advlayers
import FreeCAD
import FreeCADGui
import ObjectsFem
import pytest
from PySide import QtCore, QtGui

from advlayers import layer_mesh
from advlayers.export import FORMATS
from advlayers_gui import commands, mesh_commands
from advlayers_gui.colour_commands import ColourBy
from window import (
    answer_message, child, close_panel, errors_since, events, panel_of, press_cancel, press_ok,
    report_text, run, screenshot, select, wait_for)


@pytest.fixture
def mesh(box):
    made = advlayers.make_layer_mesh(box, size=5, first_height=0.5, layers=2)
    box.Document.clearUndos()
    events()
    return made


def test_every_command_is_announced():
    FreeCADGui.activateWorkbench("AdvancingLayersWorkbench")
    names = [name for name in commands.register() if name != "Separator"]
    assert set(names) <= set(FreeCADGui.listCommands())
    keys = []
    for kind in (*filter(None, commands.COMMANDS), *ColourBy.MEMBERS):
        announced = kind().GetResources()
        assert os.path.isfile(announced["Pixmap"]), announced["Pixmap"]
        assert not FreeCADGui.getIcon(announced["Pixmap"]).pixmap(32, 32).isNull()
        assert announced["MenuText"] and len(announced["ToolTip"]) > 20
        keys += [announced["Accel"]] if announced.get("Accel") else []
    assert len(keys) == len(set(keys)) >= 6
    toolbar = FreeCADGui.getMainWindow().findChild(QtGui.QToolBar, "Advancing Layers")
    assert len([action for action in toolbar.actions() if not action.isSeparator()]) == len(names)


def test_wall_size_and_group_of_what_is_selected(box, mesh):
    for name, kept in (("Wall", "WallList"), ("Size", "SizeList"), ("Group", "GroupList")):
        select((box, "Edge1"), (box, "Face3"))
        run(name)
        close_panel()
        (made,) = getattr(mesh, kept)
        assert made.References == [(box, ("Edge1", "Face3"))]
        assert made.ViewObject.isVisible()  # else it is grey in the tree
    assert mesh.ViewObject.Proxy.claimChildren() == (
        mesh.WallList + mesh.SizeList + mesh.GroupList)
    screenshot("children.png")


def test_wall_says_what_is_missing(box, mesh):
    select()
    seen = []
    answer_message(seen)
    run("Wall")
    assert len(seen) == 1 and "faces or edges" in seen[0]
    assert mesh.WallList == []


def test_update_and_undo(box, mesh):
    quads, nodes = mesh.QuadCount, mesh.FemMesh.Nodes
    box.Length = 60
    box.Document.recompute()
    assert mesh.State == layer_mesh.OUT_OF_DATE
    select((mesh, ""))
    run("Update")
    assert mesh.State == layer_mesh.UP_TO_DATE and mesh.QuadCount > quads
    updated = mesh.FemMesh.Nodes
    FreeCADGui.runCommand("Std_Undo")
    events()
    assert mesh.FemMesh.Nodes == nodes and mesh.QuadCount == quads
    FreeCADGui.runCommand("Std_Redo")
    events()
    assert mesh.FemMesh.Nodes == updated


def test_closing_the_document_ends_an_update(box, mesh):
    """As quitting does: the run is not waited for."""
    start, document = len(report_text()), box.Document.Name
    mesh.Size = 0.2
    QtCore.QTimer.singleShot(20, lambda: FreeCAD.closeDocument(document))
    run("Update")
    assert document not in FreeCAD.listDocuments()
    assert errors_since(start) == []


def test_a_stopped_update_leaves_everything(box, mesh, monkeypatch):
    nodes = mesh.FemMesh.Nodes
    mesh.Size = 0.2
    select((mesh, ""))

    def stop():
        for window in FreeCADGui.getMainWindow().findChildren(QtGui.QProgressDialog):
            if window.isVisible():
                window.cancel()
                return
        QtCore.QTimer.singleShot(20, stop)

    QtCore.QTimer.singleShot(20, stop)
    run("Update")
    assert mesh.FemMesh.Nodes == nodes
    assert mesh.QuadCount == mesh.FemMesh.QuadrangleCount


def test_a_failed_update_tells_why(mesh):
    mesh.Growth = 0.5
    select((mesh, ""))
    seen = []
    answer_message(seen)
    run("Update")
    assert len(seen) == 1 and "Growth must be" in seen[0]


def test_check_opens_the_results(mesh):
    mesh.Growth = 1.5
    mesh.Document.recompute()
    select((mesh, ""))
    run("Check")
    assert child(QtGui.QTabWidget, "AdvLayersTabs").currentIndex() == 2
    assert str(mesh.QuadCount) in child(QtGui.QLabel, "AdvLayersFigures").text()
    findings = child(QtGui.QTreeWidget, "AdvLayersFindings")
    assert "out of date" in findings.topLevelItem(0).text(0)
    remedy = child(QtGui.QPushButton, "AdvLayersRemedy")
    assert not remedy.isVisible()
    findings.setCurrentItem(findings.topLevelItem(0))
    assert remedy.isVisible()
    remedy.click()
    wait_for(lambda: not panel_of(mesh).meshing)
    assert not any("out of date" in findings.topLevelItem(k).text(0)
                   for k in range(findings.topLevelItemCount()))
    assert f"{mesh.QuadCount} quads" in report_text()
    press_cancel()


def test_a_mesh_takes_the_place_of_the_shape_once(box, mesh):
    assert mesh.ViewObject.Visibility and not box.ViewObject.Visibility
    box.ViewObject.Visibility = True
    mesh.Size = 6
    advlayers.update(mesh)
    assert box.ViewObject.Visibility


def test_the_toolbar_and_the_menu_offer_the_colours(box, mesh):
    FreeCADGui.activateWorkbench("AdvancingLayersWorkbench")
    other = advlayers.make_layer_mesh(box, size=8)
    box.Document.clearUndos()
    plain = mesh.ViewObject.DisplayMode
    mesh.ViewObject.Visibility, box.ViewObject.Visibility = False, True
    bar = FreeCADGui.getMainWindow().findChild(QtGui.QToolBar, "Advancing Layers")
    (button,) = [widget for widget in bar.findChildren(QtGui.QToolButton)
                 if widget.text() == ColourBy.MENU]
    offered = button.menu().actions()
    assert [action.text() for action in offered] == [kind.MENU for kind in ColourBy.MEMBERS]
    select((mesh, ""))
    for action, kind in zip(offered, ColourBy.MEMBERS):
        action.trigger()
        events()
        assert mesh.ViewObject.DisplayMode == kind.MODE
        assert mesh.ViewObject.Visibility and not box.ViewObject.Visibility
        assert other.ViewObject.DisplayMode == plain
    assert mesh.ViewObject.DisplayMode == plain
    select()
    run("ColourByQuality")
    assert mesh.ViewObject.DisplayMode == other.ViewObject.DisplayMode == ColourBy.MEMBERS[1].MODE
    select((mesh, ""))
    assert "AdvLayers_ColourBy" in commands.context_commands()
    box.Document.removeObject(box.Name)
    run("Uncoloured")
    assert mesh.ViewObject.DisplayMode == plain


def test_export_asks_for_a_file(mesh, tmp_path, monkeypatch):
    path = str(tmp_path / "mesh.vtu")
    monkeypatch.setattr(QtGui.QFileDialog, "getSaveFileName",
                        lambda *_arguments: (path, ""))
    select((mesh, ""))
    run("Export")
    assert os.path.getsize(path) > 1000
    titles = []
    monkeypatch.setattr(
        QtGui.QFileDialog, "getSaveFileName",
        lambda *arguments: titles.extend(arguments[3].split(";;")) or (
            path[:-4], next(title for title in titles if ".unv" in title)))
    run("Export")
    assert len(titles) == sum(not entry.only_cells for entry in FORMATS.values())
    assert os.path.getsize(path[:-4] + ".unv") > 1000


def test_lost_references_are_followed_and_accepted(box):
    """What FreeCAD 1.x does not follow itself is a list of faces."""
    document = box.Document
    drill = document.addObject("Part::Cylinder", "Drill")
    drill.Radius, drill.Height = 3, 100
    drill.Placement.Base = FreeCAD.Vector(10, 10, -50)
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = box, drill
    document.recompute()
    top = next(f"Face{i}" for i, face in enumerate(cut.Shape.Faces, 1)
               if face.CenterOfMass.z > 9.9)
    made = advlayers.make_layer_mesh(cut, size=5, faces=[top])
    select((made, ""))
    assert not FreeCADGui.isCommandActive("AdvLayers_FollowReferences")
    for command, quads_stay in (("FollowReferences", True), ("AcceptReferences", False)):
        drill.Placement.Base = FreeCAD.Vector(0, 0, -50)
        document.recompute()
        assert made.State == layer_mesh.LOST_REFERENCES
        seen = []
        answer_message(seen)
        run("Update")
        assert len(seen) == 1 and "Follow References" in seen[0]
        run(command)
        assert made.State == layer_mesh.OUT_OF_DATE
        assert (made.Faces != [top]) == quads_stay
        drill.Placement.Base = FreeCAD.Vector(10, 10, -50)
        document.recompute()
        made.Faces = [top]
        layer_mesh.accept_references(made)


def test_a_body_is_meshed_for_its_last_feature(box):
    document = box.Document
    body = document.addObject("PartDesign::Body", "Body")
    block = document.addObject("PartDesign::AdditiveBox", "Block")
    body.addObject(block)
    document.recompute()
    select((block, "Face3"))
    run("LayerMesh")
    close_panel()
    made = document.getObject("LayerMesh")
    assert made.Part is body and made.Faces == ["Face3"]


def test_triangles(mesh):
    select((mesh, ""))
    run("ToMesh")
    made = mesh.Document.ActiveObject
    assert made.Mesh.CountFacets == 2 * mesh.QuadCount + mesh.TriangleCount
    FreeCADGui.runCommand("Std_Undo")
    assert mesh.Document.getObject("LayerMesh_Triangles") is None


def test_a_volume(mesh):
    from advlayers.volume.programs import gmsh, python_with_netgen

    if gmsh() or python_with_netgen():
        analysis = ObjectsFem.makeAnalysis(mesh.Document, "Analysis")
        analysis.addObject(mesh)
        run("FillVolume")
        made = mesh.Document.ActiveObject
        assert made.FemMesh.TetraCount > 0
        assert made.ViewObject.Visibility and not mesh.ViewObject.Visibility
        assert made in analysis.Group and mesh not in analysis.Group
        assert FreeCADGui.Selection.getSelection() == [made]
    else:
        seen = []
        answer_message(seen)
        run("FillVolume")
        assert len(seen) == 1 and "Gmsh" in seen[0]


def test_a_gmsh_mesh_is_taken_over(box):
    document = box.Document
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    gmsh = ObjectsFem.makeMeshGmsh(document, "Gmsh")
    setattr(gmsh, "Part" if hasattr(gmsh, "Part") else "Shape", box)
    gmsh.CharacteristicLengthMax = 4
    analysis.addObject(gmsh)
    select((gmsh, ""))
    run("TakeOver")
    made = document.ActiveObject
    assert layer_mesh.is_layer_mesh(made) and made.Size.Value == 4
    assert made in analysis.Group and gmsh not in analysis.Group
    said = FreeCADGui.getMainWindow().statusBar().currentMessage()
    assert made.Label in said and analysis.Label in said
    press_ok()  # its panel is open: nothing is meshed yet
    assert made.FemMesh.NodeCount > 0 and made.ViewObject.Visibility


@pytest.fixture
def recorded():
    """The lines of ours that the console has shown since; a macro holds the same."""
    console = FreeCADGui.getMainWindow().findChild(QtGui.QPlainTextEdit, "Python console")
    if console is None:
        pytest.skip("this window has no console")
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Macro").SetBool("ScriptToPyConsole", True)
    console.clear()

    def lines():
        events(0.3)
        return [line.lstrip("> ") for line in console.toPlainText().splitlines()
                if "advlayers" in line or ".getObject(" in line]

    return lines


def replayed(lines, box, names):
    """The settings before and after the lines have run anew on the bare box."""
    before = [layer_mesh.settings_of(box.Document.getObject(name)) for name in names]
    nodes = [box.Document.getObject(name).FemMesh.NodeCount for name in names]
    for entry in list(box.Document.Objects):
        if entry is not box and entry.Name in [kept.Name for kept in box.Document.Objects]:
            box.Document.removeObject(entry.Name)
    exec("\n".join(lines), {"FreeCAD": FreeCAD})
    meshes = [box.Document.getObject(name) for name in names]
    assert [mesh.FemMesh.NodeCount for mesh in meshes] == nodes
    return before, [layer_mesh.settings_of(mesh) for mesh in meshes]


def test_commands_are_recorded(box, recorded):
    select((box, ""))
    run("LayerMesh")
    close_panel()
    select((box, "Edge1"))
    run("Wall")
    close_panel()
    select((box, "Face2"))
    run("Group")
    run("Update")
    lines = recorded()
    for call in ("make_layer_mesh", "make_wall", "make_group", "advlayers.update"):
        assert any(call in line for line in lines), call
    before, after = replayed(lines, box, ["LayerMesh"])
    assert before == after


def test_what_is_done_in_a_panel_is_recorded(box, recorded):
    from advlayers_gui.recording import Recording

    select((box, ""))
    run("LayerMesh")
    close_panel()
    mesh = box.Document.getObject("LayerMesh")
    wall = advlayers.make_wall(mesh, ["Edge1"])
    lines = recorded() + ["advlayers.make_wall(FreeCAD.ActiveDocument.LayerMesh, ['Edge1'])"]
    recording = Recording(mesh)
    mesh.Growth, mesh.Faces = 1.3, ["Face1", "Face2"]
    wall.FirstHeight, wall.Condition = 0.3, "Off"
    advlayers.make_wall(mesh, ["Edge2"], layers=3)
    gone = advlayers.make_size(mesh, ["Face1"], size=2)
    advlayers.make_group(mesh, "in let", ["Face1"])
    advlayers.remove(gone)
    advlayers.update(mesh)
    children = len(box.Document.Objects)
    recording.tell()
    assert len(box.Document.Objects) == children, "telling does nothing anew"
    before, after = replayed(lines + recorded()[len(lines) - 1:], box, ["LayerMesh"])
    assert before == after


def test_the_context_menu(box, mesh):
    select()
    assert commands.context_commands() == []
    select((mesh, ""))
    assert "AdvLayers_Update" in commands.context_commands()
    menu = QtGui.QMenu()
    mesh.ViewObject.Proxy.setupContextMenu(mesh.ViewObject, menu)
    (edit,) = menu.actions()
    edit.trigger()
    events()
    assert FreeCADGui.Control.activeDialog()
    press_cancel()


def test_export_filters_name_every_format():
    endings = {mesh_commands._shown(ending).lower() for ending in FORMATS}
    assert endings == set(FORMATS)


def test_the_tree_shows_what_is_out_of_date(box, mesh):
    provider = mesh.ViewObject.Proxy
    assert os.path.isfile(provider.getIcon()) and "Stale" not in provider.getIcon()
    fresh = mesh.ViewObject.Icon.pixmap(32, 32).toImage()
    box.Length = 60
    box.Document.recompute()
    events()
    assert os.path.isfile(provider.getIcon()) and "Stale" in provider.getIcon()
    assert mesh.ViewObject.Icon.pixmap(32, 32).toImage() != fresh
    events(0.5)  # the tree follows by a timer
    screenshot("out_of_date.png")
    select((mesh, ""))
    run("Update")
    assert "Stale" not in provider.getIcon()

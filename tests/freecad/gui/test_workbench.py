"""The workbench in a real window: it loads, says what is wrong, and takes over what was made
without one."""
import os
import subprocess

import FreeCAD
import FreeCADGui

from advlayers import core_access, layer_mesh
from advlayers.errors import CoreMissing
from window import (
    ROOT, answer_message, edit, press_cancel, press_ok, run, select)


def test_the_workbench_is_there():
    assert "AdvancingLayersWorkbench" in FreeCADGui.listWorkbenches()
    workbench = FreeCADGui.getWorkbench("AdvancingLayersWorkbench")
    assert os.path.isfile(workbench.Icon)
    FreeCADGui.activateWorkbench("AdvancingLayersWorkbench")
    assert FreeCADGui.activeWorkbench().name() == "AdvancingLayersWorkbench"
    assert "AdvLayers_LayerMesh" in FreeCADGui.listCommands()


def test_selected_faces_only(box):
    select((box, "Face2"), (box, "Face6"))
    run("LayerMesh")
    press_ok()
    made = box.Document.getObject("LayerMesh")
    assert made.Faces == ["Face2", "Face6"]
    names = [made.FemMesh.getGroupName(i) for i in made.FemMesh.Groups]
    assert "Face2" in names and "Face6" in names and "Face1" not in names


def test_nothing_selected_says_so(box):
    select()
    seen = []
    answer_message(seen)
    run("LayerMesh")
    assert len(seen) == 1 and "Select" in seen[0]
    assert [entry.Name for entry in box.Document.Objects] == ["Box"]


def test_several_shapes_selected_says_so(box):
    other = box.Document.addObject("Part::Sphere", "Ball")
    box.Document.recompute()
    select((box, "Face1"), (other, ""))
    seen = []
    answer_message(seen)
    run("LayerMesh")
    assert len(seen) == 1 and "Ball" in seen[0] and "compound" in seen[0]
    assert [entry.Name for entry in box.Document.Objects] == ["Box", "Ball"]


def test_a_missing_core_names_the_remedy(box, monkeypatch):
    def missing():
        raise CoreMissing('the meshing core is not built: run "./dev build"')

    monkeypatch.setattr(core_access, "load_core", missing)
    select((box, ""))
    seen = []
    answer_message(seen)
    run("LayerMesh")
    assert len(seen) == 1 and "./dev build" in seen[0]
    assert [entry.Name for entry in box.Document.Objects] == ["Box"]


def test_a_file_made_without_a_window_gets_its_view_provider(box, tmp_path):
    from advlayers_gui.view_provider import LayerMeshView

    box.Shape.exportStep(str(tmp_path / "box.step"))
    job = tmp_path / "job.json"
    job.write_text('{"input": "box.step", "size": 5.0, "outputs": ["box.FCStd"]}')
    batch = os.path.join(ROOT, "App", "advlayers_batch.py")
    done = subprocess.run(["freecadcmd", batch, str(job)], stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    document = FreeCAD.openDocument(str(tmp_path / "box.FCStd"))
    try:
        restored = document.getObject("LayerMesh")
        assert isinstance(restored.ViewObject.Proxy, LayerMeshView)
        assert restored.QuadCount == restored.FemMesh.QuadrangleCount > 0
        assert restored.State == layer_mesh.UP_TO_DATE
        edit(restored)
        press_cancel()
        assert restored.QuadCount == restored.FemMesh.QuadrangleCount > 0
    finally:
        FreeCAD.closeDocument(document.Name)
        FreeCAD.setActiveDocument(box.Document.Name)

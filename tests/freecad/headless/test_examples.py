"""The example macros run, and the documents beside them are what they make."""
import glob
import os
import runpy

import FreeCAD
import pytest
from advlayers import layer_mesh

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))), "Resources", "examples")
MACROS = sorted(glob.glob(os.path.join(FOLDER, "*.FCMacro")))


def test_there_are_five():
    assert len(MACROS) == 5


@pytest.mark.parametrize("path", MACROS, ids=os.path.basename)
def test_a_macro_and_its_document(path):
    before = set(FreeCAD.listDocuments())
    opened = None
    try:
        runpy.run_path(path, run_name="__main__")
        (name,) = set(FreeCAD.listDocuments()) - before
        mesh = FreeCAD.getDocument(name).getObject("LayerMesh")
        assert mesh.State == layer_mesh.UP_TO_DATE
        assert mesh.InvertedCount == 0 and mesh.QuadPercent > 95 and mesh.GoodAnglePercent > 95
        assert mesh.GroupList, "every example shows named groups"
        opened = FreeCAD.openDocument(path[:-len(".FCMacro")] + ".FCStd")
        kept = opened.getObject("LayerMesh")
        opened.recompute(None, True)
        assert kept.State == layer_mesh.UP_TO_DATE
        assert kept.QuadCount == kept.FemMesh.QuadrangleCount > 0
        assert layer_mesh.settings_of(kept) == layer_mesh.settings_of(mesh)
        assert (len(kept.WallList), len(kept.GroupList)) == (
            len(mesh.WallList), len(mesh.GroupList))
    finally:
        for name in set(FreeCAD.listDocuments()) - before:
            FreeCAD.closeDocument(name)

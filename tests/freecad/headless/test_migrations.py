"""Documents of earlier versions open with all that they held."""
import os

import advlayers
import FreeCAD
import pytest
from advlayers import layer_mesh, migrations

DATA = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__)))), "data")


@pytest.mark.parametrize("version", range(1, migrations.CURRENT + 1))
def test_a_document_of_each_schema(version):
    """Each holds a box and its mesh with walls, match and off edges and a group."""
    document = FreeCAD.openDocument(os.path.join(DATA, f"schema_{version}.FCStd"))
    try:
        mesh = document.getObject("LayerMesh")
        assert mesh.SchemaVersion == migrations.CURRENT
        settings = layer_mesh.settings_of(mesh)
        walls = [{key: value for key, value in wall.items() if value not in (None, ())}
                 for wall in settings["walls"]]
        assert walls == [{"edges": ("Edge1", "Edge2"), "first_height": 0.5},
                         {"edges": ("Edge5",), "faces": ("Face2",), "layers": 1}]
        assert (settings["match"], settings["off"]) == (("Edge3",), ("Edge4",))
        assert settings["groups"] == {"in let": ("Face1", "Edge1")}
        assert settings["size"] == 10 and settings["layers"] == 1
        document.recompute(None, True)
        assert mesh.State == layer_mesh.UP_TO_DATE
        assert mesh.QuadCount == mesh.FemMesh.QuadrangleCount > 0
        advlayers.update(mesh)
        assert not {"Walls", "MatchEdges", "OffEdges", "Groups"} & set(mesh.PropertiesList)
    finally:
        FreeCAD.closeDocument(document.Name)


def test_a_document_of_a_later_version_is_left_alone(tmp_path):
    document = FreeCAD.openDocument(os.path.join(DATA, f"schema_{migrations.CURRENT}.FCStd"))
    document.LayerMesh.SchemaVersion = migrations.CURRENT + 5
    path = str(tmp_path / "later.FCStd")
    document.saveCopy(path)
    FreeCAD.closeDocument(document.Name)
    later = FreeCAD.openDocument(path)
    try:
        assert later.LayerMesh.SchemaVersion == migrations.CURRENT + 5
        assert later.LayerMesh.FemMesh.NodeCount > 0
    finally:
        FreeCAD.closeDocument(later.Name)

"""Meshes of FreeCAD's own as the start of a layer mesh; these tests run inside freecadcmd."""
import advlayers
import Fem
import FreeCAD
import numpy as np
import ObjectsFem
import pytest
from advlayers import initial_mesh, layer_mesh
from advlayers.errors import InputError
from advlayers.volume.programs import gmsh

SETTINGS = {"size": 4, "first_height": 0.4, "layers": 1}


def gmsh_object(box, size, dimension="2D", order="1st"):
    """Meshed by FreeCAD's Gmsh, in an analysis."""
    from femmesh import gmshtools

    if not gmsh():
        pytest.skip("Gmsh is not installed")
    document = box.Document
    made = ObjectsFem.makeMeshGmsh(document, "FEMMeshGmsh")
    setattr(made, "Part" if hasattr(made, "Part") else "Shape", box)
    made.CharacteristicLengthMax = size
    made.ElementDimension, made.ElementOrder = dimension, order
    ObjectsFem.makeAnalysis(document, "Analysis").addObject(made)
    document.recompute()
    gmshtools.GmshTools(made).create_mesh()
    assert made.FemMesh.NodeCount > 0
    return made


def taken(made):
    """Nodes that came from the initial mesh, as the report has it."""
    (text,) = [text for text in made.Messages if "(initial-mesh)" in text]
    return int(text.split("took ")[1].split()[0])


@pytest.mark.parametrize("dimension, order", [("2D", "1st"), ("2D", "2nd"), ("3D", "2nd")])
def test_a_gmsh_mesh_is_followed(box, dimension, order):
    plain = advlayers.make_layer_mesh(box, **SETTINGS)
    start = gmsh_object(box, 2, dimension, order)
    made = advlayers.make_layer_mesh(box, **SETTINGS, initial_mesh=start)
    assert made.InitialMesh is start and made.State == layer_mesh.UP_TO_DATE
    assert taken(made) > 200 and made.InvertedCount == 0
    assert made.NodeCount > 2.5 * plain.NodeCount  # half the size
    assert made.FemMesh.BoundBox.DiagonalLength == pytest.approx(box.Shape.BoundBox.DiagonalLength)


def test_it_is_out_of_date_once_the_initial_mesh_changes(box):
    start = initial_mesh.add_to(box.Document, initial_mesh.of_object(gmsh_object(box, 3)), "start")
    made = advlayers.make_layer_mesh(box, **SETTINGS, initial_mesh=start)
    box.Document.recompute()
    assert made.State == layer_mesh.UP_TO_DATE
    start.FemMesh = gmsh_object(box, 2).FemMesh
    box.Document.recompute()
    assert made.State == layer_mesh.OUT_OF_DATE
    coarse = made.NodeCount
    made.AutoUpdate = True
    box.Document.recompute()
    assert made.State == layer_mesh.UP_TO_DATE and made.NodeCount > 1.5 * coarse
    made.AutoUpdate = False
    made.InitialMesh = None
    box.Document.recompute()
    assert made.State == layer_mesh.OUT_OF_DATE


def test_it_is_kept_in_files(box, tmp_path):
    made = advlayers.make_layer_mesh(box, **SETTINGS, initial_mesh=gmsh_object(box, 3))
    box.Document.saveCopy(str(tmp_path / "kept.FCStd"))
    again = FreeCAD.openDocument(str(tmp_path / "kept.FCStd"))
    try:
        kept = again.getObject(made.Name)
        again.recompute()
        assert kept.InitialMesh.Name == "FEMMeshGmsh"
        assert kept.State == layer_mesh.UP_TO_DATE
    finally:
        FreeCAD.closeDocument(again.Name)


def test_placements_count(box):
    points, triangles = initial_mesh.of_object(gmsh_object(box, 3))
    start = initial_mesh.add_to(box.Document, (points - [100, 0, 0], triangles), "beside")
    with pytest.raises(ValueError, match="off the shape"):
        advlayers.make_layer_mesh(box, **SETTINGS, initial_mesh=start)
    part = box.Document.addObject("App::Part", "Assembly")
    part.addObject(start)
    part.Placement.Rotation = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 180)
    part.Placement.Base = FreeCAD.Vector(70, 0, 0)
    start.Placement = part.Placement.inverse()
    start.Placement.Base += part.Placement.Rotation.inverted().multVec(FreeCAD.Vector(100, 0, 0))
    box.Document.recompute()
    assert np.allclose(initial_mesh.of_object(start)[0], points)
    assert taken(advlayers.make_layer_mesh(box, **SETTINGS, initial_mesh=start)) > 50


def test_a_mesh_object_of_facets(box):
    import MeshPart

    facets = box.Document.addObject("Mesh::Feature", "Facets")
    facets.Mesh = MeshPart.meshFromShape(Shape=box.Shape, MaxLength=2)
    made = advlayers.make_layer_mesh(box, **SETTINGS, initial_mesh=facets)
    assert taken(made) > 100 and made.State == layer_mesh.UP_TO_DATE


def test_arrays_and_files_become_objects_of_the_document(box, tmp_path):
    points, triangles = initial_mesh.of_object(gmsh_object(box, 3))
    made = advlayers.make_layer_mesh(box, **SETTINGS, initial_mesh=(points, triangles))
    assert made.InitialMesh.FemMesh.TriangleCount == len(triangles)
    path = str(tmp_path / "start.unv")
    made.InitialMesh.FemMesh.write(path)
    other = advlayers.make_layer_mesh(box, **SETTINGS, initial_mesh=path)
    assert other.InitialMesh.Label == "start.unv" and taken(other) == taken(made)


def test_what_cannot_be_used_is_refused_and_changes_nothing(box):
    document = box.Document
    empty = document.addObject("Fem::FemMeshObject", "Empty")
    empty.FemMesh = Fem.FemMesh()
    made = advlayers.make_layer_mesh(box, **SETTINGS)
    count, before = len(document.Objects), made.NodeCount
    for wrong, text in ((box, "must be a mesh object"), ("nowhere.vtu", "does not exist"),
                        (5, "must be a text")):
        with pytest.raises(InputError, match=text):
            advlayers.make_layer_mesh(box, initial_mesh=wrong)
    assert len(document.Objects) == count
    made.InitialMesh = empty
    with pytest.raises(InputError, match="Empty has no surface elements"):
        advlayers.update(made)
    assert made.NodeCount == before == made.FemMesh.NodeCount

"""The mesh object from FreeCAD's console; these tests run inside freecadcmd."""
import os

import advlayers
import FreeCAD
import numpy as np
import pytest
from advlayers import layer_mesh, mesh_data
from advlayers.errors import InputError
from advlayers.mesh_properties import property_settings
from advlayers.properties import property_type
from advlayers.settings_table import property_name


def groups_of(fem):
    return {fem.getGroupName(i): (fem.getGroupElementType(i), fem.getGroupElements(i))
            for i in fem.Groups}


def test_a_mesh_in_one_call(box):
    made = advlayers.make_layer_mesh(box, faces=["Face1"], size=5, first_height="0.5 mm")
    assert made.TypeId == "Fem::FemMeshObjectPython" and made.Part is box
    assert made.State == layer_mesh.UP_TO_DATE
    assert made.FemMesh.QuadrangleCount == made.QuadCount > 0
    assert made.FemMesh.TriangleCount == made.TriangleCount
    assert made.FirstHeight.Value == 0.5 and made.Faces == ["Face1"]


def test_loose_faces_are_sewn_under_the_names_that_they_have(box):
    import Part

    loose = box.Document.addObject("Part::Feature", "Loose")
    loose.Shape = Part.makeCompound([face.copy() for face in box.Shape.Faces])
    assert len(loose.Shape.Edges) == 24
    made = advlayers.make_layer_mesh(loose, size=5, sew_tolerance="0.001 mm", layers=1,
                                     walls=[{"edges": ["Edge24"]}], groups={"rim": ["Edge24"]},
                                     layer_groups=True)
    assert made.SewTolerance.Value == 0.001
    kinds = groups_of(made.FemMesh)
    same = [i for i in range(1, 24) if kinds[f"Edge{i}"] == kinds["Edge24"]]
    assert len(same) == 1 and kinds["rim"] == kinds["Edge24"]
    layers = len(kinds["Layer1"][1])
    # On both faces that met there without sharing the edge.
    assert layers == 2 * (len(kinds["rim"][1]) - 1)


def test_a_mesh_object_is_meshed_as_a_shape_of_its_facets(box):
    import MeshPart

    rod = box.Document.addObject("Part::Cylinder", "Rod")
    box.Document.recompute()
    facets = box.Document.addObject("Mesh::Feature", "Facets")
    facets.Mesh = MeshPart.meshFromShape(Shape=box.Shape.fuse(rod.Shape), LinearDeflection=0.05,
                                         AngularDeflection=0.3)
    facets.Placement.Base = FreeCAD.Vector(100, 0, 0)
    made = advlayers.make_layer_mesh(facets, size=3, first_height=0.3, layers=2)
    assert made.Part.TypeId == "Part::Feature" and made.FeatureAngle.Value == 20
    assert made.InvertedCount == 0
    assert not [text for text in made.Messages if text.startswith("error")]
    # It lies where the Mesh object does.
    bounds = facets.Mesh.BoundBox
    points = np.array([tuple(node) for node in made.FemMesh.Nodes.values()])
    assert np.allclose(points.min(axis=0), (bounds.XMin, bounds.YMin, bounds.ZMin), atol=0.1)
    assert np.allclose(points.max(axis=0), (bounds.XMax, bounds.YMax, bounds.ZMax), atol=0.1)


def test_units(box):
    inch = layer_mesh.create(box, size="1 in", first_height=FreeCAD.Units.Quantity("1 mm"),
                             feature_angle="0.5 rad")
    assert inch.Size.Value == pytest.approx(25.4)
    assert inch.FirstHeight.Value == 1.0
    assert inch.FeatureAngle.Value == pytest.approx(np.degrees(0.5))


@pytest.mark.parametrize("settings, words", [
    ({"first_height": "-1 mm"}, "first_height must be > 0 mm"),
    ({"first_height": "1 kg"}, "first_height must be a number in mm"),
    ({"first_height": "much"}, "first_height must be a number in mm"),
    ({"growth": 0.5}, "growth must be >= 1"),
    ({"faces": ["Face7"]}, "faces names Face7"),
    ({"thickness": 1}, "thickness is no known key"),
])
def test_bad_settings_leave_the_document_alone(box, settings, words):
    with pytest.raises(InputError, match=words):
        advlayers.make_layer_mesh(box, **settings)
    assert [entry.Name for entry in box.Document.Objects] == ["Box"]


def test_a_source_without_a_face(box):
    line = box.Document.addObject("Part::Line", "Line")
    box.Document.recompute()
    for source, words in ((line, "no face"), (box.Shape, "document object"), (None, "document")):
        with pytest.raises(InputError, match=words):
            advlayers.make_layer_mesh(source)


def test_ids_and_groups(box):
    made = advlayers.make_layer_mesh(box, size=5, first_height=0.5, layers=2, layer_groups=True,
                                     groups={"in let": ["Face1", "Edge5"]})
    fem = made.FemMesh
    assert sorted(fem.Nodes) == list(range(1, fem.NodeCount + 1))
    assert sorted(fem.Faces) == list(range(1, fem.FaceCount + 1))
    groups = groups_of(fem)
    for prefixes in (("Face",), ("Core", "Layer")):
        elements = [i for name, (kind, ids) in groups.items() for i in ids
                    if name.startswith(prefixes) and kind == "Face"]
        assert sorted(elements) == sorted(fem.Faces)
    assert groups["Layer1"][0] == "Face" and "Layer2" in groups and "Layer3" not in groups
    for i, edge in enumerate(box.Shape.Edges, 1):
        kind, nodes = groups[f"Edge{i}"]
        assert kind == "Node" and len(nodes) >= 2
        middle, length = edge.valueAt(sum(edge.ParameterRange) / 2), edge.Length
        assert all(fem.Nodes[node].distanceToPoint(middle) <= length / 2 + 1e-9 for node in nodes)
    assert [fem.getGroupElementType(i) for i in fem.Groups
            if fem.getGroupName(i) == "in let"] == ["Face", "Node"]


def test_recompute_never_meshes(box):
    made = advlayers.make_layer_mesh(box, size=5)
    nodes = made.FemMesh.NodeCount
    box.Document.recompute()
    assert made.State == layer_mesh.UP_TO_DATE
    made.Size = 2.5
    box.Document.recompute()
    assert made.State == layer_mesh.OUT_OF_DATE and made.FemMesh.NodeCount == nodes
    layer_mesh.update(made)
    assert made.State == layer_mesh.UP_TO_DATE and made.FemMesh.NodeCount > nodes
    box.Length = 40
    box.Document.recompute()
    assert made.State == layer_mesh.OUT_OF_DATE
    made.Threads = 2
    layer_mesh.update(made)
    assert made.FemMesh.BoundBox.XMax == pytest.approx(40.0)
    made.Threads = 1
    box.Document.recompute()
    assert made.State == layer_mesh.UP_TO_DATE


def test_a_failed_update_leaves_the_mesh(box):
    made = advlayers.make_layer_mesh(box, size=5)
    nodes = made.FemMesh.NodeCount
    made.Growth = 0.5
    with pytest.raises(InputError, match="growth"):
        layer_mesh.update(made)
    assert made.FemMesh.NodeCount == nodes
    made.Growth = 1.2
    made.Part = None
    with pytest.raises(InputError, match="nothing to mesh"):
        layer_mesh.update(made)


def test_a_stopped_update_leaves_the_mesh(box):
    made = advlayers.make_layer_mesh(box, size=5)
    nodes = made.FemMesh.NodeCount
    made.Size = 1

    def stop(_reports):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        layer_mesh.update(made, stop)
    assert made.FemMesh.NodeCount == nodes


def test_save_and_restore(box, tmp_path):
    settings = {"size": 5.0, "first_height": 0.5, "growth": 1.3, "layers": 2, "core": "triangles",
                "feature_angle": 0.0, "walls": [{"edges": ["Edge1", "Edge2"], "layers": 1}],
                "match": ["Edge3"], "off": ["Edge4"], "groups": {"in let": ["Face1", "Edge1"]}}
    made = advlayers.make_layer_mesh(box, **settings)
    before, nodes = layer_mesh.settings_of(made), made.FemMesh.Nodes
    quads, groups = made.QuadCount, groups_of(made.FemMesh)
    path = str(tmp_path / "saved.FCStd")
    box.Document.saveCopy(path)
    document = FreeCAD.openDocument(path)
    try:
        restored = document.getObject("LayerMesh")
        assert layer_mesh.is_layer_mesh(restored)
        assert restored.State == layer_mesh.UP_TO_DATE
        document.recompute(None, True)
        assert restored.State == layer_mesh.UP_TO_DATE
        assert layer_mesh.settings_of(restored) == before
        assert restored.FemMesh.Nodes == nodes and restored.QuadCount == quads
        assert groups_of(restored.FemMesh) == groups
        layer_mesh.update(restored)
        assert restored.QuadCount == quads
    finally:
        FreeCAD.closeDocument(document.Name)


def test_results_cannot_be_edited(box):
    made = layer_mesh.create(box)
    for name in made.PropertiesList:
        if made.getGroupOfProperty(name) == "Result":
            assert made.getEditorMode(name), name


def test_every_property_has_its_tooltip(box):
    made = layer_mesh.create(box)
    for entry in property_settings():
        assert made.getTypeIdOfProperty(property_name(entry)) == property_type(entry)
        assert made.getGroupOfProperty(property_name(entry)) == entry.group
        assert made.getDocumentationOfProperty(property_name(entry)) == entry.doc
    for name in made.PropertiesList:
        if made.getGroupOfProperty(name) not in ("", "Base"):
            assert made.getDocumentationOfProperty(name), name


def test_placed_parts_are_meshed_where_they_stand(box):
    part = box.Document.addObject("App::Part", "Assembly")
    part.Placement.Base = FreeCAD.Vector(0, 0, 500)
    part.addObject(box)
    box.Placement.Base = FreeCAD.Vector(100, 0, 0)
    box.Document.recompute()
    for source in (box, part):
        made = advlayers.make_layer_mesh(source, size=5)
        assert made.FemMesh.BoundBox.ZMin == pytest.approx(500.0)
        assert made.FemMesh.BoundBox.XMin == pytest.approx(100.0)


def test_bodies_and_links(box):
    body = box.Document.addObject("PartDesign::Body", "Body")
    block = box.Document.addObject("PartDesign::AdditiveBox", "Block")
    body.addObject(block)
    link = box.Document.addObject("App::Link", "Link")
    link.LinkedObject = box
    link.Placement.Base = FreeCAD.Vector(0, 70, 0)
    box.Document.recompute()
    assert advlayers.make_layer_mesh(body, size=5).QuadCount > 0
    assert advlayers.make_layer_mesh(link, size=5).FemMesh.BoundBox.YMin == pytest.approx(70.0)


def test_layers_are_no_groups_unless_asked_for(box):
    made = advlayers.make_layer_mesh(box, size=5, first_height=0.5, layers=2)
    assert not [name for name in groups_of(made.FemMesh) if name.startswith(("Layer", "Core"))]
    assert set(made.ElementLayers) == {0.0, 1.0, 2.0}
    made.LayerGroups = True
    box.Document.recompute()
    assert made.State == layer_mesh.OUT_OF_DATE
    layer_mesh.update(made)
    groups = groups_of(made.FemMesh)
    for number in (1, 2):
        members = [i + 1 for i, layer in enumerate(made.ElementLayers) if layer == number]
        assert sorted(groups[f"Layer{number}"][1]) == members


def test_init_finds_the_packages():
    """They were found by Init.py: nothing else put them on sys.path."""
    import sys

    root = os.path.join(FreeCAD.getUserAppDataDir(), "Mod", "AdvancingLayers")
    assert os.path.join(root, "App") in [os.path.normpath(entry) for entry in sys.path]
    assert advlayers.__file__.startswith(os.path.join(root, "App"))


def test_a_moved_mesh_is_read_as_it_was_made(box):
    """Its view provider moves what it shows."""
    made = advlayers.make_layer_mesh(box, size=5)
    data = mesh_data.of_object(made)
    made.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 20, 3),
                                       FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40))
    assert made.FemMesh.BoundBox.XMin > 50
    made.Proxy.latest = ("", None)  # as after opening a file
    again = mesh_data.of_object(made)
    assert again is not data
    np.testing.assert_allclose(again.mesh.nodes, data.mesh.nodes, atol=1e-9)
    assert (again.mesh.quads == data.mesh.quads).all()

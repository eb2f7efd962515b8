"""Walls, sizes and groups as objects of a document, and what they add up to."""
import advlayers
import FreeCAD
import Part
import pytest
from advlayers import controls, layer_mesh
from advlayers.errors import InputError
from advlayers.settings_table import (
    REFINEMENT_SETTINGS, SIZE_SETTINGS, WALL_SETTINGS, optional_doc, property_name, unset_value)


@pytest.fixture
def mesh(box):
    return advlayers.make_layer_mesh(box, mesh_now=False, size=5, first_height=0.5, layers=2)


def edge_names(shape, face):
    """The edges of a face, by name."""
    return sorted(f"Edge{i}" for i, edge in enumerate(shape.Edges, 1)
                  if any(edge.isSame(other) for other in shape.Faces[face - 1].Edges))


def test_without_children_every_edge_is_a_wall(mesh):
    assert layer_mesh.settings_of(mesh)["walls"] == "all"
    mesh.GrowFromAll = False
    assert layer_mesh.settings_of(mesh)["walls"] == ()


def test_a_wall_says_what_it_holds(mesh):
    wall = advlayers.make_wall(mesh, ["Edge1", "Edge2"], first_height="0.25 mm", layers=1)
    assert mesh.WallList == [wall] and controls.mesh_of(wall) is mesh
    assert wall.FirstHeight.Value == 0.25 and wall.Growth == 0.0
    assert wall.References == [(mesh.Part, ("Edge1", "Edge2"))]
    (entry,) = layer_mesh.settings_of(mesh)["walls"]
    given = {key: value for key, value in entry.items() if value not in (None, ())}
    assert given == {"edges": ("Edge1", "Edge2"), "first_height": 0.25, "layers": 1}
    advlayers.update(mesh)
    assert max(mesh.ElementLayers) == 1


def test_faces_stand_for_their_edges(box, mesh):
    advlayers.make_wall(mesh, [(box, ("Face1", "Face3"))])
    (entry,) = layer_mesh.settings_of(mesh)["walls"]
    assert entry["faces"] == ("Face1", "Face3")
    assert set(entry["edges"]) == set(edge_names(box.Shape, 1)) | set(edge_names(box.Shape, 3))


def test_seams_are_no_walls(box):
    cylinder = box.Document.addObject("Part::Cylinder", "Cylinder")
    box.Document.recompute()
    made = advlayers.make_layer_mesh(cylinder, mesh_now=False, size=2, layers=1)
    advlayers.make_wall(made, ["Face1"])
    (entry,) = layer_mesh.settings_of(made)["walls"]
    circles = {f"Edge{i}" for i, edge in enumerate(cylinder.Shape.Edges, 1) if edge.isClosed()}
    assert len(circles) == 2 and set(entry["edges"]) == circles
    advlayers.update(made)


def test_match_and_off(mesh):
    advlayers.make_wall(mesh, ["Edge1"])
    advlayers.make_wall(mesh, ["Edge2"], condition="match")
    off = advlayers.make_wall(mesh, ["Edge3"], condition="Off")
    settings = layer_mesh.settings_of(mesh)
    assert settings["match"] == ("Edge2",) and settings["off"] == ("Edge3",)
    assert len(settings["walls"]) == 1
    off.Condition = "Wall"
    assert len(layer_mesh.settings_of(mesh)["walls"]) == 2


def test_edges_that_part_faces_or_do_not(mesh):
    advlayers.make_wall(mesh, ["Edge1"], condition="boundary")
    smooth = advlayers.make_wall(mesh, ["Edge3"], condition="Smooth")
    settings = layer_mesh.settings_of(mesh)
    assert settings["boundary"] == ("Edge1",) and settings["smooth"] == ("Edge3",)
    assert settings["walls"] == "all"
    with pytest.raises(ValueError, match="smooth: Edge3 .* at 90 degrees"):
        advlayers.update(mesh)
    mesh.Document.removeObject(smooth.Name)
    advlayers.update(mesh)
    again = advlayers.make_layer_mesh(mesh.Part, mesh_now=False, smooth=["Edge2"])
    assert layer_mesh.settings_of(again)["smooth"] == ("Edge2",)


def test_a_wall_of_an_older_file_gets_the_later_conditions(mesh):
    wall = advlayers.make_wall(mesh, ["Edge1"], condition="Off")
    wall.Condition = ["Wall", "Match", "Off"]
    wall.Condition = "Off"
    wall.Proxy.onDocumentRestored(wall)
    assert wall.Condition == "Off"
    wall.Condition = "Smooth"


def test_groups_carry_their_label(mesh):
    group = advlayers.make_group(mesh, "inlet", ["Face1", "Edge5"])
    other = advlayers.make_layer_mesh(mesh.Part, mesh_now=False, size=5,
                                      groups={"inlet": ["Face2"]})
    assert layer_mesh.settings_of(mesh)["groups"] == {"inlet": ("Face1", "Edge5")}
    assert layer_mesh.settings_of(other)["groups"] == {"inlet": ("Face2",)}
    group.Label = "outlet"
    advlayers.update(mesh)
    kinds = [mesh.FemMesh.getGroupElementType(i) for i in mesh.FemMesh.Groups
             if mesh.FemMesh.getGroupName(i) == "outlet"]
    assert kinds == ["Face", "Node"]


@pytest.mark.parametrize("make, arguments, words", [
    (advlayers.make_wall, {"references": []}, "must not be empty"),
    (advlayers.make_wall, {"references": ["Edge99"]}, "the shape has 12"),
    (advlayers.make_wall, {"references": ["Vertex1"]}, "cannot hold Vertex1"),
    (advlayers.make_wall, {"references": ["Wing"]}, "no face, edge or vertex"),
    (advlayers.make_wall, {"references": ["Edge1"], "first_height": -1}, "first_height must be"),
    (advlayers.make_wall, {"references": ["Edge1"], "height": 1}, "height is no known key"),
    (advlayers.make_wall, {"references": ["Edge1"], "condition": "none"}, "must be one of"),
    (advlayers.make_size, {"references": ["Edge1"], "size": "3 kg"}, "size must be a number"),
])
def test_bad_values_leave_the_document_alone(mesh, make, arguments, words):
    before = [entry.Name for entry in mesh.Document.Objects]
    with pytest.raises(InputError, match=words):
        make(mesh, **arguments)
    assert [entry.Name for entry in mesh.Document.Objects] == before


@pytest.mark.parametrize("table", [WALL_SETTINGS, SIZE_SETTINGS])
def test_every_value_can_be_left_out(box, mesh, table):
    make = advlayers.make_wall if table is WALL_SETTINGS else advlayers.make_size
    child = make(mesh, ["Edge1"])
    assert controls.values(child) == {}
    for entry in controls.value_settings(table):
        value = getattr(child, property_name(entry))
        assert getattr(value, "Value", value) == unset_value(entry)
        shown = child.getDocumentationOfProperty(property_name(entry))
        assert shown == optional_doc(entry) and entry.doc in shown


def _given(entry, table):
    """What it says beyond the defaults."""
    defaults = {row.key: row.default for row in table}
    return {key: value for key, value in entry.items() if value != defaults[key]}


def test_sizes_of_faces_edges_and_vertices(box, mesh):
    advlayers.make_size(mesh, ["Face1", "Edge5"], size="2 mm")
    advlayers.make_size(mesh, ["Edge1"], segments=7, cluster=3, both_ends=True)
    corner = advlayers.make_size(mesh, ["Vertex1"], size=0.5, radius=1)
    mesh.Refinements = ["1 2 3 0.7 0"]
    settings = layer_mesh.settings_of(mesh)
    given = [_given(size, SIZE_SETTINGS) for size in settings["sizes"]]
    assert given == [
        {"edges": ("Edge5",), "faces": ("Face1",), "size": 2.0},
        {"edges": ("Edge1",), "segments": 7, "cluster": 3.0, "both_ends": True}]
    assert [_given(region, REFINEMENT_SETTINGS) for region in settings["refinements"]] == [
        {"point": (1.0, 2.0, 3.0), "size": 0.7},
        {"point": tuple(box.Shape.Vertexes[0].Point), "size": 0.5, "radius": 1.0}]
    advlayers.update(mesh)
    nodes = {mesh.FemMesh.getGroupName(i): len(mesh.FemMesh.getGroupElements(i))
             for i in mesh.FemMesh.Groups if mesh.FemMesh.getGroupElementType(i) == "Node"}
    assert nodes["Edge1"] == 8 and nodes["Edge5"] >= 1 + box.Shape.Edges[4].Length / 2
    corner.Size = 0
    with pytest.raises(InputError, match="surroundings of Vertex1"):
        layer_mesh.settings_of(mesh)


def test_children_mark_the_mesh_out_of_date(mesh):
    wall = advlayers.make_wall(mesh, ["Edge1"])
    advlayers.update(mesh)
    mesh.Document.recompute()
    assert mesh.State == layer_mesh.UP_TO_DATE
    wall.FirstHeight = 0.3
    mesh.Document.recompute()
    assert mesh.State == layer_mesh.OUT_OF_DATE
    wall.FirstHeight = 0
    mesh.Document.recompute()
    assert mesh.State == layer_mesh.UP_TO_DATE
    mesh.Document.removeObject(wall.Name)
    mesh.Document.recompute()
    assert mesh.State == layer_mesh.OUT_OF_DATE


def test_automatic_update(mesh):
    wall = advlayers.make_wall(mesh, ["Edge1"], first_height=0.5)
    mesh.AutoUpdate = True
    mesh.Document.recompute()
    assert mesh.State == layer_mesh.UP_TO_DATE and mesh.QuadCount > 0
    first = mesh.MeshId
    mesh.Document.recompute(None, True)
    assert mesh.MeshId == first
    wall.FirstHeight = 0.25
    mesh.Document.recompute()
    assert mesh.State == layer_mesh.UP_TO_DATE and mesh.MeshId != first


def test_save_and_restore(mesh, tmp_path):
    advlayers.make_wall(mesh, ["Edge1"], first_height=0.3, layers=1)
    advlayers.make_wall(mesh, ["Edge2"], condition="Off")
    advlayers.make_group(mesh, "inlet", ["Face1"])
    advlayers.update(mesh)
    before = layer_mesh.settings_of(mesh)
    path = str(tmp_path / "saved.FCStd")
    mesh.Document.saveCopy(path)
    document = FreeCAD.openDocument(path)
    try:
        restored = document.getObject("LayerMesh")
        assert [controls.is_control(child) for child in controls.children(restored)] == [True] * 3
        document.recompute(None, True)
        assert restored.State == layer_mesh.UP_TO_DATE
        assert layer_mesh.settings_of(restored) == before
    finally:
        FreeCAD.closeDocument(document.Name)


def test_a_copy_has_children_of_its_own(mesh):
    advlayers.make_wall(mesh, ["Edge1"], first_height=0.3)
    advlayers.make_group(mesh, "inlet", ["Face1"])
    before = layer_mesh.settings_of(mesh)
    copy = mesh.Document.copyObject(mesh, False)
    assert copy.Part is mesh.Part
    assert layer_mesh.settings_of(copy) == before
    assert not set(controls.children(copy)) & set(controls.children(mesh))
    copy.WallList[0].FirstHeight = 0.1
    assert layer_mesh.settings_of(mesh) == before
    whole = mesh.Document.copyObject(mesh, True)
    assert whole.Part is not mesh.Part
    assert {child.References[0][0] for child in controls.children(whole)} == {whole.Part}


def test_children_of_a_copy_in_another_document(mesh):
    advlayers.make_wall(mesh, ["Edge1"], first_height=0.3)
    before = layer_mesh.settings_of(mesh)
    other = FreeCAD.newDocument("Other")
    try:
        copy = other.copyObject(mesh, True)
        assert layer_mesh.settings_of(copy) == before
        assert all(child.Document is other for child in controls.children(copy))
    finally:
        FreeCAD.closeDocument(other.Name)


def test_lines_and_boxes_of_refinement_are_texts(mesh):
    mesh.Refinements = ["line 0 0 0 5 0 0 0.5 1", "box 0 0 0 1 2 3 0.4", "1 2 3 0.7"]
    line, box_, point = layer_mesh.settings_of(mesh)["refinements"]
    assert (line["end"], line["radius"], line["size"]) == ((5.0, 0.0, 0.0), 1.0, 0.5)
    assert (box_["corner"], box_["end"], box_["size"]) == ((1.0, 2.0, 3.0), None, 0.4)
    assert (point["end"], point["corner"], point["point"]) == (None, None, (1.0, 2.0, 3.0))
    made = advlayers.make_layer_mesh(mesh.Part, mesh_now=False, refinements=[
        {"point": [0, 0, 0], "end": [5, 0, 0], "size": 0.5, "radius": 1}])
    assert made.Refinements == ["line 0 0 0 5 0 0 0.5 1"]
    mesh.Refinements = ["line 0 0 0 5 0 0 0.5 1 2"]
    with pytest.raises(InputError, match="a number too many"):
        layer_mesh.settings_of(mesh)


def test_periodic_motions_and_mapped_faces_are_texts(mesh):
    mesh.Periodic = ["Face1 Edge2 move 10 0 0", "Edge5 turn 0 0 0 0 0 1 90"]
    mesh.Mapped = ["Face3"]
    settings = layer_mesh.settings_of(mesh)
    moved, turned = settings["periodic"]
    assert (moved["faces"], moved["edges"], moved["translation"]) == (
        ("Face1",), ("Edge2",), (10.0, 0.0, 0.0))
    assert (turned["angle"], turned["axis_direction"]) == (90.0, (0.0, 0.0, 1.0))
    assert settings["mapped"] == ("Face3",)
    made = advlayers.make_layer_mesh(mesh.Part, mesh_now=False, mapped=["Face1"], periodic=[
        {"faces": ["Face1"], "translation": [0, 0, 5]}])
    assert (made.Periodic, made.Mapped) == (["Face1 move 0 0 5"], ["Face1"])
    mesh.Periodic = ["Face1 move 10 0"]
    with pytest.raises(InputError, match="must hold texts like"):
        layer_mesh.settings_of(mesh)


def test_features_become_names_and_presets_settings(box):
    plate = box.Document.addObject("Part::Feature", "Plate")
    plate.Shape = Part.makeBox(40, 30, 2).cut(
        Part.makeCylinder(4, 2, FreeCAD.Vector(12, 15, 0))).cut(
            Part.makeCylinder(2, 2, FreeCAD.Vector(30, 15, 0)))
    small = advlayers.make_layer_mesh(plate, mesh_now=False, walls=[
        {"edges": ["holes 3 5"], "layers": 2}])
    (wall,) = small.WallList
    edges = [plate.Shape.getElement(name) for _object, names in wall.References for name in names]
    assert len(edges) == 2 and all(edge.Curve.Radius == 2.0 for edge in edges)
    washers = advlayers.make_layer_mesh(plate, mesh_now=False, preset="washers", size=2)
    assert washers.Others == "off" and washers.FeatureAngle.Value == 15.0
    names = [name for _object, names in washers.WallList[0].References for name in names]
    assert len(names) == 4
    advlayers.apply_preset(washers, "fem")
    assert not washers.WallList and not washers.GrowFromAll
    advlayers.apply_preset(washers, "cfd")
    assert washers.GrowFromAll and washers.Layers == "isotropic"
    with pytest.raises(InputError, match="preset must be"):
        advlayers.apply_preset(washers, "thin")

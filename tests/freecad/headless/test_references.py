"""Names of faces and edges after the model was edited: reported where they mean something else."""
import advlayers
import FreeCAD
import pytest
from advlayers import controls, layer_mesh
from advlayers.errors import InputError

# FreeCAD 1.x follows faces and marks lost ones itself; 0.20 leaves the names as they are.
FOLLOWS = tuple(int(part) for part in FreeCAD.Version()[:2]) >= (1, 0)


@pytest.fixture
def document():
    made = FreeCAD.newDocument("References")
    name = made.Name
    yield made
    if name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


def drilled_box(document):
    box = document.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 30, 20, 10
    drill = document.addObject("Part::Cylinder", "Drill")
    drill.Radius, drill.Height = 3, 100
    drill.Placement.Base = FreeCAD.Vector(10, 10, -50)
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = box, drill
    document.recompute()
    return cut


def face_name(shape, test):
    return next(f"Face{i}" for i, face in enumerate(shape.Faces, 1) if test(face))


def is_top(face):
    return face.normalAt(0.5, 0.5).z > 0.9 and face.CenterOfMass.z > 9.9


def is_hole(face):
    return type(face.Surface).__name__ == "Cylinder"


def drill_the_corner(document):
    """The hole becomes a notch in a vertical edge, and most faces get other numbers."""
    document.Drill.Placement.Base = FreeCAD.Vector(0, 0, -50)
    document.recompute()


def test_lengths_may_change(document):
    cut = drilled_box(document)
    names = [face_name(cut.Shape, is_top), face_name(cut.Shape, is_hole)]
    mesh = advlayers.make_layer_mesh(cut, size=5, faces=names, groups={"hole": names[1:]})
    wall = advlayers.make_wall(mesh, [names[0]], layers=1)
    for change in ((document.Box, "Length", 60), (document.Box, "Height", 25),
                   (document.Drill, "Radius", 4)):
        setattr(*change)
        document.recompute()
        assert mesh.State == layer_mesh.OUT_OF_DATE
        assert layer_mesh.reference_problems(mesh) == []
        advlayers.update(mesh)
    assert is_hole(cut.Shape.getElement(mesh.GroupList[0].References[0][1][0]))
    assert mesh.FemMesh.BoundBox.XMax == pytest.approx(60)
    assert controls.problems(wall) == []


def test_renumbered_faces_are_reported_and_not_meshed(document):
    cut = drilled_box(document)
    top = face_name(cut.Shape, is_top)
    mesh = advlayers.make_layer_mesh(cut, size=5, faces=[top])
    quads = mesh.QuadCount
    drill_the_corner(document)
    assert face_name(cut.Shape, is_top) != top, "the edit is to renumber the top face"
    assert mesh.State == layer_mesh.LOST_REFERENCES
    with pytest.raises(InputError, match=f"{top} is"):
        advlayers.update(mesh)
    assert mesh.QuadCount == quads
    layer_mesh.follow_references(mesh)
    assert is_top(cut.Shape.getElement(mesh.Faces[0]))
    assert mesh.State == layer_mesh.OUT_OF_DATE
    advlayers.update(mesh)
    assert mesh.FemMesh.BoundBox.ZMin == pytest.approx(10)


def test_references_of_children_are_followed_or_reported(document):
    """FreeCAD 1.x renames them itself; here they are reported and can be made to follow."""
    cut = drilled_box(document)
    top = face_name(cut.Shape, is_top)
    mesh = advlayers.make_layer_mesh(cut, size=5)
    wall = advlayers.make_wall(mesh, [top], layers=1)
    advlayers.update(mesh)
    drill_the_corner(document)
    if not FOLLOWS:
        assert [(p.owner, p.name) for p in layer_mesh.reference_problems(mesh)] == [(wall, top)]
        assert mesh.State == layer_mesh.LOST_REFERENCES
    layer_mesh.follow_references(mesh)
    ((owner, names),) = wall.References
    assert owner is cut and is_top(cut.Shape.getElement(names[0]))
    advlayers.update(mesh)


def test_lost_faces_stay_lost_until_accepted(document):
    cut = drilled_box(document)
    hole = face_name(cut.Shape, is_hole)
    mesh = advlayers.make_layer_mesh(cut, size=5)
    group = advlayers.make_group(mesh, "hole", [hole])
    document.Drill.Placement.Base.x = 500
    document.recompute()
    assert mesh.State == layer_mesh.LOST_REFERENCES
    (problem,) = layer_mesh.reference_problems(mesh)
    assert problem.owner is group and not problem.found
    layer_mesh.follow_references(mesh)
    assert layer_mesh.reference_problems(mesh)
    with pytest.raises(InputError, match="hole"):
        advlayers.update(mesh)
    group.References = [(cut, ("Face1",))]
    assert layer_mesh.reference_problems(mesh) == []
    advlayers.update(mesh)


def test_a_reference_that_means_another_face_can_be_accepted(document):
    cut = drilled_box(document)
    top = face_name(cut.Shape, is_top)
    mesh = advlayers.make_layer_mesh(cut, size=5, faces=[top])
    drill_the_corner(document)
    assert layer_mesh.reference_problems(mesh)
    layer_mesh.accept_references(mesh)
    assert mesh.Faces == [top] and mesh.State == layer_mesh.OUT_OF_DATE
    advlayers.update(mesh)


def test_names_beyond_the_model(document):
    cut = drilled_box(document)
    mesh = advlayers.make_layer_mesh(cut, mesh_now=False, size=5, faces=["Face7"])
    cut.Tool.Placement.Base.x = 500
    document.recompute()
    (problem,) = layer_mesh.reference_problems(mesh)
    assert problem.name == "Face7" and "not there any more" in problem.said.english


def test_what_is_known_survives_saving(document, tmp_path):
    cut = drilled_box(document)
    top = face_name(cut.Shape, is_top)
    mesh = advlayers.make_layer_mesh(cut, size=5, faces=[top])
    advlayers.make_wall(mesh, [top])
    path = str(tmp_path / "saved.FCStd")
    document.saveCopy(path)
    FreeCAD.closeDocument(document.Name)
    opened = FreeCAD.openDocument(path)
    try:
        restored = opened.getObject("LayerMesh")
        opened.recompute(None, True)
        assert layer_mesh.reference_problems(restored) == []
        drill_the_corner(opened)
        owners = {problem.owner for problem in layer_mesh.reference_problems(restored)}
        assert restored in owners
        assert FOLLOWS or restored.WallList[0] in owners
    finally:
        FreeCAD.closeDocument(opened.Name)


def test_a_feature_of_a_body_is_found_on_the_body(document):
    body = document.addObject("PartDesign::Body", "Body")
    block = document.addObject("PartDesign::AdditiveBox", "Block")
    body.addObject(block)
    body.Placement.Base = FreeCAD.Vector(0, 0, 100)
    document.recompute()
    mesh = advlayers.make_layer_mesh(body, mesh_now=False, size=2)
    top = face_name(block.Shape, lambda face: face.normalAt(0.5, 0.5).z > 0.9)
    wall = advlayers.make_wall(mesh, [(block, top)])
    (entry,) = layer_mesh.settings_of(mesh)["walls"]
    assert len(entry["edges"]) == 4
    shape = layer_mesh.cad_input.global_shape(body)
    assert shape.getElement(wall.References[0][1][0]).CenterOfMass.z == pytest.approx(110)
    advlayers.update(mesh)


def test_members_of_a_part_and_links(document):
    box = document.addObject("Part::Box", "Box")
    other = document.addObject("Part::Box", "Other")
    other.Placement.Base = FreeCAD.Vector(50, 0, 0)
    part = document.addObject("App::Part", "Assembly")
    part.Placement.Base = FreeCAD.Vector(0, 0, 500)
    part.addObjects([box, other])
    document.recompute()
    mesh = advlayers.make_layer_mesh(part, mesh_now=False, size=2)
    advlayers.make_wall(mesh, [(box, "Face1"), (other, "Face1")], layers=2)
    (entry,) = layer_mesh.settings_of(mesh)["walls"]
    assert len(entry["faces"]) == 2 and len(entry["edges"]) == 8
    advlayers.update(mesh)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = box
    link.Placement.Base = FreeCAD.Vector(0, 70, 0)
    document.recompute()
    linked = advlayers.make_layer_mesh(link, mesh_now=False, size=2)
    advlayers.make_wall(linked, ["Face2"], layers=2)
    advlayers.update(linked)
    assert linked.FemMesh.BoundBox.YMin == pytest.approx(70)
    with pytest.raises(InputError, match="no part of"):
        advlayers.make_wall(linked, [(other, "Face1")])


def test_compounds(document):
    boxes = []
    for i in range(2):
        box = document.addObject("Part::Box", "Box")
        box.Placement.Base = FreeCAD.Vector(50 * i, 0, 0)
        boxes.append(box)
    compound = document.addObject("Part::Compound", "Compound")
    compound.Links = boxes
    document.recompute()
    mesh = advlayers.make_layer_mesh(compound, mesh_now=False, size=2, faces=["Face7"])
    advlayers.make_wall(mesh, [(boxes[1], "Face1")], layers=2)
    advlayers.update(mesh)
    assert mesh.FemMesh.BoundBox.XMin == pytest.approx(50)

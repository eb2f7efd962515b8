"""From and to FreeCAD's other meshes: export, triangles, volumes, Gmsh's settings."""
import re

import advlayers
import Fem
import FreeCAD
import numpy as np
import ObjectsFem
import pytest
from advlayers import (
    export, gmsh_takeover, layer_mesh, mesh_feature, object_export, stored_mesh, volume_fill)
from advlayers.errors import InputError, Stopped
from advlayers.volume.programs import gmsh
from advlayers.formats import mesh_parts


@pytest.fixture
def mesh(box):
    return advlayers.make_layer_mesh(box, size=4, first_height=0.5, layers=3,
                                     groups={"inlet": ["Face1"]})


@pytest.mark.parametrize("ending", [ending for ending, entry in export.FORMATS.items()
                                    if ending not in (".fcstd", ".su2", ".med", ".cgns")
                                    and not entry.only_cells])
def test_export_writes_what_a_job_writes(mesh, tmp_path, ending):
    import advlayers_core as core
    from advlayers import meshing

    task = layer_mesh.prepare(mesh)
    context = core.RunContext()
    fresh = meshing.Run(context, lambda: task.make_mesher(core, context)).finish(
        lambda reports: None)
    parts = mesh_parts.of_mesh(fresh, {"inlet": ["Face1"]})
    mine, jobs = str(tmp_path / f"mine{ending}"), str(tmp_path / f"job{ending}")
    object_export.export_mesh(mesh, mine)
    export.FORMATS[ending].write(jobs, export.Product(parts))
    assert open(mine, "rb").read() == open(jobs, "rb").read()


def test_export_in_another_unit_and_version(mesh, tmp_path):
    path = str(tmp_path / "metres.msh")
    object_export.export_mesh(mesh, path, scale=0.001, msh_version="2.2")
    lines = open(path).read().split("\n")
    assert lines[1].startswith("2.2")
    first = lines.index("$Nodes") + 2
    points = np.array([line.split()[1:] for line in lines[first:lines.index("$EndNodes")]], float)
    assert points.max() == pytest.approx(0.03)
    with pytest.raises(InputError, match="scale must be > 0"):
        object_export.export_mesh(mesh, path, scale=0)
    with pytest.raises(InputError, match="STL files have no edges"):
        advlayers.make_group(mesh, "rim", ["Edge1"])
        layer_mesh.update(mesh)
        object_export.export_mesh(mesh, str(tmp_path / "mesh.stl"))


def test_export_of_a_saved_document(mesh, tmp_path):
    path = str(tmp_path / "saved.FCStd")
    mesh.Document.saveCopy(path)
    object_export.export_mesh(mesh, str(tmp_path / "before.vtu"))
    document = FreeCAD.openDocument(path)
    try:
        object_export.export_mesh(document.LayerMesh, str(tmp_path / "after.vtu"))
    finally:
        FreeCAD.closeDocument(document.Name)
    assert (tmp_path / "before.vtu").read_text() == (tmp_path / "after.vtu").read_text()


def test_export_says_what_is_wrong(box, mesh, tmp_path):
    with pytest.raises(InputError, match="unknown format"):
        object_export.export_mesh(mesh, str(tmp_path / "mesh.doc"))
    with pytest.raises(InputError, match="cannot be written"):
        object_export.export_mesh(mesh, str(tmp_path / "nowhere" / "mesh.vtu"))
    empty = advlayers.make_layer_mesh(box, mesh_now=False)
    with pytest.raises(InputError, match="no mesh yet"):
        object_export.export_mesh(empty, str(tmp_path / "mesh.vtu"))
    assert list(tmp_path.iterdir()) == []


def test_triangles_keep_all_of_each_quad(box, mesh):
    made = mesh_feature.make_mesh_feature(mesh)
    assert made.isDerivedFrom("Mesh::Feature")
    assert made.Mesh.CountFacets == 2 * mesh.QuadCount + mesh.TriangleCount
    assert made.Mesh.CountPoints == mesh.NodeCount
    assert made.Mesh.Area == pytest.approx(box.Shape.Area, rel=1e-5)
    assert made.Mesh.Volume == pytest.approx(box.Shape.Volume, rel=1e-5)
    assert made.Mesh.isSolid() and not made.Mesh.hasNonManifolds()


def volumes_of(fem):
    """By the sign that FreeCAD's own meshes have, see test_tetrahedra_turn_as_freecads_own."""
    nodes = {number: np.array(point) for number, point in fem.Nodes.items()}
    volumes = []
    for number in fem.Volumes:
        a, b, c, d = (nodes[node] for node in fem.getElementNodes(number)[:4])
        volumes.append(np.dot(np.cross(c - a, b - a), d - a) / 6.0)
    return np.array(volumes)


def volume_of(fem):
    volumes = volumes_of(fem)
    assert (volumes > 0.0).all()
    return volumes.sum()


def needs_gmsh():
    if not gmsh():
        pytest.skip("Gmsh is not installed")


def test_a_volume_fills_the_surface(box, mesh):
    needs_gmsh()
    made = volume_fill.fill(mesh)
    fem = made.FemMesh
    assert fem.TetraCount == fem.VolumeCount > 0
    assert volume_of(fem) == pytest.approx(box.Shape.Volume)
    assert fem.TriangleCount == 2 * mesh.QuadCount + mesh.TriangleCount
    surface = mesh.FemMesh.Nodes
    assert {number: fem.Nodes[number] for number in surface} == surface
    names = {fem.getGroupName(i): len(fem.getGroupElements(i)) for i in fem.Groups}
    assert names["inlet"] == names["Face1"] > 0 and made.Part is box


def test_tetrahedra_turn_as_freecads_own(box, mesh):
    needs_gmsh()
    from femmesh import gmshtools

    own = ObjectsFem.makeMeshGmsh(box.Document, "Own")
    setattr(own, "Part" if hasattr(own, "Part") else "Shape", box)
    own.CharacteristicLengthMax, own.ElementOrder, own.ElementDimension = 5, "1st", "3D"
    gmshtools.GmshTools(own).create_mesh()
    assert (volumes_of(own.FemMesh) > 0.0).all()
    assert (volumes_of(volume_fill.fill(mesh).FemMesh) > 0.0).all()


def test_a_volume_with_a_cavity_and_two_solids(box):
    needs_gmsh()
    document = box.Document
    hollow = document.addObject("Part::Cut", "Hollow")
    ball = document.addObject("Part::Sphere", "Ball")
    ball.Radius = 3
    ball.Placement.Base = FreeCAD.Vector(15, 10, 5)
    hollow.Base, hollow.Tool = box, ball
    other = document.addObject("Part::Box", "Other")
    other.Placement.Base = FreeCAD.Vector(100, 0, 0)
    both = document.addObject("Part::Compound", "Both")
    both.Links = [hollow, other]
    document.recompute()
    mesh = advlayers.make_layer_mesh(both, size=2, first_height=0.5, layers=1)
    made = volume_fill.fill(mesh)
    assert volume_of(made.FemMesh) == pytest.approx(both.Shape.Volume, rel=0.01)


def test_a_volume_of_second_order(box):
    needs_gmsh()
    mesh = advlayers.make_layer_mesh(box, size=4, first_height=0.5, layers=2, order=2)
    assert {len(mesh.FemMesh.getElementNodes(i)) for i in mesh.FemMesh.Faces} <= {6, 8}
    fem = volume_fill.fill(mesh, name="Fluid").FemMesh
    assert {len(fem.getElementNodes(i)) for i in fem.Volumes} == {10}
    assert volume_of(fem) == pytest.approx(box.Shape.Volume)
    nodes = fem.Nodes
    for number in fem.Volumes:
        cell = [np.array(nodes[node]) for node in fem.getElementNodes(number)]
        for mid, (a, b) in zip(cell[4:], ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))):
            assert np.allclose(mid, (cell[a] + cell[b]) / 2, atol=1e-9)
    names = {fem.getGroupName(i): fem.getGroupElementType(i) for i in fem.Groups}
    assert names["Fluid"] == "Volume" and names["Face1"] == "Face"


def test_cells_are_exported(box, mesh, tmp_path):
    """Filled or extruded on the way to the file, as in a job; the document does not change."""
    needs_gmsh()
    before = [entry.Name for entry in box.Document.Objects]
    folder = tmp_path / "meshCase" / "constant" / "polyMesh"
    folder.parent.parent.mkdir()
    object_export.export_mesh(mesh, str(folder), scale=0.001, volume={})
    patches = re.findall(r"^    (\w+)\n    \{", (folder / "boundary").read_text(), re.M)
    faces = {f"Face{i}" for i in range(1, 7)} - set(mesh.GroupList[0].References[0][1])
    assert set(patches) == faces | {"inlet"}
    plane = advlayers.make_layer_mesh(box, size=4, faces=["Face6"], order=2)
    path = str(tmp_path / "plate.med")
    object_export.export_mesh(plane, path, extrude={"thickness": 2})
    kinds = {len(cell) for cell in map(Fem.read(path).getElementNodes, Fem.read(path).Volumes)}
    assert kinds and kinds <= {15, 20}
    object_export.export_mesh(plane, path, quad_nodes=9)
    kinds = {len(cell) for cell in map(Fem.read(path).getElementNodes, Fem.read(path).Faces)}
    assert 9 in kinds and 8 not in kinds
    box.Document.removeObject(plane.Name)
    assert [entry.Name for entry in box.Document.Objects] == before


@pytest.mark.parametrize("options, said", [
    ({"volume": {"quads": "keep"}}, "no pyramids, which stand on quads that are kept: "),
    ({"volume": {}, "extrude": {"thickness": 1}}, "does not go with extrude"),
    ({"quad_nodes": 9}, "goes with order 2 only"),
])
def test_exports_that_contradict_themselves(mesh, tmp_path, options, said):
    with pytest.raises(InputError, match=said):
        object_export.export_mesh(mesh, str(tmp_path / "mesh.unv"), **options)
    assert not list(tmp_path.iterdir())


def test_filling_can_be_stopped(mesh):
    needs_gmsh()
    before = [entry.Name for entry in mesh.Document.Objects]

    def stop(_reports):
        raise Stopped

    token = layer_mesh.window_watch.set(stop)
    try:
        with pytest.raises(Stopped):
            volume_fill.fill(mesh)
    finally:
        layer_mesh.window_watch.reset(token)
    assert [entry.Name for entry in mesh.Document.Objects] == before


def test_an_open_surface_is_refused(box):
    needs_gmsh()
    mesh = advlayers.make_layer_mesh(box, size=4, faces=["Face1", "Face2"])
    before = [entry.Name for entry in box.Document.Objects]
    with pytest.raises(InputError, match="is not closed"):
        volume_fill.fill(mesh)
    assert [entry.Name for entry in box.Document.Objects] == before


@pytest.fixture
def gmsh_mesh(box):
    document = box.Document
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    made = ObjectsFem.makeMeshGmsh(document, "FEMMeshGmsh")
    setattr(made, "Part" if hasattr(made, "Part") else "Shape", box)
    made.CharacteristicLengthMax = 3.0
    analysis.addObject(made)
    layer = ObjectsFem.makeMeshBoundaryLayer(document, made, "Inflation")
    layer.NumberOfLayers, layer.MinimumThickness, layer.GrowthRate = 4, 0.2, 1.3
    layer.References = [(box, ("Edge1", "Edge2"))]
    region = ObjectsFem.makeMeshRegion(document, made, element_length=0.0, name="Fine")
    region.CharacteristicLength = 1.0
    region.References = [(box, ("Face3",))]
    group = ObjectsFem.makeMeshGroup(document, made, True, "Inlet")
    group.Label = "in let"
    group.References = [(box, ("Face2",))]
    document.recompute()
    return made


def test_settings_of_a_gmsh_mesh(box, gmsh_mesh):
    made = gmsh_takeover.take_over(gmsh_mesh)
    assert made.Part is box and made.Size.Value == 3.0
    (wall,) = made.WallList
    assert wall.References == [(box, ("Edge1", "Edge2"))] and wall.Label.startswith("Inflation")
    assert (wall.FirstHeight.Value, wall.Growth, wall.Layers) == (0.2, 1.3, 4)
    (size,) = made.SizeList
    assert size.References == [(box, ("Face3",))]
    assert [group.GroupName for group in made.GroupList] == ["in let"]
    members = box.Document.Analysis.Group
    assert made in members and gmsh_mesh not in members
    assert box.Document.getObject(gmsh_mesh.Name) is gmsh_mesh


def test_layers_from_a_face_start_at_its_edges_on_the_faces_beside(box, gmsh_mesh):
    gmsh_mesh.MeshBoundaryLayerList[0].References = [(box, ("Face1",))]
    made = gmsh_takeover.take_over(gmsh_mesh)
    (wall,) = layer_mesh.raw_settings(made)["walls"]
    assert len(wall["edges"]) == 4 and len(wall["faces"]) == 4 and "Face1" not in wall["faces"]
    for edge in wall["edges"]:
        middle = box.Shape.getElement(edge).CenterOfMass
        assert middle.x == pytest.approx(0.0)


def test_only_gmsh_meshes_are_taken_over(mesh):
    with pytest.raises(InputError, match="no mesh made with Gmsh"):
        gmsh_takeover.take_over(mesh)


def test_the_arrays_of_a_stored_mesh(mesh):
    stored = stored_mesh.read(mesh)
    assert len(stored.quads) == mesh.QuadCount and len(stored.nodes) == mesh.NodeCount
    grown = stored.node_parent >= 0
    assert np.array_equal(grown, stored.node_layer > 0) and grown.any()
    assert set(stored.face_of_quad.tolist()) == set(range(1, 7))

"""Mesh files: the table of formats, what each can carry, and that nothing half-written remains.

That other programs read them is tested in tests/readers."""
import os

import core_meshes
import numpy as np
import pytest

from advlayers import export, quad_centres
from advlayers.errors import InputError
from advlayers.extrusion import Extrusion, extrude
from advlayers.formats import mesh_parts
from advlayers.outputs import Outputs

WITHOUT_FREECAD = [ending for ending, entry in export.FORMATS.items() if entry.needs != "FreeCAD"]


@pytest.fixture(scope="module")
def parts():
    mesh = core_meshes.mesh("square", size=0.25, first_height=0.05, layers=2)
    return mesh_parts.of_mesh(mesh, {"inlet": ["Edge1"]})


@pytest.mark.parametrize("ending", WITHOUT_FREECAD)
def test_every_format_is_written(parts, tmp_path, ending):
    if export.FORMATS[ending].needs:
        pytest.importorskip(export.FORMATS[ending].needs)
    path = str(tmp_path / (f"a mesh{ending}" if ending[0] == "." else "polyMesh"))
    if export.FORMATS[ending].only_cells:
        parts = extrude(parts, Extrusion(thickness=1.0))
    for _again in range(2):
        with Outputs() as outputs:
            outputs.write(path, lambda temporary: export.FORMATS[ending].write(
                temporary, export.Product(parts)))
            outputs.publish()
    beside = export.beside(path)
    assert sorted(os.listdir(tmp_path)) == sorted(
        os.path.basename(made) for made in (path, beside) if made)


@pytest.mark.parametrize("ending", [".vtk", ".msh", ".inp", ".bdf", ".unv", ".su2", ".obj"])
def test_a_scale_is_another_unit(parts, tmp_path, ending):
    """The numbers of the file, whatever they are, are those of the scaled mesh."""
    texts = []
    for made in (parts.scaled(0.5), mesh_parts.replace(parts, nodes=parts.nodes * 0.5,
                                                       metre=0.002)):
        path = str(tmp_path / f"mesh{ending}")
        export.FORMATS[ending].write(path, export.Product(made))
        texts.append(open(path, "rb").read())
    export.FORMATS[ending].write(path, export.Product(parts))
    assert texts[0] == texts[1] != open(path, "rb").read()


def test_options_of_formats(parts, tmp_path):
    path = str(tmp_path / "mesh.msh")
    for version in ("4.1", "2.2"):
        export.FORMATS[".msh"].write(path, export.Product(parts, {"msh_version": version}))
        assert open(path).read().split()[1] == version
    path = str(tmp_path / "mesh.inp")
    for elements, name in (("shell", "S4"), ("reduced shell", "S4R"), ("plane stress", "CPS4"),
                           ("plane strain", "CPE4"), ("axisymmetric", "CAX4"),
                           ("membrane", "M3D4")):
        export.FORMATS[".inp"].write(path, export.Product(parts, {"inp_elements": elements}))
        assert f"TYPE={name}," in open(path).read()


@pytest.mark.parametrize("layer_groups", [False, True])
def test_layers_are_groups_where_that_is_asked_for(tmp_path, layer_groups):
    mesh = core_meshes.mesh("square", size=0.25, first_height=0.05, layers=2)
    made = mesh_parts.of_mesh(mesh, {}, layer_groups)
    for ending in (".unv", ".inp", ".bdf"):
        path = str(tmp_path / f"mesh{ending}")
        export.FORMATS[ending].write(path, export.Product(made))
        assert ("Layer2" in open(path).read()) == layer_groups
    layers = {name: ids for name, _dimension, ids in made.element_sets(2)
              if name.startswith(("Layer", "Core"))}
    if layer_groups:
        every = np.sort(np.concatenate(list(layers.values())))
        assert np.array_equal(every, np.arange(1, 1 + len(mesh.quads) + len(mesh.triangles)))
    assert bool(layers) == layer_groups


def carries(path, **asked):
    asked["cells"] = frozenset(asked.get("cells", ()))
    export.check_carries("outputs[0]", path, export.Asked(**{"groups": {}, **asked}))


def test_what_a_format_cannot_carry_is_said():
    carries("a.vtu", groups={"rim": ["Edge1"]}, order=2, cells={"hex20", "prism15"})
    with pytest.raises(InputError, match="STL files have no edges: the group rim of Edge1"):
        carries("a.stl", groups={"rim": ["Face1", "Edge1"]})
    with pytest.raises(InputError, match="no elements of second order: a.SU2"):
        carries("a.SU2", order=2)
    with pytest.raises(InputError, match="OBJ|Wavefront files have no volume elements"):
        carries("a.obj", cells={"tet4"})
    for path in ("a.inp", "a.unv"):
        carries(path, cells={"tet4"})
        with pytest.raises(InputError, match="no pyramids, which stand on quads that are kept"):
            carries(path, cells={"tet4", "pyramid5"})
    carries("a.med", order=2, quad_nodes=9)
    with pytest.raises(InputError, match="Abaqus files have no quads of 9 nodes: a.inp"):
        carries("a.inp", order=2, quad_nodes=9)
    with pytest.raises(InputError, match="Medit files have no quads of 8 nodes: a.mesh"):
        carries("a.mesh", order=2)
    with pytest.raises(InputError, match="Face1 is in the groups a and b"):
        carries("a.b8.ugrid", groups={"a": ["Face1"], "b": ["Face2", "Face1"]})
    carries("a.msh", groups={"a": ["Face1"], "b": ["Face2", "Face1"]})


def test_pyramids_about_an_axis_are_found():
    made = extrude(mesh_parts.of_mesh(core_meshes.mesh("square", size=3.0, core="triangles"), {}),
                   Extrusion(axis=((0, 0, 0), (1, 0, 0)), angle=5.0))
    export.check_kinds("outputs[0]", "a.msh", made)
    with pytest.raises(InputError, match="no pyramids, which the mesh has along the axis: a.inp"):
        export.check_kinds("outputs[0]", "a.inp", made)


@pytest.mark.parametrize("shape", ["sphere", "cylinder", "box"])
def test_centres_of_quads_lie_on_the_shape(shape):
    parts = mesh_parts.of_mesh(core_meshes.mesh(shape, size=3.0, first_height=0.5, layers=2,
                                                order=2), {})
    made = quad_centres.added(parts, core_meshes.model(shape).project)
    before, block = parts.of(2)[0], made.of(2)[0]
    assert block.kind == "quad9" and np.array_equal(block.cells[:, :8], before.cells)
    assert np.array_equal(block.cells[:, 8], np.arange(len(parts.nodes), len(made.nodes)))
    points = made.nodes[block.cells]
    middle = points[:, :4].mean(axis=1)
    size = np.linalg.norm(points[:, 2] - points[:, 0], axis=1)
    assert (np.linalg.norm(points[:, 8] - middle, axis=1) < 0.2 * size).all()
    assert (quad_centres.least_area(points) > 0.0).all()
    centre = points[:, 8]
    if shape == "sphere":
        assert np.allclose(np.linalg.norm(centre, axis=1), 6.0, atol=1e-12)
    elif shape == "cylinder":
        ends = np.isin(centre[:, 2], (0.0, 12.0))
        assert np.allclose(np.hypot(*centre[~ends, :2].T), 5.0, atol=1e-12)


def test_an_upside_down_centre_is_drawn_back():
    """A plane quad whose centre would be put outside it."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
    nodes = np.concatenate([corners, (corners + np.roll(corners, -1, axis=0)) / 2.0])
    parts = mesh_parts.MeshParts(nodes, (mesh_parts.Block(
        "quad8", np.arange(8)[None], np.ones(1, np.int32)),))
    made = quad_centres.added(parts, lambda _face, points: points + [2.0, 0.0, 0.0])
    assert np.array_equal(made.nodes[8], [0.5, 0.5, 0.0])


def test_formats_say_truly_which_kinds_they_have(parts, tmp_path):
    """Those of a second order are written by each that says so."""
    for kind, entry in ((kind, entry) for entry in export.FORMATS.values() for kind in entry.kinds):
        assert kind in mesh_parts.KINDS, (entry.title, kind)


def test_a_writer_sees_the_name_of_the_file_and_may_write_more(tmp_path):
    def write(temporary):
        assert os.path.basename(temporary) == "a.txt"
        for path in (temporary, temporary + ".more"):
            open(path, "w").write("new")

    with Outputs() as outputs:
        outputs.write(str(tmp_path / "a.txt"), write)
        outputs.publish()
    assert sorted(os.listdir(tmp_path)) == ["a.txt", "a.txt.more"]


def test_unknown_formats_name_the_known_ones():
    with pytest.raises(InputError, match=r"'\.xyz' \(known: \.vtu \.vtk"):
        export.check_format("outputs[0]", "mesh.xyz", True)


def test_the_longest_ending_counts():
    assert export.format_of("a.B8.ugrid") == ".b8.ugrid"
    assert export.format_of("a.ugrid") == ".ugrid"
    assert export.beside("x/wing.lb8.ugrid") == "x/wing.mapbc"

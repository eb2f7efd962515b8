"""Mesh files: what is written comes back, and nothing half-written remains."""
import os
from types import SimpleNamespace

import numpy as np
import pytest

from advlayers import export
from advlayers.errors import InputError
from advlayers.mesh_groups import mesh_groups

meshio = pytest.importorskip("meshio")

WITHOUT_FREECAD = [ending for ending, entry in export.FORMATS.items() if entry.needs != "FreeCAD"]
# Nastran's long fields hold fewer digits than a double has.
RELATIVE_ERROR = {".bdf": 1e-11}


@pytest.fixture
def mesh():
    """Two quads and two triangles on two faces, with coordinates that no decimal text ends."""
    points = np.random.default_rng(7).random((8, 3)) * 1000.0 / 3.0
    return SimpleNamespace(
        nodes=points,
        quads=np.array([[0, 1, 2, 3], [3, 2, 4, 5]], np.int32),
        triangles=np.array([[1, 6, 2], [6, 7, 2]], np.int32),
        face_of_quad=np.array([1, 1], np.int32), face_of_triangle=np.array([3, 1], np.int32),
        layer_of_quad=np.array([1, 2], np.int32), layer_of_triangle=np.array([0, 0], np.int32),
        node_parent=np.array([-1, -1, 1, 0, 2, 3, -1, -1], np.int32),
        node_layer=np.array([0, 0, 1, 1, 2, 2, 0, 0], np.int32),
        edge_segments={4: np.array([[0, 1]], np.int32), 7: np.zeros((0, 2), np.int32)},
    )


def write(mesh, path, named=None):
    product = export.Product(mesh, mesh_groups(mesh, named or {}))
    export.FORMATS[export.format_of(path)].write(path, product)


@pytest.mark.parametrize("ending", WITHOUT_FREECAD)
@pytest.mark.parametrize("drop", ["nothing", "quads", "triangles"])
def test_every_format_comes_back(mesh, tmp_path, ending, drop):
    if drop != "nothing":
        kind = drop[:-1]
        setattr(mesh, drop, getattr(mesh, drop)[:0])
        for name in (f"face_of_{kind}", f"layer_of_{kind}"):
            setattr(mesh, name, getattr(mesh, name)[:0])
    path = str(tmp_path / f"mesh{ending}")
    write(mesh, path)
    if ending == ".unv":
        points, cells = read_unv(path)[:2]
    else:
        read = meshio.read(path)
        points, cells = read.points, {"quad": [], "triangle": []}
        for block in read.cells:
            cells[block.type] += block.data.tolist()
    assert np.allclose(points, mesh.nodes, rtol=RELATIVE_ERROR.get(ending, 0.0), atol=0.0)
    assert cells["quad"] == mesh.quads.tolist()
    assert cells["triangle"] == mesh.triangles.tolist()


def test_vtu_carries_faces_layers_and_parents(mesh, tmp_path):
    path = str(tmp_path / "mesh.vtu")
    write(mesh, path)
    read = meshio.read(path)
    assert np.concatenate(read.cell_data["face"]).tolist() == [1, 1, 3, 1]
    assert np.concatenate(read.cell_data["layer"]).tolist() == [1, 2, 0, 0]
    assert read.point_data["parent"].tolist() == mesh.node_parent.tolist()
    assert read.point_data["layer"].tolist() == mesh.node_layer.tolist()
    assert read.points.dtype == np.float64


def test_unv_carries_the_groups(mesh, tmp_path):
    path = str(tmp_path / "mesh.unv")
    write(mesh, path, {"in let": ["Face3", "Edge4"]})
    groups = read_unv(path)[2]
    assert groups == [
        ("Face1", 8, [1, 2, 4]), ("Face3", 8, [3]), ("Edge4", 7, [1, 2]), ("Core", 8, [3, 4]),
        ("Layer1", 8, [1]), ("Layer2", 8, [2]), ("in let", 8, [3]), ("in let", 7, [1, 2]),
    ]


def test_every_element_is_in_one_face_group_and_one_layer_group(mesh):
    groups = mesh_groups(mesh, {})
    for prefixes in (("Face",), ("Core", "Layer")):
        ids = [i for group in groups if group.name.startswith(prefixes) for i in group.ids.tolist()]
        assert sorted(ids) == [1, 2, 3, 4]


def test_outputs_appear_together(tmp_path):
    first, second = str(tmp_path / "a.txt"), str(tmp_path / "b.txt")
    with export.Outputs() as outputs:
        for path in (first, second):
            outputs.write(path, lambda temporary: open(temporary, "w").write("new"))
            assert not os.path.exists(first)
        outputs.publish()
    assert sorted(os.listdir(tmp_path)) == ["a.txt", "b.txt"]


def test_a_failed_output_leaves_the_older_files(tmp_path):
    first, second = str(tmp_path / "a.txt"), str(tmp_path / "b.txt")
    open(first, "w").write("old")

    def fail(temporary):
        open(temporary, "w").write("half")
        raise OSError("disk full")

    with pytest.raises(OSError), export.Outputs() as outputs:
        outputs.write(first, lambda temporary: open(temporary, "w").write("new"))
        outputs.write(second, fail)
        outputs.publish()
    assert os.listdir(tmp_path) == ["a.txt"] and open(first).read() == "old"


def test_a_writer_that_wrote_nothing_is_an_error(tmp_path):
    with pytest.raises(OSError, match="nothing was written"), export.Outputs() as outputs:
        outputs.write(str(tmp_path / "a.txt"), lambda temporary: None)


def test_unknown_formats_name_the_known_ones():
    with pytest.raises(InputError, match=r"'\.stl' \(known: \.vtu \.unv"):
        export.check_format("outputs[0]", "mesh.stl", True)


def read_unv(path):
    """Nodes, elements by kind (zero-based), and groups as (name, entity, ids)."""
    lines = open(path, encoding="utf-8").read().split("\n")
    points, cells, groups = [], {"quad": [], "triangle": []}, []
    at = 0
    while at + 1 < len(lines):
        assert lines[at] == "    -1"
        dataset, at = int(lines[at + 1]), at + 2
        while lines[at] != "    -1":
            if dataset == 2411:
                points.append([float(lines[at + 1][i:i + 25]) for i in (0, 25, 50)])
                at += 2
            elif dataset == 2412:
                kind = {44: "quad", 41: "triangle"}[int(lines[at].split()[1])]
                cells[kind].append([int(node) - 1 for node in lines[at + 1].split()])
                at += 2
            else:
                count, name, numbers, at = int(lines[at].split()[7]), lines[at + 1], [], at + 2
                while len(numbers) < 4 * count:
                    numbers += [int(number) for number in lines[at].split()]
                    at += 1
                groups.append((name, numbers[0], numbers[1::4]))
        at += 1
    return np.array(points), cells, groups

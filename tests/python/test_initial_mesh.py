"""Meshes to start from: their files and their elements as triangles."""
import meshio
import numpy as np
import pytest
from advlayers import initial_mesh
from advlayers.errors import InputError
from advlayers.surface_arrays import triangles_of
from core_meshes import core

CUBE = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)


def area(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def test_quads_are_halved_and_middle_nodes_are_passed_over():
    cells = {"quad": np.arange(8)[None], "triangle": np.array([[4, 5, 6, 1, 2, 3]])}
    assert triangles_of(cells).tolist() == [[4, 5, 6], [0, 1, 2], [0, 2, 3]]


SOLIDS = {
    "hexahedron": [list(range(8))],
    "wedge": [[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]],
    "tetra": [[0, 1, 3, 4], [1, 2, 3, 6], [4, 5, 6, 1], [4, 6, 7, 3], [1, 3, 4, 6]],
}


@pytest.mark.parametrize("kind", SOLIDS)
def test_solid_elements_give_their_skin(kind):
    triangles = triangles_of({kind: np.array(SOLIDS[kind])})
    assert len(triangles) == 12
    assert area(CUBE, triangles) == pytest.approx(6)


def test_pyramids_give_their_skin():
    points = np.vstack([CUBE, [[0.5, 0.5, 0.5]]])
    sides = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    triangles = triangles_of({"pyramid": np.array([side + [8] for side in sides])})
    assert area(points, triangles) == pytest.approx(6) and 8 not in triangles


def universal_file():
    """The lines of one with a beam and a triangle of second order."""
    records = [(1, 0, 0), (2, 1, 0), (3, 2, 0), (4, 1, 1), (5, 0, 2), (6, 0, 1)]
    lines = ["    -1", "  2411"]
    for number, x, y in records:
        lines += [f"{number:10d}{1:10d}{1:10d}{11:10d}", f"  {x}.0D+00  {y}.0D+00  0.0D+00"]
    lines += ["    -1", "    -1", "  2412"]
    lines += ["%10d%10d%10d%10d%10d%10d" % (1, 21, 2, 1, 7, 2), "%10d%10d%10d" % (0, 0, 0),
              "%10d%10d" % (1, 3)]
    lines += ["%10d%10d%10d%10d%10d%10d" % (2, 42, 2, 1, 7, 6), "%10d" * 6 % (1, 2, 3, 4, 5, 6),
              "    -1"]
    return lines


def test_a_universal_file_of_second_order(tmp_path):
    path = tmp_path / "one.unv"
    path.write_text("\n".join(universal_file()) + "\n")
    points, triangles = initial_mesh.read(str(path))
    assert points[triangles[0]].tolist() == [[0, 0, 0], [2, 0, 0], [0, 2, 0]]


def test_a_cut_universal_file_names_the_line_and_the_reason(tmp_path):
    lines = universal_file()
    path = tmp_path / "cut.unv"
    whole = len(lines)
    for kept in range(2, whole):
        if lines[kept - 1] == "    -1" or lines[kept:kept + 1] == ["  2412"]:
            continue  # cut between two datasets
        path.write_text("\n".join(lines[:kept]) + "\n")
        with pytest.raises(InputError, match=rf"line {kept}: the file ends within a dataset"):
            initial_mesh.read(str(path))
    path.write_text("\n".join(lines[:3] + [lines[3][:9]] + lines[4:]))
    with pytest.raises(InputError, match="line 4: 3 coordinates are due, got 1"):
        initial_mesh.read(str(path))


@pytest.mark.parametrize("ending", [".vtu", ".vtk", ".msh", ".inp", ".bdf", ".mesh", ".ply",
                                    ".obj", ".stl", ".off"])
def test_files_read_by_meshio(tmp_path, ending):
    triangles = triangles_of({"hexahedron": np.arange(8)[None]})
    path = str(tmp_path / f"cube{ending}")
    meshio.Mesh(CUBE, [("triangle", triangles)]).write(path)
    points, found = initial_mesh.read(path)
    assert len(found) == 12 and area(points, found) == pytest.approx(6)


@pytest.mark.parametrize("name, text", [
    ("a.xyz", "unknown format"), ("a.vtu", "does not exist"), (".", "unknown format"),
])
def test_what_is_no_mesh_file(tmp_path, name, text):
    with pytest.raises(InputError, match=text):
        initial_mesh.check_readable(str(tmp_path / name), freecad=False)


def test_files_that_only_freecad_reads(tmp_path):
    path = tmp_path / "a.med"
    path.write_text("")
    with pytest.raises(InputError, match="freecadcmd"):
        initial_mesh.check_readable(str(path), freecad=False)


@pytest.mark.parametrize("wrong, text", [
    (5, "a pair"), ((CUBE,), "a pair"), ("ab", "a pair"),
    ((CUBE[:, :2], [[0, 1, 2]]), "its points"), ((CUBE, [[0, 1]]), "its triangles"),
    ((CUBE, [[0.5, 1, 2]]), "its triangles"), ((CUBE, [["a", "b", "c"]]), "its triangles"),
    ((None, [[0, 1, 2]]), "its points"),
])
def test_the_core_refuses_what_are_no_arrays(wrong, text):
    with pytest.raises(core.InvalidInput, match=text):
        core.Settings(size=1, first_height=0.1, initial_mesh=wrong)

"""OpenFOAM's polyMesh, read back strictly by the rules of OpenFOAM's user guide."""
import re

import core_meshes
import numpy as np
import pytest
from advlayers.errors import InputError
from advlayers.extrusion import Extrusion, extrude
from advlayers.formats import mesh_parts, polymesh
from cell_measures import under

GROUPS = {"far wall": ["Edge1", "Edge3"], "Symmetry": ["Edge2"]}


def read_list(path):
    """The header's words, and what stands between the outer brackets."""
    text = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
    header, rest = re.match(r"\s*FoamFile\s*\{(.*?)\}(.*)", text, re.S).groups()
    words = dict(line.split(None, 1) for line in header.replace(";", "").split("\n") if
                 line.strip())
    count, body = re.match(r"\s*(\d+)\s*\((.*)\)\s*$", rest, re.S).groups()
    return words, int(count), body


class PolyMesh:
    def __init__(self, folder):
        words, count, body = read_list(folder / "points")
        assert words["class"].strip() == "vectorField"
        self.points = np.array([row.split() for row in re.findall(r"\(([^)]*)\)", body)], float)
        assert self.points.shape == (count, 3)
        words, count, body = read_list(folder / "faces")
        assert words["class"].strip() == "faceList"
        self.faces = []
        for size, row in re.findall(r"(\d+)\(([^)]*)\)", body):
            self.faces.append([int(word) for word in row.split()])
            assert len(self.faces[-1]) == int(size)
        assert len(self.faces) == count
        self.owner = self._labels(folder / "owner")
        self.neighbour = self._labels(folder / "neighbour")
        words, count, body = read_list(folder / "boundary")
        assert words["class"].strip() == "polyBoundaryMesh"
        self.patches = {}
        for name, entry in re.findall(r"(\S+)\s*\{(.*?)\}", body, re.S):
            self.patches[name] = dict(re.findall(r"(\w+)\s+([^;]+);", entry))
        assert len(self.patches) == count

    @staticmethod
    def _labels(path):
        words, count, body = read_list(path)
        assert words["class"].strip() == "labelList"
        labels = np.array(body.split(), int)
        assert len(labels) == count
        return labels

    def volumes(self):
        total = np.zeros(self.owner.max() + 1)
        for number, face in enumerate(self.faces):
            cone = under(self.points[[face]])[0]
            total[self.owner[number]] += cone
            if number < len(self.neighbour):
                total[self.neighbour[number]] -= cone
        return total


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    folder = tmp_path_factory.mktemp("case") / "polyMesh"
    result = core_meshes.mesh("square", layers=3)
    made = extrude(mesh_parts.of_mesh(result, GROUPS), Extrusion(thickness=2.0, cells=2))
    polymesh.write(str(folder), made)
    return made, PolyMesh(folder)


def test_faces_come_in_the_upper_triangular_order(written):
    _made, mesh = written
    owner, neighbour = mesh.owner[:len(mesh.neighbour)], mesh.neighbour
    assert (owner < neighbour).all()
    pairs = list(zip(owner.tolist(), neighbour.tolist()))
    assert pairs == sorted(pairs) and len(set(pairs)) == len(pairs)


def test_every_face_looks_out_of_its_owner(written):
    made, mesh = written
    volumes = mesh.volumes()
    assert len(volumes) == sum(map(len, made.of(3)))
    assert (volumes > 0.0).all() and volumes.sum() == pytest.approx(200.0)


def test_coordinates_come_back_as_they_were(written):
    made, mesh = written
    assert np.array_equal(mesh.points, made.nodes)


def test_patches_follow_each_other_with_their_names_and_types(written):
    made, mesh = written
    start = len(mesh.neighbour)
    for entry in mesh.patches.values():
        assert int(entry["startFace"]) == start
        start += int(entry["nFaces"])
    assert start == len(mesh.faces)
    types = {name: entry["type"] for name, entry in mesh.patches.items()}
    assert types == {"far_wall": "wall", "Symmetry": "symmetry", "Edge4": "patch",
                     "front": "empty", "back": "empty"}
    first = int(mesh.patches["Symmetry"]["startFace"])
    faces = mesh.faces[first:first + int(mesh.patches["Symmetry"]["nFaces"])]
    (number,) = [group.parts[0] for group in made.groups if group.name == "Symmetry"]
    block = next(block for block in made.of(2) if block.kind == "quad4")
    assert (sorted(map(sorted, faces))
            == sorted(map(sorted, block.cells[block.part == number].tolist())))


def test_a_surface_is_refused(tmp_path):
    parts = mesh_parts.of_mesh(core_meshes.mesh("box"), {})
    with pytest.raises(InputError, match="needs cells: ask for extrude or volume"):
        polymesh.write(str(tmp_path / "polyMesh"), parts)

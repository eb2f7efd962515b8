"""MSH, Medit, Nastran and UNV files as Gmsh reads them."""
from dataclasses import replace

import numpy as np
import pytest
from agreement import ordered, same_cells, same_points
from mesh_cases import NAMES, case

from advlayers.formats import bdf, medit, msh, unv

gmsh = pytest.importorskip("gmsh")
KINDS = {1: "line2", 8: "line3", 2: "tri3", 9: "tri6", 3: "quad4", 16: "quad8", 10: "quad9",
         4: "tet4", 11: "tet10", 7: "pyramid5", 6: "prism6", 5: "hex8", 19: "pyramid13",
         18: "prism15", 17: "hex20"}
# Gmsh's order of the nodes of second order to that of mesh_parts.
ORDERS = {"tet10": [0, 1, 2, 3, 4, 5, 6, 7, 9, 8],
          "pyramid13": [0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12],
          "prism15": [0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11],
          "hex20": [0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15]}


@pytest.fixture
def model():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    yield gmsh.model
    gmsh.finalize()


def points_of(model, count):
    tags, coordinates, _ = model.mesh.getNodes()
    points = np.empty((count, 3))
    assert sorted(tags.tolist()) == list(range(1, count + 1))
    points[np.asarray(tags, int) - 1] = np.reshape(coordinates, (-1, 3))
    return points


def cells_of(model, dimension=-1, tag=-1):
    found = {}
    for kind, _tags, nodes in zip(*model.mesh.getElements(dimension, tag)):
        name = KINDS[kind]
        size = {"line2": 2, "line3": 3}.get(name) or int(name[-2:] if name[-2:].isdigit()
                                                         else name[-1])
        rows = np.reshape(nodes, (-1, size)).astype(int) - 1
        found[name] = rows[:, ORDERS[name]] if name in ORDERS else rows
    return found


@pytest.mark.parametrize("version", msh.VERSIONS)
@pytest.mark.parametrize("name", NAMES)
def test_msh(model, tmp_path, name, version):
    parts = case(name)
    path = str(tmp_path / "mesh.msh")
    msh.write(path, parts, version)
    gmsh.open(path)
    same_points(parts, points_of(model, len(parts.nodes)))
    same_cells(parts, cells_of(model), [1, 2, 3])
    for dimension in (1, 2, 3):
        names = {}
        for _dimension, physical in model.getPhysicalGroups(dimension):
            for entity in model.getEntitiesForPhysicalGroup(dimension, physical):
                names.setdefault(int(entity), []).append(
                    model.getPhysicalName(dimension, physical))
        owners = {number: owner.replace(" ", "_")
                  for number, owner in parts.owners(dimension).items()}
        if version == "2.2":
            assert {number: found[0] for number, found in names.items()} == owners
        assert set(names) == set(owners)
        for number, owner in owners.items():
            assert owner in names[number]
            blocks = {}
            for block in parts.of(dimension):
                blocks.setdefault(block.kind, []).append(block.cells[block.part == number])
            seen = cells_of(model, dimension, number)
            for kind, rows in blocks.items():
                rows = np.concatenate(rows)
                assert np.array_equal(ordered(seen.get(kind, rows[:0])), ordered(rows))
        if version == "4.1":
            for entry in parts.groups:
                if entry.dimension == dimension:
                    plain = entry.name.replace(" ", "_")
                    assert all(plain in names[number] for number in entry.parts)


@pytest.mark.parametrize("name", ["extruded", "extruded second", "turned second", "filled",
                                  "filled second"])
def test_jacobians_are_positive(model, tmp_path, name):
    path = str(tmp_path / "mesh.msh")
    msh.write(path, case(name))
    gmsh.open(path)
    for kind in model.mesh.getElementTypes(3):
        points, _weights = model.mesh.getIntegrationPoints(kind, "Gauss4")
        _jacobians, determinants, _at = model.mesh.getJacobians(kind, points)
        assert len(determinants) and min(determinants) > 0.0


@pytest.mark.parametrize("name", [
    name for name in NAMES if "second" not in name and name != "nine"])
@pytest.mark.parametrize("ending", ["mesh", "bdf", "unv"])
def test_other_formats(model, tmp_path, name, ending):
    """Gmsh 4.8 reads neither prisms nor pyramids of Medit's files, no lines of Nastran's and no
    groups of UNV files; these have no pyramids at all."""
    parts = case(name)
    if ending in ("mesh", "unv"):
        missing = {"mesh": ("pyramid5", "prism6"), "unv": ("pyramid5",)}[ending]
        parts = parts.with_blocks(block for block in parts.blocks if block.kind not in missing)
        used = np.unique(np.concatenate([block.cells.ravel() for block in parts.blocks]))
        assert np.array_equal(used, np.arange(len(used)))  # what is left out had the last nodes
        parts = replace(parts, nodes=parts.nodes[:len(used)])
    path = str(tmp_path / f"mesh.{ending}")
    {"mesh": medit, "bdf": bdf, "unv": unv}[ending].write(path, parts)
    gmsh.open(path)
    same_points(parts, points_of(model, len(parts.nodes)), digits=10 if ending == "bdf" else 17)
    seen = cells_of(model)
    dimensions = [1, 2, 3]
    if ending == "bdf":
        seen.pop("line2", None)
        dimensions = [parts.dimension]
    same_cells(parts, seen, dimensions)

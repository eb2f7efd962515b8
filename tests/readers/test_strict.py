"""Files for which the readers here are written from the formats' descriptions."""
import numpy as np
import pytest
from agreement import (
    cells_of, corners, group, ordered, owned, same_cells, same_points, signed_volume)
from mesh_cases import NAMES, case

import strict
from advlayers.formats import bdf, obj, plane, stl, su2, ugrid


@pytest.mark.parametrize("name", ["plane", "extruded", "filled"])
def test_su2(tmp_path, name):
    parts = case(name)
    path = str(tmp_path / "mesh.su2")
    su2.write(path, parts)
    dimension, points, cells, markers = strict.su2(path)
    assert dimension == parts.dimension
    if dimension == 2:
        parts = plane.turned_up(parts, (0, 1))
        assert np.array_equal(points, parts.nodes[:, :2])
        for rows in cells.values():
            x = points[np.array(rows)]
            ahead = np.roll(x, -1, axis=1)
            assert ((x[..., 0] * ahead[..., 1] - x[..., 1] * ahead[..., 0]).sum(axis=1) > 0).all()
    else:
        same_points(parts, points)
        for kind, rows in cells.items():
            assert (signed_volume(points, kind, rows) > 0.0).all()
    same_cells(parts, cells, [dimension])
    names = {number: set(found) for number, found in owned(parts, dimension - 1).items()}
    assert set(markers) == {name.replace(" ", "_") for name in names}
    for name, numbers in names.items():
        wanted = cells_of(parts, dimension - 1, numbers)
        assert set(markers[name.replace(" ", "_")]) == set(wanted)
        for kind, rows in wanted.items():
            assert np.array_equal(ordered(markers[name.replace(" ", "_")][kind]), ordered(rows))


def test_su2_has_no_marker_inside(tmp_path):
    """A line between two faces is no border."""
    from advlayers.formats.mesh_parts import Block, MeshParts

    nodes = np.array([[x, y, 0.0] for y in (0, 1) for x in (0, 1, 2)])
    quads = np.array([[0, 1, 4, 3], [1, 2, 5, 4]], np.int32)
    lines = np.array([[1, 4], [0, 1]], np.int32)
    parts = MeshParts(nodes, (Block("quad4", quads, np.array([1, 2], np.int32)),
                              Block("line2", lines, np.array([7, 8], np.int32))))
    path = str(tmp_path / "mesh.su2")
    su2.write(path, parts)
    assert list(strict.su2(path)[3]) == ["Edge8"]


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_su2_of_any_plane(tmp_path, axis):
    parts = case("plane")
    from dataclasses import replace

    turned = replace(parts, nodes=np.roll(parts.nodes, axis + 1, axis=1))
    path = str(tmp_path / "mesh.su2")
    su2.write(path, turned)
    _dimension, points, cells, _markers = strict.su2(path)
    for rows in cells.values():
        x = points[np.array(rows)]
        ahead = np.roll(x, -1, axis=1)
        assert ((x[..., 0] * ahead[..., 1] - x[..., 1] * ahead[..., 0]).sum(axis=1) > 0).all()


@pytest.mark.parametrize("ending", [".ugrid", ".b8.ugrid", ".lb8.ugrid"])
@pytest.mark.parametrize("name", ["solid", "facets", "extruded", "filled"])
def test_ugrid(tmp_path, name, ending):
    parts = case(name)
    path = str(tmp_path / f"mesh{ending}")
    ugrid.write(path, parts)
    points, cells, surfaces = strict.ugrid(path)
    same_points(parts, points)
    # The base of AFLR's pyramid goes around nodes 1, 4, 5, 2, and its apex is 3.
    cells["pyramid5"] = cells["pyramid5"][:, [0, 3, 4, 1, 2]]
    same_cells(parts, cells, [2, 3])
    names = strict.mapbc(str(tmp_path / "mesh.mapbc"))
    wanted = owned(parts, 2)
    assert sorted(names) == list(range(1, len(wanted) + 1))
    for number, (_condition, name) in names.items():
        owner = name if name in wanted else name.replace("_", " ")
        for kind, rows in cells_of(parts, 2, wanted[owner]).items():
            assert np.array_equal(ordered(cells[kind][surfaces[kind] == number]), ordered(rows))


@pytest.mark.parametrize("name", [name for name in NAMES if name != "nine"])
def test_bdf(tmp_path, name):
    parts = case(name)
    path = str(tmp_path / "mesh.bdf")
    bdf.write(path, parts)
    points, cells, plotted, names, sets = strict.bdf(path)
    same_points(parts, points, digits=10)
    same_cells(parts, {kind: [row[2] for row in rows] for kind, rows in cells.items()},
               [parts.dimension])
    owner = {}
    for kind, rows in cells.items():
        for element, number, nodes in rows:
            owner[element] = number
            assert names[number] == parts.name(parts.dimension, number)
    for entry in parts.groups:
        kind = 2 if entry.dimension == parts.dimension else 1
        members = sets[entry.name, kind]
        if kind == 2:
            assert set(members) == {e for e, number in owner.items() if number in entry.parts}
        else:
            rows = cells_of(parts, entry.dimension, entry.parts).values()
            assert set(members) == {int(n) + 1 for row in rows for n in row.ravel()}
    if parts.dimension == 2:
        wanted = cells_of(parts, 1, parts.grouped(1))
        lines = [corners(kind, rows) for kind, rows in wanted.items()]
        assert sorted(map(sorted, plotted)) == sorted(
            sorted(line) for rows in lines for line in rows.tolist())


@pytest.mark.parametrize("name", ["solid", "plane", "facets"])
def test_obj(tmp_path, name):
    parts = case(name)
    path = str(tmp_path / "mesh.obj")
    obj.write(path, parts)
    points, cells = strict.obj(path)
    same_points(parts, points)
    for owner, numbers in owned(parts, 2).items():
        for kind, rows in cells_of(parts, 2, numbers).items():
            assert np.array_equal(ordered(cells[owner, rows.shape[1]]), ordered(rows)), kind
    for entry in parts.groups:
        if entry.dimension == 1:
            rows = cells_of(parts, 1, entry.parts)["line2"]
            assert np.array_equal(
                ordered(cells[entry.name.replace(" ", "_"), 2]), ordered(rows))


@pytest.mark.parametrize("name", ["solid", "plane", "facets"])
def test_stl(tmp_path, name):
    parts = case(name)
    path = str(tmp_path / "mesh.stl")
    stl.write(path, parts)
    solids = strict.stl(path)
    assert set(solids) == set(owned(parts, 2))
    exact = set(map(tuple, parts.nodes.tolist()))
    for owner, numbers in owned(parts, 2).items():
        points, normals = solids[owner]
        assert set(map(tuple, points.reshape(-1, 3).tolist())) <= exact
        wanted = np.zeros(3)
        for kind, rows in cells_of(parts, 2, numbers).items():
            x = parts.nodes[rows]
            wanted += (np.cross(x[:, 2] - x[:, 0], x[:, -1] - x[:, 1]).sum(axis=0) / 2
                       if kind == "quad4" else
                       np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]).sum(axis=0) / 2)
        areas = np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]) / 2
        assert np.allclose(areas.sum(axis=0), wanted, atol=1e-9)
        assert (np.einsum("ij,ij->i", areas, normals) > 0.0).all()


def test_groups_are_what_they_were_asked_for():
    """The cases themselves: a group of several faces, one of edges, one of both."""
    parts = case("solid")
    assert group(parts, "inlet", 2) == (1, 2) and group(parts, "tip", 1) == (1,)

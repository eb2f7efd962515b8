"""Closed meshes filled with cells: upright, within the very nodes of the surface, judged."""
import core_meshes
import numpy as np
import pytest
from advlayers.errors import InputError
from advlayers.formats import mesh_parts
from advlayers.volume import fill as fill_module
from advlayers.volume.fill import VolumeFill
from advlayers.volume.programs import gmsh, python_with_netgen
from cell_measures import border, same_turn, volumes

GROUPS = {"inlet": ["Face1"], "rim": ["Edge1"]}
PROGRAMS = [pytest.param("gmsh", marks=pytest.mark.skipif(not gmsh(), reason="needs Gmsh")),
            pytest.param("netgen", marks=pytest.mark.skipif(not python_with_netgen(),
                                                            reason="needs Netgen"))]


def surface(name, **settings):
    result = core_meshes.mesh(name, **{"size": 2.0, "first_height": 0.5, "layers": 2, **settings})
    return mesh_parts.of_mesh(result, GROUPS)


def filled(name, program="any", quads="split", **settings):
    model = core_meshes.model(name)
    parts = surface(name, **settings)
    return parts, VolumeFill(2.0, program, quads).fill(parts, model.solids, name, model.project)


def check_filled(parts, made):
    corners = len(parts.nodes)
    assert np.array_equal(made.nodes[:corners], parts.nodes)
    outside = border(made)
    rows = [tuple(row) for block in made.of(2) for row in block.cells.tolist()]
    assert len(rows) == len(outside)
    assert all(same_turn(row, outside[tuple(sorted(row))]) for row in rows)
    for block in made.of(3):
        assert (volumes(made.nodes, block.kind, block.cells) > 0.0).all()


@pytest.mark.parametrize("program", PROGRAMS)
@pytest.mark.parametrize("name", ["box", "bracket", "drilled_plate"])
def test_cells_are_upright_and_fill_the_skin(name, program):
    parts, result = filled(name, program)
    check_filled(parts, result.parts)
    total = sum(volumes(result.parts.nodes, block.kind, block.cells).sum()
                for block in result.parts.of(3))
    assert total == pytest.approx(core_meshes.SOLIDS[name][4], rel=0.02)
    assert result.figures["volume"] == pytest.approx(total)
    assert {group.name: group.parts for group in result.parts.groups if group.dimension == 3} == {
        "Volume": (1,)}
    assert {group.name for group in result.parts.groups} == {"inlet", "rim", "Volume"}


@pytest.mark.skipif(not gmsh(), reason="needs Gmsh")
def test_quads_are_kept_with_a_pyramid_each():
    parts, result = filled("box", "gmsh", "keep")
    check_filled(parts, result.parts)
    count = {block.kind: len(block) for block in result.parts.blocks}
    quads = sum(len(block) for block in parts.of(2) if block.kind == "quad4")
    assert count["quad4"] == count["pyramid5"] == result.figures["pyramids"] == quads > 0


def test_thin_quads_cannot_be_kept():
    with pytest.raises(InputError, match="cannot be kept: one is .* times as long as high"):
        filled("box", "gmsh", "keep", first_height=0.02)


def ten_node_jacobians(nodes, cells):
    """(t, 10) determinants at the nodes, with the side of the first three nodes seen from inside
    counter-clockwise."""
    sides = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
    places = [np.eye(4)[k] for k in range(4)] + [(np.eye(4)[a] + np.eye(4)[b]) / 2
                                                 for a, b in sides]
    found = []
    for place in places:
        slopes = np.zeros((len(cells), 4, 3))
        for k in range(4):
            slopes[:, k] += (4 * place[k] - 1) * nodes[cells[:, k]]
        for number, (a, b) in enumerate(sides):
            slopes[:, a] += 4 * place[b] * nodes[cells[:, 4 + number]]
            slopes[:, b] += 4 * place[a] * nodes[cells[:, 4 + number]]
        found.append(np.linalg.det(slopes[:, 1:] - slopes[:, :1]))
    return np.array(found).T


@pytest.mark.parametrize("program", PROGRAMS)
@pytest.mark.parametrize("name", ["sphere", "drilled_plate"])
def test_second_order_keeps_to_the_shape(name, program):
    parts, result = filled(name, program, order=2)
    made = result.parts
    kinds = {block.kind: block for block in made.blocks}
    assert set(kinds) - {"line3"} == {"tri6", "tet10"}
    assert (ten_node_jacobians(made.nodes, kinds["tet10"].cells) > 0.0).all()
    if name == "sphere" and not result.figures["mid_nodes_off_shape"]:
        on_skin = np.unique(kinds["tri6"].cells)
        assert np.abs(np.linalg.norm(made.nodes[on_skin], axis=1) - 6.0).max() < 1e-9 * 20
    corners = np.unique(np.concatenate([block.cells[:, :3].ravel() for block in parts.of(2)]))
    assert np.array_equal(made.nodes[corners], parts.nodes[corners])


def test_an_open_surface_is_refused():
    parts = mesh_parts.of_mesh(core_meshes.mesh("square"), {})
    with pytest.raises(InputError, match="square is not closed: 40 sides of elements"):
        VolumeFill(1.0).fill(parts, [], "square")


def test_cells_without_volume_are_refused():
    cells = fill_module.Cells(
        np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0.0]]),
        np.array([[0, 1, 2, 3], [0, 1, 2, 4], [0, 1, 2, 3]]), np.zeros((0, 5), int),
        np.ones(3, int), np.zeros(0, int))
    with pytest.raises(InputError, match="1 of 3 cells have no volume, or a negative one"):
        VolumeFill._upright(cells, "box")


@pytest.mark.skipif(not gmsh(), reason="needs Gmsh")
def test_too_many_slivers_are_refused():
    parts = surface("box", first_height=0.15, layers=3)
    with pytest.raises(InputError, match="have an angle below 5 degrees"):
        VolumeFill(2.0, "gmsh", most_slivers=0.0).fill(parts, [], "box")


def test_a_program_that_is_not_there(monkeypatch):
    monkeypatch.setattr(fill_module, "gmsh", lambda: "")
    monkeypatch.setattr(fill_module, "python_with_netgen", lambda: "")
    with pytest.raises(InputError, match="Neither Gmsh nor Netgen is installed"):
        VolumeFill(2.0).fill(surface("box"), [], "box")
    with pytest.raises(InputError, match="is not installed: netgen"):
        VolumeFill(2.0, "netgen").fill(surface("box"), [], "box")

"""Mid nodes: on the exact shape, shared by neighbours, and elements sound at all of their nodes."""
import advlayers_core as core
import numpy as np
import pytest
from core_meshes import SOLIDS, mesh, mesher

CURVED = {"sphere": 6.0, "cylinder": 5.0}


@pytest.fixture(scope="module", params=sorted(SOLIDS))
def solid(request):
    return request.param


@pytest.fixture(scope="module")
def curved(solid):
    return mesh(solid, order=2)


def all_nodes(result):
    return np.concatenate([result.nodes, result.mid_nodes])


def sides_and_mids(result):
    """(m, 3): the ends of each side of each element, ascending, and its mid node."""
    rows = []
    for cells, mids in ((result.quads, result.mids_of_quad),
                        (result.triangles, result.mids_of_triangle)):
        for k in range(cells.shape[1]):
            ends = np.sort(cells[:, [k, (k + 1) % cells.shape[1]]], axis=1)
            rows.append(np.column_stack([ends, mids[:, k]]))
    return np.concatenate(rows)


def test_each_mesh_edge_has_one_mid_node(curved):
    rows = np.unique(sides_and_mids(curved), axis=0)
    first = len(curved.nodes)
    assert sorted(rows[:, 2]) == list(range(first, first + len(curved.mid_nodes)))
    assert len(np.unique(rows[:, :2], axis=0)) == len(rows)


def test_the_corners_are_those_of_first_order(solid, curved):
    straight = mesh(solid)
    assert np.array_equal(straight.nodes, curved.nodes)
    assert np.array_equal(straight.quads, curved.quads)
    for nothing in (straight.mid_nodes, straight.mids_of_quad, straight.mids_of_segment):
        assert len(nothing) == 0


def test_segments_on_cad_edges_have_the_mid_nodes_of_the_elements(curved):
    mid_of = {(a, b): mid for a, b, mid in sides_and_mids(curved).tolist()}
    assert sorted(curved.mids_of_segment) == sorted(curved.edge_segments)
    for edge, segments in curved.edge_segments.items():
        expected = [mid_of[tuple(sorted(pair))] for pair in segments.tolist()]
        assert curved.mids_of_segment[edge].tolist() == expected


def test_mid_nodes_lie_in_the_middle(curved):
    """Of a curve that turns by no more than its chord allows."""
    x = all_nodes(curved)
    rows = sides_and_mids(curved)
    a, b, mid = (x[rows[:, k]] for k in range(3))
    one, other = np.linalg.norm(mid - a, axis=1), np.linalg.norm(mid - b, axis=1)
    assert (np.abs(one - other) <= 0.1 * (one + other)).all()


@pytest.mark.parametrize("settings", [{}, {"first_height": 0.001, "layers": 10}],
                         ids=["thick", "thin"])
@pytest.mark.parametrize("name", ["drilled_plate", "cylinder", "sphere", "torus", "cone"])
def test_mid_nodes_lie_on_the_shape(name, settings):
    result = mesh(name, order=2, **settings)
    assert "mid-nodes-off-cad" not in {entry["code"] for entry in result.diagnostics}
    for face in np.unique(np.concatenate([result.face_of_quad, result.face_of_triangle])):
        ids = np.unique(np.concatenate([result.mids_of_quad[result.face_of_quad == face].ravel(),
                                        result.mids_of_triangle[result.face_of_triangle == face]
                                        .ravel()]))
        x = all_nodes(result)[ids]
        assert off_surface(name, x).min(axis=1).max() < 1e-9 * 20


def off_surface(name, x):
    """(n, k) distances from the surfaces that the solid is made of [mm]."""
    radius = np.hypot(x[:, 0], x[:, 1])
    levels = {"drilled_plate": [0.0, 4.0], "cylinder": [0.0, 12.0], "cone": [0.0, 8.0]}
    off = [np.abs(x[:, 2] - z) for z in levels.get(name, [])]
    if name == "sphere":
        off.append(np.abs(np.linalg.norm(x, axis=1) - 6.0))
    if name == "cylinder":
        off.append(np.abs(radius - 5.0))
    if name == "torus":
        off.append(np.abs(np.hypot(radius - 10.0, x[:, 2]) - 3.0))
    if name == "cone":
        off.append(np.abs(radius - (5.0 - 3.0 / 8.0 * x[:, 2])))
    if name == "drilled_plate":
        off += [np.abs(x[:, 0] - p) for p in (0.0, 20.0)] + [np.abs(x[:, 1] - p) for p in (0, 12.0)]
        off.append(np.abs(np.hypot(x[:, 0] - 8.0, x[:, 1] - 6.0) - 3.0))
    return np.array(off).T


def quad_jacobians(x, quads, mids):
    """(q, 8) at the nodes, along the straight quad's normal, as a part of the straight quad's."""
    corners, straight = x[quads], (x[quads] + np.roll(x[quads], -1, axis=1)) / 2
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    u, v = np.array([-1, 1, 1, -1.0]), np.array([-1, -1, 1, 1.0])
    found = []
    for s, t in [*zip(u, v), (0, -1), (1, 0), (0, 1), (-1, 0)]:
        along_s = np.append(u * (1 + v * t) * (2 * u * s + v * t) / 4,
                            [-s * (1 - t), (1 - t * t) / 2, -s * (1 + t), (t * t - 1) / 2])
        along_t = np.append(v * (1 + u * s) * (2 * v * t + u * s) / 4,
                            [(s * s - 1) / 2, -t * (1 + s), (1 - s * s) / 2, -t * (1 - s)])
        pair = []
        for middle in (straight, x[mids]):
            nodes = np.concatenate([corners, middle], axis=1)
            pair.append(np.einsum("ij,ij->i", np.cross(
                np.einsum("k,ikj->ij", along_s, nodes), np.einsum("k,ikj->ij", along_t, nodes)),
                normals))
        found.append(pair[1] / pair[0])
    return np.array(found).T


@pytest.mark.parametrize("height", [0.3, 0.01, 0.0005])
def test_layers_thinner_than_the_bend_of_their_edges_stay_sound(height):
    result = mesh("drilled_plate", order=2, first_height=height, layers=6)
    x = all_nodes(result)
    bend = np.linalg.norm(x[result.mids_of_quad]
                          - (x[result.quads] + np.roll(x[result.quads], -1, axis=1)) / 2, axis=2)
    assert bend.max() > 0.01  # what straight edges beside the hole would have cut
    assert (quad_jacobians(x, result.quads, result.mids_of_quad) > 0.0999).all()


def test_bends_that_nothing_follows_are_drawn_back_and_told():
    """A coarse edge of a cone whose one layer is thinner than the edge bends."""
    result = mesh("cone", order=2, size=6.0, curvature_angle=90.0,
                  walls=[{"edges": ["Edge1"], "first_height": 0.02, "layers": 1}])
    x = all_nodes(result)
    assert (quad_jacobians(x, result.quads, result.mids_of_quad) > 0.0999).all()
    told = [entry for entry in result.diagnostics if entry["code"] == "mid-nodes-off-cad"]
    assert len(told) == 1 and told[0]["severity"] == "warning"
    off = off_surface("cone", x[len(result.nodes):]).min(axis=1)
    # One drawn back from the rim within the bottom is on the shape still.
    assert 0 < (off > 1e-9).sum() <= int(told[0]["values"][0])


def test_any_number_of_threads_gives_the_same_bits():
    one, two = (mesh("drilled_plate", order=2, threads=n) for n in (1, 2))
    assert np.array_equal(one.mid_nodes, two.mid_nodes)
    assert np.array_equal(one.mids_of_quad, two.mids_of_quad)


def test_other_orders_are_refused():
    with pytest.raises(core.InvalidInput, match="order must be >= 1 and <= 2, got 3"):
        mesher("box", order=3)

"""Jobs that start from an existing mesh in a file."""
import json

import meshio
import numpy as np
import pytest

from batch_runs import files

GOOD = {"input": "box.step", "size": 5.0, "first_height": 0.5, "layers": 1}


def box_mesh(step=2.5):
    """Quads on the faces of the box of 30 x 20 x 10 mm."""
    size, points, quads = np.array([30.0, 20.0, 10.0]), [], []
    for axis in range(3):
        across = [k for k in range(3) if k != axis]
        counts = (size[across] / step).astype(int)
        for level in (0.0, size[axis]):
            start = sum(len(part) for part in points)
            i, j = np.meshgrid(*(np.arange(n + 1) for n in counts), indexing="ij")
            grid = np.full((i.size, 3), level)
            grid[:, across] = step * np.column_stack([i.ravel(), j.ravel()])
            number = start + np.arange(i.size).reshape(i.shape)
            points.append(grid)
            quads.append(np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:],
                                   number[:-1, 1:]], axis=-1).reshape(-1, 4))
    return np.concatenate(points), np.concatenate(quads)


@pytest.fixture
def start(tmp_path):
    """Writes a mesh to start from."""
    def write(name="start.vtu", moved=(0.0, 0.0, 0.0)):
        points, quads = box_mesh()
        meshio.Mesh(points + moved, [("quad", quads)]).write(tmp_path / name)
        return name
    return write


def test_it_is_followed(batch, job, tmp_path, start):
    reports = []
    for initial in (None, start()):  # a relative path is relative to the job
        ran = batch(job(**GOOD, initial_mesh=initial, outputs=["box.vtu"], report="report.json"))
        assert ran.status == 0, ran.stderr
        with open(tmp_path / "report.json") as file:
            reports.append(json.load(file))
    plain, followed = reports
    codes = [entry["code"] for entry in followed["diagnostics"]]
    assert codes.count("initial-mesh") == 1
    assert followed["nodes"] > 2 * plain["nodes"] and followed["inverted"] == 0


def test_what_does_not_fit_is_one_line_each_and_nothing_is_written(batch, job, tmp_path, start):
    beside = start("beside.vtu", moved=(100.0, 0.0, 0.0))
    points, _quads = box_mesh()
    meshio.Mesh(points, [("vertex", np.arange(len(points))[:, None])]).write(
        tmp_path / "points.vtu")
    texts = {beside: "mm off the shape", "points.vtu": "has no surface elements"}
    for ending in ("vtu", "unv", "msh", "stl", "inp"):
        texts[f"damaged.{ending}"] = f"damaged.{ending}"
        (tmp_path / f"damaged.{ending}").write_text("no mesh\n    -1\n  2412\nsix\n")
    jobs = [job(f"{name}.json", **GOOD, initial_mesh=name, outputs=["box.vtu"],
                report="report.json") for name in texts]
    before = files(tmp_path)
    ran = batch(*jobs)
    assert ran.status == 1 and len(ran.lines) == len(texts), ran.stderr
    for line, text in zip(ran.lines, texts.values()):
        assert "initial_mesh" in line and text in line
    assert files(tmp_path) == before


def test_it_is_not_overwritten(batch, job, start):
    path = start()
    ran = batch(job(**GOOD, initial_mesh=path, outputs=[path]))
    assert ran.status == 1 and "would overwrite the initial mesh" in ran.lines[0]


def test_a_document_holds_it(batch, job, tmp_path, start):
    if not batch.freecad:
        pytest.skip("documents need FreeCAD")
    ran = batch(job("first.json", **GOOD, initial_mesh=start(), outputs=["box.FCStd"]),
                job("again.json", input=str(tmp_path / "box.FCStd"), report="report.json"))
    assert ran.status == 0, ran.stderr

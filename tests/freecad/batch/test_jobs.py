"""Whole jobs: what they write, what they say, and how they end."""
import json
import os
import shutil
import signal
import subprocess
import zipfile

import meshio
import numpy as np
import pytest

from batch_runs import BATCH, HOSTS, ROOT, files, run

BOX = {"size": 5.0, "first_height": 0.5, "growth": 1.3}
REPORT_KEYS = {
    "version", "input", "nodes", "quads", "triangles", "quad_percent", "layer_quad_percent",
    "core_quad_percent", "angles_45_135_percent", "angles_below_20_percent",
    "angles_above_160_percent", "min_angle", "max_angle", "inverted", "patches", "walls",
    "diagnostics", "seconds",
}
SECONDS = {"read", "boundary", "triangulate", "layers", "core", "mesh_object", "write", "total"}


def check_box(folder, report_name="r.json", vtu="box.vtu"):
    """The report and the mesh of the box belong together and to the box."""
    report = json.loads((folder / report_name).read_text())
    assert set(report) == REPORT_KEYS and set(report["seconds"]) == SECONDS
    mesh = meshio.read(folder / vtu)
    counts = {block.type: len(block.data) for block in mesh.cells}
    assert counts.get("quad", 0) == report["quads"] > 0
    assert counts.get("triangle", 0) == report["triangles"]
    assert len(mesh.points) == report["nodes"]
    assert report["inverted"] == 0
    faces = [values for block, values in zip(mesh.cells, mesh.cell_data["face"])
             if block.type != "line"]
    assert set(np.concatenate(faces)) == {1, 2, 3, 4, 5, 6}
    assert np.ptp(mesh.points, axis=0) == pytest.approx([30.0, 20.0, 10.0], abs=1e-9)
    assert euler_number(mesh) == 2
    seconds = report["seconds"]
    parts = sum(seconds[key] for key in SECONDS - {"total"})
    assert all(value >= 0 for value in seconds.values()) and parts <= seconds["total"] + 1e-3
    return report


def euler_number(mesh):
    """Of a closed surface, every edge of which has exactly two elements."""
    edges = {}
    surface = [block for block in mesh.cells if block.type != "line"]
    for block in surface:
        for cell in block.data.tolist():
            for a, b in zip(cell, cell[1:] + cell[:1]):
                edges[(a, b)] = edges.get((a, b), 0) + 1
    assert set(edges.values()) == {1}
    assert all((b, a) in edges for a, b in edges)
    return len(mesh.points) - len(edges) // 2 + sum(len(block.data) for block in surface)


def test_faces_that_share_no_edge_are_sewn(batch, job, tmp_path):
    ran = batch(job(input="loose.brep", **BOX, sew_tolerance=0.001, outputs=["box.vtu", "box.unv"],
                    groups={"all around": ["Edge1", "Edge24"]}, report="r.json"))
    assert ran.status == 0, ran.stderr
    (entry,) = [entry for entry in check_box(tmp_path)["diagnostics"] if entry["code"] == "sewn"]
    assert "joined 24 edges; free edges left: 0" in entry["text"]


@pytest.mark.parametrize("name", ["box.step", "box.brep"])
def test_a_box(batch, job, tmp_path, name):
    ran = batch(job(input=name, **BOX, outputs=["box.vtu", "box.unv"], report="r.json"))
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout
    assert files(tmp_path) == ["box.unv", "box.vtu", "r.json"]
    check_box(tmp_path)


def test_every_format(batch, job, tmp_path):
    """In metres, from one job; what other programs make of the files is tested elsewhere."""
    endings = [".vtu", ".vtk", ".msh", ".inp", ".bdf", ".unv", ".med", ".cgns", ".b8.ugrid",
               ".mesh", ".obj", ".stl", ".ply"]
    ran = batch(job(input="box.step", **BOX, outputs=[f"box{ending}" for ending in endings],
                    scale=0.001, groups={"inlet": ["Face1"]}))
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout
    assert set(files(tmp_path)) == {f"box{ending}" for ending in endings} | {"box.mapbc"}
    points = meshio.read(tmp_path / "box.vtu").points
    assert np.ptp(points, axis=0) == pytest.approx([0.03, 0.02, 0.01], abs=1e-12)


def test_iges_holds_faces_that_do_not_share_their_edges(batch, job, tmp_path):
    ran = batch(job(input="box.iges", **BOX, outputs=["box.vtu"]))
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout
    mesh = meshio.read(tmp_path / "box.vtu")
    assert set(np.concatenate(mesh.cell_data["face"])) == {1, 2, 3, 4, 5, 6}
    assert np.ptp(mesh.points, axis=0) == pytest.approx([30.0, 20.0, 10.0], abs=1e-9)


def test_endings_in_any_case_and_odd_names(batch, job, tmp_path, shapes):
    shutil.copy(shapes / "box.step", shapes / "Käse fünf.StP")
    ran = batch(job(input="Käse fünf.StP", **BOX, outputs=["ü b.VTU"], report="r.json"))
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout
    shutil.move(tmp_path / "ü b.VTU", tmp_path / "box.vtu")
    check_box(tmp_path)


def test_both_hosts_make_the_same_mesh(job, tmp_path):
    reports = []
    for host, command in HOSTS.items():
        ran = run(command + [job(input="box.step", **BOX, outputs=["box.vtu"], report="r.json")])
        assert ran.status == 0
        reports.append(check_box(tmp_path))
    assert reports[0]["walls"] == reports[1]["walls"]
    assert reports[0]["quads"] == reports[1]["quads"]


def test_stl(job, tmp_path):
    ran = run(HOSTS["freecadcmd"] + [job(input="box.stl", **BOX, outputs=["box.vtu"],
                                         report="r.json")])
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout
    mesh = meshio.read(tmp_path / "box.vtu")
    assert set(np.concatenate(mesh.cell_data["face"])) == set(range(1, 13))
    assert euler_number(mesh) == 2


def test_object_of_an_fcstd(job, tmp_path):
    values = {"input": "two.FCStd", "outputs": ["box.vtu"], "report": "r.json"}
    ran = run(HOSTS["freecadcmd"] + [job(**values)])
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout
    mesh, report = meshio.read(tmp_path / "box.vtu"), (tmp_path / "r.json").read_text()
    # The box has more faces than the rod, and it stands where its group puts it.
    assert "Moved" in report
    assert mesh.points[:, 0].min() == pytest.approx(1000.0)
    for name in ("Small", "The rod"):
        ran = run(HOSTS["freecadcmd"] + [job(**values, object=name)])
        assert (ran.status, ran.stderr) == (0, ""), ran.stdout
        assert meshio.read(tmp_path / "box.vtu").points[:, 0].max() < 10.0


def test_faces_and_groups(batch, job, tmp_path):
    ran = batch(job(input="box.step", **BOX, faces=["Face2", "Face5"],
                    groups={"in let": ["Face2"]}, outputs=["box.vtu", "box.unv"]))
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout
    mesh = meshio.read(tmp_path / "box.vtu")
    assert set(np.concatenate(mesh.cell_data["face"])) == {2, 5}
    names = (tmp_path / "box.unv").read_text().split("\n")
    assert "in let" in names and "Face2" in names and "Face1" not in names


def test_a_shortfall_is_an_error_where_strict(batch, job, tmp_path):
    """A hundred layers do not fit on the box; three do."""
    for layers, strict, status in ((100, False, 0), (100, True, 2), (3, True, 0)):
        ran = batch(job(input="box.step", size=1.0, first_height=0.2, growth=1.2, layers=layers,
                        strict=strict, outputs=["box.vtu"], report="r.json"))
        assert (ran.status, ran.stderr) == (status, ""), ran.stdout
        report = json.loads((tmp_path / "r.json").read_text())
        assert {wall["requested_layers"] for wall in report["walls"]} == {layers}
        errors = [entry for entry in report["diagnostics"] if entry["severity"] == "error"]
        assert bool(errors) == (status == 2)
        assert (tmp_path / "box.vtu").exists()


def test_the_same_names_whatever_is_installed(job, tmp_path):
    """An add-on of another version does not get between the script and its own packages."""
    other = tmp_path / "home" / "Mod" / "Other" / "advlayers"
    other.mkdir(parents=True)
    (other / "__init__.py").write_text("raise RuntimeError('the wrong one')\n")
    environment = {**os.environ, "FREECAD_USER_HOME": str(tmp_path / "home"),
                   "PYTHONPATH": str(other.parent)}
    ran = run(HOSTS["freecadcmd"] + [job(input="box.step", **BOX, report="r.json")],
              env=environment)
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout


def test_packages_from_elsewhere_are_refused(job, tmp_path):
    other = tmp_path / "advlayers"
    other.mkdir()
    (other / "__init__.py").write_text("")
    path = job(input="box.step", report="r.json")
    code = (f"import sys, runpy; sys.path.insert(0, {str(tmp_path)!r}); import advlayers; "
            f"sys.argv = [{BATCH!r}, {path!r}]; runpy.run_path({BATCH!r})")
    ran = run(["freecadcmd", "-c", code])
    assert ran.status == 1 and len(ran.lines) == 1 and "was loaded from" in ran.lines[0]
    assert not (tmp_path / "r.json").exists()


def test_a_missing_package_is_named(job, tmp_path):
    (tmp_path / "numpy.py").write_text("raise ModuleNotFoundError(name='numpy')\n")
    ran = run(HOSTS["python"] + [job(input="box.step", **BOX, report="r.json")],
              env={**os.environ, "PYTHONPATH": str(tmp_path)})
    assert (ran.status, ran.lines) == (1, ["advlayers: the Python package numpy is missing"])
    assert not (tmp_path / "r.json").exists()


def test_freecads_own_name_may_come_first(job, tmp_path):
    """FreeCAD 1.0 has it so."""
    path = job(input="box.step", **BOX, report="r.json")
    code = (f"import sys; sys.argv = ['freecadcmd', {BATCH!r}, {path!r}]; "
            f"sys.path.insert(0, {str(ROOT / 'App')!r}); import advlayers_batch")
    ran = run(["freecadcmd", "-c", code])
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout
    assert (tmp_path / "r.json").exists()


def test_ctrl_c(batch, job, tmp_path):
    """Stops a run that would take long, leaves nothing behind."""
    host = HOSTS["freecadcmd" if batch.freecad else "python"]
    path = job(input="box.step", size=0.02, first_height=0.01, growth=1.01,
               max_elements=10**9, max_seconds=1e6, max_memory=1e6,
               outputs=["box.vtu"], report="r.json")
    process = subprocess.Popen(host + [path], stdin=subprocess.DEVNULL, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    for line in process.stdout:
        if line.startswith(path):  # the first progress: it meshes
            break
    process.send_signal(signal.SIGINT)
    _stdout, stderr = process.communicate(timeout=120)
    assert process.returncode == 130
    assert stderr == "advlayers: stopped\n"
    assert files(tmp_path) == []


def test_fcstd_output(job, tmp_path):
    ran = run(HOSTS["freecadcmd"] + [job(
        input="box.step", size=2.0, outputs=["box.FCStd", "box.med", "box.vtu"], report="r.json",
        walls=[{"edges": ["Edge1"], "first_height": 0.25}], groups={"inlet": ["Face1"]})])
    assert (ran.status, ran.stderr) == (0, ""), ran.stdout
    assert files(tmp_path) == ["box.FCStd", "box.med", "box.vtu", "r.json"]
    assert zipfile.ZipFile(tmp_path / "box.FCStd").testzip() is None
    home = tmp_path / "home"
    (home / "Mod").mkdir(parents=True)
    (home / "Mod" / "AdvancingLayers").symlink_to(ROOT)
    note = tmp_path / "seen.json"
    code = f"""
import json, FreeCAD
document = FreeCAD.openDocument({str(tmp_path / "box.FCStd")!r})
mesh = document.getObject("LayerMesh")
groups = [mesh.FemMesh.getGroupName(i) for i in mesh.FemMesh.Groups]
fem = mesh.FemMesh
seen = dict(proxy=type(mesh.Proxy).__name__, state=mesh.State, size=mesh.Size.Value,
            heights=[wall.FirstHeight.Value for wall in mesh.WallList], nodes=fem.NodeCount,
            quads=fem.QuadrangleCount, triangles=fem.TriangleCount, groups=groups,
            faces=len(mesh.Part.Shape.Faces))
json.dump(seen, open({str(note)!r}, "w"))
"""
    opened = run(["freecadcmd", "-c", code], env={**os.environ, "FREECAD_USER_HOME": str(home)})
    assert opened.status == 0, opened.stderr
    seen, report = json.loads(note.read_text()), json.loads((tmp_path / "r.json").read_text())
    assert (seen["proxy"], seen["state"]) == ("LayerMesh", "Up to date")
    assert seen["size"] == 2.0 and 0.25 in seen["heights"] and seen["faces"] == 6
    assert [seen[key] for key in ("nodes", "quads", "triangles")] == [
        report[key] for key in ("nodes", "quads", "triangles")]
    assert {"Face1", "Face6", "Edge1", "Edge12", "inlet"} <= set(seen["groups"])

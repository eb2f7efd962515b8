"""The mesher's loop as Python drives it: reports, threads, stopping, errors."""
import os
import signal
import subprocess
import sys
import threading
import time

import advlayers_core as core
import numpy as np
import pytest
from advlayers.layer_heights import height_errors
from core_meshes import DATA, mesh, mesher, model

FINE = {"size": 0.1, "first_height": 0.01}


def test_reports_name_patch_and_layer():
    run = mesher("box", layers=3)
    reports = list(run)
    result = run.result()
    assert {report.patch for report in reports} == set(range(6))
    assert max(report.layer for report in reports) in (3, 4)
    assert all(set(vars_of) <= {"collapse", "row-end", "close-triangle", "zip", "rung", "fan"}
               for vars_of in (report.events for report in reports))
    assert [patch["faces"] for patch in result.patches] == [[f"Face{k}"] for k in range(1, 7)]


@pytest.mark.parametrize("name", ["box", "cylinder", "drilled_plate"])
def test_threads_do_not_show_in_the_mesh(name):
    one, two, four = (mesh(name, threads=count) for count in (1, 2, 4))
    for other in (two, four):
        assert one.nodes.tobytes() == other.nodes.tobytes()
        assert one.quads.tobytes() == other.quads.tobytes()
        assert one.triangles.tobytes() == other.triangles.tobytes()
        assert one.walls == other.walls and one.diagnostics == other.diagnostics


def test_a_snapshot_is_a_mesh_at_every_layer():
    run = mesher("bracket")
    run.snapshot()
    elements = []
    for _ in run:
        shot = run.snapshot()
        elements.append(len(shot.quads) + len(shot.triangles))
        assert np.array_equal(np.union1d(shot.quads, shot.triangles), np.arange(len(shot.nodes)))
    assert max(elements) > elements[0]
    run.result()
    with pytest.raises(core.InvalidInput, match="snapshot"):
        run.snapshot()


def test_stopping_early_keeps_the_layers_so_far():
    run = mesher("square", size=0.5)
    for report in run:
        if report.layer == 4:
            break
    result = run.result()
    assert result.layer_of_quad.max() == 4
    assert (result.layer_of_quad == 0).any()
    assert list(run) == []


def test_result_is_the_same_object_every_time():
    run = mesher("square")
    assert run.result() is run.result()


@pytest.mark.parametrize("layers", [0, 1, 4])
def test_cancel_from_another_thread_lets_no_work_follow(layers):
    """Judged by what the run still does; how long that takes `./dev bench cancel` measures."""
    context = core.RunContext()
    settings = core.Settings(**FINE, threads=1)
    reached, cancelled = threading.Event(), threading.Event()
    after = []

    def work():
        run = core.Mesher(model("bracket"), settings, context)
        try:
            for _ in range(layers):
                next(run)
            reached.set()
            for _ in run:
                after.append("layer" if cancelled.is_set() else "before")
            run.result()
            after.append("result")
        except core.Cancelled:
            after.append("cancelled")

    thread = threading.Thread(target=work)
    thread.start()
    reached.wait()
    context.cancel()
    cancelled.set()
    thread.join()
    assert after[-1] == "cancelled"
    assert after.count("layer") <= 1  # the one that was at hand
    assert context.progress[0] != "core"


def test_other_threads_run_while_it_meshes():
    """Counted within one call: a core that kept Python's lock would let nobody count there."""
    run = mesher("bracket", size=0.1, first_height=0.01)
    counted = [0]
    stop = threading.Event()

    def count():
        while not stop.wait(0.001):
            counted[0] += 1

    counter = threading.Thread(target=count)
    counter.start()
    most = 0
    for step in (lambda: list(run), run.result):
        before = counted[0]
        step()
        most = max(most, counted[0] - before)
    stop.set()
    counter.join()
    assert most > 2


def test_ctrl_c_interrupts():
    program = (
        "import sys, advlayers_core as core\n"
        "run = core.Mesher(core.read_file(sys.argv[1]),"
        " core.Settings(size=0.03, first_height=0.003))\n"
        "print('ready', flush=True)\n"
        "for report in run: pass\n"
        "run.result()\n")
    child = subprocess.Popen([sys.executable, "-c", program, os.path.join(DATA, "bracket.brep")],
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    child.stdout.readline()
    time.sleep(0.3)
    child.send_signal(signal.SIGINT)
    _, errors = child.communicate(timeout=60)
    assert b"KeyboardInterrupt" in errors, child.returncode


def test_walls_may_be_chosen():
    result = mesh("box", walls=[{"edges": ["Edge1"], "faces": ["Face1"], "layers": 2,
                                 "first_height": 0.2, "growth": 1.5}])
    assert {(wall["edge"], wall["face"]) for wall in result.walls} == {("Edge1", "Face1")}
    wall = result.walls[0]
    assert (wall["first_height"], wall["growth"], wall["layers"]) == (0.2, 1.5, 2)
    assert wall["achieved_first_height"]["mean"] == pytest.approx(0.2, rel=0.02)
    layered = result.face_of_quad[result.layer_of_quad > 0]
    assert set(layered) == {1}


def test_walls_tell_where_their_columns_ended_first():
    result = mesh("bracket", size=5.0, first_height=0.5, growth=1.3)
    low, high = result.nodes.min(axis=0), result.nodes.max(axis=0)
    assert any(wall["stops"] for wall in result.walls)
    for wall in result.walls:
        assert set(wall["first_stops"]) == set(wall["stops"])
        for place in wall["first_stops"].values():
            assert place["layer"] >= 1
            point = np.array(place["point"])
            assert ((low - 1e-9 <= point) & (point <= high + 1e-9)).all()
            assert np.linalg.norm(result.nodes - point, axis=1).min() < 1e-9


@pytest.mark.parametrize("wall, words", [
    ({"first_height": 0.1, "aspect_ratio": 20.0}, "exclude each other"),
    ({"first_height": 0.1, "growth": 1.2, "layers": 3, "thickness": 1.0}, "one too many"),
    ({"thickness": 1e-3}, "less than the first height"),
    ({"height": 0.1}, "unknown key"),
    ({"end_height": -1.0}, "end_height must be > 0 mm"),
])
def test_walls_that_contradict_themselves_are_refused(wall, words):
    with pytest.raises(core.InvalidInput) as error:
        mesh("box", walls=[{"edges": ["Edge1"], **wall}])
    assert words in str(error.value)


@pytest.mark.parametrize("size, words", [
    ({"edges": ["Edge1"], "size": 0.1, "segments": 3}, "exclude each other"),
    ({"faces": ["Face1"], "segments": 3}, "lists none"),
    ({"edges": ["Edge1"]}, "needs a size"),
    ({"edges": ["Edge1"], "both_ends": True, "size": 1.0}, "both_ends needs a cluster"),
    ({"edges": ["Edge99"], "size": 1.0}, "there is no Edge99"),
])
def test_sizes_that_contradict_themselves_are_refused(size, words):
    with pytest.raises(core.InvalidInput) as error:
        mesh("box", sizes=[size])
    assert words in str(error.value)


def test_sizes_and_refinements_are_meshed():
    result = mesh("square", walls=[], sizes=[{"edges": ["Edge1"], "segments": 31}],
                  refinements=[{"point": (5, 5, 0), "size": 0.1, "radius": 1.0}])
    assert len(result.edge_segments[1]) == 31
    finer = np.linalg.norm(result.nodes - (5, 5, 0), axis=1) < 1.0
    assert np.count_nonzero(finer) > 150


@pytest.mark.parametrize("wall", [{"end_height": 0.3}, {"aspect_ratio": 12.0}])
def test_heights_that_vary_are_judged_by_what_was_asked_where(wall):
    result = mesh("square", layers=4, walls=[{"edges": ["Edge1"], **wall}])
    asked = result.walls[0]["first_heights"]
    assert len(asked) == len(result.edge_segments[1]) + 1
    errors = height_errors(result)
    layered = np.concatenate([result.layer_of_quad, result.layer_of_triangle]) > 0
    assert np.nanmax(np.abs(errors[layered])) < 0.02


def test_no_walls_make_an_isotropic_mesh():
    result = mesh("box", walls=[])
    assert result.layer_of_quad.max() == 0
    assert result.figures["quad_percent"] > 95


def test_core_of_triangles_stays_triangles():
    result = mesh("square", core="triangles", walls=[])
    assert len(result.quads) == 0 and len(result.triangles) > 100


def test_faces_may_be_chosen():
    result = mesh("box", faces=["Face2", "Face5"])
    assert set(result.face_of_quad) == {2, 5}
    assert [patch["faces"] for patch in result.patches] == [["Face2"], ["Face5"]]


@pytest.mark.parametrize("settings, word", [
    ({"size": 0}, "size"),
    ({"size": -1}, "size"),
    ({"size": float("nan")}, "size"),
    ({"size": float("inf")}, "size"),
    ({"size": "1"}, "size"),
    ({"size": True}, "size"),
    ({"size": 1j}, "size must be a number, got 1j"),
    ({"size": 10 ** 400}, "size"),
    ({"layers": np.float64(3)}, "layers"),
    ({"first_height": 0}, "first_height"),
    ({"growth": 0.5}, "growth"),
    ({"layers": -1}, "layers"),
    ({"layers": 2.5}, "layers"),
    ({"layers": "many"}, "layers"),
    ({"layers": 10 ** 12}, "layers"),
    ({"feature_angle": 180}, "feature_angle"),
    ({"core": "hexes"}, "core"),
    ({"walls": "none"}, "walls"),
    ({"walls": [{"edges": ["Edge99"]}]}, "Edge99"),
    ({"walls": [{"edges": ["Edge0"]}]}, "Edge0"),
    ({"walls": [{"edges": ["Face1"]}]}, "Face1"),
    ({"walls": [{"edges": []}]}, "edges"),
    ({"walls": [{"edges": ["Edge1"], "height": 1}]}, "height"),
    ({"walls": [{"edges": ["Edge1"], "first_height": 0}]}, "first_height"),
    ({"match": ["Edge13"]}, "Edge13"),
    ({"off": "Edge1"}, "off"),
    ({"faces": ["Face7"]}, "Face7"),
    ({"faces": []}, "faces"),
    ({"threads": -1}, "threads"),
    ({"colour": "blue"}, "colour"),
])
def test_a_wrong_setting_is_named(settings, word):
    with pytest.raises(core.InvalidInput, match=word) as caught:
        mesher("box", **settings)
    assert isinstance(caught.value, ValueError)


@pytest.mark.parametrize("layers", [np.int64(3), np.uint8(3)])
def test_numbers_of_numpy_are_numbers(layers):
    settings = core.Settings(size=np.float32(1.0), first_height=np.float64(0.1), layers=layers)
    assert settings.layers == 3 and settings.size == 1.0


@pytest.mark.parametrize("beyond", [2 ** 32, -2 ** 32, 2 ** 40])
def test_an_index_too_large_for_the_core_is_refused(beyond):
    made = mesh("square", core="triangles")
    triangles = made.triangles if len(made.triangles) else made.quads[:, :3]
    triangles = triangles.astype(np.int64)
    triangles[1, 2] += beyond
    with pytest.raises(core.InvalidInput, match=f"triangle 1 .* has node {triangles[1, 2]}"):
        mesher("square", initial_mesh=(np.asarray(made.nodes), triangles))


def test_size_and_first_height_must_be_given():
    with pytest.raises(core.InvalidInput, match="first_height"):
        core.Settings(size=1.0)


def test_bad_text_and_files_are_refused(tmp_path):
    with pytest.raises(core.InvalidInput):
        core.read_brep("no BREP")
    with pytest.raises(core.InvalidInput, match="missing.step"):
        core.read_file(tmp_path / "missing.step")
    with pytest.raises(core.InvalidInput):
        core.read_file(tmp_path)


def test_a_model_is_kept_alive_by_its_mesher():
    run = core.Mesher(model("box"), core.Settings(size=1.0, first_height=0.1))
    assert sum(1 for _ in run) > 0


def test_a_missing_extension_says_what_to_do(tmp_path):
    package = tmp_path / "advlayers_core"
    package.mkdir()
    source = os.path.join(os.path.dirname(core.__file__), "__init__.py")
    (package / "__init__.py").write_text(open(source, encoding="utf-8").read(), encoding="utf-8")
    child = subprocess.run([sys.executable, "-c", "import advlayers_core"], capture_output=True,
                           env={**os.environ, "PYTHONPATH": str(tmp_path)}, text=True, check=False)
    assert "ImportError" in child.stderr and "./dev install" in child.stderr

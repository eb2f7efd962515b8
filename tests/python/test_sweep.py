"""Sweeps here: what tables and jobs come to, that nothing is done twice, limits, results."""
import csv
import json
import os
import subprocess
import sys
import threading
import time

import pytest

from advlayers.sweep import places, plan, report, row, table
from advlayers.sweep.errors import SweepError
from advlayers.sweep.plan import Limits
from conftest import ROOT
from row_orders import Orders

BOX = os.path.join(ROOT, "tests", "data", "box.brep")
TOP = {"input": BOX, "size": 5.0, "first_height": 0.5, "outputs": ["{name}.vtu"]}


def planned(folder, text, job=None, **limits):
    (folder / "t.csv").write_text(text)
    (folder / "job.json").write_text(json.dumps(job or TOP))
    columns, rows = table.read(str(folder / "t.csv"))
    return columns, plan.plan(columns, rows, str(folder / "job.json"), str(folder / "sweep"),
                              Limits(**limits))


def swept(tasks, workers=2):
    left = [task for task in tasks if not plan.is_done(task)]
    list(places.Here(workers).run([task.order_file for task in left]))
    return len(left)


def test_cells_go_to_their_places(tmp_path):
    job = {**TOP, "walls": [{"edges": ["Edge1"]}, {"edges": ["Edge2"]}], "input": "{shape}.step",
           "outputs": ["{name}-{size}.vtu"]}
    _columns, (task, other) = planned(
        tmp_path, "name,size,walls[1].layers,y_plus.speed,shape,cad.Sheet.chord,growth,info.span\n"
        "a,2.5,3,40,wing,12 mm,,7\nb,4,,,foil,1.5,1.3,8\n", job)
    assert task.job["size"] == 2.5 and "growth" not in task.job
    assert [wall.get("layers") for wall in task.job["walls"]] == [None, 3]
    assert task.job["y_plus"] == {"speed": 40}
    assert task.job["parameters"] == {"Sheet.chord": "12 mm"}
    assert task.job["input"] == str(tmp_path / "wing.step")
    assert task.job["outputs"] == [str(tmp_path / "a-2.5.vtu")]
    assert other.job["growth"] == 1.3 and other.job["parameters"] == {"Sheet.chord": 1.5}


@pytest.mark.parametrize("text, job, said", [
    ("name,sise\na,1\n", TOP, "'sise'"),
    ("name,size\na,1\na,2\n", TOP, "two rows of the name a"),
    ("name,size\na/b,1\n", TOP, "'a/b'"),
    ("name,size\na,1,2\n", TOP, "3 cells"),
    ("name\n", TOP, "no row"),
    ("name,size\na,1\nb,2\n", {**TOP, "outputs": ["same.vtu"]}, "a and b"),
    ("name,size\na,1\n", {**TOP, "outputs": ["{chord}.vtu"]}, "{chord}"),
    ("name,walls[2].layers\na,1\n", {**TOP, "walls": []}, "walls[2].layers"),
])
def test_what_cannot_be_is_named(tmp_path, text, job, said):
    with pytest.raises(SweepError, match=".*" + said.replace("[", r"\[").replace("{", r"\{")):
        planned(tmp_path, text, job)


def test_rows_are_meshed_once_and_again_when_something_has_changed(tmp_path):
    text = "name,size,growth\na,5,1.3\nb,4,1.3\nc,5,-1\n"
    columns, tasks = planned(tmp_path, text)
    assert swept(tasks) == 3
    lines = report.results(columns, tasks)
    assert [line["state"] for line in lines] == ["meshed", "meshed", "failed"]
    assert "growth" in lines[2]["message"] and lines[0]["quads"] > 0
    assert (tmp_path / "a.vtu").exists() and not (tmp_path / "c.vtu").exists()
    picture = (tmp_path / "sweep" / "pictures" / "a.png").read_bytes()
    assert picture.startswith(b"\x89PNG") and picture[-8:-4] == b"IEND"

    _columns, tasks = planned(tmp_path, text)
    assert [task.row.name for task in tasks if not plan.is_done(task)] == ["c"]
    (tmp_path / "b.vtu").unlink()
    _columns, tasks = planned(tmp_path, text.replace("a,5", "a,6"))
    assert [plan.is_done(task) for task in tasks] == [False, False, False]

    report.write(str(tmp_path / "sweep"), "a <title>", columns, lines)
    with open(tmp_path / "sweep" / "results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["name"] for row in rows] == ["a", "b", "c"]
    page = (tmp_path / "sweep" / "index.html").read_text()
    assert "a &lt;title&gt;" in page and page.count("<img") == 2 and "<svg" in page


def test_two_processes_do_a_row_once(tmp_path):
    orders = Orders(tmp_path, 1)
    twice = [subprocess.Popen([sys.executable, row.__file__, orders.files[0]]) for _ in range(2)]
    wait_until(lambda: orders.begun_rows())
    orders.let_go()
    assert [process.wait(60) for process in twice] == [0, 0]
    assert orders.begun_rows() == orders.journal() == ["r0"]


def test_a_stop_ends_the_rows_and_what_is_done_stays_done(tmp_path):
    orders = Orders(tmp_path, 3)
    orders.let_go()
    running = places.Here(1).run(orders.files)
    first = next(running)
    running.close()
    done = orders.journal()
    assert f"r{first}" in done and len(done) < 3
    list(places.Here(1).run(orders.files))
    assert orders.journal() == orders.names()


def test_limits_end_a_row_and_say_so(tmp_path):
    orders = Orders(tmp_path, 1)  # never let go
    order = json.loads((tmp_path / "r0.order.json").read_text())
    (tmp_path / "r0.order.json").write_text(json.dumps({**order, "seconds": 0.5}))
    assert row.main(orders.files[0]) == row.DONE
    record = json.loads((tmp_path / "r0.record.json").read_text())
    assert record["status"] == 1 and "limit of 0.5 s" in record["message"]


def wait_until(true):
    end = time.monotonic() + 60
    while not true():
        assert time.monotonic() < end
        time.sleep(0.02)


def test_a_row_whose_process_is_killed_is_done_by_another(tmp_path):
    orders = Orders(tmp_path, 1)
    here = places.Here(1)
    running = here.run(orders.files)
    done = threading.Thread(target=lambda: list(running))
    done.start()
    wait_until(lambda: orders.begun_rows() and here._running)
    next(iter(here._running)).kill()
    wait_until(lambda: len(orders.begun_rows()) == 2)
    orders.let_go()
    done.join(60)
    assert not done.is_alive() and orders.journal() == ["r0"]

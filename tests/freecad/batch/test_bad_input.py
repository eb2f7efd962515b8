"""Bad input: exit status 1, exactly one line on stderr that names file and key, nothing written."""
import json

import pytest

from batch_runs import files

GOOD = {"input": "box.step", "size": 5.0, "first_height": 0.5}

BAD = {
    "missing file": ({"input": "none.step"}, "input"),
    "unreadable STEP": ({"input": "garbage.step"}, "input"),
    "STEP file of no length": ({"input": "zero.step"}, "input"),
    "unreadable BREP": ({"input": "garbage.brep"}, "input"),
    "empty shape": ({"input": "empty.brep"}, "input"),
    "shape without a face": ({"input": "line.brep"}, "input"),
    "unreadable FCStd": ({"input": "garbage.FCStd"}, "input"),
    "unreadable STL": ({"input": "garbage.stl"}, "input"),
    "FCStd without a shape": ({"input": "nothing.FCStd"}, "input"),
    "object that is not there": ({"input": "two.FCStd", "object": "Huge"}, "Huge"),
    "object of a STEP file": ({"object": "Box"}, "object"),
    "face that is not there": ({"faces": ["Face99"]}, "Face99"),
    "edge that is not there": ({"walls": [{"edges": ["Edge99"]}]}, "Edge99"),
    "group of a face that is not there": ({"groups": {"in": ["Face99"]}}, "groups.in"),
    "negative height": ({"first_height": -0.5}, "first_height"),
    "zero size": ({"size": 0}, "size"),
    "growth below 1": ({"growth": 0.5}, "growth"),
    "angle out of range": ({"feature_angle": 180.0}, "feature_angle"),
    "unknown key": ({"first_hight": 0.5}, "first_hight"),
    "text for a number": ({"growth": "1.2"}, "growth"),
    "truth for a number": ({"layers": True}, "layers"),
    "one name for a list": ({"faces": "Face1"}, "faces"),
    "initial mesh that is not there": ({"initial_mesh": "none.vtu"}, "initial_mesh"),
    "initial mesh of no known format": ({"initial_mesh": "start.xyz"}, "initial_mesh"),
    "initial mesh that is a number": ({"initial_mesh": 5}, "initial_mesh"),
    "folder that is not there": ({"outputs": ["none/box.vtu"]}, "outputs"),
    "edges into a file that has none": (
        {"outputs": ["box.stl"], "groups": {"rim": ["Edge1"]}}, "outputs[0]"),
    "two names for what has one": (
        {"outputs": ["box.vtu", "box.ugrid"], "groups": {"a": ["Face1"], "b": ["Face1"]}},
        "outputs[1]"),
    "a solid's surface for SU2": ({"outputs": ["box.vtu", "box.su2"]}, "outputs[1]"),
    "two files that write a third": ({"outputs": ["box.ugrid", "box.b8.ugrid"]}, "box.mapbc"),
    "zero scale": ({"scale": 0}, "scale"),
    "unknown version": ({"msh_version": "4.0"}, "msh_version"),
    "report that is another file": ({"report": "box.FCStd"}, "report"),
    "output of too long a name": ({"outputs": ["x" * 300 + ".vtu"]}, "outputs[0]"),
    "number of 10 000 digits": ({"layers": 10 ** 4000}, "layers"),
    "group that ends a file": ({"groups": {"    -1": ["Face1"]}}, "groups"),
    "half a character": ({"object": "\ud800"}, "object"),
    "more elements than allowed": ({"size": 0.001}, "size"),
    "growth that never ends": ({"first_height": 1e-5, "growth": 1.0}, "growth"),
    "a length of another unit": ({"size": 5.0, "sizes": [{"edges": ["Edge1"],
                                                          "segments": 1000000}]}, "sizes"),
    "less memory than it takes": ({"max_memory": 1e-3}, "max_memory"),
    "less time than it takes": ({"max_seconds": 1e-3}, "max_seconds"),
    "unknown format": ({"outputs": ["box.vtu", "box.xyz"]}, "outputs[1]"),
}


@pytest.mark.parametrize("case", BAD)
def test_one_line_and_nothing_written(batch, job, tmp_path, case):
    values, key = BAD[case]
    if not batch.freecad and values.get("input", "").lower().endswith(".fcstd"):
        key = "freecadcmd"  # the remedy
    path = job(**{**GOOD, "outputs": ["box.vtu"], "report": "report.json", **values})
    ran = batch(path)
    assert ran.status == 1
    assert len(ran.lines) == 1, ran.stderr
    assert path in ran.lines[0] and key in ran.lines[0]
    assert files(tmp_path) == []


def test_the_job_file_itself(batch, tmp_path):
    (tmp_path / "broken.json").write_text("{")
    for name in ("broken.json", "none.json"):
        ran = batch(str(tmp_path / name))
        assert ran.status == 1 and len(ran.lines) == 1 and name in ran.lines[0]


def test_no_job_at_all(batch):
    ran = batch()
    assert ran.status == 1 and len(ran.lines) == 1 and "job.json" in ran.lines[0]


def test_older_files_stay(batch, job, tmp_path):
    (tmp_path / "box.vtu").write_text("old")
    ran = batch(job(**{**GOOD, "outputs": ["box.vtu"], "faces": ["Face99"]}))
    assert ran.status == 1
    assert (tmp_path / "box.vtu").read_text() == "old" and files(tmp_path) == ["box.vtu"]


def test_the_other_jobs_run(batch, job, tmp_path):
    bad = job("bad.json", **{**GOOD, "growth": 0.5, "report": "bad.r.json"})
    good = job("good.json", **GOOD, report="good.r.json")
    ran = batch(bad, good)
    assert ran.status == 1
    assert len(ran.lines) == 1 and bad in ran.lines[0]
    assert json.loads((tmp_path / "good.r.json").read_text())["inverted"] == 0
    assert not (tmp_path / "bad.r.json").exists()

"""Job files: read and checked before anything is meshed."""
import json
import os

import pytest

from advlayers.errors import InputError
from advlayers.job import read_job


@pytest.fixture
def write(tmp_path):
    (tmp_path / "box.step").write_text("not looked at yet")

    def write_job(**values):
        path = tmp_path / "job.json"
        path.write_text(json.dumps({"input": "box.step", "report": "r.json", **values}))
        return str(path)

    return write_job


def test_paths_are_relative_to_the_job_file(write, tmp_path, monkeypatch):
    monkeypatch.chdir("/")
    (tmp_path / "out").mkdir()
    job = read_job(write(outputs=["out/box.vtu", str(tmp_path / "box.UNV")]))
    assert job.input == str(tmp_path / "box.step") and job.input_name == "box.step"
    assert job.outputs == (str(tmp_path / "out" / "box.vtu"), str(tmp_path / "box.UNV"))
    assert job.report == str(tmp_path / "r.json")


def test_endings_are_read_in_any_case(write, tmp_path):
    (tmp_path / "wing.StP").write_text("")
    assert read_job(write(input="wing.StP")).input.endswith("wing.StP")


@pytest.mark.parametrize("values, words", [
    ({"input": "none.step"}, "input does not exist"),
    ({"input": "."}, "input has the unknown format"),
    ({"input": "box.txt"}, "unknown format '.txt'"),
    ({"input": 3}, "input must be a text"),
    ({"input": None}, "input must be a text"),
    ({"outputs": "box.vtu"}, "outputs must be a list"),
    ({"outputs": [1]}, "outputs[0] must be a text"),
    ({"outputs": ["box.xyz"]}, "outputs[0] has the unknown format '.xyz'"),
    ({"outputs": ["none/box.vtu"]}, "outputs[0] lies in a folder that does not exist"),
    ({"outputs": ["box.FCStd"]}, "outputs[0] needs FreeCAD"),
    ({"outputs": ["a.vtu", "./a.vtu"]}, "outputs[1] would overwrite outputs[0]"),
    ({"report": "box.step"}, "report would overwrite the input"),
    ({"report": "job.json"}, "report would overwrite the job file"),
    ({"report": "none/r.json"}, "report lies in a folder that does not exist"),
    ({"report": "."}, "report"),
    ({"report": None}, "nothing to do"),
    ({"strict": 1}, "strict must be true or false"),
    ({"first_height": -7}, "first_height must be > 0 mm, got -7"),
    ({"first_hight": 7}, "first_hight is no known key"),
])
def test_bad_jobs_are_named(write, values, words):
    with pytest.raises(InputError) as error:
        read_job(write(**values))
    assert words in str(error.value)


@pytest.mark.parametrize("text, words", [
    ("", "no JSON"), ("[]", "one JSON object"), ("{", "no JSON"), ("[" * 100000, "nested"),
    ('{"input": "box.step", "input": "b.step"}', "input is given twice"),
    ('{"growth": NaN, "input": "box.step"}', "growth must be a finite number"),
])
def test_bad_files_are_named(tmp_path, text, words):
    (tmp_path / "box.step").write_text("")
    path = tmp_path / "job.json"
    path.write_text(text)
    with pytest.raises(InputError) as error:
        read_job(str(path))
    assert words in str(error.value)


def test_a_file_that_is_no_text(tmp_path):
    path = tmp_path / "job.json"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError):
        read_job(str(path))


def test_documents_need_freecad(write, tmp_path):
    (tmp_path / "box.FCStd").write_text("")
    with pytest.raises(InputError, match="freecadcmd"):
        read_job(write(input="box.FCStd"))


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_written_to(write, tmp_path):
    (tmp_path / "closed").mkdir(mode=0o500)
    with pytest.raises(InputError, match="cannot be written to"):
        read_job(write(outputs=["closed/box.vtu"]))


@pytest.mark.parametrize("text, words", [
    ('"size": ' + "9" * 10_000, "size must be a finite number"),
    ('"size": -' + "9" * 10_000, "size must be a finite number"),
    ('"size": 1e' + "9" * 10_000, "size must be a finite number"),
    ('"layers": ' + "9" * 10_000, "layers must be a whole number"),
    ('"outputs": ["a\\u0000.vtu"]', "outputs[0] must be a text"),
    ('"faces": [' + ", ".join(['"Face1"'] * 30_000) + "]", "faces names Face1 twice"),
    ('"a": ' + "[" * 100_000, "the job file is nested too deeply"),
])
def test_endless_values_are_named(tmp_path, text, words):
    (tmp_path / "box.step").write_text("not looked at yet")
    path = tmp_path / "job.json"
    path.write_text('{"input": "box.step", "report": "r.json", ' + text + "}")
    with pytest.raises(InputError) as error:
        read_job(str(path))
    assert words in str(error.value)
    assert len(str(error.value)) < 300

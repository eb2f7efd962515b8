"""Damaged CAD files: exit status 1, one line on stderr, and the other jobs' meshes, in both hosts.

FreeCAD's and OpenCASCADE's own readers crash on some of these files, run on others without end, and
take a part for the whole of others.
"""
import re
import shutil
import zipfile

import pytest

from batch_runs import HOSTS, files, run

GOOD = {"size": 5.0, "first_height": 0.5}


def cut(data, share):
    return data[:int(share * len(data))]


def without_a_face(data):
    return re.sub(rb"#\d+ = ADVANCED_FACE\([^;]*;", b"", data, count=1)


def with_another_face_twice(data):
    first, second = re.findall(rb"#\d+", re.search(rb"CLOSED_SHELL\([^;]*;", data).group())[:2]
    return re.sub(rb"CLOSED_SHELL\('',\(" + first, b"CLOSED_SHELL('',(" + second, data)


def moved_vertex(data):
    points = re.findall(rb"VERTEX_POINT\('',(#\d+)\)", data)
    return re.sub(re.escape(points[0]) + rb" = CARTESIAN_POINT\('',\([^,]*,",
                  points[0] + b" = CARTESIAN_POINT('',(77.,", data)


DAMAGE = {
    "STEP without a face": ("box.step", without_a_face),
    "STEP with a face in the place of another": ("box.step", with_another_face_twice),
    "STEP with a vertex elsewhere": ("box.step", moved_vertex),
    "STEP cut": ("box.step", lambda data: cut(data, 0.9)),
    "IGES cut": ("box.iges", lambda data: cut(data, 0.9)),
    "IGES with an entity of another type": (
        "box.iges", lambda data: data.replace(b"     144 ", b"     114 ", 1)),
    "BREP cut within a number": ("box.brep", lambda data: data[:440]),
    "STL cut": ("box.stl", lambda data: cut(data, 0.6)),
    "STL with a line left out": ("box.stl", lambda data: data.replace(b"endloop", b"", 1)),
}


@pytest.mark.parametrize("case", DAMAGE)
def test_one_line_and_the_other_mesh(batch, job, shapes, tmp_path, case):
    name, damage = DAMAGE[case]
    sound = (shapes / name).read_bytes()
    spoilt = damage(sound)
    assert spoilt != sound
    (shapes / f"spoilt_{name}").write_bytes(spoilt)
    bad = job("bad.json", input=f"spoilt_{name}", **GOOD, outputs=["bad.vtu"], report="r.json")
    good = job("good.json", input="box.step", **GOOD, outputs=["good.vtu"])
    ran = batch(bad, good)
    assert ran.status == 1
    assert len(ran.lines) == 1 and f"spoilt_{name}" in ran.lines[0], ran.stderr
    assert files(tmp_path) == ["bad.json", "good.json", "good.vtu"]


def test_a_document_whose_shape_is_spoilt(job, shapes, tmp_path):
    with zipfile.ZipFile(shapes / "two.FCStd") as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    spoilt = shapes / "spoilt.FCStd"
    shape = next(name for name in members if name.endswith(".brp"))
    with zipfile.ZipFile(spoilt, "w") as archive:
        for name, data in members.items():
            archive.writestr(name, cut(data, 0.5) if name == shape else data)
    command = HOSTS["freecadcmd"]
    bad = job("bad.json", input="spoilt.FCStd", object="Small", **GOOD, outputs=["bad.vtu"])
    good = job("good.json", input="two.FCStd", **GOOD, outputs=["good.vtu"])
    ran = run(command + [bad, good])
    assert ran.status == 1 and len(ran.lines) == 1 and "spoilt.FCStd" in ran.lines[0], ran.stderr
    shutil.copy(shapes / "two.FCStd", spoilt)
    spoilt.write_bytes(cut(spoilt.read_bytes(), 0.9))
    ran = run(command + [bad, good])
    assert ran.status == 1 and len(ran.lines) == 1 and "spoilt.FCStd" in ran.lines[0], ran.stderr
    assert files(tmp_path) == ["bad.json", "good.json", "good.vtu"]

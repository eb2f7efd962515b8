"""Files that appear together or not at all."""
import errno
import os
import subprocess
import sys
import zipfile

import pytest
from advlayers import outputs, written_file
from advlayers.outputs import Outputs


def put(text):
    def write(path):
        with open(path, "w") as file:
            file.write(text)
    return write


def content(path):
    with open(path) as file:
        return file.read()


def test_they_appear_together(tmp_path):
    first, second = str(tmp_path / "a.txt"), str(tmp_path / "b.txt")
    with Outputs() as made:
        for path in (first, second):
            made.write(path, put("new"))
            assert not os.path.exists(first)
        made.publish()
    assert sorted(os.listdir(tmp_path)) == ["a.txt", "b.txt"]


def test_a_failed_writer_leaves_the_older_files(tmp_path):
    first, second = str(tmp_path / "a.txt"), str(tmp_path / "b.txt")
    put("old")(first)

    def fail(path):
        put("half")(path)
        raise OSError(errno.ENOSPC, "disk full", path)

    with pytest.raises(OSError) as caught, Outputs() as made:
        made.write(first, put("new"))
        made.write(second, fail)
        made.publish()
    assert caught.value.filename == second
    assert os.listdir(tmp_path) == ["a.txt"] and content(first) == "old"


def test_a_writer_that_wrote_nothing_is_an_error(tmp_path):
    for write in (lambda path: None, put("")):
        with pytest.raises(OSError, match="nothing was written"), Outputs() as made:
            made.write(str(tmp_path / "a.txt"), write)
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("turn", [0, 1, 2, 3])
def test_where_one_cannot_take_its_place_none_does(tmp_path, monkeypatch, turn):
    names = ["a.txt", "b.txt", "c.txt", "folder"]
    put("old")(tmp_path / "a.txt")
    put("old")(tmp_path / "c.txt")
    (tmp_path / "folder").mkdir()
    put("old")(tmp_path / "folder" / "part")
    replace, seen = os.replace, []

    def failing(source, target):
        if ".advlayers" not in target and os.path.basename(source) != "older":
            seen.append(target)
            if len(seen) == turn + 1:
                raise OSError(errno.EACCES, "not allowed", target)
        replace(source, target)

    def folder(path):
        os.mkdir(path)
        put("new")(os.path.join(path, "part"))

    monkeypatch.setattr(outputs.os, "replace", failing)
    with pytest.raises(OSError) as caught, Outputs() as made:
        for name in names:
            made.write(str(tmp_path / name), folder if name == "folder" else put("new"))
        made.publish()
    assert caught.value.filename == str(tmp_path / names[turn])
    assert sorted(os.listdir(tmp_path)) == ["a.txt", "c.txt", "folder"]
    for name in ("a.txt", "c.txt", "folder/part"):
        assert content(tmp_path / name) == "old"


def test_a_folder_takes_the_place_of_another(tmp_path):
    for text in ("one", "two"):
        def write(path, text=text):
            os.mkdir(path)
            put(text)(os.path.join(path, text))
        with Outputs() as made:
            made.write(str(tmp_path / "polyMesh"), write)
            made.publish()
    assert os.listdir(tmp_path) == ["polyMesh"]
    assert os.listdir(tmp_path / "polyMesh") == ["two"]


def test_a_link_is_replaced_and_not_followed(tmp_path):
    put("theirs")(tmp_path / "theirs.txt")
    os.symlink(tmp_path / "theirs.txt", tmp_path / "a.txt")
    with Outputs() as made:
        made.write(str(tmp_path / "a.txt"), put("new"))
        made.publish()
    assert content(tmp_path / "theirs.txt") == "theirs"
    assert content(tmp_path / "a.txt") == "new" and not os.path.islink(tmp_path / "a.txt")


def test_what_a_killed_run_left_goes_with_the_next_and_a_living_one_keeps_its_own(tmp_path):
    script = ("import os, signal, sys\nfrom advlayers.outputs import Outputs\n"
              "made = Outputs()\n"
              "made.write(sys.argv[1], lambda path: open(path, 'w').write('half') and None)\n"
              "os.kill(os.getpid(), signal.SIGKILL)\n")
    subprocess.run([sys.executable, "-c", script, str(tmp_path / "a.txt")],
                   env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    left = os.listdir(tmp_path)
    assert len(left) == 1 and left[0].startswith(".advlayers-")
    own = outputs._new_folder(str(tmp_path))
    with Outputs() as made:
        made.write(str(tmp_path / "b.txt"), put("new"))
        made.publish()
    assert sorted(os.listdir(tmp_path)) == [os.path.basename(own), "b.txt"]


def test_every_cut_of_a_document_is_seen(tmp_path):
    path = tmp_path / "a.FCStd"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("Document.xml", "<Document/>" * 100)
    data = path.read_bytes()
    written_file.check(str(path))
    for length in range(len(data)):
        path.write_bytes(data[:length])
        with pytest.raises(OSError):
            written_file.check(str(path))


def test_every_cut_of_an_hdf_file_is_seen(tmp_path):
    h5py = pytest.importorskip("h5py")
    for libver in ("earliest", "latest"):
        path = tmp_path / "a.med"
        with h5py.File(path, "w", libver=libver) as file:
            file["numbers"] = range(1000)
        data = path.read_bytes()
        written_file.check(str(path))
        for length in (0, 10, 50, 100, len(data) // 2, len(data) - 1):
            path.write_bytes(data[:length])
            with pytest.raises(OSError):
                written_file.check(str(path))


@pytest.mark.parametrize("name, text", [
    ("a.vtu", "<VTKFile>\n</VTKFile>\n"), ("a.unv", "    -1\n  2411\n    -1\n"),
    ("a.bdf", "BEGIN BULK\nENDDATA\n"), ("a.inp", "*NODE\n1, 0, 0, 0\n"), ("a.json", "{\n}\n")])
def test_a_text_has_an_end(tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text)
    written_file.check(str(path))
    path.write_text(text[:-3])
    with pytest.raises(OSError, match="whole"):
        written_file.check(str(path))

"""The wheel needs nothing but the system, and lives beside every other OpenCASCADE."""
import itertools
import os
import re
import subprocess
import sys
import tarfile
import zipfile

import pytest

import backend
import graft
from conftest import DIST, ROOT

OTHERS = ("Part", "gmsh", "vtk", "netgen.meshing")
_SYSTEM = {"libc.so.6", "libm.so.6", "libgcc_s.so.1", "libstdc++.so.6", "libpthread.so.0",
           "libdl.so.2", "librt.so.1", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}


@pytest.fixture(scope="module")
def unpacked(wheel, tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
    return folder


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory):
    """A Python that has the wheel, and Debian's packages beside it."""
    folder = tmp_path_factory.mktemp("venv")
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", str(folder)],
                   check=True)
    subprocess.run([str(folder / "bin" / "pip"), "install", "-q", "--no-index", "--no-deps",
                    wheel], check=True)
    return str(folder / "bin" / "python3")


@pytest.fixture(scope="module")
def shapes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("shapes")
    for name in ("cylinder", "drilled_plate"):
        with open(os.path.join(ROOT, "tests", "data", name + ".brep"), "rb") as file:
            (folder / (name + ".brep")).write_bytes(file.read())
    subprocess.run(["freecadcmd", "-c", f"import Part; Part.makeBox(10, 20, 30).cut(Part."
                    f"makeCylinder(3, 40)).exportStep({str(folder / 'cut.step')!r})"],
                   check=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    return str(folder)


def mesh_hash(python, shapes, names, **variables):
    program = os.path.join(ROOT, "tests", "packages", "mesh_hash.py")
    done = subprocess.run([python, program, shapes, ",".join(names)], capture_output=True,
                          text=True, env={**os.environ, **variables}, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()[-1].split()


def test_all_that_is_needed_is_inside(unpacked):
    files = graft.elf_files(str(unpacked))
    inside = {os.path.basename(path) for path in files}
    assert any(name.startswith("libTKernel-advlayers-") for name in inside)
    for path in files:
        for name in graft.needed(path):
            assert name in inside or name in _SYSTEM, f"{path} needs {name}"


def test_nothing_of_it_mixes_with_others(unpacked):
    for path in graft.elf_files(str(unpacked)):
        assert graft.unique_symbols(path) == [], path
        if os.path.basename(path).startswith("_core"):
            said = subprocess.run(["nm", "-D", "--defined-only", path], check=True,
                                  capture_output=True, text=True).stdout
            assert [line.split()[-1] for line in said.splitlines()] == ["PyInit__core"]


def test_the_licences_of_all_that_is_inside_are_there(unpacked):
    folder, = unpacked.glob("*.dist-info/licenses")
    said = (folder / "CARRIED.txt").read_text()
    for path in graft.elf_files(str(unpacked / "advlayers_core" / "libs")):
        assert re.search(re.escape(os.path.basename(path)) + r": of [\w.+-]+, see", said)
    for name in re.findall(r"see (\S+\.txt)", said):
        assert (folder / name).stat().st_size > 500


@pytest.mark.parametrize("first, then", [
    (k, order) for order in itertools.permutations(OTHERS, 2) for k in range(3)
    if order[0] < order[1] or k == 1])
def test_the_same_mesh_among_others_in_any_order(installed, shapes, reference, first, then):
    """The core before, between and after two others."""
    names = list(then)
    names.insert(first, "advlayers_core")
    place, found = mesh_hash(installed, shapes, names)
    assert "site-packages" in place and found == reference


@pytest.fixture(scope="module")
def reference(shapes):
    """Of the build that the wheel was made from."""
    return mesh_hash(sys.executable, shapes, ["advlayers_core"],
                     PYTHONPATH=os.path.join(ROOT, "mesher_core", "python"))[1]


def test_the_sdist_has_what_a_build_needs():
    path = os.path.join(DIST, f"advlayers_core-{backend.version()}.tar.gz")
    with tarfile.open(path) as archive:
        names = {name.split("/", 1)[1] for name in archive.getnames() if "/" in name}
    tracked = subprocess.run(["git", "-C", ROOT, "ls-files", "mesher_core", "CMakeLists.txt",
                              "pyproject.toml"], capture_output=True, text=True, check=False)
    assert set(tracked.stdout.split()) <= names
    assert not [name for name in names if name.endswith((".so", ".pyc"))]

"""A core from a wheel: which one fits, what its sums say, and where it goes."""
import base64
import hashlib
import http.server
import platform
import sys
import threading
import zipfile

import advlayers
import pytest

from advlayers import core_wheel
from advlayers.errors import InputError

PYTHON = "cp{}{}".format(*sys.version_info[:2])
HERE = f"manylinux_2_17_{platform.machine()}"
CORE = b"\x7fELF the core"


def name(version=advlayers.__version__, python=PYTHON, system=HERE):
    return f"advlayers_core-{version}-{python}-{python}-{system}.whl"


def make_wheel(folder, called=None, listed=None):
    """A wheel with a core; `listed`: what its own list has for the core instead."""
    path = folder / (called or name())
    files = {"advlayers_core/__init__.py": b"wrong = True\n", "advlayers_core/_core.so": CORE,
             "advlayers_core/advlayers-read": b"reader", "advlayers_core/libs/libTK-1.so": b"lib"}
    record = "advlayers_core-1.dist-info/RECORD"
    with zipfile.ZipFile(path, "w") as archive:
        for file, data in files.items():
            entry = zipfile.ZipInfo(file)
            entry.external_attr = (0o755 if file.endswith("read") else 0o644) << 16
            archive.writestr(entry, data)
        said = {**files, **({"advlayers_core/_core.so": listed} if listed else {})}
        sums = {file: base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
                for file, data in said.items()}
        archive.writestr(record, "".join(f"{file},sha256={digest},1\n"
                                         for file, digest in sums.items()) + f"{record},,\n")
    return path


def write_sums(folder, path, digest=None):
    digest = digest or hashlib.sha256(path.read_bytes()).hexdigest()
    (folder / "SHA256SUMS").write_text(f"{digest}  {path.name}\n")
    return digest


@pytest.fixture
def package(tmp_path, monkeypatch):
    """The add-on's folder of the core, as a checkout has it."""
    folder = tmp_path / "addon" / "advlayers_core"
    folder.mkdir(parents=True)
    (folder / "__init__.py").write_text("ours = True\n")
    monkeypatch.setattr(core_wheel, "PACKAGE", str(folder))
    return folder


def test_the_core_goes_where_its_own_build_would_be(tmp_path, package):
    path = make_wheel(tmp_path)
    digest = write_sums(tmp_path, path)
    assert not core_wheel.is_built_here()
    chosen = core_wheel.offer(str(tmp_path))
    assert (chosen.name, chosen.sha256, chosen.known_sum) == (path.name, digest, True)
    core_wheel.install(chosen)
    assert core_wheel.is_built_here()
    assert (package / "_core.so").read_bytes() == CORE
    assert (package / "libs" / "libTK-1.so").exists()
    assert (package / "advlayers-read").stat().st_mode & 0o111
    assert (package / "__init__.py").read_text() == "ours = True\n"
    assert sorted(entry.name for entry in package.iterdir()) == [
        "__init__.py", "_core.so", "advlayers-read", "libs"]


@pytest.mark.parametrize("called, why", [
    (name(version="0.0.9"), "version 0.0.9"),
    (name(python="cp27"), "for cp27"),
    (name(system=f"manylinux_2_999_{platform.machine()}"), "manylinux_2_999"),
    (name(system="win_arm64"), "win_arm64"),
])
def test_what_does_not_fit_is_not_offered_and_why_is_said(tmp_path, called, why):
    make_wheel(tmp_path, called)
    with pytest.raises(InputError, match=why):
        core_wheel.offer(str(tmp_path))


def test_a_wheel_that_is_not_what_its_sum_says_is_refused(tmp_path):
    path = make_wheel(tmp_path)
    write_sums(tmp_path, path, "0" * 64)
    with pytest.raises(InputError, match="0000"):
        core_wheel.offer(str(path))


def test_a_damaged_wheel_is_refused(tmp_path):
    with pytest.raises(InputError, match="_core.so"):
        core_wheel.offer(str(make_wheel(tmp_path, listed=b"other")))
    path = make_wheel(tmp_path)
    path.write_bytes(path.read_bytes()[:200])
    with pytest.raises(InputError, match="damaged"):
        core_wheel.offer(str(path))


def test_an_index_gives_wheel_and_sum(tmp_path, package):
    folder = tmp_path / "site" / "advlayers-core"
    folder.mkdir(parents=True)
    path = make_wheel(folder)
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    (folder / "index.html").write_text(f'<a href="{path.name}#sha256={digest}">wheel</a>')

    class Handler(http.server.SimpleHTTPRequestHandler):
        def __init__(self, *given, **more):
            super().__init__(*given, directory=str(tmp_path / "site"), **more)

        def log_message(self, *_given):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        address = "http://127.0.0.1:%d" % server.server_address[1]
        chosen = core_wheel.offer(address)
        assert chosen.known_sum and chosen.sha256 == digest
        (folder / "index.html").write_text(f'<a href="{path.name}#sha256={"1" * 64}">wheel</a>')
        with pytest.raises(InputError, match="1111"):
            core_wheel.offer(address)
    finally:
        server.shutdown()
        server.server_close()

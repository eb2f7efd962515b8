"""PEP 517 backend of advlayers-core: CMake builds it, graft makes it need nothing but the system.

Debian 12 has neither scikit-build-core nor auditwheel, so what of them is needed stands here.
Settings: `build-dir`, a CMake build of this tree to take instead of making one.
"""
from __future__ import annotations

import base64
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from typing import Dict, Iterable, List, Optional

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, HERE)

import graft  # noqa: E402  (beside this file, which is no package)
import licences  # noqa: E402

NAME = "advlayers_core"
# Where CMake's component "python" puts the package, and where a wheel keeps it: at its top.
_INSTALLED = os.path.join("lib", "python3", "dist-packages", NAME)
# What the sdist has: enough to build, and to test what was built.
_SOURCES = ("CMakeLists.txt", "CMakePresets.json", "CITATION.cff", "LICENSE", "README.md",
            "docs/CHANGELOG.md", "mesher_core", "pyproject.toml")
_NOT_SOURCES = re.compile(r"(/|^)__pycache__(/|$)|\.pyc$|/_core[^/]*\.(so|pyd|dylib)$|"
                          r"/advlayers-read(\.exe)?$")
_EARLIEST = 315532800  # 1980, where zip files begin


def version() -> str:
    """The one that CMakeLists.txt gives the project."""
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.search(r"project\(AdvancingLayers VERSION ([0-9.]+)", file.read()).group(1)


def get_requires_for_build_wheel(config_settings: Optional[Dict] = None) -> List[str]:
    """What the system does not have of CMake, Ninja and pybind11 comes from the index."""
    missing = [tool for tool in ("cmake", "ninja") if shutil.which(tool) is None]
    found = subprocess.run(["cmake", "--find-package", "-DNAME=pybind11", "-DCOMPILER_ID=GNU",
                            "-DLANGUAGE=CXX", "-DMODE=EXIST"], capture_output=True,
                           check=False).returncode == 0 if "cmake" not in missing else False
    return missing + ([] if found else ["pybind11>=2.10"])


def get_requires_for_build_sdist(config_settings: Optional[Dict] = None) -> List[str]:
    return []


def build_wheel(wheel_directory: str, config_settings: Optional[Dict] = None,
                metadata_directory: Optional[str] = None) -> str:
    """Returns the wheel's name in the folder."""
    with tempfile.TemporaryDirectory() as work:
        build = (config_settings or {}).get("build-dir") or _built(os.path.join(work, "build"))
        stage = os.path.join(work, "stage")
        subprocess.run(["cmake", "--install", build, "--component", "python", "--strip",
                        "--prefix", stage], check=True, stdout=subprocess.DEVNULL)
        package = os.path.join(stage, _INSTALLED)
        _keep_one_python(package)
        carried = graft.graft(package)
        platform = graft.platform_tag(package)
        python = "cp{}{}".format(*sys.version_info[:2])
        tag = f"{python}-{python}-{platform}"
        name = f"{NAME}-{version()}-{tag}.whl"
        _write_wheel(os.path.join(wheel_directory, name), package, tag, carried)
        return name


def build_sdist(sdist_directory: str, config_settings: Optional[Dict] = None) -> str:
    """Returns the archive's name in the folder."""
    top = f"{NAME}-{version()}"
    path = os.path.join(sdist_directory, f"{top}.tar.gz")

    def plain(entry: tarfile.TarInfo) -> Optional[tarfile.TarInfo]:
        if _NOT_SOURCES.search(entry.name):
            return None
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = ""
        entry.mtime = _epoch()
        return entry

    with tarfile.open(path, "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for source in _SOURCES:
            archive.add(os.path.join(ROOT, source), f"{top}/{source}", filter=plain)
        info = plain(tarfile.TarInfo(f"{top}/PKG-INFO"))
        text = metadata().encode()
        info.size = len(text)
        archive.addfile(info, io.BytesIO(text))
    return os.path.basename(path)


def metadata() -> str:
    with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
        readme = file.read()
    return "\n".join((
        "Metadata-Version: 2.1",
        f"Name: {NAME.replace('_', '-')}",
        f"Version: {version()}",
        "Summary: Quad-dominant surface meshes that grow in layers from the edges of CAD faces",
        "License: LGPL-2.1-or-later",
        "Keywords: mesh,quad,boundary layer,CAD,FreeCAD",
        "Classifier: License :: OSI Approved :: GNU Lesser General Public License v2 or later "
        "(LGPLv2+)",
        "Classifier: Programming Language :: C++",
        "Classifier: Programming Language :: Python :: 3",
        "Classifier: Topic :: Scientific/Engineering",
        "Requires-Python: >=3.9",
        "Requires-Dist: numpy",
        "Description-Content-Type: text/markdown",
        "", readme))


def _built(build: str) -> str:
    subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DADVLAYERS_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}"]
                   + os.environ.get("CMAKE_ARGS", "").split(), check=True)
    subprocess.run(["cmake", "--build", build], check=True)
    return build


def _keep_one_python(package: str) -> None:
    """A build folder may hold the modules of several Pythons."""
    ours = "_core" + sysconfig.get_config_var("EXT_SUFFIX")
    for name in os.listdir(package):
        if re.match(r"_core\..*\.?(so|pyd)$", name) and name != ours:
            os.remove(os.path.join(package, name))
    if not os.path.exists(os.path.join(package, ours)):
        raise FileNotFoundError(f"the build has no {ours}: it is for another Python")


def _write_wheel(path: str, package: str, tag: str, carried: Iterable[graft.Carried]) -> None:
    info = f"{NAME}-{version()}.dist-info"
    record = []
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:

        def add(name: str, data: bytes, mode: int = 0o644) -> None:
            entry = zipfile.ZipInfo(name, _zip_time())
            entry.external_attr = (0o100000 | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(data)}")

        for where, folders, names in os.walk(package):
            folders.sort()
            for name in sorted(names):
                full = os.path.join(where, name)
                inside = os.path.relpath(full, os.path.dirname(package)).replace(os.sep, "/")
                with open(full, "rb") as file:
                    add(inside, file.read(), 0o755 if os.access(full, os.X_OK) else 0o644)
        add(f"{info}/METADATA", metadata().encode())
        add(f"{info}/WHEEL", ("Wheel-Version: 1.0\nGenerator: advlayers\n"
                              f"Root-Is-Purelib: false\nTag: {tag}\n").encode())
        for name, text in licences.texts(ROOT, carried).items():
            add(f"{info}/licenses/{name}", text)
        archive.writestr(zipfile.ZipInfo(f"{info}/RECORD", _zip_time()),
                         "\n".join([*record, f"{info}/RECORD,,", ""]))


def _epoch() -> int:
    return max(_EARLIEST, int(os.environ.get("SOURCE_DATE_EPOCH", _EARLIEST)))


def _zip_time():
    import time

    return time.gmtime(_epoch())[:6]

"""Puts the core of a wheel into this add-on's folder, where its own build would be.

So the core goes when the add-on goes, and no other add-on meets it. A wheel comes from a file, a
folder, or an index of packages (PEP 503). It must be of this add-on's version, fit this Python and
system, and be what its sums say: those of the index or of SHA256SUMS beside it, and its own RECORD.
"""
from __future__ import annotations

import base64
import hashlib
import html.parser
import io
import os
import platform
import re
import shutil
import sys
import tempfile
import urllib.error
import urllib.parse
import urllib.request
import zipfile
from dataclasses import dataclass
from typing import Iterator, List, Tuple

import advlayers
from advlayers.errors import InputError

NAME = "advlayers-core"
KEY = "wheel"  # of errors
SUMS = "SHA256SUMS"
PACKAGE = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__)))), "mesher_core", "python", "advlayers_core")
_WHEEL = re.compile(r"advlayers_core-(?P<version>[0-9.]+)-(?P<python>\w+)-(?P<abi>\w+)-"
                    r"(?P<system>[\w.]+)\.whl")
_SECONDS = 30  # for a server to answer
_MOST_BYTES = 300 * 2 ** 20
_INSTALLED = re.compile(r"advlayers_core/(_core[^/]*|advlayers-read(\.exe)?|libs/[^/]+|"
                        r"[^/]+\.(dll|dylib))")


@dataclass(frozen=True)
class Offer:
    """A wheel that fits; nothing is installed yet."""
    name: str
    data: bytes
    sha256: str
    origin: str  # file or address
    known_sum: bool  # the sum was found beside it and is the same


def is_built_here() -> bool:
    """Whether the add-on's folder has a core, for whatever Python."""
    return os.path.isdir(PACKAGE) and any(
        name.startswith("_core.") and not name.endswith(".pyi") for name in os.listdir(PACKAGE))


def offer(source: str) -> Offer:
    """The wheel that fits best in a file, a folder or an index. Raises InputError saying what else
    there is."""
    found = list(_listed(source))
    fitting = [(name, place, wanted) for name, place, wanted in found if misfit(name) == ""]
    if not fitting:
        names = ", ".join(f"{name} ({misfit(name)})" for name, _place, _sum in found)
        raise InputError(KEY, "for Python {} and version {} is not there: {}", _python(),
                         advlayers.__version__, names or source)
    # The newest system that this one still is: its wheel asks for most, and was built for it.
    name, place, wanted = max(fitting, key=lambda entry: _glibc_of(entry[0]))
    data = _read(place)
    digest = hashlib.sha256(data).hexdigest()
    if wanted and wanted != digest:
        raise InputError(KEY, "{} is not what its sum says: {} instead of {}", name, digest, wanted)
    _check_record(name, data)
    return Offer(name, data, digest, place, bool(wanted))


def install(chosen: Offer) -> str:
    """Puts the core into the add-on's folder and returns the folder. A core that is there for the
    same Python is replaced."""
    with zipfile.ZipFile(io.BytesIO(chosen.data)) as archive:
        entries = [entry for entry in archive.infolist() if _INSTALLED.fullmatch(entry.filename)]
        try:
            folder = tempfile.mkdtemp(prefix=".advlayers-wheel-", dir=PACKAGE)
            try:
                for entry in entries:
                    _put(archive, entry, folder)
            finally:
                shutil.rmtree(folder, ignore_errors=True)
        except OSError as error:
            raise InputError(KEY, "cannot be installed: {}", error) from error
    sys.modules.pop("advlayers_core", None)
    return PACKAGE


def misfit(name: str) -> str:
    """Why the wheel is not for this add-on, Python and system; empty: it is."""
    found = _WHEEL.fullmatch(name)
    if found is None:
        return "no wheel of the core"
    if found["version"] != advlayers.__version__:
        return f"version {found['version']}"
    if found["python"] != _python():
        return f"for {found['python']}"
    return "" if any(_is_here(system) for system in found["system"].split(".")) else (
        f"for {found['system']}")


def _python() -> str:
    return "cp{}{}".format(*sys.version_info[:2])


def _is_here(system: str) -> bool:
    machine = platform.machine().lower()
    linux = re.fullmatch(r"manylinux_([0-9]+)_([0-9]+)_(\w+)", system)
    if linux:
        return (sys.platform.startswith("linux") and linux[3] == machine
                and (int(linux[1]), int(linux[2])) <= _glibc_here())
    if sys.platform == "win32":
        return system == f"win_{machine}"
    mac = re.fullmatch(r"macosx_([0-9]+)_([0-9]+)_(\w+)", system)
    if mac and sys.platform == "darwin":
        here = tuple(int(part) for part in platform.mac_ver()[0].split(".")[:2])
        return mac[3] in (machine, "universal2") and (int(mac[1]), int(mac[2])) <= here
    return False


def _glibc_here() -> Tuple[int, int]:
    kind, version = platform.libc_ver()
    found = re.match(r"([0-9]+)\.([0-9]+)", version)
    return (int(found[1]), int(found[2])) if kind == "glibc" and found else (0, 0)


def _glibc_of(name: str) -> Tuple[int, int]:
    found = re.search(r"manylinux_([0-9]+)_([0-9]+)", name)
    return (int(found[1]), int(found[2])) if found else (0, 0)


def _listed(source: str) -> Iterator[Tuple[str, str, str]]:
    """Name, place and sum (or "") of each wheel of the core."""
    if re.match(r"https?://", source):
        yield from _of_index(source)
        return
    if os.path.isdir(source):
        files = [os.path.join(source, name) for name in sorted(os.listdir(source))]
    elif os.path.isfile(source):
        files = [source]
    else:
        raise InputError(KEY, "is neither file nor folder: {}", source)
    for path in files:
        if path.endswith(".whl"):
            yield os.path.basename(path), path, _sum_beside(path)


def _sum_beside(path: str) -> str:
    try:
        with open(os.path.join(os.path.dirname(path), SUMS), encoding="utf-8") as file:
            for line in file:
                digest, _space, name = line.strip().partition("  ")
                if name.lstrip("*") == os.path.basename(path):
                    return digest
    except (OSError, UnicodeDecodeError):
        pass
    return ""


class _Links(html.parser.HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.found: List[str] = []

    def handle_starttag(self, tag, attrs) -> None:
        if tag == "a":
            self.found += [value for key, value in attrs if key == "href" and value]


def _of_index(source: str) -> Iterator[Tuple[str, str, str]]:
    page = source.rstrip("/") + f"/{NAME}/"
    links = _Links()
    links.feed(_read(page).decode("utf-8", "replace"))
    for link in links.found:
        address, fragment = urllib.parse.urldefrag(urllib.parse.urljoin(page, link))
        name = urllib.parse.unquote(address.rsplit("/", 1)[-1])
        digest = re.fullmatch(r"sha256=([0-9a-f]{64})", fragment)
        if name.endswith(".whl"):
            yield name, address, digest[1] if digest else ""


def _read(place: str) -> bytes:
    try:
        if re.match(r"https?://", place):
            with urllib.request.urlopen(place, timeout=_SECONDS) as answer:
                data = answer.read(_MOST_BYTES + 1)
        else:
            with open(place, "rb") as file:
                data = file.read(_MOST_BYTES + 1)
    except (OSError, urllib.error.URLError) as error:
        raise InputError(KEY, "cannot be read: {}: {}", str(error), place) from error
    if len(data) > _MOST_BYTES:
        raise InputError(KEY, "is larger than any of the core: {}", place)
    return data


def _check_record(name: str, data: bytes) -> None:
    """Every file is what the wheel's own list says, and stands in it."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            record = next(entry for entry in archive.namelist()
                          if entry.endswith(".dist-info/RECORD"))
            sums = dict(line.split(",")[:2] for line in
                        archive.read(record).decode().splitlines() if line)
            for entry in archive.namelist():
                digest = base64.urlsafe_b64encode(
                    hashlib.sha256(archive.read(entry)).digest()).rstrip(b"=").decode()
                if entry != record and sums.get(entry) != f"sha256={digest}":
                    raise InputError(KEY, "{} is damaged: {} is not as its list says", name, entry)
    except (zipfile.BadZipFile, StopIteration, ValueError, EOFError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(KEY, "{} is damaged: {}", name, str(error)) from error


def _put(archive: zipfile.ZipFile, entry: zipfile.ZipInfo, folder: str) -> None:
    target = os.path.join(PACKAGE, *entry.filename.split("/")[1:])
    os.makedirs(os.path.dirname(target), exist_ok=True)
    temporary = os.path.join(folder, os.path.basename(target))
    with open(temporary, "wb") as file:
        file.write(archive.read(entry))
    os.chmod(temporary, (entry.external_attr >> 16) & 0o755 | 0o644)
    os.replace(temporary, target)

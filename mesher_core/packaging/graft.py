"""Makes a Python package need nothing but the system: takes in the libraries it is linked with.

Each gets a name that no other copy has, so that one process may hold FreeCAD's OpenCASCADE and ours
side by side. Two things would mix them all the same: symbols that ELF calls unique, of which a
process has but one whatever library asks (they become plain global ones here), and libraries that
the program itself is linked with, which are asked first (RTLD_DEEPBIND in the package's
__init__.py turns that round).
"""
from __future__ import annotations

import hashlib
import os
import re
import shutil
import struct
import subprocess
import sys
import sysconfig
from dataclasses import dataclass
from typing import Dict, List, Set

FOLDER = "libs"  # in the package

# What every Linux has (PEP 600, of whose list this is the part that is needed).
_OF_THE_SYSTEM = re.compile(
    r"(linux-vdso|ld-linux[-\w]*|libc|libm|libdl|librt|libpthread|libgcc_s|libstdc\+\+)\.so\b.*")
_SHT_DYNSYM = 11
_STB_GLOBAL, _STB_GNU_UNIQUE = 1, 10


@dataclass(frozen=True)
class Carried:
    """A library that the package takes along."""
    name: str  # in the package
    origin: str  # the file that it is a copy of


def graft(package: str) -> List[Carried]:
    """Does so with all that is in the folder. Elsewhere than on Linux delocate (macOS) and
    delvewheel (Windows) do it, with the finished wheel."""
    if not sys.platform.startswith("linux"):
        return []
    ours = elf_files(package)
    origins: Dict[str, str] = {}
    for path in ours:
        origins.update(_foreign(path))
    if not origins:
        return []
    folder = os.path.join(package, FOLDER)
    os.mkdir(folder)
    names = {wanted: _name_of_its_own(wanted, origin) for wanted, origin in origins.items()}
    for wanted, origin in origins.items():
        copy = os.path.join(folder, names[wanted])
        shutil.copy(os.path.realpath(origin), copy)
        os.chmod(copy, 0o755)
        _patch(copy, names, "$ORIGIN", names[wanted])
        os.chmod(copy, 0o644)
    for path in ours:
        _patch(path, names, "$ORIGIN/" + FOLDER)
    return [Carried(names[wanted], os.path.realpath(origin))
            for wanted, origin in sorted(origins.items())]


def elf_files(folder: str) -> List[str]:
    found = []
    for where, _folders, names in os.walk(folder):
        for name in names:
            path = os.path.join(where, name)
            with open(path, "rb") as file:
                if file.read(4) == b"\x7fELF":
                    found.append(path)
    return sorted(found)


def needed(path: str) -> List[str]:
    """The libraries that a file names."""
    text = subprocess.run(["patchelf", "--print-needed", path], check=True, capture_output=True,
                          text=True).stdout
    return text.split()


def platform_tag(package: str) -> str:
    """The oldest system that has all that the files ask of it."""
    if not sys.platform.startswith("linux"):
        return re.sub(r"[-.]", "_", sysconfig.get_platform())
    oldest = max((version for path in elf_files(package) for version in _glibc_versions(path)),
                 default=(2, 17))
    machine = os.uname().machine
    return "manylinux_{}_{}_{}".format(*max(oldest, (2, 17))[:2], machine)


def _foreign(path: str) -> Dict[str, str]:
    """Name and place of each library that the file needs, itself or by others."""
    text = subprocess.run(["ldd", path], check=True, capture_output=True, text=True).stdout
    lost = re.findall(r"(\S+) => not found", text)
    if lost:
        raise FileNotFoundError(f"{path} needs what is not here: {', '.join(lost)}")
    return {name: place for name, place in re.findall(r"(\S+) => (/\S+)", text)
            if not _OF_THE_SYSTEM.fullmatch(name)}


def _name_of_its_own(name: str, origin: str) -> str:
    with open(origin, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()[:8]
    stem, ending = name.split(".so", 1)
    return f"{stem}-advlayers-{digest}.so{ending}"


def _patch(path: str, names: Dict[str, str], rpath: str, soname: str = "") -> None:
    _make_unique_symbols_global(path)
    command = ["patchelf", "--set-rpath", rpath]
    if soname:
        command += ["--set-soname", soname]
    for name in needed(path):
        if name in names:
            command += ["--replace-needed", name, names[name]]
    subprocess.run([*command, path], check=True)


def _make_unique_symbols_global(path: str) -> None:
    with open(path, "r+b") as file:
        for offset in unique_symbols(path):
            file.seek(offset)
            kind = file.read(1)[0] & 0xF
            file.seek(offset)
            file.write(bytes([_STB_GLOBAL << 4 | kind]))


def unique_symbols(path: str) -> List[int]:
    """Where in the file the st_info of each is (ELF-64, little-endian: System V gABI, 4)."""
    with open(path, "rb") as file:
        data = file.read()
    if data[4:6] != b"\x02\x01":
        raise ValueError(f"{path} is no little-endian ELF-64 file")
    table, = struct.unpack_from("<Q", data, 40)
    size, count = struct.unpack_from("<HH", data, 58)
    found = []
    for section in range(table, table + size * count, size):
        kind, = struct.unpack_from("<I", data, section + 4)
        if kind == _SHT_DYNSYM:
            begin, length = struct.unpack_from("<QQ", data, section + 24)
            found += [symbol + 4 for symbol in range(begin, begin + length, 24)
                      if data[symbol + 4] >> 4 == _STB_GNU_UNIQUE]
    return found


def _glibc_versions(path: str) -> Set:
    text = subprocess.run(["readelf", "--version-info", "--wide", path], check=True,
                          capture_output=True, text=True).stdout
    return {tuple(int(part) for part in found.split("."))
            for found in re.findall(r"Name: GLIBC_([0-9.]+)", text)}

"""The licences of what a wheel carries: our own, those of libraries and of headers compiled in."""
from __future__ import annotations

import os
import re
import subprocess
from typing import Dict, Iterable

# Headers that are compiled in: a Debian package that has each, and what it is under.
_HEADERS = (("Eigen", "libeigen3-dev", "MPL-2.0"), ("Boost", "libboost*-dev", "BSL-1.0"),
            ("pybind11", "pybind11-dev", "BSD-3-Clause"))


def texts(root: str, carried: Iterable) -> Dict[str, bytes]:
    """By the name in the wheel's folder of licences. `carried`: of graft.Carried."""
    with open(os.path.join(root, "LICENSE"), "rb") as file:
        found = {"LICENSE": file.read()}
    lines = ["advlayers-core is under LGPL-2.1-or-later (LICENSE). Its wheel carries:", ""]
    for library in carried:
        package = _owner(library.origin)
        text = _copyright(package)
        if text:
            found[f"{package}.txt"] = text
        lines.append(f"{library.name}: of {package or library.origin}"
                     + (f", see {package}.txt" if text else ""))
    for title, pattern, licence in _HEADERS:
        package = _installed(pattern)
        text = _copyright(package)
        if text:
            found[f"{package}.txt"] = text
        lines.append(f"{title} (headers, compiled in): {licence}"
                     + (f", see {package}.txt" if text else ""))
    found["CARRIED.txt"] = ("\n".join(lines) + "\n").encode()
    return found


def _owner(path: str) -> str:
    """The Debian package, or "" elsewhere. The file may be known without the /usr before it."""
    for name in (path, re.sub(r"^/usr", "", path), "/usr" + path):
        line = _said("dpkg-query", "-S", name)
        if line:
            return line.split(":")[0]
    return ""


def _installed(pattern: str) -> str:
    for line in _said("dpkg-query", "-W", "-f", "${db:Status-Status} ${Package}\n",
                      pattern).splitlines():
        state, _space, package = line.partition(" ")
        if state == "installed":
            return package
    return ""


def _copyright(package: str) -> bytes:
    path = f"/usr/share/doc/{package}/copyright"
    if not package or not os.path.exists(path):
        return b""
    with open(path, "rb") as file:
        return file.read()


def _said(*command: str) -> str:
    try:
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout
    except FileNotFoundError:
        return ""

"""Running the programs that fill volumes, so that a window can show it and stop it."""
from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from typing import Any, Callable, List, NamedTuple, Tuple

_POLL = 0.05  # [s] between two looks at the program


class Cells(NamedTuple):
    """What came out; indices into the nodes, of which the skin's come first and as they were."""

    nodes: Any
    tetrahedra: Any
    pyramids: Any
    solid_of_tetrahedron: Any  # number of the solid, from 1
    solid_of_pyramid: Any


def call(command: List[str], folder: str, watch: Callable[[], None]) -> Tuple[str, int]:
    """What the program printed, and its exit status. What `watch` raises ends the program."""
    log = os.path.join(folder, "log.txt")
    with open(log, "w", encoding="utf-8") as file:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=file,
                                   stderr=subprocess.STDOUT)
        try:
            while process.poll() is None:
                watch()
                time.sleep(_POLL)
        except BaseException:
            process.kill()
            process.wait()
            raise
    with open(log, encoding="utf-8", errors="replace") as file:
        return file.read(), process.returncode


def gmsh() -> str:
    """The Gmsh that FreeCAD's FEM workbench is set up with, else the one on the path; empty: none.
    """
    command = shutil.which("gmsh") or ""
    if "FreeCAD" in sys.modules:
        import FreeCAD

        kept = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Fem/Gmsh")
        if not kept.GetBool("UseStandardGmshLocation", True):
            command = kept.GetString("gmshBinaryPath", "") or command
        command = command or os.path.join(FreeCAD.getHomePath(), "bin", "gmsh")
    return command if os.access(command, os.X_OK) else ""


def python_with_netgen() -> str:
    """A Python that has Netgen's package; empty: none."""
    own = sys.executable if os.path.basename(sys.executable).startswith("python") else ""
    for command in (own, shutil.which("python3") or "", "/usr/bin/python3"):
        if os.access(command, os.X_OK) and not subprocess.run(
                [command, "-c", "import numpy, netgen.meshing"], stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode:
            return command
    return ""

"""What is installed here, as a text to copy into a report."""
from __future__ import annotations

import os
import platform
import sys
from typing import List, Tuple

import advlayers
from advlayers.core_access import load_core
from advlayers.errors import CoreMissing


def text() -> str:
    return "\n".join(f"{title}: {said}" for title, said in rows())


def rows() -> List[Tuple[str, str]]:
    found = [("Advancing Layers", f"{advlayers.__version__} ({_folder(advlayers)})")]
    try:
        core = load_core()
        found += [("Core", f"{core.__version__} ({_folder(core)})"),
                  ("OpenCASCADE of the core", core.kernel_version)]
    except CoreMissing as error:
        found.append(("Core", str(error)))
    if "FreeCAD" in sys.modules:
        found += _of_freecad()
    return found + [("Python", f"{platform.python_version()} ({sys.executable or 'built in'})"),
                    ("System", f"{platform.platform()}, {' '.join(platform.libc_ver())}")]


def _of_freecad() -> List[Tuple[str, str]]:
    import FreeCAD
    import Part

    version = FreeCAD.Version()
    return [("FreeCAD", f"{'.'.join(version[:3])} ({version[3]})"),
            ("OpenCASCADE of FreeCAD", Part.OCC_VERSION)]


def _folder(module) -> str:
    return os.path.dirname(os.path.abspath(module.__file__))

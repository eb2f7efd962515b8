"""Starts another FreeCAD window with its own add-on folder, and runs a function of ours in it."""
import json
import os
import shutil
import subprocess
import textwrap

from window import ROOT

_SCRIPT = """
import json, os, sys, traceback
from PySide import QtCore
def run():
    seen = {{}}
    try:
        exec(compile(open({code!r}).read(), {code!r}, "exec"), {{"seen": seen, "ROOT": {root!r}}})
    except BaseException:
        seen["error"] = traceback.format_exc()
    with open({note!r}, "w") as file:
        json.dump(seen, file)
    os._exit(0)
QtCore.QTimer.singleShot(0, run)
"""


_SESSION = """
import os, traceback
from PySide import QtCore
def run():
    try:
        exec(compile(open({code!r}).read(), {code!r}, "exec"), {{}})
    except BaseException:
        traceback.print_exc()
        os._exit(3)
QtCore.QTimer.singleShot(0, run)
"""


def link_add_on(home):
    (home / "Mod").mkdir(parents=True, exist_ok=True)
    (home / "Mod" / "AdvancingLayers").symlink_to(ROOT)


def copy_without_core(home):
    """The add-on as a checkout that was never built."""
    target = home / "Mod" / "AdvancingLayers"
    target.mkdir(parents=True)
    for name in ("Init.py", "InitGui.py", "package.xml"):
        shutil.copy(os.path.join(ROOT, name), target)
    for name in ("App", "Gui", "Resources", os.path.join("mesher_core", "python")):
        shutil.copytree(os.path.join(ROOT, name), target / name,
                        ignore=shutil.ignore_patterns("_core*.so", "__pycache__"))


def run(home, code):
    """What the code put into `seen`, and what FreeCAD printed."""
    home.mkdir(exist_ok=True)
    note = home / "seen.json"
    done = _start(home, code, _SCRIPT, note=str(note), root=ROOT)
    seen = json.loads(note.read_text())
    assert "error" not in seen, seen["error"]
    return seen, done.stdout + done.stderr


def run_until_it_quits(home, code):
    """The exit status, and what FreeCAD printed; the code sees to it that FreeCAD quits."""
    done = _start(home, code, _SESSION)
    return done.returncode, done.stdout + done.stderr


def _start(home, code, template, **values):
    script, body = home / "start.py", home / "body.py"
    body.write_text(textwrap.dedent(code))
    script.write_text(template.format(code=str(body), **values))
    return subprocess.run(
        ["freecad", str(script)], stdin=subprocess.DEVNULL, capture_output=True, text=True,
        timeout=120, check=False, env={**os.environ, "FREECAD_USER_HOME": str(home)})

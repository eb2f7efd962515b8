"""FreeCAD's window runs this at its start: all GUI tests in one window, then it ends.

FreeCAD ignores what a start-up script raises and stays open, so the end is always os._exit.
"""
import os
import sys
import traceback

from PySide import QtCore

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "gui")


def run():
    status = 1
    # FreeCAD has the window's report view in their place, and 1.1 prints nothing beside it.
    sys.stdout, sys.stderr = (open(number, "w", closefd=False) for number in (1, 2))
    try:
        import pytest

        status = int(pytest.main(["-q", "-p", "no:cacheprovider", FOLDER]))
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


QtCore.QTimer.singleShot(0, run)

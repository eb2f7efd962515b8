"""Acting in FreeCAD's window as a user does."""
import os
import time

import FreeCADGui
from PySide import QtCore, QtGui

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__)))))
PICTURES = os.path.join(ROOT, "out", "gui")


def events(seconds=0.05):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()
        time.sleep(0.005)


def screenshot(name):
    """Of the whole screen: a widget's own grab leaves the 3D view blank in some versions."""
    os.makedirs(PICTURES, exist_ok=True)
    path = os.path.join(PICTURES, name)
    assert QtGui.QApplication.primaryScreen().grabWindow(0).save(path)
    return path


def select(*picks):
    """Pairs of an object and the name of a face or edge, or "" for all of it."""
    FreeCADGui.Selection.clearSelection()
    for document_object, name in picks:
        FreeCADGui.Selection.addSelection(document_object.Document.Name, document_object.Name,
                                          name)
    events()


def run(name):
    """One of our commands."""
    FreeCADGui.runCommand(f"AdvLayers_{name}")
    events()


def close_panel():
    """Presses OK where a task panel is open."""
    for box in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        button = box.button(QtGui.QDialogButtonBox.Ok)
        if FreeCADGui.Control.activeDialog() and button is not None and button.isVisible():
            button.click()
            events()
            return


def answer_message(seen):
    """Closes the message box that comes up next, and keeps its text."""
    def close():
        message = QtGui.QApplication.activeModalWidget()
        if message is None:
            QtCore.QTimer.singleShot(50, close)
            return
        seen.append(message.text())
        message.close()
    QtCore.QTimer.singleShot(50, close)

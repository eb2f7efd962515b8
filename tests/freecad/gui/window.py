"""Acting in FreeCAD's window as a user does."""
import os
import time

import FreeCADGui
from PySide import QtCore, QtGui

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__)))))
PICTURES = os.path.join(ROOT, "out", "gui")


_DEFERRED_DELETE = 52  # QEvent.DeferredDelete: a number for Qt 5, an enumeration for Qt 6


def events(seconds=0.05):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()
        # Within a test Qt never comes back to the loop that would do this.
        QtCore.QCoreApplication.sendPostedEvents(None, _DEFERRED_DELETE)
        time.sleep(0.005)


def wait_for(condition, seconds=60.0):
    """Lets the window live until the condition holds. Returns the longest time that one turn of
    the event loop took the window's thread; the clock's time depends on what else is running."""
    end = time.monotonic() + seconds
    longest = 0.0
    while not condition():
        assert time.monotonic() < end, "it never came about"
        start = time.thread_time()
        QtGui.QApplication.processEvents()
        longest = max(longest, time.thread_time() - start)
        time.sleep(0.002)
    return longest


def screenshot(name, settle=0.2):
    """Of the whole screen: a widget's own grab leaves the 3D view blank in some versions. Without
    the report view, which comes up with the first error and takes room from the 3D view."""
    report = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "Report view")
    if report is not None and report.isVisible():
        report.hide()
    events(settle)
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


def edit(document_object):
    """Opens the panel of an object, as a double click does."""
    assert document_object.ViewObject.Proxy.doubleClicked(document_object.ViewObject)
    events()
    assert FreeCADGui.Control.activeDialog()


def panel_of(document_object):
    return document_object.ViewObject.Proxy.panel


def child(kind, name):
    """A widget of the open panel."""
    found = [widget for widget in FreeCADGui.getMainWindow().findChildren(kind, name)]
    assert found, name
    return found[-1]


def click(name):
    child(QtGui.QAbstractButton, name).click()
    events()


def choose(name):
    """An entry of a button's menu."""
    child(QtGui.QAction, name).trigger()
    events()


def status():
    return child(QtGui.QLabel, "AdvLayersStatus").text()


def mesh_until_done(mesh_object, seconds=60.0):
    """Presses Mesh and waits for the end of the run."""
    panel = panel_of(mesh_object)
    click("AdvLayersMeshButton")
    longest = wait_for(lambda: not panel.meshing and not panel.scene.busy, seconds)
    events()
    return longest


def press(standard_button):
    """Presses a button of the task panel."""
    for box in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        try:
            button = box.button(standard_button)
        except RuntimeError:  # of a panel that was closed: PySide still knows it
            continue
        if button is not None and button.isVisible():
            button.click()
            events()
            return
    raise AssertionError("no such button in the task panel")


def press_ok():
    press(QtGui.QDialogButtonBox.Ok)
    wait_for(lambda: not FreeCADGui.Control.activeDialog())


def asked():
    """Whether the panel asks before it closes."""
    found = FreeCADGui.getMainWindow().findChildren(QtGui.QWidget, "AdvLayersQuestion")
    return any(widget.isVisible() for widget in found)


def press_cancel():
    """Discards what there is to lose."""
    press(QtGui.QDialogButtonBox.Cancel)
    if asked():
        click("AdvLayersDiscard")
    assert not FreeCADGui.Control.activeDialog()


def close_panel():
    """Presses OK where a task panel is open."""
    if FreeCADGui.Control.activeDialog():
        press_ok()


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


def report_text():
    """What the report view shows."""
    view = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view")
    return view.toPlainText()


def errors_since(length):
    """Lines of the report view after so many characters that tell of trouble."""
    words = ("error", "exception", "traceback", "advancing layers:")
    return [line for line in report_text()[length:].splitlines()
            if any(word in line.lower() for word in words)]

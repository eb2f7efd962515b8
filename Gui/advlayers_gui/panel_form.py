"""The widget of a task panel: F1 tells what the field with the focus is for."""
from __future__ import annotations

from PySide import QtCore, QtGui


class PanelForm(QtGui.QWidget):
    def event(self, event) -> bool:
        # Else FreeCAD's own F1 takes the key: it looks for help on the net.
        if event.type() == QtCore.QEvent.ShortcutOverride and event.key() == QtCore.Qt.Key_F1:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event) -> None:
        if event.key() != QtCore.Qt.Key_F1:
            super().keyPressEvent(event)
            return
        widget = QtGui.QApplication.focusWidget()
        while widget is not None and not widget.whatsThis() and widget is not self:
            widget = widget.parentWidget()
        if widget is None or not widget.whatsThis():
            from advlayers_gui import help_window

            help_window.show()
        else:
            place = widget.mapToGlobal(QtCore.QPoint(0, widget.height()))
            QtGui.QWhatsThis.showText(place, widget.whatsThis(), widget)

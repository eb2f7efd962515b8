"""What the commands have in common: how they are announced, recorded, undone, and how they fail."""
from __future__ import annotations

from typing import Dict

import FreeCAD
import FreeCADGui
from PySide import QtGui

from advlayers_gui.resources import icon

TITLE = "Advancing Layers"
_TOLD = 15000  # [ms] that the status bar shows what was done


class Command:
    """A command of the workbench; run() does the work and may raise what the user is told."""

    NAME = ""  # without the prefix
    MENU = ""
    TOOLTIP = ""
    KEYS = ""

    def GetResources(self) -> Dict[str, str]:
        # FreeCAD itself translates these, in the context of the command's name.
        return {"Pixmap": icon(f"AdvLayers_{self.NAME}"), "MenuText": self.MENU,
                "ToolTip": self.TOOLTIP, "Accel": self.KEYS}

    @property
    def title(self) -> str:
        """In the user's language; of a step of undo."""
        return FreeCAD.Qt.translate(f"AdvLayers_{self.NAME}", self.MENU).rstrip("…")

    def IsActive(self) -> bool:
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        from advlayers.errors import Stopped
        from advlayers.sentence import of_error

        try:
            self.run()
        except Stopped:
            pass
        except (ValueError, RuntimeError) as error:
            show_error(of_error(error).translated)

    def run(self) -> None:
        raise NotImplementedError


class Transaction:
    """One step of undo; taken back where the work inside fails, or gone with its document."""

    def __init__(self, document, name: str) -> None:
        self._document, self._name = document, name
        self._document_name = document.Name

    def __enter__(self) -> None:
        self._document.openTransaction(self._name)

    def __exit__(self, kind, _error, _trace) -> None:
        if self._document_name not in FreeCAD.listDocuments():
            return
        if kind is None:
            self._document.commitTransaction()
        else:
            self._document.abortTransaction()


def show_error(text: str) -> None:
    FreeCAD.Console.PrintError(f"{TITLE}: {text}\n")
    QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), TITLE, text)


def tell(text: str) -> None:
    """What a command has done, where the user looks and where it can be read again."""
    FreeCAD.Console.PrintMessage(f"{TITLE}: {text}\n")
    FreeCADGui.getMainWindow().statusBar().showMessage(text, _TOLD)


def do(code: str) -> None:
    """Runs a line in the console's namespace; the macro recorder and the console see it."""
    FreeCADGui.doCommand(code)


def in_code(document_object) -> str:
    """The object, as a line of code has it."""
    return (f"FreeCAD.getDocument({document_object.Document.Name!r})"
            f".getObject({document_object.Name!r})")


def call_on(document_object, title: str, importing: str, function: str) -> None:
    """Calls a function with the object as a macro would, in one step of undo."""
    with Transaction(document_object.Document, title):
        do(importing)
        do(f"{function}({in_code(document_object)})")
        document_object.Document.recompute()

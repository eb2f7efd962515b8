"""What all task panels of the workbench have in common: OK keeps the changes of one transaction,
Cancel takes them back, and every way out cleans up behind the panel. What would lose work asks
first: Cancel, Esc and undo."""
from __future__ import annotations

from typing import List, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtGui

from advlayers import cad_input
from advlayers.freecad_versions import as_number
from advlayers.language import tr
from advlayers_gui import view_3d
from advlayers_gui.escape_key import EscapeKey
from advlayers_gui.leave_question import LeaveQuestion
from advlayers_gui.panel_form import PanelForm
from advlayers_gui.recording import Recording
from advlayers_gui.settings_preview import SettingsPreview
from advlayers_gui.undo_watch import UndoWatch


class TaskPanel:
    """Edits one document object; the view provider opens the transaction."""

    TITLE = ""  # of the transaction

    def __init__(self, document_object) -> None:
        self._object = document_object
        self._document_name, self._object_name = document_object.Document.Name, document_object.Name
        self.preview = SettingsPreview(self._previewed)
        self._overlays = [view_3d.Overlay(document_object.Document, root)
                          for root in self.preview.roots]
        # Of the document before the panel's own transaction.
        document = document_object.Document
        self._undo_count = document.UndoCount - bool(document.HasPendingTransaction)
        self._visible_before: List[Tuple[str, bool]] = []
        self._recording = Recording(document_object)
        self._altered = False  # since it was opened
        self._left = False
        self._question = LeaveQuestion(self._keep, self._discard)
        self._escape = EscapeKey(self._cancel)
        self._undo_watch = UndoWatch(document, self._undone)
        self.form = PanelForm()
        self.form.setWindowIcon(QtGui.QIcon(document_object.ViewObject.Proxy.getIcon()))
        # Control.closeDialog() asks nobody.
        self.form.destroyed.connect(lambda *_form: self.leave())

    # --- what FreeCAD calls -------------------------------------------------------------------

    def getStandardButtons(self):
        return as_number(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def accept(self) -> bool:
        document = self._object.Document
        self.leave()
        document.recompute()
        self._recording.tell()
        document.commitTransaction()
        FreeCADGui.getDocument(document.Name).resetEdit()
        return True

    def reject(self) -> bool:
        at_stake = self.at_stake()
        if at_stake:
            self._question.ask(at_stake)
            return False
        self._discard()
        return True

    # --- ways out -----------------------------------------------------------------------------

    def at_stake(self) -> str:
        """What would be lost with the panel, as the question has it; empty where nothing would."""
        return tr("The changes made here are not kept yet.") if self._altered else ""

    def _keep(self) -> None:
        """As it is now."""
        self.accept()

    def _discard(self) -> None:
        self.leave()
        document = FreeCAD.getDocument(self._document_name)
        if document.HasPendingTransaction:
            document.abortTransaction()
        # An undo that was taken back, or work in another document, has closed a transaction.
        while document.UndoCount > self._undo_count:
            document.undo()
        self._restore_visibility()  # once more: it may have been part of the transaction
        FreeCADGui.getDocument(document.Name).resetEdit()
        document.recompute()

    def _cancel(self) -> None:
        """As the button does."""
        if not self._left:
            self.reject()

    def leave_unasked(self) -> None:
        """FreeCAD ends the edit: a script asks for it, or the object is going away."""
        self.leave()

    def _undone(self) -> None:
        """After an undo: where it took back work of this panel, the work is brought back, and the
        question asked."""
        if self._document_name not in FreeCAD.listDocuments():
            return
        document = FreeCAD.getDocument(self._document_name)
        at_stake = self.at_stake()
        if not at_stake:
            if not self._left:
                self._reload()
            return
        document.redo()
        panel = self
        if self._left:  # its object had gone, and the panel with it
            FreeCADGui.getDocument(document.Name).setEdit(self._object_name)
            panel = document.getObject(self._object_name).ViewObject.Proxy.panel
            panel._take_over(self)
        document.openTransaction(tr(self.TITLE))
        panel._question.ask(tr("Undo would take back all of this panel.") + " " + at_stake)

    def _take_over(self, other: TaskPanel) -> None:
        """The work of an earlier panel of the same object."""
        self._undo_count, self._altered = other._undo_count, other._altered
        self._visible_before = other._visible_before

    def _reload(self) -> None:
        """Shows the properties as they are now."""

    def leave(self) -> None:
        """Takes away all that the panel has put up outside of itself; more than once if need be."""
        if not self._left:
            self._left = True
            self._escape.release()
            self._undo_watch.release()
            for overlay in self._overlays:
                overlay.remove()
            self.preview.clear()
            self._clean_up()
            self._restore_visibility()

    def _remember_visibility(self, *things) -> None:
        """The panel shows and hides them as it needs, until it is left."""
        self._visible_before = [(thing.Name, thing.ViewObject.Visibility) for thing in things]

    def _look_at(self, source) -> None:
        """The view shows the shape, unless it does already."""
        view_3d.fit_unseen(self._object.Document, cad_input.global_shape(source).BoundBox)

    def _restore_visibility(self) -> None:
        if self._document_name in FreeCAD.listDocuments():
            document = FreeCAD.getDocument(self._document_name)
            for name, visible in self._visible_before:
                thing = document.getObject(name)
                if thing is not None and thing.ViewObject.Visibility != visible:
                    thing.ViewObject.Visibility = visible

    def _previewed(self, wrong: str) -> None:
        """The preview is drawn, or says what is wrong with the walls."""

    def _clean_up(self) -> None:
        """For what a panel has beside overlays."""

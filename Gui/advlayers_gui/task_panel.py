"""What all task panels of the workbench have in common: OK keeps the changes of one transaction,
Cancel takes them back, and every way out cleans up behind the panel."""
from __future__ import annotations

from typing import List, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtGui

from advlayers import cad_input
from advlayers.errors import InputError
from advlayers.freecad_versions import as_number
from advlayers.height_lines import wall_lines
from advlayers.layer_mesh import settings_of
from advlayers.sentence import of_error
from advlayers_gui.height_preview import HeightPreview
from advlayers_gui.recording import Recording
from advlayers_gui.view_3d import Overlay

# A preview of more edges than this would keep the window waiting after each change.
_MOST_EDGES = 600


class TaskPanel:
    """Edits one document object; the view provider opens the transaction."""

    TITLE = ""  # of the transaction

    def __init__(self, document_object) -> None:
        self._object = document_object
        self._document_name, self._object_name = document_object.Document.Name, document_object.Name
        self.heights = HeightPreview()
        self._overlays = [Overlay(document_object.Document, self.heights.root)]
        self._undo_count = document_object.Document.UndoCount
        self._visible_before: List[Tuple[str, bool]] = []
        self._recording = Recording(document_object)
        self._left = False
        self.form = QtGui.QWidget()
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
        self.leave()
        document = FreeCAD.getDocument(self._document_name)
        if document.HasPendingTransaction:
            document.abortTransaction()
        elif document.UndoCount > self._undo_count:
            document.undo()  # work in another document has closed the transaction meanwhile
        self._restore_visibility()  # once more: it may have been part of the transaction
        FreeCADGui.getDocument(document.Name).resetEdit()
        document.recompute()
        return True

    # ------------------------------------------------------------------------------------------

    def leave(self) -> None:
        """Takes away all that the panel has put up outside of itself; more than once if need be."""
        if not self._left:
            self._left = True
            for overlay in self._overlays:
                overlay.remove()
            self.heights.clear()
            self._clean_up()
            self._restore_visibility()

    def _remember_visibility(self, *things) -> None:
        """The panel shows and hides them as it needs, until it is left."""
        self._visible_before = [(thing.Name, thing.ViewObject.Visibility) for thing in things]

    def _restore_visibility(self) -> None:
        if self._document_name in FreeCAD.listDocuments():
            document = FreeCAD.getDocument(self._document_name)
            for name, visible in self._visible_before:
                thing = document.getObject(name)
                if thing is not None and thing.ViewObject.Visibility != visible:
                    thing.ViewObject.Visibility = visible

    def _clean_up(self) -> None:
        """For what a panel has beside overlays."""

    def _preview_heights(self, mesh_object) -> str:
        """Draws the heights as they are asked for; returns what is wrong with the settings."""
        self.heights.clear()
        if mesh_object is None or mesh_object.Part is None:
            return ""
        try:
            settings = settings_of(mesh_object)
        except InputError as error:
            return error.sentence.translated
        shape = cad_input.global_shape(mesh_object.Part)
        if len(shape.Edges) <= _MOST_EDGES:
            try:
                self.heights.show(wall_lines(shape, settings))
            except ValueError as error:  # of the core: a wall that contradicts itself
                return of_error(error).translated
        return ""

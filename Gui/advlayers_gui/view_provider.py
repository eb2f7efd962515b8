"""How a layer mesh shows in the tree and in the view."""
from __future__ import annotations

import contextlib
from typing import Any, Callable, Set

import FreeCAD
import FreeCADGui
from pivy import coin
from PySide import QtCore, QtGui

from advlayers.controls import children, is_control, mesh_of
from advlayers.errors import InputError
from advlayers.freecad_versions import Stateless
from advlayers.language import tr
from advlayers.layer_mesh import LOST_REFERENCES, OUT_OF_DATE, SOURCE_IN_ERROR
from advlayers.properties import HIDDEN
from advlayers_gui import view_3d
from advlayers_gui.command import show_error
from advlayers_gui.resources import icon
from advlayers_gui.field_modes import FieldView

_GONE = (ReferenceError, RuntimeError)  # the document was closed, the object was deleted
_to_fit: Set[str] = set()  # names of documents
_NOTHING = "Nothing"  # the display mode of what has no picture of its own


class EditedInPanel:
    """The part of a view provider that opens and closes a task panel."""

    panel: Any = None  # while it is open

    def panel_class(self, document_object):
        """Raises InputError where there is nothing to edit."""
        raise NotImplementedError

    def setEdit(self, view_object, mode=0) -> bool:
        if mode != 0 or FreeCADGui.Control.activeDialog():
            return False
        document = view_object.Object.Document
        try:
            panel_class = self.panel_class(view_object.Object)
        except InputError as error:
            show_error(error.sentence.translated)
            return False
        # Before the panel hides and shows things: undo is to bring back what was seen before it.
        if not document.HasPendingTransaction:
            document.openTransaction(tr(panel_class.TITLE))
        self.panel = panel_class(view_object.Object)
        FreeCADGui.Control.showDialog(self.panel)
        return True

    def unsetEdit(self, _view_object, _mode=0) -> bool:
        if self.panel is not None:
            panel, self.panel = self.panel, None
            panel.leave_unasked()
            FreeCADGui.Control.closeDialog()
        return True

    def setupContextMenu(self, view_object, menu) -> None:
        edit = menu.addAction(QtGui.QIcon(self.getIcon()), tr("Edit"))
        edit.triggered.connect(lambda _checked=False: self.doubleClicked(view_object))

    def doubleClicked(self, view_object) -> bool:
        if FreeCADGui.Control.activeDialog():
            FreeCAD.Console.PrintWarning(tr("Close the open task panel first.") + "\n")
        else:
            view_object.Document.setEdit(view_object.Object.Name)
        return True


class LayerMeshView(Stateless, EditedInPanel, FieldView):
    """View provider of a layer mesh."""

    _object = None
    _stale = False  # FreeCAD's own picture is of an earlier mesh

    def __init__(self, view_object) -> None:
        view_object.Proxy = self

    def attach(self, view_object) -> None:
        super().attach(view_object)
        self._object = view_object.Object
        self._redraw, self._show = _turn_of(self._draw_unseen), _turn_of(self._show_again)

    def redraw(self) -> None:
        """FreeCAD's own picture of the mesh is to be made anew in the next turn of the event loop.
        """
        self._stale = True
        self._redraw.start()

    def draw(self) -> None:
        """Makes it at once, where that is still to be done."""
        if self._stale:
            self._stale = False
            self._redraw.stop()
            self._object.ViewObject.update()

    def _draw_unseen(self) -> None:
        """A picture that is shown would be painted in the same turn."""
        with contextlib.suppress(*_GONE):
            self._object.ViewObject.SwitchNode.whichChild = coin.SO_SWITCH_NONE
            self._show.start()
            self.draw()

    def _show_again(self) -> None:
        with contextlib.suppress(*_GONE):
            view_object = self._object.ViewObject
            if view_object.Visibility:
                view_object.show()

    def getIcon(self) -> str:
        stale = self._object is not None and self._object.State in (
            OUT_OF_DATE, LOST_REFERENCES, SOURCE_IN_ERROR)
        return icon("AdvLayers_LayerMesh_Stale" if stale else "AdvLayers_LayerMesh")

    def updateData(self, mesh_object, name: str) -> None:
        super().updateData(mesh_object, name)
        if name == "State":
            mesh_object.ViewObject.signalChangeIcon()

    def claimChildren(self):
        return children(self._object)

    def panel_class(self, document_object):
        from advlayers_gui.mesh_panel import MeshPanel

        if document_object.Part is None:
            raise InputError("", "Part of {} is empty: there is nothing to mesh",
                             document_object.Label)
        return MeshPanel


def _turn_of(work: Callable[[], None]):
    """A timer that does the work once, in the turn of the event loop after its start()."""
    timer = QtCore.QTimer()
    timer.setSingleShot(True)
    timer.timeout.connect(work)
    return timer


class ControlView(Stateless, EditedInPanel):
    """View provider of a wall, a size or a group."""

    _object = None

    def __init__(self, view_object) -> None:
        view_object.Proxy = self

    def attach(self, view_object) -> None:
        self._object = view_object.Object
        # The tree shows what has no display mode in grey, like something hidden.
        view_object.addDisplayMode(coin.SoGroup(), _NOTHING)

    def getDisplayModes(self, _view_object):
        return [_NOTHING]

    def getDefaultDisplayMode(self) -> str:
        return _NOTHING

    def getIcon(self) -> str:
        return icon(f"AdvLayers_{type(self._object.Proxy).__name__}")

    def panel_class(self, document_object):
        from advlayers_gui.control_panel import ControlPanel

        mesh_object = mesh_of(document_object)
        if mesh_object is None or mesh_object.Part is None:
            raise InputError("", "{} belongs to no layer mesh of a shape", document_object.Label)
        return ControlPanel


def attach_to(document_object) -> None:
    """Gives the object our view provider, unless it has it."""
    view_object = document_object.ViewObject
    if view_object is None:
        return
    if not isinstance(view_object.Proxy, (LayerMeshView, ControlView)):
        _give_provider(document_object, view_object)
        if document_object.Document.Restoring:
            _show_restored(document_object)
    if not is_control(document_object):
        keep_all_faces(document_object)


def _show_restored(document_object) -> None:
    """FreeCAD hides all that a file says nothing of, and one saved without a window says nothing:
    its document would open as an empty view, and one that looks elsewhere."""
    _fit_soon(document_object.Document.Name)
    if is_control(document_object):
        document_object.ViewObject.Visibility = True
    elif document_object.FemMesh.FaceCount:
        show_mesh(document_object)
    elif document_object.Part is not None:
        document_object.Part.ViewObject.Visibility = True


def _fit_soon(name: str) -> None:
    """Once the document is open, and once for all of its objects."""
    if name in _to_fit:
        return

    def fit() -> None:
        _to_fit.discard(name)
        if name in FreeCAD.listDocuments():
            view_3d.fit_all(FreeCAD.getDocument(name))

    _to_fit.add(name)
    QtCore.QTimer.singleShot(0, fit)


def _give_provider(document_object, view_object) -> None:
    if is_control(document_object):
        ControlView(view_object)
    else:
        LayerMeshView(view_object)
        # The mesh's own edges show what was made; the shape below would hide half of it.
        view_object.ShapeColor = (0.80, 0.87, 0.95)
    # FreeCAD attaches the first provider of an object, and no later one.
    if view_object.Proxy._object is None:
        view_object.Proxy.attach(view_object)


def show_mesh(document_object) -> None:
    """In place of the shape."""
    document_object.Part.ViewObject.Visibility = False
    document_object.ViewObject.Visibility = True


def keep_all_faces(document_object) -> None:
    """FreeCAD hides faces between two volumes; a surface mesh has none, and to look for them takes
    seconds, or minutes, where layers make elements crowd. Only below a number of faces does it keep
    them all without a look, so the number is the highest there is, and no one is to lower it.

    Not saved: FreeCAD draws the mesh when it has read the number, and the other after that."""
    view_object = document_object.ViewObject
    for name, value in (("MaxFacesShowInner", 2**31 - 1), ("ShowInner", True)):
        if getattr(view_object, name) != value:
            setattr(view_object, name, value)
        view_object.setEditorMode(name, HIDDEN)
        view_object.setPropertyStatus(name, "Transient")

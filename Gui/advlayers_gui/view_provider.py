"""How a layer mesh shows in the tree and in the view."""
from __future__ import annotations

import FreeCAD
import FreeCADGui

from advlayers.controls import children, is_control
from advlayers.proxy import Stateless
from advlayers_gui.resources import icon
from advlayers_gui.field_modes import FieldView


class LayerMeshView(Stateless, FieldView):
    """View provider of a layer mesh."""

    _object = None

    def __init__(self, view_object) -> None:
        view_object.Proxy = self

    def attach(self, view_object) -> None:
        super().attach(view_object)
        self._object = view_object.Object

    def getIcon(self) -> str:
        return icon("AdvLayers_LayerMesh")

    def claimChildren(self):
        return children(self._object)

    def setEdit(self, view_object, mode=0) -> bool:
        from advlayers_gui import mesh_panel

        if mode != 0 or FreeCADGui.Control.activeDialog():
            return False
        document = view_object.Object.Document
        if not document.HasPendingTransaction:
            document.openTransaction("Edit Layer Mesh")
        FreeCADGui.Control.showDialog(mesh_panel.MeshPanel(view_object.Object))
        return True

    def unsetEdit(self, _view_object, _mode=0) -> bool:
        FreeCADGui.Control.closeDialog()
        return True

    def doubleClicked(self, view_object) -> bool:
        if FreeCADGui.Control.activeDialog():
            FreeCAD.Console.PrintWarning("Close the open task panel first.\n")
        else:
            view_object.Document.setEdit(view_object.Object.Name)
        return True


class ControlView(Stateless):
    """View provider of a wall, a size or a group."""

    _object = None

    def __init__(self, view_object) -> None:
        view_object.Proxy = self

    def attach(self, view_object) -> None:
        self._object = view_object.Object

    def getIcon(self) -> str:
        return icon(f"AdvLayers_{type(self._object.Proxy).__name__}")


def attach_to(document_object) -> None:
    """Gives the object our view provider, unless it has it."""
    view_object = document_object.ViewObject
    if view_object is None or isinstance(view_object.Proxy, (LayerMeshView, ControlView)):
        return
    if is_control(document_object):
        ControlView(view_object)
    else:
        LayerMeshView(view_object)
        # The mesh's own edges show what was made; the shape below would hide half of it.
        view_object.ShapeColor = (0.80, 0.87, 0.95)
    # FreeCAD attaches the first provider of an object, and no later one.
    if view_object.Proxy._object is None:
        view_object.Proxy.attach(view_object)

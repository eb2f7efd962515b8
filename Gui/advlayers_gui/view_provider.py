"""How a layer mesh shows in the tree and in the view."""
from __future__ import annotations

import FreeCAD
import FreeCADGui

from advlayers_gui.commands import icon
from advlayers_gui.field_modes import FieldView


class LayerMeshView(FieldView):
    """View provider of a layer mesh."""

    def __init__(self, view_object) -> None:
        view_object.Proxy = self

    def getIcon(self) -> str:
        return icon("AdvLayers_LayerMesh")

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

    # FreeCAD 0.20 calls the second pair, later versions the first.
    def dumps(self):
        return None

    def loads(self, _state) -> None:
        return None

    def __getstate__(self):
        return None

    def __setstate__(self, _state) -> None:
        return None


def attach_to(document_object) -> None:
    """Gives the object our view provider, unless it has it."""
    view_object = document_object.ViewObject
    if view_object is not None and not isinstance(view_object.Proxy, LayerMeshView):
        LayerMeshView(view_object)
        # The mesh's own edges show what was made; the shape below would hide half of it.
        view_object.ShapeColor = (0.80, 0.87, 0.95)

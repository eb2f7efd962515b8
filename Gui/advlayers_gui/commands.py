"""The workbench's commands. They ask as little as possible before the mesh is there."""
from __future__ import annotations

import os
from typing import List, Optional, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtGui

_TITLE = "Advancing Layers"


def icon(name: str) -> str:
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    return os.path.join(root, "Resources", "icons", f"{name}.svg")


def show_error(text: str) -> None:
    FreeCAD.Console.PrintError(f"{_TITLE}: {text}\n")
    QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), _TITLE, text)


class LayerMeshCommand:
    """Creates a mesh object for the selected shape, or for the selected faces of one."""

    def GetResources(self):
        return {
            "Pixmap": icon("AdvLayers_LayerMesh"),
            "MenuText": "Layer Mesh…",
            "ToolTip": "Creates a quad-dominant surface mesh of the selected shape or faces, "
                       "with layers along its edges",
        }

    def IsActive(self) -> bool:
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        from advlayers import layer_mesh
        from advlayers.core_access import load_core
        from advlayers.errors import CoreMissing, InputError

        source, faces = _selected()
        if source is None:
            show_error("Select the shape to mesh, or some of its faces, first.")
            return
        document = source.Document
        document.openTransaction("Layer Mesh")
        try:
            load_core()
            settings = {"faces": faces} if faces else {}
            created = layer_mesh.create(source, **settings)
        except (InputError, CoreMissing) as error:
            document.abortTransaction()
            show_error(str(error))
            return
        _add_to_active_analysis(created)
        document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.ActiveDocument.setEdit(created.Name)


def _selected() -> Tuple[Optional[object], List[str]]:
    """The first selected object and its selected faces, if any."""
    selection = FreeCADGui.Selection.getSelectionEx()
    if not selection:
        return None, []
    first = selection[0]
    return first.Object, [name for name in first.SubElementNames if name.startswith("Face")]


def _add_to_active_analysis(created) -> None:
    """FEM solves with the one mesh of an analysis: joins the active one unless it has a mesh."""
    try:
        import FemGui
    except ImportError:
        return
    analysis = FemGui.getActiveAnalysis()
    if analysis is None or analysis.Document is not created.Document:
        return
    if not any(member.isDerivedFrom("Fem::FemMeshObject") for member in analysis.Group):
        analysis.addObject(created)


def register() -> List[str]:
    """Makes the commands known to FreeCAD; returns their names in the order of the toolbar."""
    FreeCADGui.addCommand("AdvLayers_LayerMesh", LayerMeshCommand())
    return ["AdvLayers_LayerMesh"]

"""Whether the window's part of this installation works: for FreeCAD's Test workbench."""
from __future__ import annotations

import unittest

import FreeCAD
import FreeCADGui

from advlayers_gui import commands


class Window(unittest.TestCase):
    def test_commands(self) -> None:
        names = {name for name in commands.register() if name != "Separator"}
        self.assertTrue(names <= set(FreeCADGui.listCommands()))

    def test_new_layer_mesh(self) -> None:
        document = FreeCAD.newDocument("AdvancingLayersTest")
        try:
            box = document.addObject("Part::Box", "Box")
            document.recompute()
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(box)
            FreeCADGui.runCommand("AdvLayers_LayerMesh")
            self.assertTrue(FreeCADGui.Control.activeDialog())
            FreeCADGui.ActiveDocument.resetEdit()
            self.assertIsNotNone(document.getObject("LayerMesh"))
        finally:
            FreeCADGui.Control.closeDialog()
            FreeCAD.closeDocument(document.Name)

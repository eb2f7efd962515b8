"""Whether this installation works: for FreeCAD's Test workbench and `freecadcmd -t`."""
from __future__ import annotations

import os
import tempfile
import unittest

import FreeCAD

import advlayers
from advlayers import core_access, layer_mesh


class Installation(unittest.TestCase):
    def setUp(self) -> None:
        self.document = FreeCAD.newDocument("AdvancingLayersTest")
        self.box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()

    def tearDown(self) -> None:
        for name in list(FreeCAD.listDocuments()):
            if name.startswith("AdvancingLayersTest"):
                FreeCAD.closeDocument(name)

    def test_core(self) -> None:
        self.assertTrue(core_access.load_core().Mesher)

    def test_mesh(self) -> None:
        mesh = advlayers.make_layer_mesh(self.box, size=2, first_height=0.2, layers=3)
        self.assertEqual(mesh.State, layer_mesh.UP_TO_DATE)
        self.assertGreater(mesh.QuadCount, 100)
        self.assertEqual(mesh.InvertedCount, 0)

    def test_save_and_open(self) -> None:
        mesh = advlayers.make_layer_mesh(self.box, size=3)
        advlayers.make_wall(mesh, ["Edge1"], layers=2)
        settings = layer_mesh.settings_of(mesh)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "AdvancingLayersTest_saved.FCStd")
            self.document.saveCopy(path)
            opened = FreeCAD.openDocument(path)
        self.assertEqual(layer_mesh.settings_of(opened.getObject(mesh.Name)), settings)

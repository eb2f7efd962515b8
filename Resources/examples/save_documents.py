"""Runs the macros of this folder and saves their documents beside them: `./dev examples`."""
import glob
import os
import runpy

import FreeCAD

FOLDER = os.path.dirname(os.path.abspath(__file__))


def save_all():
    for path in sorted(glob.glob(os.path.join(FOLDER, "*.FCMacro"))):
        document = FreeCAD.newDocument(os.path.basename(path)[:-len(".FCMacro")])
        runpy.run_path(path)["make"](document)
        document.saveAs(path[:-len(".FCMacro")] + ".FCStd")
        FreeCAD.closeDocument(document.Name)

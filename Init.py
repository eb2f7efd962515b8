"""FreeCAD runs this at start-up, also without a GUI: puts the add-on's packages on sys.path.

FreeCAD executes the file without __file__; the add-on's root is on sys.path by then.
"""


def add_packages():
    import os
    import sys

    import FreeCAD

    for root in map(os.path.normpath, list(sys.path)):
        if os.path.isfile(os.path.join(root, "App", "advlayers", "__init__.py")):
            for part in ("App", "Gui", os.path.join("mesher_core", "python")):
                folder = os.path.join(root, part)
                if folder not in sys.path:
                    sys.path.append(folder)
            FreeCAD.__unit_test__ += ["advlayers.selftest"]
            return


add_packages()

"""Registers the workbench's commands.

A module of its own on `sys.path`, with nothing but this call in it: FreeCAD writes `import` and
the name of the file that calls addCommand() into every recorded macro, and that line has to run
anywhere, headless too.
"""


def add(name: str, command) -> None:
    import FreeCADGui

    FreeCADGui.addCommand(name, command)

"""FreeCAD runs this when its window starts: offers the workbench, loads nothing yet.

FreeCAD executes the file inside a function of its own, so names of this file are not seen from
the methods below: every import stands inside the method that needs it.
"""
import FreeCADGui


class AdvancingLayersWorkbench(FreeCADGui.Workbench):
    MenuText = "Advancing Layers"
    ToolTip = "Quad-dominant surface meshes that grow in layers from the edges of CAD faces"

    def __init__(self):
        import os
        import FreeCAD
        import FreeCADGui
        import advlayers
        from advlayers import window

        def views():
            from advlayers_gui import view_provider

            return view_provider

        def update_beside(document_object, task):
            from advlayers_gui import automatic_update

            automatic_update.ask(document_object, task)

        window.register(views, update_beside)
        root = os.path.dirname(os.path.dirname(os.path.dirname(advlayers.__file__)))
        resources = os.path.join(root, "Resources")
        self.__class__.Icon = os.path.join(resources, "icons", "AdvancingLayers.svg")
        # Here, not in Initialize: the preferences may be opened before the workbench.
        FreeCADGui.addIconPath(os.path.join(resources, "icons"))
        FreeCADGui.addLanguagePath(os.path.join(resources, "translations"))
        FreeCADGui.updateLocale()
        FreeCADGui.addPreferencePage(os.path.join(resources, "ui", "preferences.ui"),
                                     "Advancing Layers")
        FreeCAD.__unit_test__ += ["advlayers_gui.selftest"]

    def GetClassName(self):
        return "Gui::PythonWorkbench"

    def Initialize(self):
        from advlayers_gui import commands

        names = commands.register()
        self.appendToolbar("Advancing Layers", names)
        self.appendMenu("Advancing Layers", names)

    def Activated(self):
        import FreeCAD
        from advlayers import revive

        for document in FreeCAD.listDocuments().values():
            revive.revive(document)

    def ContextMenu(self, _recipient):
        from advlayers_gui import commands

        names = commands.context_commands()
        if names:
            self.appendContextMenu("Advancing Layers", names)


FreeCADGui.addWorkbench(AdvancingLayersWorkbench())

"""Commands that add objects to the document: layer mesh, wall, size, group."""
from __future__ import annotations

from typing import Any, Dict, List, Tuple

import FreeCAD
import FreeCADGui

from advlayers_gui import selected
from advlayers_gui.command import Command, Transaction, do, in_code


class LayerMesh(Command):
    NAME = "LayerMesh"
    MENU = "Layer Mesh…"
    TOOLTIP = ("Creates a quad-dominant surface mesh of the selected shape or faces, with layers "
               "along its edges, or along the selected ones")
    KEYS = "Y, L"

    def run(self) -> None:
        from advlayers import preferences
        from advlayers.core_access import load_core
        from advlayers.errors import InputError

        found = selected.source()
        if found is None:
            raise InputError("", "Select the shape to mesh, or some of its faces, first.")
        source, picked = found
        load_core()
        settings = {**preferences.settings(), **_picked_settings(picked)}
        document = source.Document
        words = "".join(f", {key}={value!r}" for key, value in settings.items())
        document.openTransaction(self.title)
        try:
            do("import advlayers")
            do(f"mesh = advlayers.make_layer_mesh({in_code(source)}, mesh_now=False{words})")
        except Exception:
            document.abortTransaction()
            raise
        # The panel commits the transaction, or takes it back.
        created = document.ActiveObject
        _join_active_analysis(created)
        document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.getDocument(document.Name).setEdit(created.Name)


def _picked_settings(names: List[str]) -> Dict[str, Any]:
    """Only the faces among them are meshed, and layers grow from the edges among them alone."""
    found: Dict[str, Any] = {}
    faces = [name for name in names if name.startswith("Face")]
    edges = [name for name in names if name.startswith("Edge")]
    if faces:
        found["faces"] = faces
    if edges:
        found["walls"] = [{"edges": edges}]
    return found


def _join_active_analysis(created) -> None:
    """FEM solves with the one mesh of an analysis: joins the active one unless it has a mesh."""
    from advlayers import analysis

    try:
        import FemGui
    except ImportError:
        return
    active = FemGui.getActiveAnalysis()
    if active is None or active.Document is not created.Document:
        return
    if analysis.mesh_of(active) is None:
        do(f"{in_code(active)}.addObject({in_code(created)})")


class _Child(Command):
    """Adds a child to a layer mesh for the selected faces and edges."""

    FUNCTION = ""
    SUBJECT = ""

    def IsActive(self) -> bool:
        return super().IsActive() and bool(selected.all_layer_meshes())

    def run(self) -> None:
        from advlayers.errors import InputError

        picks = selected.picks()
        mesh = selected.mesh_for(picks)
        if mesh is None:
            raise InputError("", "Select the layer mesh as well: there are several.")
        if not picks:
            raise InputError("", "Select faces or edges of the meshed shape first.")
        # With the mesh at hand, the very names on the meshed object stand in the macro.
        references = ", ".join(f"({in_code(owner)}, {names!r})" for owner, names in picks)
        with Transaction(mesh.Document, self.title):
            do("import advlayers")
            do(f"advlayers.{self.FUNCTION}({in_code(mesh)}, {self.arguments(references)})")
        mesh.Document.recompute()
        self.edit(mesh.Document.ActiveObject)

    def arguments(self, references: str) -> str:
        return f"[{references}]"

    def edit(self, created) -> None:
        """Opens the child's panel where it has one."""
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.getDocument(created.Document.Name).setEdit(created.Name)


class Wall(_Child):
    NAME = "Wall"
    MENU = "Wall"
    TOOLTIP = ("Gives the selected edges, or the edges of the selected faces, layers of their own "
               "height, growth and number")
    KEYS = "Y, W"
    FUNCTION = "make_wall"


class Size(_Child):
    NAME = "Size"
    MENU = "Size"
    TOOLTIP = "Sets the size of the mesh on the selected faces and edges"
    KEYS = "Y, S"
    FUNCTION = "make_size"


class Group(_Child):
    NAME = "Group"
    MENU = "Named Group"
    TOOLTIP = ("Groups the selected faces and edges under a name, for boundary conditions: the "
               "label of the new object, which may be changed")
    KEYS = "Y, G"
    FUNCTION = "make_group"

    def arguments(self, references: str) -> str:
        return f"{self._free_name()!r}, [{references}]"

    def _free_name(self) -> str:
        taken = {entry.Label for entry in FreeCAD.ActiveDocument.Objects}
        numbers: Tuple[Any, ...] = tuple(range(1, len(taken) + 2))
        return next(name for name in (f"group{number}" for number in numbers)
                    if name not in taken)

    def edit(self, created) -> None:
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(created)

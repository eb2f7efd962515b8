"""Commands for layer meshes that are there: update, check, export, convert, fill, take over."""
from __future__ import annotations

import os
from typing import Any, List

import FreeCAD
import FreeCADGui
from PySide import QtGui

from advlayers_gui import selected
from advlayers import controls
from advlayers.language import tr
from advlayers_gui.command import Command, call_on, do, in_code, tell


class _OnMeshes(Command):
    """Works on the selected layer meshes, or on all of the document."""

    CALL = ("", "")  # what run_on() calls with a mesh: a line that imports it, and its name

    def IsActive(self) -> bool:
        return super().IsActive() and bool(selected.all_layer_meshes())

    def run(self) -> None:
        for mesh in selected.layer_meshes_or_all():
            self.run_on(mesh)

    def run_on(self, mesh) -> None:
        from advlayers_gui.progress_window import shown_progress

        with shown_progress(mesh):
            call_on(mesh, self.title, *self.CALL)


class _OnOneMesh(_OnMeshes):
    """Works on the selected layer mesh, or on the only one of the document."""

    def run(self) -> None:
        from advlayers.errors import InputError

        meshes = selected.layer_meshes_or_all()
        if len(meshes) != 1:
            raise InputError("", "Select one layer mesh first.")
        self.run_on(meshes[0])


class Update(_OnMeshes):
    NAME = "Update"
    MENU = "Update Mesh"
    TOOLTIP = "Meshes the selected layer meshes again, or all of the document that are out of date"
    KEYS = "Y, U"
    CALL = ("import advlayers", "advlayers.update")

    def run(self) -> None:
        chosen = selected.layer_meshes()
        for mesh in chosen or [entry for entry in selected.all_layer_meshes()
                               if entry.State != "Up to date"]:
            self.run_on(mesh)


class Check(_OnOneMesh):
    NAME = "Check"
    MENU = "Check Mesh"
    TOOLTIP = ("Opens the results of the mesh: lost references, diagnostics, worst elements; a "
               "click leads to the place")
    KEYS = "Y, C"

    def run_on(self, mesh) -> None:
        from advlayers import check

        words = {"error": tr("error"), "warning": tr("warning"), "info": tr("note")}
        lines = [f"{words[group.severity]}: {group.text}{_at(group.findings[0].point)}"
                 for group in check.grouped(check.check(mesh))]
        FreeCAD.Console.PrintMessage("\n".join([check.summary(mesh)] + lines) + "\n")
        FreeCADGui.getDocument(mesh.Document.Name).setEdit(mesh.Name)
        if mesh.ViewObject.Proxy.panel is not None:
            mesh.ViewObject.Proxy.panel.show_results()


def _at(point) -> str:
    return " ({:.6g}, {:.6g}, {:.6g})".format(*point) if point else ""


class _OnLostReferences(_OnMeshes):
    """For meshes whose model was edited so that faces have other numbers."""

    def IsActive(self) -> bool:
        return super().IsActive() and any(
            mesh.State == "Lost references" for mesh in selected.layer_meshes_or_all())


class FollowReferences(_OnLostReferences):
    NAME = "FollowReferences"
    MENU = "Follow References"
    TOOLTIP = ("Gives lost references the names that what was picked has now, where it is still "
               "there")
    CALL = ("from advlayers import layer_mesh", "layer_mesh.follow_references")


class AcceptReferences(_OnLostReferences):
    NAME = "AcceptReferences"
    MENU = "Accept References"
    TOOLTIP = "Takes lost references for what their names stand for now"
    CALL = ("from advlayers import layer_mesh", "layer_mesh.accept_references")


class Export(_OnOneMesh):
    NAME = "Export"
    MENU = "Export Mesh…"
    TOOLTIP = "Writes the mesh to a file with all of its quads, triangles and groups"

    def run_on(self, mesh) -> None:
        path = self.ask(mesh)
        if path:
            do("from advlayers import object_export")
            do(f"object_export.export_mesh({in_code(mesh)}, {path!r})")

    def ask(self, mesh) -> str:
        from advlayers.export import FORMATS, format_of

        offered = {ending: entry for ending, entry in FORMATS.items() if not entry.only_cells}
        filters = [f"{tr(entry.title)} (*{_shown(ending)})" for ending, entry in offered.items()]
        start = os.path.join(os.path.dirname(mesh.Document.FileName), mesh.Label)
        path, chosen = QtGui.QFileDialog.getSaveFileName(
            FreeCADGui.getMainWindow(), tr("Export Mesh"), start, ";;".join(filters))[:2]
        if path and format_of(path) not in FORMATS:
            path += _shown(list(offered)[filters.index(chosen)])
        return path


def _select(document_object) -> None:
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document_object)


def _in_analyses(mesh) -> str:
    """In which it is now."""
    from advlayers import analysis

    labels = ", ".join(entry.Label for entry in analysis.analyses_of(mesh))
    return " " + tr("It is the mesh of {}.").format(labels) if labels else ""


def _shown(ending: str) -> str:
    return ".FCStd" if ending == ".fcstd" else ending


class ToMesh(_OnMeshes):
    NAME = "ToMesh"
    MENU = "Convert to Triangles"
    TOOLTIP = "Makes a Mesh object of the layer mesh, each quad as two triangles"
    CALL = ("from advlayers import mesh_feature", "mesh_feature.make_mesh_feature")


class FillVolume(_OnOneMesh):
    NAME = "FillVolume"
    MENU = "Fill with Tetrahedra"
    TOOLTIP = "Fills the inside of a closed layer mesh with tetrahedra, using Gmsh or Netgen"
    CALL = ("from advlayers import volume_fill", "volume_fill.fill")

    def run_on(self, mesh) -> None:
        super().run_on(mesh)
        made = mesh.Document.ActiveObject
        mesh.ViewObject.Visibility, made.ViewObject.Visibility = False, True
        _select(made)
        tell(tr("{} has {} cells inside {}.").format(
            made.Label, made.FemMesh.VolumeCount, mesh.Label) + _in_analyses(made))


class TakeOver(Command):
    NAME = "TakeOver"
    MENU = "Take over from Gmsh Mesh"
    TOOLTIP = ("Makes a layer mesh with the sizes, boundary layers, regions and groups of the "
               "selected Gmsh mesh, and puts it in its place in the analysis")

    def IsActive(self) -> bool:
        return super().IsActive() and bool(self._gmsh_meshes())

    def run(self) -> None:
        from advlayers.errors import InputError

        chosen = [entry for entry in FreeCADGui.Selection.getSelection()
                  if entry in self._gmsh_meshes()] or self._gmsh_meshes()
        if len(chosen) != 1:
            raise InputError("", "Select one Gmsh mesh first.")
        call_on(chosen[0], self.title, "from advlayers import gmsh_takeover",
                "gmsh_takeover.take_over")
        made = chosen[0].Document.ActiveObject
        mesh = controls.mesh_of(made) if controls.is_control(made) else made
        chosen[0].ViewObject.Visibility = False
        tell(tr("{} has the sizes of {}, {} walls, {} local sizes and {} groups.").format(
            mesh.Label, chosen[0].Label, len(mesh.WallList), len(mesh.SizeList),
            len(mesh.GroupList)) + _in_analyses(mesh))
        # Not meshed yet: the panel shows what was taken over, and OK meshes.
        _select(mesh)
        FreeCADGui.getDocument(mesh.Document.Name).setEdit(mesh.Name)

    @staticmethod
    def _gmsh_meshes() -> List[Any]:
        from advlayers.gmsh_takeover import is_gmsh_mesh

        return [entry for entry in FreeCAD.ActiveDocument.Objects if is_gmsh_mesh(entry)]

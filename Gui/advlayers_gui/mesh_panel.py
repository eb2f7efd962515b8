"""The task panel of a layer mesh: the settings asked for most, Mesh and Stop, and what came out."""
from __future__ import annotations

import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from advlayers import layer_mesh
from advlayers.settings_table import setting

_LENGTHS = (("size", "Size"), ("first_height", "First height"))


class MeshPanel:
    """Edits one mesh object. OK keeps settings and mesh, Cancel brings both back."""

    def __init__(self, mesh_object) -> None:
        self._object = mesh_object
        # An undone transaction brings the properties back, but not the mesh.
        self._old_mesh = mesh_object.FemMesh.copy()
        self._old_state = {name: getattr(mesh_object, name) for name in mesh_object.PropertiesList
                           if mesh_object.getGroupOfProperty(name) == "Result"}
        self._mesher_running = False
        self._stop_asked = False
        self.form = self._build()

    # --- what FreeCAD calls -------------------------------------------------------------------

    def getStandardButtons(self):
        buttons = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel
        try:
            return int(buttons)
        except TypeError:  # Qt 6
            return buttons

    def accept(self) -> bool:
        if self._mesher_running:
            return False
        self._store_settings()
        if self._object.State == layer_mesh.NOT_MESHED and not self._mesh():
            return False
        document = self._object.Document
        document.recompute()
        document.commitTransaction()
        FreeCADGui.ActiveDocument.resetEdit()
        return True

    def reject(self) -> bool:
        if self._mesher_running:
            self._stop_asked = True
            return False
        document, name = self._object.Document, self._object.Name
        document.abortTransaction()
        FreeCADGui.ActiveDocument.resetEdit()
        if document.getObject(name) is not None and self._old_mesh.NodeCount:
            self._object.FemMesh = self._old_mesh
            for key, value in self._old_state.items():
                setattr(self._object, key, value)
            document.recompute()
        return True

    # --- the form -----------------------------------------------------------------------------

    def _build(self):
        form = QtGui.QWidget()
        form.setWindowTitle("Layer Mesh")
        layout = QtGui.QFormLayout(form)
        self._lengths = {}
        for key, label in _LENGTHS:
            field = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
            field.setProperty("unit", "mm")
            field.setProperty("minimum", 0.0)
            field.setProperty("value", getattr(self._object, setting(key).property))
            self._add_row(layout, key, label, field)
            self._lengths[key] = field
        self._growth = QtGui.QDoubleSpinBox()
        self._growth.setRange(setting("growth").low, 10.0)
        self._growth.setSingleStep(0.05)
        self._growth.setDecimals(3)
        self._growth.setValue(self._object.Growth)
        self._add_row(layout, "growth", "Growth", self._growth)
        self._layers = QtGui.QLineEdit(self._object.Layers)
        self._add_row(layout, "layers", "Layers", self._layers)
        self._button = QtGui.QPushButton("Mesh")
        self._button.setObjectName("AdvLayersMeshButton")
        self._button.clicked.connect(self._mesh_or_stop)
        layout.addRow(self._button)
        self._status = QtGui.QLabel(self._object.State)
        self._status.setObjectName("AdvLayersStatus")
        self._status.setWordWrap(True)
        layout.addRow(self._status)
        return form

    def _add_row(self, layout, key: str, label: str, field) -> None:
        field.setToolTip(setting(key).doc)
        field.setObjectName(f"AdvLayers_{key}")
        layout.addRow(label, field)

    def _store_settings(self) -> None:
        for key, field in self._lengths.items():
            value = field.property("value")
            setattr(self._object, setting(key).property, getattr(value, "Value", value))
        self._object.Growth = self._growth.value()
        self._object.Layers = self._layers.text().strip()

    # --- meshing ------------------------------------------------------------------------------

    def _mesh_or_stop(self) -> None:
        if self._mesher_running:
            self._stop_asked = True
        else:
            self._mesh()

    def _mesh(self) -> bool:
        """Meshes while the window stays alive; says on the status line how it went."""
        self._store_settings()
        self._mesher_running, self._stop_asked = True, False
        self._button.setText("Stop")
        progress = _Progress(self._status)
        try:
            layer_mesh.update(self._object, lambda reports: self._watch(progress, reports))
        except _Stopped:
            self._status.setText("Stopped; the mesh is the one before.")
            return False
        except (ValueError, RuntimeError) as error:
            FreeCAD.Console.PrintError(f"Advancing Layers: {error}\n")
            self._status.setText(str(error))
            return False
        finally:
            self._mesher_running = False
            self._button.setText("Mesh")
        if self._object.Part.ViewObject is not None:
            self._object.Part.ViewObject.Visibility = False
        self._status.setText(progress.summary(self._object))
        return True

    def _watch(self, progress, reports) -> None:
        progress.add(reports)
        QtCore.QCoreApplication.processEvents()
        if self._stop_asked:
            raise _Stopped()


class _Stopped(Exception):
    """The user pressed Stop."""


class _Progress:
    def __init__(self, label) -> None:
        self._label = label
        self._start = time.monotonic()
        self._layers = self._quads = self._triangles = 0

    def add(self, reports) -> None:
        self._layers += len(reports)
        self._quads += sum(report.quads for report in reports)
        self._triangles += sum(report.triangles for report in reports)
        self._label.setText(f"{self._layers} layers · {self._quads} quads · "
                            f"{time.monotonic() - self._start:.1f} s")

    def summary(self, mesh_object) -> str:
        lines = [f"{mesh_object.QuadCount} quads and {mesh_object.TriangleCount} triangles "
                 f"({mesh_object.QuadPercent:.1f} % quads) in "
                 f"{time.monotonic() - self._start:.1f} s"]
        return "\n".join(lines + list(mesh_object.Messages)[:10])

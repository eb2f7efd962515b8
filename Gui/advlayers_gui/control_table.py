"""The walls, sizes and groups of a layer mesh in a table; the marked one is edited below it."""
from __future__ import annotations

from typing import Any, Callable, List, Optional

import FreeCAD
from PySide import QtCore, QtGui

from advlayers import controls
from advlayers.errors import InputError
from advlayers.language import tr
from advlayers.settings_table import property_name, value_settings
from advlayers_gui.control_editor import (
    ControlEditor, change_condition, condition_texts, references_of)
from advlayers.lengths import length_text
from advlayers_gui.picking import PickSession
from advlayers_gui.reference_list import tool_button
from advlayers_gui.setting_fields import label_of

_KIND, _NAME, _ON, _VALUES = range(4)


class ControlTable:
    """`on_change` is called after every change; `on_refused` gets the reason where one fails."""

    def __init__(self, mesh_object, picks: PickSession, on_change: Callable[[], None],
                 on_refused: Callable[[str], None]) -> None:
        self._mesh_object, self._picks = mesh_object, picks
        self._on_change, self._on_refused = on_change, on_refused
        self._editor: Optional[ControlEditor] = None
        self._rows: List[Any] = []
        self.widget = QtGui.QWidget()
        self._layout = QtGui.QVBoxLayout(self.widget)
        self._layout.setContentsMargins(4, 4, 4, 4)
        self._layout.addLayout(self._buttons())
        self._layout.addWidget(self._make_table())
        self._empty = QtGui.QLabel(tr(
            "No walls yet: with Layers from all edges, layers grow from every edge. Select edges "
            "in the 3D view and press + Wall for values of their own, + Size for finer places, "
            "+ Group for boundary conditions."))
        self._empty.setObjectName("AdvLayersNoConditions")
        self._empty.setWordWrap(True)
        self._layout.addWidget(self._empty)
        self._place = QtGui.QVBoxLayout()
        self._layout.addLayout(self._place)
        self._layout.addStretch()
        self.load()

    def store(self) -> None:
        if self._editor is not None:
            self._editor.store()

    def release(self) -> None:
        """The widgets are going away."""
        if self._editor is not None:
            self._editor.release()
            self._editor = None

    def load(self) -> None:
        """Shows the children as they are now; keeps the marked row where it is still there."""
        marked = self._marked()
        self._rows = controls.children(self._mesh_object)
        self._table.blockSignals(True)
        self._table.setRowCount(len(self._rows))
        self._table.setVisible(bool(self._rows))
        self._empty.setVisible(not self._rows)
        for row, control in enumerate(self._rows):
            self._fill(row, control)
        self._table.resizeColumnsToContents()
        self._table.blockSignals(False)
        if marked in self._rows:
            self._table.selectRow(self._rows.index(marked))
        else:
            self._table.clearSelection()
            self._edit(None)

    def _buttons(self):
        grid = QtGui.QGridLayout()
        wall = self._adder(
            controls.Wall, tr("Wall"),
            tr("Layers grow from the selected edges; with faces selected too, on these alone"))
        wall.setMenu(self._other_conditions(wall))
        wall.setPopupMode(QtGui.QToolButton.MenuButtonPopup)
        size = self._adder(
            controls.Size, tr("Size"),
            tr("A size of their own for the selected faces, edges and vertices"))
        group = self._adder(controls.Group, tr("Group"),
                            tr("A named group of the selected faces and edges"))
        remove = tool_button("− " + tr("Remove"), tr("Removes the marked row"), self._remove)
        remove.setObjectName("AdvLayersRemoveControl")
        for place, button in enumerate((wall, size, group, remove)):
            button.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
            grid.addWidget(button, *divmod(place, 2))
        return grid

    def _adder(self, kind, text: str, doc: str):
        button = tool_button("+ " + text, doc, lambda: self._add(kind, ""))
        button.setObjectName(f"AdvLayersAdd{kind.__name__}")
        return button

    def _other_conditions(self, parent):
        menu = QtGui.QMenu(parent)
        menu.setToolTipsVisible(True)
        for condition, doc in (
                ("Match", tr("Layers run along the selected edges")),
                ("Off", tr("No layers at the selected edges")),
                ("Boundary",
                 tr("The selected edges bound their faces, however smoothly these meet")),
                ("Smooth",
                 tr("Layers run across the selected edges, however sharply their faces meet"))):
            action = menu.addAction("+ " + condition_texts()[condition])
            action.setObjectName(f"AdvLayersAdd{condition}")
            action.setToolTip(doc)
            action.triggered.connect(
                lambda _checked=False, condition=condition: self._add(controls.Wall, condition))
        return menu

    def _make_table(self):
        self._table = QtGui.QTableWidget(0, 4)
        self._table.setObjectName("AdvLayersConditions")
        self._table.setHorizontalHeaderLabels([
            tr("Kind"), tr("Name"),
            tr("On"), tr("Values")])
        self._table.verticalHeader().setVisible(False)
        self._table.horizontalHeader().setStretchLastSection(True)
        self._table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self._table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
        self._table.setMinimumHeight(110)
        self._table.setMaximumHeight(180)
        self._table.itemSelectionChanged.connect(lambda: self._edit(self._marked()))
        self._table.itemClicked.connect(lambda _item: self._highlight())
        self._table.itemChanged.connect(self._renamed)
        return self._table

    def _fill(self, row: int, control) -> None:
        if isinstance(control.Proxy, controls.Wall):
            choice = QtGui.QComboBox()
            choice.setObjectName(f"AdvLayersCondition{row}")
            choice.addItems(list(condition_texts().values()))
            choice.setCurrentIndex(controls.CONDITIONS.index(control.Condition))
            choice.currentIndexChanged.connect(
                lambda index, control=control: self._set_condition(control, index))
            self._table.setCellWidget(row, _KIND, choice)
        else:
            self._table.removeCellWidget(row, _KIND)
        kind = {controls.Size: tr("Size"), controls.Group: tr("Group")}.get(type(control.Proxy), "")
        texts = {_KIND: kind, _NAME: control.Label,
                 _ON: ", ".join(references_of(control, self._mesh_object.Part)),
                 _VALUES: _values_text(control)}
        for column, text in texts.items():
            item = QtGui.QTableWidgetItem(text)
            if column != _NAME:
                item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable)
            item.setToolTip(text)
            self._table.setItem(row, column, item)

    def _marked(self):
        ranges = self._table.selectedRanges()
        row = ranges[0].topRow() if ranges else -1
        return self._rows[row] if 0 <= row < len(self._rows) else None

    def _add(self, kind, condition: str) -> None:
        names = self._picks.names()
        try:
            if kind is controls.Group:
                label = tr("Group")
                made = controls.make_group(self._mesh_object, label, names)
            else:
                made = controls.make(kind, self._mesh_object, names,
                                     condition=condition or controls.CONDITIONS[0],
                                     label=condition_texts().get(condition, ""))
        except InputError as error:
            self._on_refused(error.sentence.translated if names else
                             tr("select faces or edges in the 3D view first"))
            return
        self.load()
        self._table.selectRow(self._rows.index(made))
        self._on_change()

    def _remove(self) -> None:
        marked = self._marked()
        if marked is not None:
            self._edit(None)
            marked.Document.removeObject(marked.Name)
            self.load()
            self._on_change()

    def _highlight(self) -> None:
        marked = self._marked()
        if marked is not None:
            self._picks.select(references_of(marked, self._mesh_object.Part))

    def _renamed(self, item) -> None:
        if item.column() == _NAME and item.text().strip():
            self._rows[item.row()].Label = item.text().strip()
            self._changed_in_table(self._rows[item.row()])

    def _set_condition(self, control, index: int) -> None:
        change_condition(control, controls.CONDITIONS[index])
        self._changed_in_table(control)

    def _changed_in_table(self, control) -> None:
        self._changed()
        if control is self._marked():
            self._edit(control)  # shows it as it is now

    def _edit(self, control) -> None:
        self.release()
        while self._place.count():
            editor = self._place.takeAt(0).widget()
            editor.hide()
            editor.deleteLater()
        if control is not None:
            self._editor = ControlEditor(control, self._mesh_object.Part, self._picks,
                                         self._changed, self._on_refused)
            self._place.addWidget(self._editor.widget)

    def _changed(self) -> None:
        self._table.blockSignals(True)
        for row, control in enumerate(self._rows):
            self._fill(row, control)
        self._table.blockSignals(False)
        self._on_change()


def _values_text(control) -> str:
    """ "First height 0.1 mm, Layers 5": the values that are given, in the user's units."""
    parts = []
    for entry in value_settings(control.Proxy.TABLE):
        if entry.key in controls.values(control):
            value = getattr(control, property_name(entry))
            parts.append(f"{label_of(entry)} {_shown(value)}")
    return ", ".join(parts)


def _shown(value: Any) -> str:
    if hasattr(value, "Unit") and value.Unit == FreeCAD.Units.Length:
        return length_text(value.Value)
    if hasattr(value, "UserString"):
        return value.UserString
    return f"{value:g}" if isinstance(value, float) else str(value)

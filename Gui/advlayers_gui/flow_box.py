"""A first height from a flow: y+, speed, length and fluid, and what they come to."""
from __future__ import annotations

from typing import Any, Callable, Dict, List, Optional, Tuple

from PySide import QtGui

from advlayers.errors import InputError
from advlayers.flow_height import Estimate, estimate
from advlayers.language import tr
from advlayers.settings_check import check_all
from advlayers.settings_table import Y_PLUS_SETTINGS
from advlayers_gui.setting_fields import Field, field_for, label_of, tooltip_of

# A car, a small aircraft's wing: something to start from; the program takes none for granted.
_SHOWN_FIRST = {"speed": 30.0, "length": 1000.0, "density": 1.225, "viscosity": 1.8e-5}


class FlowBox:
    """`growth` gives that of the layers, `use` gets the height [mm] that was chosen."""

    def __init__(self, growth: Callable[[], float], use: Callable[[float], None]) -> None:
        self._growth, self._use = growth, use
        self._fields: List[Tuple[Field, Optional[Any]]] = []
        self.widget = QtGui.QGroupBox(tr("First height from y+"))
        self.widget.setObjectName("AdvLayersFlow")
        self.widget.setCheckable(True)
        self.widget.setChecked(False)
        inside = QtGui.QWidget()
        around, form = QtGui.QVBoxLayout(self.widget), QtGui.QFormLayout(inside)
        around.setContentsMargins(2, 10, 2, 0)
        form.setContentsMargins(2, 0, 2, 0)
        around.addWidget(inside)
        for entry in Y_PLUS_SETTINGS:
            self._add(entry, form)
        self._said = QtGui.QLabel()
        self._said.setObjectName("AdvLayersFlowSaid")
        self._said.setWordWrap(True)
        form.addRow(self._said)
        self._button = QtGui.QPushButton(tr("Use this height"))
        self._button.setObjectName("AdvLayersFlowUse")
        self._button.clicked.connect(self._take)
        form.addRow(self._button)
        inside.setVisible(False)
        self.widget.toggled.connect(inside.setVisible)
        self.widget.toggled.connect(lambda _on: self.refresh())

    def flow(self) -> Dict[str, Any]:
        """As a job would have it."""
        return {field.entry.key: field.value() for field, given in self._fields
                if given is None or given.isChecked()}

    def refresh(self) -> None:
        """Says what the flow comes to."""
        found = self._estimate()
        self._button.setEnabled(found is not None)
        if found is not None:
            self._said.setText(found.said(self._growth()).translated)

    def release(self) -> None:
        """The widgets are going away."""
        for field, _given in self._fields:
            field.release()

    def _add(self, entry, form) -> None:
        field = field_for(entry, None)
        field.widget.setObjectName(f"AdvLayersFlow_{entry.key}")
        field.show(_SHOWN_FIRST.get(entry.key, entry.default))
        optional = entry.default is None and not entry.required
        title = QtGui.QCheckBox(label_of(entry)) if optional else QtGui.QLabel(label_of(entry))
        title.setToolTip(tooltip_of(entry))
        if optional:
            field.enable(False)
            title.setObjectName(f"AdvLayersFlow_{entry.key}_given")
            title.toggled.connect(field.enable)
            title.toggled.connect(lambda _on: self.refresh())
        field.on_edited(self.refresh)
        form.addRow(title, field.widget)
        self._fields.append((field, title if optional else None))

    def _estimate(self) -> Optional[Estimate]:
        try:
            return estimate(check_all(self.flow(), Y_PLUS_SETTINGS))
        except InputError as error:
            self._said.setText(error.sentence.translated)
            return None

    def _take(self) -> None:
        found = self._estimate()
        if found is not None:
            self._use(found.first_height)

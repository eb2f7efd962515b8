"""One wall, size or group: its references and its values in widgets."""
from __future__ import annotations

from typing import Callable, List

from PySide import QtGui

from advlayers import controls
from advlayers.errors import InputError
from advlayers.language import tr
from advlayers.picked_names import link_value, names_on
from advlayers_gui.picking import PickSession
from advlayers_gui.reference_list import ReferenceList
from advlayers_gui.setting_fields import SettingsForm


class ControlEditor:
    def __init__(self, control, source, picks: PickSession, on_change: Callable[[], None],
                 on_refused: Callable[[str], None]) -> None:
        self._control, self._source, self._on_change = control, source, on_change
        self.widget = QtGui.QWidget()
        layout = QtGui.QFormLayout(self.widget)
        layout.setContentsMargins(0, 0, 0, 0)
        self._add_name(layout)
        if isinstance(control.Proxy, controls.Wall):
            self._add_condition(layout)
        kind = type(control.Proxy).__name__.lower()
        self._references = ReferenceList(kind, control.Proxy.KINDS, picks, self._refer, on_refused)
        layout.addRow(tr("On"), self._references.widget)
        self._references.show(references_of(control, source))
        self._form = SettingsForm(control, controls.value_settings(control.Proxy.TABLE), layout,
                                  on_change, on_refused, optional=True)

    def store(self) -> None:
        self._form.store()

    def release(self) -> None:
        """The widgets are going away."""
        self._form.release()

    def _add_name(self, layout) -> None:
        self._name = QtGui.QLineEdit(self._control.Label)
        self._name.setObjectName("AdvLayers_control_name")
        self._name.editingFinished.connect(self._rename)
        layout.addRow(tr("Name"), self._name)

    def _add_condition(self, layout) -> None:
        self._condition = QtGui.QComboBox()
        self._condition.setObjectName("AdvLayers_condition")
        self._condition.addItems(list(controls.CONDITIONS))
        self._condition.setCurrentIndex(controls.CONDITIONS.index(self._control.Condition))
        self._condition.setToolTip(self._control.getDocumentationOfProperty("Condition"))
        self._condition.currentIndexChanged.connect(self._set_condition)
        layout.addRow(tr("Condition"), self._condition)

    def _rename(self) -> None:
        name = self._name.text().strip()
        if name and name != self._control.Label:
            self._control.Label = name
            self._on_change()

    def _set_condition(self, index: int) -> None:
        self._control.Condition = controls.CONDITIONS[index]
        self._on_change()

    def _refer(self, names: List[str]) -> None:
        self._control.References = link_value(self._source, names)
        self._on_change()


def references_of(control, source) -> List[str]:
    """The names of the references on the source; as they are saved where they are not on it."""
    try:
        return names_on(source, control.References)
    except InputError:
        return [name for _owner, names in control.References for name in names]

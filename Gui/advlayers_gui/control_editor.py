"""One wall, size or group: its references and its values in widgets."""
from __future__ import annotations

from typing import Any, Callable, Dict, List

from PySide import QtGui

from advlayers import controls, hints
from advlayers.errors import InputError
from advlayers.language import tr, tr_doc
from advlayers.layer_mesh import own_settings
from advlayers.picked_names import link_value, names_on
from advlayers.properties import from_property
from advlayers.settings_table import MESH_SETTINGS, Setting, property_name, value_settings
from advlayers_gui.picking import PickSession
from advlayers_gui.reference_list import ReferenceList
from advlayers_gui.setting_fields import SettingsForm

_GROWING = controls.CONDITIONS[0]


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
        layout.addRow(self._references.widget)
        self._references.show(references_of(control, source))
        self._values = QtGui.QWidget()
        values = QtGui.QFormLayout(self._values)
        values.setContentsMargins(0, 0, 0, 0)
        self._form = SettingsForm(control, value_settings(control.Proxy.TABLE), values,
                                  on_change, on_refused, self._typed, self._inherited)
        layout.addRow(self._values)
        self._show_values()

    def _inherited(self, entry: Setting) -> Any:
        """What holds here where no value is given: that of the mesh, where it has a number."""
        mesh = controls.mesh_of(self._control)
        of_mesh = next((other for other in MESH_SETTINGS if other.key == entry.key), None)
        if mesh is None or of_mesh is None:
            return None
        value = from_property(of_mesh, getattr(mesh, property_name(of_mesh)))
        return value if isinstance(value, (int, float)) and value > 0 else None

    def _typed(self, typed: Dict[str, Any]) -> None:
        mesh = controls.mesh_of(self._control)
        if mesh is not None and isinstance(self._control.Proxy, controls.Wall):
            said = hints.of_wall(own_settings(mesh), {**controls.values(self._control), **typed})
            if said is not None:
                self._on_refused(said.translated)

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
        self._condition.addItems(list(condition_texts().values()))
        self._condition.setCurrentIndex(controls.CONDITIONS.index(self._control.Condition))
        self._condition.setToolTip(
            tr_doc(self._control.getDocumentationOfProperty("Condition")))
        self._condition.currentIndexChanged.connect(self._set_condition)
        layout.addRow(tr("Condition"), self._condition)

    def _rename(self) -> None:
        name = self._name.text().strip()
        if name and name != self._control.Label:
            self._control.Label = name
            self._on_change()

    def _set_condition(self, index: int) -> None:
        change_condition(self._control, controls.CONDITIONS[index])
        self._name.setText(self._control.Label)
        self._show_values()
        self._on_change()

    def _show_values(self) -> None:
        """Only a wall that layers grow from has any."""
        self._values.setVisible(getattr(self._control, "Condition", _GROWING) == _GROWING)

    def _refer(self, names: List[str]) -> None:
        self._control.References = link_value(self._source, names)
        self._on_change()


def condition_texts() -> Dict[str, str]:
    """The conditions of a wall, in their order, in the user's language."""
    texts = {"Wall": tr("Wall"), "Match": tr("Match"), "Off": tr("Off"),
             "Boundary": tr("Boundary"), "Smooth": tr("Smooth")}
    return {condition: texts[condition] for condition in controls.CONDITIONS}


def change_condition(wall, condition: str) -> None:
    """A name that says no more than the condition changes with it."""
    texts = condition_texts()
    renamed = wall.Label == texts[wall.Condition]
    wall.Condition = condition
    if renamed:
        wall.Label = texts[condition]


def references_of(control, source) -> List[str]:
    """The names of the references on the source; as they are saved where they are not on it."""
    try:
        return names_on(source, control.References)
    except InputError:
        return [name for _owner, names in control.References for name in names]


def groups_of(mesh_object) -> Dict[str, List[str]]:
    """The faces and edges of each wall, size and group, by its label."""
    return {control.Label: references_of(control, mesh_object.Part)
            for control in controls.children(mesh_object)}

"""Widgets for settings of the table: one kind of field for each kind of setting."""
from __future__ import annotations

import contextlib
import math
import re
from typing import Any, Callable, Dict, Iterable, List, Optional

import FreeCAD
import FreeCADGui
from PySide import QtGui

from advlayers.errors import InputError
from advlayers.initial_mesh import holds_mesh
from advlayers.language import tr, tr_doc
from advlayers.properties import from_property, to_property
from advlayers.settings_table import Setting, label, property_name, unset_value
from advlayers_gui.decimal_sign import accept_both

_HIGHEST = 1e9  # where a setting has no bound of its own
_HIGHEST_NUMBER = 1000.0  # of numbers without a unit: growths and ratios
_MOST = 1_000_000
# What a field has to have room for; where its label leaves less, the field goes below the label.
_LEAST_TEXT = "00.00 mm"
_LEAST_NUMBER = "0.0000"
_UNSEEN = "color: transparent"
_DIGITS = 6  # of a length or an angle
_QUANTITY_BUTTONS = 36  # [pixels] for the sign of an expression and the arrows
_BUTTONS = 24


class Field:
    """One setting in a widget. `value` is as a job has it."""

    def __init__(self, entry: Setting, widget) -> None:
        self.entry, self.widget = entry, widget
        widget.setToolTip(tooltip_of(entry))

    def value(self) -> Any:
        raise NotImplementedError

    def show(self, value: Any) -> None:
        raise NotImplementedError

    def on_edited(self, act: Callable[[], None]) -> None:
        """Calls when the user is done with an entry."""
        raise NotImplementedError

    def on_typed(self, act: Callable[[Any], None]) -> None:
        """Calls with the value as it is being typed, where it is one."""

    def bind(self, document_object) -> None:
        """Offers expressions, where the widget can."""

    def least_width(self) -> int:
        """[pixels]"""
        return self._room_for(_LEAST_NUMBER, _BUTTONS)

    def _room_for(self, text: str, buttons: int) -> int:
        return self.widget.fontMetrics().boundingRect(text).width() + buttons

    def enable(self, on: bool) -> None:
        self.widget.setEnabled(on)

    def blank(self) -> None:
        """Shows no value, where the widget can."""

    def release(self) -> None:
        """Lets go of the widget."""
        self.widget = None


class RoundingField(Field):
    """A number that its widget rounds: what it was to show stays as it is until it is edited."""

    def __init__(self, entry: Setting, widget) -> None:
        super().__init__(entry, widget)
        self._rounded = self._exact = math.nan

    def value(self) -> float:
        held = self._held()
        return self._exact if held == self._rounded else held

    def show(self, value: float) -> None:
        self.widget.setStyleSheet("")
        self._hold(value)
        self._rounded, self._exact = self._held(), value

    def blank(self) -> None:
        # FreeCAD writes its number again whenever the widget is shown.
        self.widget.setStyleSheet(_UNSEEN)

    def on_typed(self, act: Callable[[Any], None]) -> None:
        def typed(text: str) -> None:
            value = self._read(text)
            if value is not None:
                act(value)

        self.widget.findChild(QtGui.QLineEdit).textEdited.connect(typed)

    def _read(self, text: str) -> Optional[float]:
        """Of an entry that may be unfinished."""
        try:
            return float(text.replace(",", "."))
        except ValueError:
            return None

    def _held(self) -> float:
        """By the widget."""
        raise NotImplementedError

    def _hold(self, value: float) -> None:
        raise NotImplementedError


class QuantityField(RoundingField):
    """Lengths and angles, in the user's units."""

    def __init__(self, entry: Setting) -> None:
        super().__init__(entry, _quantity_box())
        self.widget.destroyed.connect(self._forget)  # the dialog was closed by someone else
        self.widget.setProperty("unit", entry.unit)
        self.widget.setProperty("minimum", entry.low if entry.low is not None else -_HIGHEST)
        self.widget.setProperty("maximum", entry.high if entry.high is not None else _HIGHEST)
        self.widget.setProperty("keyboardTracking", False)
        self._unit = FreeCAD.Units.Quantity(f"1 {entry.unit}").Unit
        self._shown_unit = entry.unit
        accept_both(self.widget)

    def _held(self) -> float:
        return float(self.widget.property("rawValue"))

    def _hold(self, value: float) -> None:
        """With digits that mean something: FreeCAD shows two decimals, and takes what it shows for
        the value: 0.1 mm would be 0.00 in."""
        quantity = FreeCAD.Units.Quantity(float(value), self._unit)
        quantity.Format = {"Precision": _DIGITS, "NumberFormat": "g", "Denominator": 8}
        self._shown_unit = quantity.getUserPreferred()[2]
        if not self.widget.setProperty("value", quantity) or not self._holds(value):
            self.widget.setProperty("rawValue", float(value))

    def _holds(self, value: float) -> bool:
        return math.isclose(self._held(), value, rel_tol=10.0 ** (2 - _DIGITS))

    def _read(self, text: str) -> Optional[float]:
        bare = super()._read(text)
        entry = text.replace(",", ".") if bare is None else f"{bare} {self._shown_unit}"
        try:
            quantity = FreeCAD.Units.Quantity(entry)
        except (ValueError, OSError):
            return None
        return quantity.Value if quantity.Unit == self._unit else None

    def on_edited(self, act: Callable[[], None]) -> None:
        self.widget.editingFinished.connect(act)

    def least_width(self) -> int:
        return self._room_for(_LEAST_TEXT, _QUANTITY_BUTTONS)

    def _forget(self) -> None:
        self.widget = None

    def release(self) -> None:
        """FreeCAD would delete its own widget without telling Python, which would take the next
        one at its address for it: so Python is made the owner, and deletes it."""
        if self.widget is not None:
            with contextlib.suppress(RuntimeError):  # the whole dialog is being deleted
                self.widget.setParent(None)
        super().release()

    def bind(self, document_object) -> None:
        FreeCADGui.ExpressionBinding(self.widget).bind(document_object, property_name(self.entry))


def _quantity_box():
    """FreeCAD may hand out the Python object of an earlier box that is deleted, where the new one
    has its address; while the new one is kept, the next has another address."""
    while True:
        made = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        try:
            made.objectName()
        except RuntimeError:
            continue
        return made


class NumberField(RoundingField):
    """Numbers without a unit."""

    def __init__(self, entry: Setting) -> None:
        super().__init__(entry, QtGui.QDoubleSpinBox())
        self.widget.setDecimals(entry.decimals)
        self.widget.setSingleStep(0.05)
        self.widget.setRange(entry.low if entry.low is not None else -_HIGHEST_NUMBER,
                             entry.high if entry.high is not None else _HIGHEST_NUMBER)
        self.widget.setKeyboardTracking(False)
        accept_both(self.widget)

    def _held(self) -> float:
        return self.widget.value()

    def _hold(self, value: float) -> None:
        self.widget.setValue(value)

    def on_edited(self, act: Callable[[], None]) -> None:
        self.widget.valueChanged.connect(lambda _value: act())


class CountField(NumberField):
    """Whole numbers."""

    def __init__(self, entry: Setting) -> None:
        RoundingField.__init__(self, entry, QtGui.QSpinBox())
        self.widget.setRange(int(entry.low or 0), _MOST)
        self.widget.setKeyboardTracking(False)

    def _hold(self, value: float) -> None:
        self.widget.setValue(int(value))


class LayersField(Field):
    """A number of layers, or the way in which they end by themselves."""

    def __init__(self, entry: Setting) -> None:
        super().__init__(entry, QtGui.QWidget())
        self.choice, self.number = QtGui.QComboBox(), QtGui.QSpinBox()
        self.choice.addItems([tr("Until they meet"),
                              tr("Until isotropic"),
                              tr("Number")])
        self.number.setRange(1, _MOST)
        self.number.setKeyboardTracking(False)
        self.choice.setMinimumContentsLength(8)
        self.choice.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.choice.setObjectName("LayersEnd")
        self.number.setObjectName("LayersNumber")
        row = QtGui.QHBoxLayout(self.widget)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.choice, 1)
        row.addWidget(self.number)
        self.choice.currentIndexChanged.connect(
            lambda index: self.number.setVisible(index == 2))

    def value(self) -> Any:
        return (0, "isotropic", self.number.value())[self.choice.currentIndex()]

    def show(self, value: Any) -> None:
        self.choice.setCurrentIndex(1 if value == "isotropic" else 2 if value else 0)
        self.number.setVisible(self.choice.currentIndex() == 2)
        if isinstance(value, int) and value > 0:
            self.number.setValue(value)

    def on_edited(self, act: Callable[[], None]) -> None:
        self.choice.currentIndexChanged.connect(lambda _index: act())
        self.number.valueChanged.connect(lambda _value: act())

    def least_width(self) -> int:
        return self._room_for(_longest(self.choice), _BUTTONS)


class ChoiceField(Field):
    def __init__(self, entry: Setting) -> None:
        super().__init__(entry, QtGui.QComboBox())
        self.widget.addItems([tr(choice) for choice in entry.choices])

    def value(self) -> str:
        return self.entry.choices[self.widget.currentIndex()]

    def show(self, value: str) -> None:
        self.widget.setCurrentIndex(self.entry.choices.index(value))

    def on_edited(self, act: Callable[[], None]) -> None:
        self.widget.currentIndexChanged.connect(lambda _index: act())

    def least_width(self) -> int:
        return self._room_for(_longest(self.widget), _BUTTONS)


def _longest(box) -> str:
    """Of the texts of a combo box."""
    return max((box.itemText(i) for i in range(box.count())), key=len)


class FlagField(Field):
    def __init__(self, entry: Setting) -> None:
        super().__init__(entry, QtGui.QCheckBox())

    def value(self) -> bool:
        return self.widget.isChecked()

    def show(self, value: bool) -> None:
        self.widget.setChecked(bool(value))

    def on_edited(self, act: Callable[[], None]) -> None:
        self.widget.toggled.connect(lambda _on: act())


def _short(word: str) -> str:
    """A number with as many digits as one likes to read."""
    try:
        return f"{float(word):g}"
    except ValueError:
        return word


class LinesField(Field):
    """A line of numbers for each of several things, as the property has them."""

    def __init__(self, entry: Setting) -> None:
        super().__init__(entry, QtGui.QPlainTextEdit())
        self.widget.setMaximumHeight(3 * self.widget.fontMetrics().height() + 12)
        self.widget.setTabChangesFocus(True)

    def value(self) -> Any:
        lines = [line.strip() for line in self.widget.toPlainText().splitlines()]
        return from_property(self.entry, [line for line in lines if line])

    def show(self, value: Any) -> None:
        self.widget.setPlainText("\n".join(
            " ".join(_short(word) for word in line.split())
            for line in to_property(self.entry, value)))

    def on_edited(self, act: Callable[[], None]) -> None:
        """A line that is being written is no entry yet: it counts with Mesh and OK."""


class MeshField(Field):
    """One of the document's meshes, or none."""

    def __init__(self, entry: Setting, document_object) -> None:
        super().__init__(entry, QtGui.QComboBox())
        self.widget.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        # Not those made from this one: no object may depend on itself.
        later = [document_object] + document_object.InListRecursive
        self._meshes = [None] + [other for other in document_object.Document.Objects
                                 if holds_mesh(other) and other not in later]
        self.widget.addItems([tr("none")] + [mesh.Label for mesh in self._meshes[1:]])

    def value(self) -> Any:
        return self._meshes[self.widget.currentIndex()]

    def show(self, value: Any) -> None:
        if value not in self._meshes:
            self._meshes.append(value)
            self.widget.addItem(value.Label)
        self.widget.setCurrentIndex(self._meshes.index(value))

    def on_edited(self, act: Callable[[], None]) -> None:
        self.widget.currentIndexChanged.connect(lambda _index: act())


def field_for(entry: Setting, document_object) -> Field:
    if entry.kind == "mesh":
        return MeshField(entry, document_object)
    if entry.kind == "number":
        return QuantityField(entry) if entry.unit else NumberField(entry)
    return {"count": CountField, "layers": LayersField, "choice": ChoiceField,
            "flag": FlagField, "refinements": LinesField, "faces_only": LinesField,
            "periodic": LinesField}[entry.kind](entry)


def label_of(entry: Setting) -> str:
    """In the user's language."""
    return tr(label(entry.key))


def tooltip_of(entry: Setting) -> str:
    """In the user's language, without the keys of jobs: "first height" for "first_height"."""
    return re.sub(r"\b[a-z]+(_[a-z]+)+\b", lambda key: key.group().replace("_", " "),
                  tr_doc(entry.doc))


class SettingsForm:
    """Rows of fields that show and change the properties of one document object."""

    def __init__(self, document_object, entries: Iterable[Setting], layout,
                 on_edited: Callable[[], None], on_refused: Callable[[str], None],
                 on_typed: Callable[[Dict[str, Any]], None],
                 inherited: Optional[Callable[[Setting], Any]] = None) -> None:
        """`on_typed` gets a setting and its value while it is being typed. `inherited`: each row
        has a box to tick for a value that is given, and shows what holds without one in grey."""
        optional = inherited is not None
        self._inherited = inherited
        self._object, self._on_edited, self._on_refused = document_object, on_edited, on_refused
        layout.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        layout.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        self._fields: List[Field] = []
        self._given: List[Optional[Any]] = []
        titles = [self._add(entry, layout, optional) for entry in entries]
        # Rows alike are laid out alike; and Qt, which forgets the gap between the two, sees whether
        # a field fits beside the widest title.
        gap = max(layout.horizontalSpacing(), 6)
        layout.setHorizontalSpacing(0)
        widest = max((title.sizeHint().width() for title in titles), default=0)
        for title in titles:
            title.setMinimumWidth(widest + gap)
        self._loading = True
        for field in self._fields:
            field.on_edited(self._edited)
            field.on_typed(
                lambda value, key=field.entry.key: on_typed({key: value}))
            field.bind(document_object)
        self.load()

    def _add(self, entry: Setting, layout, optional: bool):
        """Returns the row's title."""
        field = field_for(entry, self._object)
        name = f"{type(self._object.Proxy).__name__}_{entry.key}"
        field.widget.setObjectName(name)
        field.widget.setMinimumWidth(field.least_width())
        title = QtGui.QCheckBox(label_of(entry)) if optional else QtGui.QLabel(label_of(entry))
        title.setToolTip(tooltip_of(entry))
        for widget in (title, field.widget):
            widget.setWhatsThis(f"<b>{label_of(entry)}</b><br>{tooltip_of(entry)}")
        field.widget.setAccessibleName(label_of(entry))
        if optional:
            title.setObjectName(f"{name}_given")
            title.toggled.connect(lambda on: self._give(field, on))
        layout.addRow(title, field.widget)
        self._fields.append(field)
        self._given.append(title if optional else None)
        return title

    def load(self) -> None:
        self._loading = True
        for field, given in zip(self._fields, self._given):
            value = from_property(field.entry, getattr(self._object, property_name(field.entry)))
            known = given is None or value != unset_value(field.entry)
            if given is not None:
                given.setChecked(known)
                field.enable(known)
            if known:
                field.show(value)
            else:
                self._show_inherited(field)
        self._loading = False

    def _give(self, field: Field, on: bool) -> None:
        """A box was ticked, or not any more: the value begins with what held until now."""
        field.enable(on)
        if not self._show_inherited(field) and on:
            field.show(field.entry.default or field.entry.low or 0)
        self._edited()

    def _show_inherited(self, field: Field) -> bool:
        """Whether there is such a value."""
        value = self._inherited(field.entry)
        if value is None:
            field.blank()
        else:
            field.show(value)
        return value is not None

    def store(self) -> None:
        """Writes what differs; a property that an expression rules keeps its expression. Raises
        InputError for an entry that makes no sense."""
        ruled = {path.lstrip(".") for path, _expression in self._object.ExpressionEngine}
        for field, given in zip(self._fields, self._given):
            entry, name = field.entry, property_name(field.entry)
            if name in ruled:
                continue
            wanted = unset_value(entry) if given is not None and not given.isChecked() \
                else field.value()
            if from_property(entry, getattr(self._object, name)) != wanted:
                setattr(self._object, name, to_property(entry, wanted))

    def release(self) -> None:
        """The widgets are going away."""
        self._loading = True
        for field in self._fields:
            field.release()

    def _edited(self) -> None:
        if self._loading:
            return
        try:
            self.store()
        except InputError as error:
            self._on_refused(error.sentence.translated)
        else:
            self._on_edited()

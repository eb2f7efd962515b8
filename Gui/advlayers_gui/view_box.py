"""How a coloured mesh is looked at: element edges, the range of the colours, a plane that cuts."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Optional, Tuple

from PySide import QtCore, QtGui

from advlayers.language import tr
from advlayers_gui.decimal_sign import accept_both

NEAR, ALWAYS, NEVER = range(3)
_STEPS = 200  # of the slider


@dataclass(frozen=True)
class ViewOptions:
    edges: int = NEAR
    span: Optional[Tuple[float, float]] = None  # of the colours; None: that of the field
    logarithmic: Optional[bool] = None  # None: as the field is as a rule
    cut_axis: int = -1  # 0, 1, 2: nothing beyond the plane across x, y, z is drawn; -1: no plane
    cut_share: float = 0.5  # of the mesh's extent along the axis

    @property
    def colours(self) -> Tuple[Any, Any]:
        """What the colours depend on."""
        return self.span, self.logarithmic


class ViewBox:
    """`on_options` gets the options with each change."""

    def __init__(self, on_options: Callable[[ViewOptions], None]) -> None:
        self._on_options, self._silent = on_options, False
        self.widget = QtGui.QGroupBox(tr("View"))
        self.widget.setObjectName("AdvLayersView")
        self.widget.setCheckable(True)
        self.widget.setChecked(False)
        inside = QtGui.QWidget()
        around, form = QtGui.QVBoxLayout(self.widget), QtGui.QFormLayout(inside)
        around.setContentsMargins(2, 10, 2, 0)
        around.addWidget(inside)
        inside.setVisible(False)
        self.widget.toggled.connect(inside.setVisible)
        self._edges = self._choice("Edges", [tr("Near"), tr("Always"), tr("Never")], tr(
            "When the edges of the elements are drawn; near: where they are far enough apart"))
        form.addRow(tr("Element edges"), self._edges)
        self._own = QtGui.QCheckBox(tr("Colours from"))
        self._own.setObjectName("AdvLayersOwnRange")
        self._own.setToolTip(tr("A range of the colours other than that of the field"))
        self._low, self._high = self._number("Low", 0.0), self._number("High", 1.0)
        ends = QtGui.QHBoxLayout()
        for end in (self._low, self._high):
            ends.addWidget(end)
        form.addRow(self._own, ends)
        self._scale = self._choice(
            "Scale", [tr("As usual"), tr("Even"), tr("Logarithmic")],
            tr("How the colours are spread over their range; logarithmic needs numbers above 0"))
        form.addRow(tr("Scale"), self._scale)
        self._axis = self._choice("Cut", [tr("Nowhere"), "X", "Y", "Z"],
                                  tr("Hides what lies beyond a plane across this axis"))
        self._share = QtGui.QSlider(QtCore.Qt.Horizontal)
        self._share.setObjectName("AdvLayersCutShare")
        self._share.setRange(0, _STEPS)
        self._share.setValue(_STEPS // 2)
        form.addRow(tr("Cut across"), self._axis)
        form.addRow(self._share)
        self._own.toggled.connect(self._changed)
        self._share.valueChanged.connect(self._changed)

    def options(self) -> ViewOptions:
        low, high = self._low.value(), self._high.value()
        return ViewOptions(
            self._edges.currentIndex(),
            (low, high) if self._own.isChecked() and low < high else None,
            (None, False, True)[self._scale.currentIndex()],
            self._axis.currentIndex() - 1, self._share.value() / _STEPS)

    def offer_range(self, low: float, high: float) -> None:
        """That of the field that is shown, as long as the user has none of their own."""
        if not self._own.isChecked():
            self._silent = True
            self._low.setValue(low)
            self._high.setValue(high)
            self._silent = False

    def _choice(self, name: str, texts, doc: str):
        box = QtGui.QComboBox()
        box.setObjectName(f"AdvLayersView{name}")
        box.addItems(texts)
        box.setToolTip(doc)
        box.setMinimumContentsLength(6)
        box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        box.currentIndexChanged.connect(self._changed)
        return box

    def _number(self, name: str, value: float):
        box = QtGui.QDoubleSpinBox()
        box.setObjectName(f"AdvLayersView{name}")
        box.setDecimals(4)
        box.setRange(-1e9, 1e9)
        box.setValue(value)
        box.setKeyboardTracking(False)
        box.setMinimumWidth(60)
        box.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
        accept_both(box)
        box.valueChanged.connect(self._changed)
        return box

    def _changed(self, *_value) -> None:
        if not self._silent:
            self._on_options(self.options())

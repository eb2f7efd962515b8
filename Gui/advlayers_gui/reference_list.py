"""A list of faces and edges that is filled from the selection in the 3D view."""
from __future__ import annotations

from typing import Callable, List, Sequence, Tuple

from PySide import QtCore, QtGui

from advlayers.language import tr
from advlayers_gui.picking import PickSession


class ReferenceList:
    """`kinds` may be added: "Face", "Edge". A click on a row highlights it in the view; `on_change`
    gets the new names."""

    def __init__(self, name: str, kinds: Tuple[str, ...], picks: PickSession,
                 on_change: Callable[[List[str]], None],
                 on_refused: Callable[[str], None], empty: str = "") -> None:
        self._kinds, self._picks = kinds, picks
        self._on_change, self._on_refused, self._empty = on_change, on_refused, empty
        self._names: List[str] = []
        self.widget = QtGui.QWidget()
        self._list = QtGui.QListWidget()
        self._list.setObjectName(f"AdvLayers_{name}_list")
        self._list.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self._list.setFixedHeight(4 * self._list.fontMetrics().height() + 16)
        self._list.itemClicked.connect(lambda _item: self._highlight())
        add = tool_button("+", tr("Adds what is selected in the 3D view"), self._add)
        add.setObjectName(f"AdvLayers_{name}_add")
        remove = tool_button("−", tr("Takes the marked rows off the list"), self._remove)
        remove.setObjectName(f"AdvLayers_{name}_remove")
        layout = QtGui.QGridLayout(self.widget)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._list, 0, 0, 2, 1)
        layout.addWidget(add, 0, 1)
        layout.addWidget(remove, 1, 1, QtCore.Qt.AlignTop)

    def show(self, names: Sequence[str]) -> None:
        self._names = list(names)
        self._list.clear()
        self._list.addItems(self._names)
        if not self._names and self._empty:
            item = QtGui.QListWidgetItem(self._empty)
            item.setFlags(QtCore.Qt.NoItemFlags)
            self._list.addItem(item)

    def _marked(self) -> List[str]:
        return [item.text() for item in self._list.selectedItems()]

    def _highlight(self) -> None:
        self._picks.select(self._marked())

    def _add(self) -> None:
        picked = [name for name in self._picks.names()
                  if name.rstrip("0123456789") in self._kinds]
        fresh = [name for name in picked if name not in self._names]
        if not picked:
            wanted = " / ".join(self._kinds)
            self._on_refused(tr("select in the 3D view first: {}")
                             .format(wanted))
        elif not fresh:
            self._on_refused(tr("{} is on the list already")
                             .format(", ".join(picked)))
        else:
            self._set(self._names + fresh)

    def _remove(self) -> None:
        marked = self._marked()
        if marked:
            self._set([name for name in self._names if name not in marked])

    def _set(self, names: List[str]) -> None:
        self.show(names)
        self._on_change(names)


def tool_button(text: str, doc: str, act: Callable[[], None]):
    button = QtGui.QToolButton()
    button.setText(text)
    button.setToolTip(doc)
    button.clicked.connect(lambda _checked=False: act())
    return button

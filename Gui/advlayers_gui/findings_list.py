"""What there is to say about a mesh: one line for a kind, with its members below; a click leads to
the next place, a button does something about it where something can be done at once."""
from __future__ import annotations

from typing import Any, Callable, Dict, List, Tuple

from PySide import QtCore, QtGui

from advlayers import check
from advlayers.check import Finding, Group
from advlayers.language import tr

_ICONS = {"error": QtGui.QStyle.SP_MessageBoxCritical,
          "warning": QtGui.QStyle.SP_MessageBoxWarning,
          "info": QtGui.QStyle.SP_MessageBoxInformation}
# A button's text and what it does, by the kind of finding.
Remedies = Dict[str, Tuple[str, Callable[[], None]]]


class FindingsList:
    """`on_finding` gets the one that is to be looked at."""

    def __init__(self, on_finding: Callable[[Finding], None], remedies: Remedies) -> None:
        self._on_finding, self._remedies = on_finding, remedies
        self._groups: List[Group] = []
        self._turn: List[int] = []  # of each group, the member that its line leads to next
        self.widget = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(self.widget)
        layout.setContentsMargins(0, 0, 0, 0)
        self._tree = QtGui.QTreeWidget()
        self._tree.setObjectName("AdvLayersFindings")
        self._tree.setHeaderHidden(True)
        self._tree.setIndentation(14)
        self._tree.setMinimumHeight(80)
        self._tree.setWordWrap(True)
        self._tree.setToolTip(tr("A click shows the place; another one on the same line the next"))
        self._tree.itemClicked.connect(lambda item, _column: self._pick(item))
        self._tree.currentItemChanged.connect(lambda item, _before: self._offer(item))
        layout.addWidget(self._tree)
        self._remedy = QtGui.QPushButton()
        self._remedy.setObjectName("AdvLayersRemedy")
        self._remedy.clicked.connect(lambda _checked=False: self._mend())
        self._remedy.hide()
        layout.addWidget(self._remedy)

    def show(self, findings: List[Finding], nothing: str) -> None:
        """`nothing`: what to say where there are none."""
        self._groups = check.grouped(findings)
        self._turn = [0] * len(self._groups)
        self._tree.clear()
        self._remedy.hide()
        for group in self._groups:
            item = QtGui.QTreeWidgetItem([group.text])
            item.setIcon(0, self._tree.style().standardIcon(_ICONS[group.severity]))
            item.setToolTip(0, group.text)
            if len(group.findings) > 1:
                item.addChildren([QtGui.QTreeWidgetItem([finding.text])
                                  for finding in group.findings])
            self._tree.addTopLevelItem(item)
        if not self._groups and nothing:
            item = QtGui.QTreeWidgetItem([nothing])
            item.setFlags(QtCore.Qt.NoItemFlags)
            self._tree.addTopLevelItem(item)

    def _group_of(self, item: Any) -> int:
        return self._tree.indexOfTopLevelItem(item if item.parent() is None else item.parent())

    def _pick(self, item) -> None:
        if not self._groups:
            return
        number = self._group_of(item)
        findings = self._groups[number].findings
        if item.parent() is not None:
            self._on_finding(findings[item.parent().indexOfChild(item)])
            return
        self._on_finding(findings[self._turn[number]])
        self._turn[number] = (self._turn[number] + 1) % len(findings)

    def _offer(self, item) -> None:
        kind = self._groups[self._group_of(item)].kind if item and self._groups else ""
        self._remedy.setVisible(kind in self._remedies)
        if kind in self._remedies:
            self._remedy.setText(self._remedies[kind][0])

    def _mend(self) -> None:
        item = self._tree.currentItem()
        if item is not None and self._groups:
            self._remedies[self._groups[self._group_of(item)].kind][1]()

"""What came out: counts, qualities, walls asked and achieved, notes; and where to look at them."""
from __future__ import annotations

from typing import Any, Callable, List, Mapping, Optional, Sequence

from PySide import QtCore, QtGui

from advlayers import check
from advlayers.check import Finding
from advlayers.language import tr
from advlayers.mesh_data import FIELDS, HEIGHT, QUALITY, MeshData, Place
from advlayers.sentence import stop_words
from advlayers_gui.colours import title_of
from advlayers_gui.findings_list import FindingsList, Remedies
from advlayers_gui.histogram import BARS, Histogram
from advlayers_gui.view_box import ViewBox, ViewOptions
from advlayers.lengths import length_text


class ResultsPage:
    """`on_field` gets the field to colour by; `on_place` where to look at, None for nowhere, and
    what there is to see; `remedies` what can be done about kinds of findings."""

    def __init__(self, on_field: Callable[[str], None],
                 on_place: Callable[[Optional[Place], str], None], remedies: Remedies,
                 on_options: Callable[[ViewOptions], None]) -> None:
        self._on_field, self._on_place = on_field, on_place
        self._data: Optional[MeshData] = None
        self.widget = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(self.widget)
        layout.setContentsMargins(4, 4, 4, 4)
        self._figures = QtGui.QLabel(tr("There is no mesh yet: press Mesh."))
        self._figures.setObjectName("AdvLayersFigures")
        self._figures.setWordWrap(True)
        layout.addWidget(self._figures)
        layout.addLayout(self._make_field_row())
        self.view = ViewBox(on_options)
        layout.addWidget(self.view.widget)
        self._histogram = Histogram(self._pick_bar)
        layout.addWidget(self._histogram)
        layout.addWidget(self._make_walls())
        self._findings = FindingsList(self._pick_finding, remedies)
        layout.addWidget(self._findings.widget)

    @property
    def field(self) -> str:
        return FIELDS[self._choice.currentIndex()]

    def show(self, data: Optional[MeshData], remarks: Sequence[Finding] = ()) -> None:
        """The mesh, where there is one; the remarks are listed with what the mesh gives cause
        for."""
        self._data = data
        self._findings.show([*remarks, *(check.of_mesh(data) if data else ())],
                            tr("There is nothing to complain of.") if data else "")
        if data is not None:
            self._figures.setText(_figures_text(data.report))
            self._histogram.show_values(data.field(QUALITY))
            self._fill_walls(data.report.get("walls", ()))

    # --- widgets ------------------------------------------------------------------------------

    def _make_field_row(self):
        row = QtGui.QHBoxLayout()
        row.addWidget(QtGui.QLabel(tr("Colour by")))
        self._choice = QtGui.QComboBox()
        self._choice.setObjectName("AdvLayersField")
        self._choice.setToolTip(tr("What the colours of the elements in the 3D view stand for"))
        self._choice.setMinimumContentsLength(6)
        self._choice.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self._choice.addItems([title_of(field) for field in FIELDS])
        self._choice.currentIndexChanged.connect(lambda index: self._on_field(FIELDS[index]))
        row.addWidget(self._choice, 1)
        return row

    def _make_walls(self):
        headers = [tr("Edge"), tr("Face"), tr("Height asked"), tr("Height got"), tr("Growth"),
                   tr("Layers"), tr("Ended by")]
        self._walls = QtGui.QTableWidget(0, len(headers))
        self._walls.setObjectName("AdvLayersWalls")
        self._walls.setHorizontalHeaderLabels(headers)
        rows = self._walls.verticalHeader()
        rows.setVisible(False)
        rows.setDefaultSectionSize(self._walls.fontMetrics().height() + 6)
        self._walls.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self._walls.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self._walls.setMinimumHeight(130)
        self._walls.setToolTip(tr("A click shows where layers end too early, or where the first "
                                  "height is most off"))
        self._walls.cellClicked.connect(lambda row, _column: self._pick_wall(row))
        return self._walls

    # --- contents -----------------------------------------------------------------------------

    def _fill_walls(self, walls) -> None:
        self._walls.setRowCount(len(walls))
        for row, wall in enumerate(walls):
            for column, text in enumerate(_wall_texts(wall)):
                item = QtGui.QTableWidgetItem(text)
                item.setToolTip(text)
                if column > 1:
                    item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
                self._walls.setItem(row, column, item)
        self._walls.resizeColumnsToContents()

    # --- clicks -------------------------------------------------------------------------------

    def _pick_bar(self, bar: int) -> None:
        if self._data is None:
            return
        quality = self._data.field(QUALITY)
        low, high = bar / BARS, (bar + 1) / BARS
        element = self._data.worst((quality >= low) & ((quality < high) | (bar == BARS - 1)))
        if element >= 0:
            text = tr("element {}: quality {:.2f}").format(element + 1, quality[element])
            self._on_place(self._data.place_of(element), text)

    def _pick_finding(self, finding: Finding) -> None:
        if finding.wall >= 0:
            self._pick_wall(finding.wall)
        elif finding.element >= 0:
            self._on_place(self._data.place_of(finding.element), finding.text)
        else:
            place = self._data.place_near(finding.point) if finding.point else None
            self._on_place(place, finding.text)

    def _pick_wall(self, row: int) -> None:
        """Where layers stopped early, if any; else where the first height is most off."""
        wall = self._data.report["walls"][row]
        reason, point = _early_stop(wall)
        if point is not None:
            text = tr("{edge} on {face}: layers end here first: {reason}").format(
                edge=wall["edge"], face=wall["face"], reason=stop_words(reason))
            self._on_place(self._data.place_near(point), text)
            return
        element = self._data.worst_height(int(wall["edge"][4:]), int(wall["face"][4:]))
        if element < 0:
            self._on_place(None, tr("{edge} on {face} has no layer").format(
                edge=wall["edge"], face=wall["face"]))
            return
        text = tr("{edge} on {face}: the first height is most off here, by {error:+.1f} %").format(
            edge=wall["edge"], face=wall["face"], error=self._data.field(HEIGHT)[element])
        self._on_place(self._data.place_of(element), text)


# Ends that are no shortfall: there was nowhere to go on, or no need to.
_EXPECTED = ("layers-reached", "isotropic", "closed", "merged")


def _early_stop(wall: Mapping[str, Any]):
    """The reason of the lowest end that is a shortfall, and its point; else nothing."""
    places = {reason: place for reason, place in wall.get("first_stops", {}).items()
              if reason not in _EXPECTED}
    if not places:
        return "", None
    reason = min(places, key=lambda key: places[key]["layer"])
    return reason, places[reason]["point"]


def _figures_text(report: Mapping[str, Any]) -> str:
    """A table: what, how many, what share of all."""
    if "nodes" not in report:
        return ""
    rows = [
        (tr("Quads"), report["quads"], _percent(report["quad_percent"])),
        (tr("in layers"), "", _percent(report["layer_quad_percent"])),
        (tr("Triangles"), report["triangles"], _percent(100.0 - report["quad_percent"])),
        (tr("Nodes"), report["nodes"], ""),
        (tr("Angles from"), f"{report['min_angle']:.1f}°", ""),
        (tr("to"), f"{report['max_angle']:.1f}°", ""),
        ("45–135°", "", _percent(report["angles_45_135_percent"])),
    ]
    if report["inverted"]:
        rows.append((tr("Inverted"), report["inverted"], ""))
    cells = "".join(
        f"<tr><td>{name}</td><td align='right'><b>{value}</b>&nbsp;</td>"
        f"<td align='right'>{share}</td></tr>" for name, value, share in rows)
    return f"<table width='100%'>{cells}</table>"


def _percent(number: float) -> str:
    return f"{number:.1f}&nbsp;%"


def _wall_texts(wall: Mapping[str, Any]) -> List[str]:
    achieved = wall["achieved_first_height"]
    mean = achieved["mean"]
    asked = wall["requested_layers"]
    stops = ", ".join(f"{stop_words(reason)} ({count})"
                      for reason, count in sorted(wall["stops"].items(), key=lambda x: -x[1]))
    return [wall["edge"], wall["face"], length_text(wall["first_height"]),
            "{} ({} – {})".format(*map(length_text, (mean, achieved["min"], achieved["max"]))),
            f"{wall['growth']:.3g} → {wall['achieved_growth']:.3g}",
            f"{asked} → {wall['layers']}" if asked else str(wall["layers"]), stops]

"""How many elements are how good, as bars."""
from __future__ import annotations

from typing import Any, Callable

import numpy as np
from PySide import QtCore, QtGui

from advlayers.language import tr
from advlayers_gui.colours import quality_scale

BARS = 20


class Histogram(QtGui.QWidget):
    """Of values from 0 to 1. The height of a bar is logarithmic, so that a few bad elements among
    many good ones are seen. `on_pick` gets the number of a bar that is clicked on."""

    def __init__(self, on_pick: Callable[[int], None]) -> None:
        super().__init__()
        self.setObjectName("AdvLayersHistogram")
        self.setMinimumHeight(90)
        self.setMouseTracking(True)
        self.counts = np.zeros(BARS, int)
        self._on_pick = on_pick

    def show_values(self, values: Any) -> None:
        self.counts = np.histogram(values, BARS, (0.0, 1.0))[0]
        self.update()

    def paintEvent(self, _event) -> None:
        painter = QtGui.QPainter(self)
        tallest = np.log1p(max(int(self.counts.max()), 1))
        line = self.fontMetrics().height()
        room = self.height() - line - 2
        width = self.width() / BARS
        colours = quality_scale().rgb((np.arange(BARS) + 0.5) / BARS)
        for k, count in enumerate(self.counts.tolist()):
            height = room * np.log1p(count) / tallest
            colour = QtGui.QColor.fromRgbF(*[float(x) for x in colours[k]])
            painter.fillRect(QtCore.QRectF(k * width + 1, room - height, width - 2, height), colour)
        painter.drawLine(0, room, self.width(), room)
        for k in range(0, BARS + 1, 5):
            text = f"{k / BARS:g}"
            wide = self.fontMetrics().boundingRect(text).width()
            x = min(max(k * width - 0.5 * wide, 0.0), self.width() - wide - 2.0)
            painter.drawText(QtCore.QPointF(x, self.height() - 3), text)
        painter.end()

    def mouseMoveEvent(self, event) -> None:
        bar = self._bar_at(event)
        QtGui.QToolTip.showText(
            QtGui.QCursor.pos(),
            tr("{} elements of quality {:.2f} to {:.2f}").format(
                self.counts[bar], bar / BARS, (bar + 1) / BARS), self)

    def mousePressEvent(self, event) -> None:
        self._on_pick(self._bar_at(event))

    def _bar_at(self, event) -> int:
        return min(max(int(event.pos().x() * BARS / max(self.width(), 1)), 0), BARS - 1)

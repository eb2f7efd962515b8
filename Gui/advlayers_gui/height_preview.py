"""Lines in the 3D view where the layers that are asked for would end."""
from __future__ import annotations

from typing import Iterable, List

import numpy as np
from pivy import coin

from advlayers.height_lines import WallLines
from advlayers.language import tr
from advlayers_gui.conditions_view import polylines
from advlayers.lengths import length_text

_FIRST_COLOUR = (0.10, 0.45, 0.85)
_LAST_COLOUR = (0.93, 0.50, 0.10)


class HeightPreview:
    """Blue: the top of the first layer; orange: that of the last one, where their number is set.
    caption() says so, with the heights."""

    def __init__(self) -> None:
        self.lines: List[WallLines] = []  # shown
        self.root = self._switch = coin.SoSwitch()
        self._lines = coin.SoSeparator()
        self._switch.addChild(self._lines)
        self.unhide()

    def hide(self) -> None:
        self._switch.whichChild = coin.SO_SWITCH_NONE

    def unhide(self) -> None:
        self._switch.whichChild = coin.SO_SWITCH_ALL

    def caption(self) -> str:
        """What is shown; empty where nothing is."""
        parts = []
        for text, heights in (
                (tr("first height {} (blue)"), [line.first_heights for line in self.lines]),
                (tr("all layers {} (orange)"), [line.totals for line in self.lines])):
            values = np.concatenate(heights) if heights else np.zeros(0)
            if len(values):
                parts.append(text.format(_range(values)))
        return tr("Preview: {}").format(", ".join(parts)) if parts else ""

    def clear(self) -> None:
        self.lines = []
        self._lines.removeAllChildren()

    def show(self, lines: Iterable[WallLines]) -> None:
        self.clear()
        self.lines = lines = list(lines)
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        flat = coin.SoLightModel()
        flat.model = coin.SoLightModel.BASE_COLOR
        style = coin.SoDrawStyle()
        style.lineWidth = 2.0
        for node in (pick, flat, style):
            self._lines.addChild(node)
        self._lines.addChild(polylines([line.first for line in lines], _FIRST_COLOUR))
        ends = [line for line in lines if line.last is not None]
        self._lines.addChild(polylines([line.last for line in ends], _LAST_COLOUR))
        rungs = [np.array([foot, last]) for line in ends
                 for foot, last in zip(line.foot, line.last)]
        self._lines.addChild(polylines(rungs, _LAST_COLOUR))


def _range(lengths) -> str:
    """From the least to the largest, in the user's units."""
    ends = [length_text(length) for length in (lengths.min(), lengths.max())]
    return " – ".join(dict.fromkeys(ends))

"""What the edges of the shape are to the mesh, in colours: walls with arrows on the sides where
layers grow, match edges, edges without layers, local sizes and groups; with a legend."""
from __future__ import annotations

from typing import Any, Dict, Iterable, List, Mapping, Tuple

import numpy as np
from pivy import coin

from advlayers.edge_outlines import MATCH, OFF, WALL, EdgeOutlines
from advlayers.height_lines import WallLines
from advlayers.language import tr
from advlayers_gui.legend import WordLegend

_Colour = Tuple[float, float, float]
_COLOURS: Dict[str, _Colour] = {WALL: (0.78, 0.13, 0.13), MATCH: (0.10, 0.55, 0.25),
                                OFF: (0.45, 0.45, 0.48)}
_SIZE_COLOUR, _LIT_COLOUR = (0.55, 0.20, 0.70), (1.00, 0.80, 0.05)
_GROUP_COLOURS = ((0.05, 0.50, 0.65), (0.75, 0.45, 0.05), (0.35, 0.45, 0.10), (0.60, 0.25, 0.35))
_DASHES = 0x00FF
_ARROW = 0.025  # of the shape's diagonal


class ConditionsView:
    def __init__(self) -> None:
        self.shown: Dict[str, int] = {}  # lines of each kind
        self.root = self._switch = coin.SoSwitch()
        self._content, self._legend = coin.SoSeparator(), WordLegend()
        for node in (self._content, self._legend.root):
            self._switch.addChild(node)
        self.unhide()

    def hide(self) -> None:
        self._switch.whichChild = coin.SO_SWITCH_NONE

    def unhide(self) -> None:
        self._switch.whichChild = coin.SO_SWITCH_ALL

    def clear(self) -> None:
        self.shown = {}
        self._content.removeAllChildren()
        self._legend.hide()

    def show(self, outlines: EdgeOutlines, settings: Mapping[str, Any], walls: List[WallLines],
             diagonal: float) -> None:
        self.clear()
        self._content.addChild(_unlit())
        legend = []
        kinds = outlines.conditions(settings)
        texts = {WALL: tr("Wall"), MATCH: tr("Match"), OFF: tr("Off")}
        for kind, colour in _COLOURS.items():
            lines = [outlines.lines[name] for name, other in kinds.items() if other == kind]
            legend += self._add(kind, texts[kind], lines, colour, 3.0 if kind == WALL else 2.0)
        arrows = [stroke for line in walls for stroke in _arrow(line, _ARROW * diagonal)]
        self._add("arrow", "", arrows, _COLOURS[WALL], 2.0)
        sized = [name for size in settings["sizes"] for key in ("edges", "faces")
                 for name in size[key]]
        legend += self._add("size", tr("Size"), outlines.of(sized), _SIZE_COLOUR, 4.0, _DASHES)
        for number, (name, members) in enumerate(settings["groups"].items()):
            colour = _GROUP_COLOURS[number % len(_GROUP_COLOURS)]
            legend += self._add("group", name, outlines.of(list(members)), colour, 5.0, _DASHES)
        self._legend.show(legend)

    def light(self, lines: Iterable[Any]) -> None:
        """Over all others: what is being worked on."""
        self._content.addChild(_unlit())
        self._add("lit", "", list(lines), _LIT_COLOUR, 6.0)

    def _add(self, kind: str, text: str, lines: List[Any], colour: _Colour, width: float,
             pattern: int = 0xFFFF) -> List[Tuple[_Colour, str]]:
        """Returns the entry of the legend, where there are lines."""
        self.shown[kind] = self.shown.get(kind, 0) + len(lines)
        if not lines:
            return []
        style = coin.SoDrawStyle()
        style.lineWidth, style.linePattern = width, pattern
        self._content.addChild(style)
        self._content.addChild(polylines(lines, colour))
        return [(colour, text)]


def _unlit():
    """Not picked, not shaded."""
    group = coin.SoGroup()
    pick = coin.SoPickStyle()
    pick.style = coin.SoPickStyle.UNPICKABLE
    flat = coin.SoLightModel()
    flat.model = coin.SoLightModel.BASE_COLOR
    group.addChild(pick)
    group.addChild(flat)
    return group


def _arrow(line: WallLines, length: float) -> List[Any]:
    """From the middle of the edge to the side of the layers."""
    if not len(line.foot):
        return []
    middle = len(line.foot) // 2
    foot, way = line.foot[middle], line.first[middle] - line.foot[middle]
    tall = np.linalg.norm(way)
    if tall == 0.0:
        return []
    way = way / tall * length
    beside = (line.foot[-1] - line.foot[0]) if middle in (0, len(line.foot)) \
        else line.foot[middle] - line.foot[middle - 1]
    wide = np.linalg.norm(beside)
    aside = beside / wide * 0.25 * length if wide > 0.0 else 0.0 * way
    tip = foot + way
    return [np.array([foot, tip]), np.array([tip - 0.35 * way + aside, tip]),
            np.array([tip - 0.35 * way - aside, tip])]


def polylines(lines: List[Any], colour: _Colour):
    separator = coin.SoSeparator()
    if not lines:
        return separator
    paint = coin.SoBaseColor()
    paint.rgb = colour
    points = np.concatenate(lines).astype(np.float32)
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), points)
    drawn = coin.SoLineSet()
    drawn.numVertices.setValues(0, len(lines), [len(line) for line in lines])
    for node in (paint, coordinates, drawn):
        separator.addChild(node)
    return separator

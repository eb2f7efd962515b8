"""Legends in the lower left corner of the 3D view: of a colour scale, of colours with a word."""
from __future__ import annotations

from typing import Iterable, Sequence, Tuple

import numpy as np
from pivy import coin

from advlayers_gui.colours import Scale

# In the view's own coordinates, which run from -1 to 1 both ways.
_LEFT, _RIGHT, _BOTTOM, _TOP = -0.95, -0.91, -0.85, -0.25
_PLATE = (-0.98, -0.72, -0.90, -0.14)  # left, right, bottom, top
_PLATE_COLOUR = (0.93, 0.94, 0.95)
_STEPS = 40
_LABELS = 5
_LINE = 0.06  # from one word to the next
_TEXT_COLOUR = (0.05, 0.05, 0.05)


class _Corner:
    """Takes no room in the scene, and cannot be picked."""

    def __init__(self) -> None:
        # FreeCAD's own node: "fit all" must not take the legend for a part of the model.
        kind = coin.SoType.fromName("SoSkipBoundingGroup")
        self.root = kind.createInstance() if not kind.isBad() else coin.SoSeparator()
        self._content = coin.SoAnnotation()
        self.root.addChild(self._content)

    def hide(self) -> None:
        self._content.removeAllChildren()

    def _show(self, *nodes) -> None:
        self.hide()
        camera = coin.SoOrthographicCamera()
        camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        camera.height = 2.0
        camera.position = (0.0, 0.0, 1.0)
        camera.nearDistance, camera.farDistance = 0.5, 1.5
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        flat = coin.SoLightModel()
        flat.model = coin.SoLightModel.BASE_COLOR
        for node in (camera, pick, flat, *nodes):
            self._content.addChild(node)


class Legend(_Corner):
    def show(self, scale: Scale) -> None:
        self._show(_plate(_PLATE), _bar(scale), _texts(scale))


class WordLegend(_Corner):
    def show(self, entries: Sequence[Tuple[Tuple[float, float, float], str]]) -> None:
        """Colours and what they stand for, from the top."""
        if not entries:
            self.hide()
            return
        left, right, bottom, _top = _PLATE
        top = bottom + _LINE * (len(entries) + 0.5)
        nodes = [_plate((left, right + 0.2, bottom, top))]
        for number, (colour, word) in enumerate(entries):
            height = top - _LINE * (number + 0.8)
            nodes += [_sample(colour, height), _words(((word, _RIGHT + 0.03, height - 0.012),))]
        self._show(*nodes)


def _sample(colour, height: float):
    """A short line of the colour."""
    separator = coin.SoSeparator()
    paint = coin.SoBaseColor()
    paint.rgb = colour
    style = coin.SoDrawStyle()
    style.lineWidth = 4.0
    ends = coin.SoCoordinate3()
    ends.point.setValues(0, 2, [(_LEFT, height, 0.0), (_RIGHT + 0.01, height, 0.0)])
    for node in (paint, style, ends, coin.SoLineSet()):
        separator.addChild(node)
    return separator


def _plate(extent: Tuple[float, float, float, float]):
    """What the texts stand on, so that they can be read before any mesh."""
    plate = coin.SoSeparator()
    left, right, bottom, top = extent
    corners = [(left, bottom, 0.0), (right, bottom, 0.0), (right, top, 0.0), (left, top, 0.0)]
    colour = coin.SoBaseColor()
    colour.rgb = _PLATE_COLOUR
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, 4, corners)
    face = coin.SoFaceSet()
    face.numVertices = 4
    for node in (colour, coordinates, face):
        plate.addChild(node)
    return plate


def _bar(scale: Scale):
    bar = coin.SoSeparator()
    heights = np.linspace(_BOTTOM, _TOP, _STEPS + 1)
    points = [(x, y, 0.0) for y in heights for x in (_LEFT, _RIGHT)]
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), points)
    colours = coin.SoBaseColor()
    colours.rgb.setValues(0, len(points),
                          np.repeat(scale.at(np.linspace(0.0, 1.0, _STEPS + 1)), 2, axis=0)
                          .tolist())
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.PER_VERTEX
    strip = coin.SoTriangleStripSet()
    strip.numVertices = len(points)
    for node in (coordinates, binding, colours, strip):
        bar.addChild(node)
    return bar


def _texts(scale: Scale):
    labels = [(label, _RIGHT + 0.015, _BOTTOM + share * (_TOP - _BOTTOM) - 0.012)
              for share, label in scale.labels(_LABELS)]
    return _words([*labels, (scale.title, _LEFT, _TOP + 0.04)])


def _words(placed: Iterable[Tuple[str, float, float]]):
    texts = coin.SoSeparator()
    colour = coin.SoBaseColor()
    colour.rgb = _TEXT_COLOUR
    font = coin.SoFont()
    font.name, font.size = "Arial", 13.0
    texts.addChild(colour)
    texts.addChild(font)
    for words, x, y in placed:
        texts.addChild(_text(words, x, y))
    return texts


def _text(words: str, x: float, y: float):
    separator = coin.SoSeparator()
    place = coin.SoTranslation()
    place.translation = (x, y, 0.0)
    text = coin.SoText2()
    text.string = words
    separator.addChild(place)
    separator.addChild(text)
    return separator

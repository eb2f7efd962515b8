"""The legend of a colour scale, in the lower left corner of the 3D view."""
from __future__ import annotations

import numpy as np
from pivy import coin

from advlayers_gui.colours import Scale

# In the view's own coordinates, which run from -1 to 1 both ways.
_LEFT, _RIGHT, _BOTTOM, _TOP = -0.95, -0.91, -0.85, -0.25
_PLATE = (-0.98, -0.72, -0.90, -0.14)  # left, right, bottom, top
_PLATE_COLOUR = (0.93, 0.94, 0.95)
_STEPS = 40
_LABELS = 5
_TEXT_COLOUR = (0.05, 0.05, 0.05)


class Legend:
    """Takes no room in the scene, and cannot be picked."""

    def __init__(self) -> None:
        # FreeCAD's own node: "fit all" must not take the legend for a part of the model.
        kind = coin.SoType.fromName("SoSkipBoundingGroup")
        self.root = kind.createInstance() if not kind.isBad() else coin.SoSeparator()
        self._content = coin.SoAnnotation()
        self.root.addChild(self._content)

    def hide(self) -> None:
        self._content.removeAllChildren()

    def show(self, scale: Scale) -> None:
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
        for node in (camera, pick, flat, _plate(), _bar(scale), _texts(scale)):
            self._content.addChild(node)


def _plate():
    """What the texts stand on, so that they can be read before any mesh."""
    plate = coin.SoSeparator()
    left, right, bottom, top = _PLATE
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
    texts = coin.SoSeparator()
    colour = coin.SoBaseColor()
    colour.rgb = _TEXT_COLOUR
    font = coin.SoFont()
    font.name, font.size = "Arial", 13.0
    texts.addChild(colour)
    texts.addChild(font)
    for share, label in scale.labels(_LABELS):
        texts.addChild(_text(label, _RIGHT + 0.015, _BOTTOM + share * (_TOP - _BOTTOM) - 0.012))
    texts.addChild(_text(scale.title, _LEFT, _TOP + 0.04))
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

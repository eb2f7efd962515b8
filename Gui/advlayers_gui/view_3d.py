"""The 3D views of a document: what is laid over them for a while, and where they look."""
from __future__ import annotations

from typing import Any, List

import FreeCADGui
import numpy as np
from pivy import coin


class Overlay:
    """A Coin node in every 3D view that the document has when it is put up."""

    def __init__(self, document, root) -> None:
        self._root = root
        self._scenes = [view.getSceneGraph() for view in views_of(document)]
        for scene in self._scenes:
            scene.addChild(root)

    def remove(self) -> None:
        for scene in self._scenes:
            scene.removeChild(self._root)
        self._scenes = []


def views_of(document) -> List[Any]:
    shown = FreeCADGui.getDocument(document.Name)
    return list(shown.mdiViewsOfType("Gui::View3DInventor"))


def fit_all(document) -> None:
    for view in views_of(document):
        view.fitAll()


# Of what is seen, in half widths or heights of the view: how far out it may reach, and how wide it
# has to be at the least.
_FAR_OUT, _SMALL = 1.5, 0.1


def fit_unseen(document, bound_box) -> None:
    """Fits the views that do not show the box, or show it as a dot or from far within."""
    corners = np.array([tuple(bound_box.getPoint(number)) for number in range(8)])
    for view in views_of(document):
        places = _in_view(view.getCameraNode(), corners)
        least, most = places.min(axis=0), places.max(axis=0)
        if (least < -_FAR_OUT).any() or (most > _FAR_OUT).any() or (most - least).max() < _SMALL:
            view.fitAll()


def _in_view(camera, points):
    """(n, 2): how far right and up, in half heights of the view."""
    turn = camera.orientation.getValue()
    right, up, back = (np.array(turn.multVec(coin.SbVec3f(*axis)).getValue())
                       for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
    away = points - np.array(camera.position.getValue().getValue())
    if camera.getTypeId() == coin.SoPerspectiveCamera.getClassTypeId():
        half = np.maximum(-away @ back, 1e-9) * np.tan(0.5 * camera.heightAngle.getValue())
    else:
        half = 0.5 * camera.height.getValue()
    return np.stack([away @ right / half, away @ up / half], axis=1)


def look_at(document, point, normal, width: float) -> None:
    """Turns the views to the point, from where the normal points to; `width` [mm] fills them."""
    for view in views_of(document):
        camera = view.getCameraNode()
        towards = np.asarray(normal, float)
        length = float(np.linalg.norm(towards))
        if length > 0.0:
            camera.orientation = _facing(towards / length)
        back = camera.orientation.getValue().multVec(coin.SbVec3f(0.0, 0.0, 1.0))
        distance = max(camera.focalDistance.getValue(), 4.0 * width)
        if camera.getTypeId() == coin.SoPerspectiveCamera.getClassTypeId():
            distance = 0.5 * width / np.tan(0.5 * camera.heightAngle.getValue())
        else:
            camera.height = width
        camera.focalDistance = distance
        camera.position = coin.SbVec3f(*[float(x) for x in point]) + back * distance


def _facing(towards):
    """The camera's turn that makes it look against the direction, upright where that can be."""
    up = np.array([0.0, 0.0, 1.0]) if abs(towards[2]) < 0.95 else np.array([0.0, 1.0, 0.0])
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    up = np.cross(towards, right)
    matrix = coin.SbMatrix(*[float(x) for row in (right, up, towards)
                             for x in (*row, 0.0)], 0.0, 0.0, 0.0, 1.0)
    return coin.SbRotation(matrix)

"""Elements as Coin nodes. A large mesh is handed over piece by piece, so that no piece keeps the
window waiting."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Generator, Iterator, List

import numpy as np
from pivy import coin

from advlayers_gui.turns import Turns
from advlayers_gui.view_box import ALWAYS, NEAR

# Elements that are handed over at once: some 30 ms for the arrays, and as much for the picture.
PIECE = 20000
# Beside the viewer's own light, so that no side of the model is black.
_LIGHTS = (((0.2, 0.3, 1.0), 0.12), ((1.0, 0.6, 0.0), 0.10))
_APART = 10.0  # [pixels] of an element whose edges are drawn
_LINE_COLOUR = (0.10, 0.12, 0.16)


@dataclass(frozen=True)
class Piece:
    """Some elements as Coin takes them. Made of arrays alone, so in any thread."""

    points: Any  # (n, 3) float32
    faces: Any  # int32: the corners of each element, -1
    lines: Any  # int32: both ends of each side, -1; a side of two elements once
    colours: Any  # (elements,) uint32: 0xRRGGBBAA
    in_layers: int  # elements that are not of the core


def pieces_of(mesh, colours, size: int = PIECE) -> Iterator[Piece]:
    """Cuts an ElementMesh up; `colours` as those of Piece, by element."""
    first = 0
    for cells in (mesh.quads, mesh.triangles):
        for start in range(0, len(cells), size):
            some = cells[start:start + size]
            part = slice(first + start, first + start + len(some))
            yield _piece(mesh.nodes, some, colours[part], mesh.layers[part])
        first += len(cells)


def _piece(nodes, cells, colours, layers) -> Piece:
    used, corners = np.unique(cells, return_inverse=True)
    corners = corners.reshape(cells.shape).astype(np.int32)
    end = np.full((len(corners), 1), -1, np.int32)
    sides = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2)
    sides = np.sort(sides, axis=1).astype(np.int64)
    keys = np.unique(sides[:, 0] * len(used) + sides[:, 1])
    lines = np.column_stack([keys // len(used), keys % len(used), np.full(len(keys), -1)])
    return Piece(np.ascontiguousarray(nodes[used], np.float32),
                 np.hstack([corners, end]).ravel(),
                 lines.astype(np.int32).ravel(),
                 np.ascontiguousarray(colours, np.uint32),
                 int(np.count_nonzero(layers)))


class _PieceNode:
    """The Coin nodes of one piece."""

    def __init__(self) -> None:
        self.root = coin.SoSeparator()
        self._points = coin.SoCoordinate3()
        self._colours = coin.SoPackedColor()
        self._faces = coin.SoIndexedFaceSet()
        self._lines = coin.SoIndexedLineSet()
        self.elements = self.in_layers = 0
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_FACE
        behind = coin.SoPolygonOffset()  # the sides stay visible on the faces
        filled = coin.SoSeparator()
        for node in (behind, binding, self._colours, self._faces):
            filled.addChild(node)
        drawn = coin.SoSeparator()
        flat = coin.SoLightModel()
        flat.model = coin.SoLightModel.BASE_COLOR
        colour = coin.SoBaseColor()
        colour.rgb = _LINE_COLOUR
        for node in (flat, colour, self._lines):
            drawn.addChild(node)
        # Near: where the piece takes so much room that its edges can be told apart.
        self._near, self._edges = coin.SoLevelOfDetail(), coin.SoSwitch()
        self._near.addChild(drawn)
        self._near.addChild(coin.SoGroup())
        self._edges.addChild(self._near)
        self._edges.addChild(drawn)
        for node in (self._points, filled, self._edges):
            self.root.addChild(node)

    def draw_edges(self, when: int) -> None:
        self._edges.whichChild = {NEAR: 0, ALWAYS: 1}.get(when, coin.SO_SWITCH_NONE)

    def fill(self, piece: Piece) -> None:
        # Coin reads indices when it draws: they must fit the points at any time.
        for field in (self._faces.coordIndex, self._lines.coordIndex):
            field.setNum(0)
        self._points.point.setNum(len(piece.points))
        self._points.point.setValues(0, len(piece.points), piece.points)
        self._faces.coordIndex.setValues(0, len(piece.faces), piece.faces)
        self._lines.coordIndex.setValues(0, len(piece.lines), piece.lines)
        self.elements, self.in_layers = len(piece.colours), piece.in_layers
        self._near.screenArea = _APART * self.elements
        self._colours.orderedRGBA.setNum(self.elements)
        self._colours.orderedRGBA.setValues(0, self.elements, piece.colours)


class MeshDrawing:
    """A scene of elements that is filled piece by piece, some in each turn of the event loop."""

    def __init__(self) -> None:
        self.root = coin.SoSeparator()  # what follows it is not cut
        hints = coin.SoShapeHints()  # both sides lit: surfaces are seen from within too
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        for direction, intensity in _LIGHTS:
            light = coin.SoDirectionalLight()
            light.direction, light.intensity = direction, intensity
            self.root.addChild(light)
        self._pieces = coin.SoGroup()
        self._plane = coin.SoClipPlane()
        self._plane.on = False
        for node in (hints, self._plane, self._pieces):
            self.root.addChild(node)
        self._when = NEAR
        self._nodes: List[_PieceNode] = []
        self._turns = Turns()

    @property
    def element_count(self) -> int:
        """Elements shown at this moment."""
        return sum(node.elements for node in self._nodes)

    @property
    def layer_element_count(self) -> int:
        """Those of them that are not of the core."""
        return sum(node.in_layers for node in self._nodes)

    @property
    def busy(self) -> bool:
        return self._turns.busy

    def draw_edges(self, when: int) -> None:
        """NEAR, ALWAYS or NEVER."""
        self._when = when
        for node in self._nodes:
            node.draw_edges(when)

    def cut(self, axis: int, place: float) -> None:
        """Hides what lies beyond the place on the axis; an axis of -1 hides nothing."""
        self._plane.on = axis >= 0
        if axis >= 0:
            normal = [-1.0 if number == axis else 0.0 for number in range(3)]
            self._plane.plane = coin.SbPlane(coin.SbVec3f(*normal), -place)

    def show(self, pieces: Iterator[Piece]) -> None:
        """Replaces what is shown: some pieces at once, the others turn by turn."""
        self._turns.start(self._fill(pieces))

    def clear(self) -> None:
        self.show(iter(()))

    def _fill(self, pieces: Iterator[Piece]) -> Generator[None, None, None]:
        filled = 0
        for piece in pieces:
            if filled == len(self._nodes):
                self._nodes.append(_PieceNode())
                self._nodes[-1].draw_edges(self._when)
                self._pieces.addChild(self._nodes[-1].root)
            self._nodes[filled].fill(piece)
            filled += 1
            yield
        for node in self._nodes[filled:]:
            self._pieces.removeChild(node.root)
        del self._nodes[filled:]

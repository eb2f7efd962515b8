"""A small picture of a mesh without a window: elements by layer, their edges, as PNG."""
from __future__ import annotations

import struct
import zlib
from typing import Any, List, Tuple

import numpy as np

from advlayers.formats.mesh_parts import MeshParts

WIDTH, HEIGHT = 480, 360  # pixels
_FROM = np.array([-0.5, -0.75, 0.45])  # where the viewer stands, seen from the middle
_CORE, _FIRST, _LAST = (np.array(colour, float) for colour in (
    (236, 226, 196), (22, 78, 140), (196, 220, 240)))
_EDGE = np.array([40.0, 48.0, 60.0])
_STEPS_PER_PIXEL = 1.6  # of the samples of an element
_BATCH = 4_000_000  # samples at a time


def write(path: str, parts: MeshParts) -> None:
    with open(path, "wb") as file:
        file.write(png(draw(parts)))


def draw(parts: MeshParts) -> Any:
    """(HEIGHT, WIDTH, 3) bytes; what is nearer to the viewer hides what is behind."""
    corners, layers = _elements(parts)
    right, up, towards = _directions(corners)
    seen = np.stack([corners @ right, corners @ up], axis=-1)
    low, high = seen.min(axis=(0, 1)), seen.max(axis=(0, 1))
    width, height = np.maximum(high - low, 1e-300)
    scale = 0.94 * min(WIDTH / width, HEIGHT / height)
    seen = (seen - (low + high) / 2) * scale * [1, -1] + [WIDTH / 2, HEIGHT / 2]
    colours = _colours(corners, layers, towards)
    image = np.full((HEIGHT * WIDTH, 3), 255.0)
    depth = np.full(HEIGHT * WIDTH, -np.inf)
    steps = _steps(seen)
    for count in np.unique(steps):
        chosen = np.flatnonzero(steps == count)
        batch = max(1, _BATCH // count ** 2)
        for start in range(0, len(chosen), batch):
            part = chosen[start:start + batch]
            _paint(image, depth, seen[part], corners[part] @ towards, colours[part], count)
    return image.reshape(HEIGHT, WIDTH, 3).round().astype(np.uint8)


def png(image: Any) -> bytes:
    """PNG, third edition: 8 bits a channel, RGB, no filter."""
    height, width = image.shape[:2]
    lines = b"".join(b"\0" + line.tobytes() for line in image)

    def chunk(kind: bytes, data: bytes) -> bytes:
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def _elements(parts: MeshParts) -> Tuple[Any, Any]:
    """Corners (n, 4, 3), a triangle's last twice, and the layer of each element."""
    corners: List[Any] = []
    layers: List[Any] = []
    for block in parts.of(2):
        of_quad = block.kind.startswith("quad")
        corners.append(parts.nodes[block.cells[:, [0, 1, 2, 3] if of_quad else [0, 1, 2, 2]]])
        layers.append(block.layers)
    return np.concatenate(corners), np.concatenate(layers)


def _directions(corners: Any) -> Tuple[Any, Any, Any]:
    """Right, up and towards the viewer; a flat mesh is looked at squarely."""
    extent = np.ptp(corners.reshape(-1, 3), axis=0)
    flat = int(np.argmin(extent))
    if extent[flat] < 1e-6 * extent.max():
        towards = np.eye(3)[flat]
    else:
        towards = _FROM / np.linalg.norm(_FROM)
    upright = np.array([0.0, 1.0, 0.0]) if abs(towards[2]) > 0.9 else np.array([0.0, 0.0, 1.0])
    right = np.cross(upright, towards)
    right /= np.linalg.norm(right)
    return right, np.cross(towards, right), towards


def _colours(corners: Any, layers: Any, towards: Any) -> Any:
    share = (np.maximum(layers, 1) - 1) / max(int(layers.max()) - 1, 1)
    colours = _FIRST + share[:, None] * (_LAST - _FIRST)
    colours[layers == 0] = _CORE
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    lengths = np.linalg.norm(normals, axis=1)
    facing = np.abs(normals @ towards) / np.where(lengths > 0, lengths, 1)
    return colours * (0.55 + 0.45 * facing)[:, None]


def _steps(seen: Any) -> Any:
    """Samples along a side of each element, in powers of two."""
    sides = np.linalg.norm(np.roll(seen, -1, axis=1) - seen, axis=2).max(axis=1)
    wanted = np.clip(_STEPS_PER_PIXEL * sides, 2, 2048)
    return (2 ** np.ceil(np.log2(wanted))).astype(int)


def _paint(image: Any, depth: Any, seen: Any, heights: Any, colours: Any, count: int) -> None:
    along = (np.arange(count) + 0.5) / count
    u, v = (axis.ravel() for axis in np.meshgrid(along, along))
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v])
    points = np.einsum("ks,nkd->nsd", weights, seen)
    near = np.einsum("ks,nk->ns", weights, heights)
    x, y = points[..., 0].astype(int), points[..., 1].astype(int)
    inside = (x >= 0) & (x < WIDTH) & (y >= 0) & (y < HEIGHT)
    pixel = (y * WIDTH + x)[inside]
    near = near[inside]
    element = np.broadcast_to(np.arange(len(seen))[:, None], inside.shape)[inside]
    rim = np.broadcast_to(_on_rim(u, v, count), inside.shape)[inside]
    # The last of equal pixels stays: so the nearest comes last.
    order = np.argsort(near, kind="stable")
    order = order[near[order] > depth[pixel[order]]]
    where = pixel[order]
    depth[where] = near[order]
    shades = colours[element[order]]
    image[where] = np.where(rim[order][:, None], 0.55 * shades + 0.45 * _EDGE, shades)


def _on_rim(u: Any, v: Any, count: int) -> Any:
    """Samples within a pixel of a side; an element of a few pixels has no inside to show."""
    if count <= 4:
        return np.zeros(len(u), bool)
    reach = _STEPS_PER_PIXEL / (2 * count)
    return (np.minimum(u, v) < reach) | (np.maximum(u, v) > 1 - reach)

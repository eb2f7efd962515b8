"""A mesh and its report, and the values that its elements are judged and coloured by."""
from __future__ import annotations

import json
from dataclasses import dataclass, replace
from typing import Any, Callable, Dict, Generator, List, Mapping, Tuple

import numpy as np

from advlayers import element_mesh
from advlayers.element_mesh import ElementMesh, finish
from advlayers.layer_heights import height_errors
from advlayers.report import make_report

LAYERS, QUALITY, ASPECT, HEIGHT, DIAGNOSTICS = FIELDS = (
    "Layers", "Quality", "Aspect Ratio", "Height Error", "Diagnostics")
# Below this an element is pointed out; a corner has some 25 or 155 degrees then.
POOR_QUALITY = 0.3


# Of the longest side of an element, to see it among its neighbours.
_SIDES_SHOWN = 12.0


@dataclass(frozen=True)
class Place:
    """Where to look: a point, from where, and how much of the surroundings [mm]."""

    point: Any
    normal: Any
    width: float


class MeshData:
    def __init__(self, mesh: ElementMesh, relative_height_errors,
                 report: Mapping[str, Any]) -> None:
        self.mesh = mesh
        self.report = report
        self.relative_height_errors = relative_height_errors
        self._fields: Dict[str, Any] = {}

    def field(self, name: str):
        """(elements,) NaN where the field says nothing: the core has neither layer nor height.

        Layer; quality from 0 to 1; longest over shortest side; height error [%]; quality where it
        is poor."""
        if name not in self._fields:
            self._fields[name] = _MAKERS[name](self)
        return self._fields[name]

    def prepare(self, check: Callable[[], None]) -> None:
        """Works the quality out, which takes a while; `check` is called on the way and may raise.
        """
        self._fields[QUALITY] = element_mesh.quality(self.mesh, check)

    def height_errors(self):
        errors = np.array(self.relative_height_errors, float)
        if len(errors) != self.mesh.count:  # a mesh made before they were kept
            errors = np.full(self.mesh.count, np.nan)
        return 100.0 * errors

    def layers(self):
        return np.where(self.mesh.layers > 0, self.mesh.layers, np.nan)

    def poor(self):
        quality = self.field(QUALITY)
        return np.where(quality < POOR_QUALITY, quality, np.nan)

    def place_of(self, element: int) -> Place:
        points = self.mesh.nodes[self.mesh.corners(element)]
        sides = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
        normal = np.cross(points[2] - points[0], points[-1] - points[1])
        return Place(points.mean(axis=0), normal, _SIDES_SHOWN * float(sides.max()))

    def place_near(self, point) -> Place:
        """The element whose middle is nearest, seen from above, centred at the point."""
        distances = np.linalg.norm(element_mesh.centres(self.mesh) - np.asarray(point), axis=1)
        place = self.place_of(int(np.argmin(distances)))
        return Place(np.asarray(point, float), place.normal, place.width)

    def worst(self, within=None) -> int:
        """The element of the least quality, of all or of those where `within` is true; -1: there
        is none."""
        quality = self.field(QUALITY)
        if within is not None:
            quality = np.where(within, quality, np.inf)
        return int(np.argmin(quality)) if np.isfinite(quality).any() else -1

    def worst_height(self, edge: int, face: int) -> int:
        """The element of the first layer beside the edge on the face whose height is most off; -1:
        there is none."""
        mesh = self.mesh
        on_edge = np.zeros(len(mesh.nodes), bool)
        on_edge[np.asarray(mesh.edge_nodes.get(edge, ()), np.int64).ravel()] = True
        beside = np.concatenate([on_edge[mesh.quads].any(axis=1),
                                 on_edge[mesh.triangles].any(axis=1)])
        errors = np.abs(self.field(HEIGHT))
        errors = np.where(beside & (mesh.layers == 1) & (mesh.faces == face), errors, np.nan)
        return int(np.nanargmax(errors)) if np.isfinite(errors).any() else -1

    def diagnostic_points(self) -> Dict[str, List[Tuple[float, float, float]]]:
        """Where the report points at, by severity."""
        found: Dict[str, List[Tuple[float, float, float]]] = {}
        for entry in self.report.get("diagnostics", ()):
            if entry["point"] and any(entry["point"]):
                found.setdefault(entry["severity"], []).append(tuple(entry["point"]))
        return found


_MAKERS = {
    LAYERS: MeshData.layers,
    QUALITY: lambda data: element_mesh.quality(data.mesh),
    ASPECT: lambda data: element_mesh.aspect_ratio(data.mesh),
    HEIGHT: MeshData.height_errors,
    DIAGNOSTICS: MeshData.poor,
}


def of_core(label: str, mesh) -> MeshData:
    """Of a finished mesh; the report has the label."""
    return MeshData(element_mesh.of_core(mesh), height_errors(mesh),
                    make_report(label, mesh, [], mesh.seconds))


def remember(mesh_object, data: MeshData) -> None:
    """Keeps what the object's mesh was made from with the object: to read 100 000 elements out of
    a FemMesh takes half a second."""
    mesh_object.Proxy.latest = (mesh_object.MeshId, data)


def of_object(mesh_object) -> MeshData:
    """What a mesh object in a document holds."""
    return finish(reading(mesh_object))


def reading(mesh_object) -> Generator[None, None, MeshData]:
    """The same in steps of some 20 ms, for a window."""
    name, data = getattr(mesh_object.Proxy, "latest", ("", None))
    if data is not None and (name, data.mesh.count) == (
            mesh_object.MeshId, mesh_object.FemMesh.FaceCount):
        return data
    mesh = yield from element_mesh.reading(mesh_object)
    mesh = replace(mesh, nodes=_unmoved(mesh.nodes, mesh_object.FemMesh.Placement))
    report = json.loads(mesh_object.Details) if mesh_object.Details else {}
    data = MeshData(mesh, mesh_object.HeightErrors, report)
    remember(mesh_object, data)
    return data


def _unmoved(nodes, placement):
    """As the core made them, and as a view provider shows what its object's placement moves."""
    if placement.isIdentity():
        return nodes
    back = np.array(placement.inverse().toMatrix().A).reshape(4, 4)
    return nodes @ back[:3, :3].T + back[:3, 3]

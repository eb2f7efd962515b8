"""Writes docs/first-try.md and its pictures: what comes out where nothing but the shape is given,
layers ending where they are as high as wide, as a new mesh of the window has it.

    python3 docs/make_first_try.py [SHAPE ...]

Beside each mesh stands gmsh's of the same shape, with its own defaults, where python3-gmsh is
installed. Needs python3-matplotlib and FreeCAD's Part. Named shapes alone are drawn anew; figures
of the others stay as they are in first-try/figures.json.
"""
from __future__ import annotations

import json
import math
import os
import sys
import tempfile
import time
from typing import Any, Callable, Dict, List, Optional, Tuple

DOCS = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(DOCS)
for part in ("App", os.path.join("mesher_core", "python"), os.path.join("tests", "measuring")):
    sys.path.insert(0, os.path.join(ROOT, part))

import advlayers_core as core  # noqa: E402
import matplotlib  # noqa: E402
import numpy as np  # noqa: E402
from advlayers.meshing import core_settings  # noqa: E402
from advlayers.settings_check import check_all  # noqa: E402
from advlayers.settings_table import MESH_SETTINGS  # noqa: E402
from freecad_part import FreeCAD, Part  # noqa: E402

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

FOLDER = os.path.join(DOCS, "first-try")
FIGURES = os.path.join(FOLDER, "figures.json")
V = FreeCAD.Vector
LIGHT = np.array([0.3, -0.5, 0.8]) / math.sqrt(0.98)


def naca(thickness: float, chord: float, z: float = 0.0, scale: float = 1.0, turn: float = 0.0):
    """A wire of two splines with a sharp end."""
    xs = [(1 - math.cos(math.pi * i / 30)) / 2 for i in range(31)]
    ys = [5 * thickness * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x ** 2 + 0.2843 * x ** 3
                           - 0.1036 * x ** 4) for x in xs]
    c, s = math.cos(turn), math.sin(turn)
    edges = []
    for side in (1, -1):
        places = [(chord * scale * (x - 0.25), side * chord * scale * y) for x, y in zip(xs, ys)]
        curve = Part.BSplineCurve()
        curve.interpolate([V(c * x - s * y, s * x + c * y, z) for x, y in places])
        edges.append(curve.toShape())
    return Part.Wire([edges[0], edges[1].reversed()])


def airfoil_domain():
    airfoil = Part.Face(naca(0.12, 100.0))
    return Part.makePlane(4000, 4000, V(-2000, -2000, 0)).cut(airfoil).Faces[0]


def holes_plate():
    plate = Part.makeBox(200, 200, 5)
    for i in range(10):
        for j in range(10):
            plate = plate.cut(Part.makeCylinder(4, 5, V(10 + 20 * i, 10 + 20 * j, 0)))
    return plate


def gear(teeth: int = 16):
    points = []
    for k in range(teeth):
        for place, radius in ((0.0, 40.0), (0.35, 50.0), (0.55, 50.0), (0.9, 40.0)):
            angle = 2 * math.pi * (k + place) / teeth
            points.append(V(radius * math.cos(angle), radius * math.sin(angle), 0))
    wheel = Part.Face(Part.makePolygon(points + points[:1])).extrude(V(0, 0, 15))
    return wheel.cut(Part.makeCylinder(12, 15))


def tunnel():
    outline = [(0, 3), (2, 8), (10, 9), (15, 15), (28, 15), (34, 10), (40, 9), (40, 3)]
    body = Part.Face(Part.makePolygon([V(x, -8, z) for x, z in outline + outline[:1]]))
    car = body.extrude(V(0, 16, 0))
    return Part.makeBox(300, 160, 100, V(-100, -80, 0)).cut(car)


def filleted_box():
    box = Part.makeBox(60, 40, 30)
    return box.makeFillet(5, box.Edges)


def bracket():
    solid = Part.makeBox(80, 50, 8).fuse(Part.makeBox(8, 50, 60)).removeSplitter()
    inner = [edge for edge in solid.Edges if abs(edge.CenterOfMass.x - 8) < 1e-6
             and abs(edge.CenterOfMass.z - 8) < 1e-6]
    solid = solid.makeFillet(6, inner)
    for y in (15, 35):
        solid = solid.cut(Part.makeCylinder(4, 20, V(55, y, -5)))
    return solid.cut(Part.makeCylinder(6, 20, V(-5, 25, 40), V(1, 0, 0)))


def tee():
    across = Part.makeCylinder(20, 160, V(-80, 0, 0), V(1, 0, 0))
    return across.fuse(Part.makeCylinder(14, 70)).removeSplitter()


def impeller():
    hub = Part.makeCone(30, 12, 40)
    blades = []
    for k in range(6):
        blade = Part.makeBox(45, 2, 30, V(5, -1, 2))
        blade.rotate(V(0, 0, 0), V(0, 0, 1), 60 * k)
        blades.append(blade)
    return hub.fuse(blades).removeSplitter()


def blade():
    sections = [naca(0.10, 60.0, z, 1.0 - z / 300.0, math.radians(z / 4.0)) for z in (0, 50, 100)]
    return Part.makeLoft(sections, True)


SHAPES: Dict[str, Tuple[Callable[[], Any], str, Tuple[float, float]]] = {
    "airfoil": (airfoil_domain, "Airfoil in a domain of 40 chords", (90, 0)),
    "wing": (lambda: Part.makeLoft([naca(0.18, 100.0), naca(0.18, 100.0, 150.0)], True),
             "NACA 0018 wing", (25, -60)),
    "blade": (blade, "Twisted blade", (25, -60)),
    "plate": (holes_plate, "Plate with 100 holes", (60, -60)),
    "bracket": (bracket, "Bracket with a fillet and bolt holes", (25, -55)),
    "rounded-box": (filleted_box, "Rounded box", (25, -60)),
    "tee": (tee, "Pipe tee", (35, -65)),
    "gear": (gear, "Gear", (50, -60)),
    "tunnel": (tunnel, "Car in a tunnel", (25, -60)),
    "impeller": (impeller, "Impeller", (40, -60)),
    "cylinder": (lambda: Part.makeCylinder(20, 60), "Cylinder", (25, -60)),
    "cone": (lambda: Part.makeCone(25, 8, 50), "Cone", (25, -60)),
    "sphere": (lambda: Part.makeSphere(30), "Sphere", (25, -60)),
    "torus": (lambda: Part.makeTorus(40, 12), "Torus", (40, -60)),
    "sheet": (lambda: Part.makePlane(200, 100).cut(Part.makeCylinder(10, 2, V(60, 50, -1))),
              "Sheet with a hole", (90, 0)),
    "wedge": (lambda: Part.makeWedge(0, 0, 0, 20, 10, 60, 30, 40, 40, 50), "Wedge", (25, -60)),
}


def first_try(shape):
    model = core.read_brep(shape.exportBrepToString())
    settings = check_all({"layers": "isotropic"}, MESH_SETTINGS)
    start = time.process_time()
    mesher = core.Mesher(model, core_settings(core, settings, model.diagonal))
    for _report in mesher:
        pass
    return model, mesher.result(), time.process_time() - start


def gmsh_mesh(shape) -> Optional[Tuple[Any, Any]]:
    """Points and triangles."""
    try:
        import gmsh
    except ImportError:
        return None
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "shape.brep")
        shape.exportBrep(path)
        gmsh.initialize()
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            gmsh.merge(path)
            gmsh.model.mesh.generate(2)
            tags, points, _parameters = gmsh.model.mesh.getNodes()
            place = np.zeros(int(tags.max()) + 1, int)
            place[tags.astype(int)] = np.arange(len(tags))
            kinds, _elements, nodes = gmsh.model.mesh.getElements(2)
            cells = np.concatenate([part.reshape(-1, 3) for kind, part in zip(kinds, nodes)
                                    if kind == 2])
            return points.reshape(-1, 3), place[cells.astype(int)]
        finally:
            gmsh.finalize()


def turn_per_edge(mesh) -> float:
    """The largest angle [deg] between two mesh edges that follow each other on a smooth CAD edge;
    a turn of more than 60 degrees is a corner."""
    most = 0.0
    for segments in mesh.edge_segments.values():
        segments = np.asarray(segments)
        on = mesh.nodes[segments[:, 1]] - mesh.nodes[segments[:, 0]]
        on /= np.linalg.norm(on, axis=1)[:, None]
        turns = np.degrees(np.arccos(np.clip((on[1:] * on[:-1]).sum(axis=1), -1, 1)))
        most = max([most, *turns[turns < 60.0].tolist()])
    return most


def figures(mesh, seconds: float, peer) -> Dict[str, Any]:
    found = {key: mesh.figures[key] for key in (
        "quads", "triangles", "quad_percent", "angles_45_135_percent", "min_angle", "max_angle",
        "inverted")}
    found["turn"] = turn_per_edge(mesh)
    found["seconds"] = seconds
    found["gmsh"] = 0 if peer is None else len(peer[1])
    return found


def polygons(nodes, cells, colours, view) -> Tuple[List[Any], List[Any]]:
    """Seen along `view`: those that face the eye, the farthest first."""
    elevation, azimuth = np.radians(view)
    right = np.array([-math.sin(azimuth), math.cos(azimuth), 0.0])
    ahead = np.array([math.cos(azimuth) * math.cos(elevation),
                      math.sin(azimuth) * math.cos(elevation), math.sin(elevation)])
    if view[0] == 90:
        right, ahead = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
    up = np.cross(ahead, right)
    shown, shades, depth = [], [], []
    for group, colour in zip(cells, colours):
        corners = nodes[group]
        normal = np.cross(corners[:, 2] - corners[:, 0],
                          corners[:, -1] - corners[:, 1])
        normal /= np.linalg.norm(normal, axis=1)[:, None] + 1e-300
        front = normal @ ahead > 0.0
        if view[0] == 90:
            front[:] = True
        flat = np.stack([corners @ right, corners @ up], axis=2)[front]
        shade = 0.75 + 0.25 * np.abs(normal[front] @ LIGHT)
        shown += list(flat)
        shades += list(np.asarray(colour)[front] * shade[:, None])
        depth += list((corners.mean(axis=1) @ ahead)[front])
    order = np.argsort(depth)
    return [shown[i] for i in order], [np.clip(shades[i], 0, 1) for i in order]


def colours_of(layers) -> Any:
    """Layers in blue, darkest at the walls; the core grey."""
    most = max(int(layers.max(initial=0)), 1)
    share = np.clip((layers - 1) / max(most - 1, 1), 0, 1)[:, None]
    blue = np.array([0.16, 0.38, 0.63]) * (1 - share) + np.array([0.80, 0.89, 0.95]) * share
    return np.where(layers[:, None] > 0, blue, np.array([0.93, 0.93, 0.90]))


def draw(path: str, mesh, peer, view, zoom: Optional[float]) -> None:
    columns = 2 if zoom is None else 3
    figure, axes = pyplot.subplots(1, columns, figsize=(4.2 * columns, 3.4), dpi=95)
    ours = polygons(mesh.nodes, (mesh.quads, mesh.triangles),
                    (colours_of(mesh.layer_of_quad), colours_of(mesh.layer_of_triangle)), view)
    pictures = [(axes[0], ours, None)]
    if zoom is not None:
        pictures.append((axes[1], ours, zoom))
    if peer is not None:
        grey = np.full((len(peer[1]), 3), 0.93)
        pictures.append((axes[-1], polygons(peer[0], (peer[1],), (grey,), view), zoom))
    for axis, (shown, shades), near in pictures:
        axis.add_collection(PolyCollection(shown, facecolors=shades, edgecolors="#1a1f26",
                                           linewidths=0.25))
        axis.autoscale_view()
        axis.set_aspect("equal")
        if near is not None:
            axis.set_xlim(-near, near)
            axis.set_ylim(-0.8 * near, 0.8 * near)
    for axis in axes:
        axis.set_axis_off()
    figure.subplots_adjust(0, 0, 1, 1, 0.02, 0)
    figure.savefig(path)
    pyplot.close(figure)


ZOOMS = {"airfoil": 90.0}  # half the width of a second look [mm]


def page(found: Dict[str, Dict[str, Any]], words: Dict[str, str]) -> str:
    lines = [
        "# First tries", "",
        "*Written by `docs/make_first_try.py`.* No setting is given but the shape; layers end "
        "where they are as high as wide, as a new mesh of the window has it. Left ours, right "
        "gmsh's with its own defaults. *Turn*: the largest angle between two mesh edges along a "
        "smooth CAD edge, in degrees.", "",
        "| shape | elements | quads % | 45–135° % | angles | turn | seconds | gmsh's triangles |",
        "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    for name, row in found.items():
        lines.append(
            f"| [{SHAPES[name][1]}](#{name}) | {row['quads'] + row['triangles']} | "
            f"{row['quad_percent']:.1f} | {row['angles_45_135_percent']:.1f} | "
            f"{row['min_angle']:.0f}–{row['max_angle']:.0f} | {row['turn']:.1f} | "
            f"{row['seconds']:.1f} | {row['gmsh']} |")
    for name in found:
        lines += ["", f"<a id=\"{name}\"></a>", f"**{SHAPES[name][1]}.** {words.get(name, '')}", "",
                  f"![{SHAPES[name][1]}](first-try/{name}.png)"]
    return "\n".join(lines) + "\n"


def main() -> None:
    os.makedirs(FOLDER, exist_ok=True)
    found: Dict[str, Dict[str, Any]] = {}
    if os.path.exists(FIGURES):
        with open(FIGURES, encoding="utf-8") as file:
            found = json.load(file)
    for name in sys.argv[1:] or SHAPES:
        make, _title, view = SHAPES[name]
        shape = make()
        _model, mesh, seconds = first_try(shape)
        peer = gmsh_mesh(shape)
        words = found.get(name, {}).get("words", "")
        found[name] = {**figures(mesh, seconds, peer), "words": words}
        draw(os.path.join(FOLDER, name + ".png"), mesh, peer, view, ZOOMS.get(name))
        print(name, found[name], flush=True)
    found = {name: found[name] for name in SHAPES if name in found}
    with open(FIGURES, "w", encoding="utf-8") as file:
        json.dump(found, file, indent=1)
        file.write("\n")
    words = {name: row.get("words", "") for name, row in found.items()}
    with open(os.path.join(DOCS, "first-try.md"), "w", encoding="utf-8") as file:
        file.write(page(found, words))


if __name__ == "__main__":
    main()

"""Advancing Layers: everything between a CAD shape and a finished mesh that needs no window.

Importing the package is cheap: FreeCAD and the mesher's core are loaded at first use.
"""
from __future__ import annotations

import contextlib
import functools

__version__ = "0.1.0"

_done_already = False


def _action(function):
    """Something that changes a document; see done_already()."""
    @functools.wraps(function)
    def act(*arguments, **keywords):
        return None if _done_already else function(*arguments, **keywords)

    return act


@contextlib.contextmanager
def done_already():
    """Inside the block this package's functions do nothing: so a window can have the macro recorder
    see what was done in a panel, as a line that runs but changes nothing more."""
    global _done_already
    _done_already = True
    try:
        yield
    finally:
        _done_already = False


@_action
def make_layer_mesh(source, mesh_now: bool = True, **settings):
    """Meshes a document object and returns the new Fem::FemMeshObjectPython.

    The settings are those of the reference page: `make_layer_mesh(doc.Body, faces=["Face1"],
    first_height="7 mm")`. Lengths may be numbers [mm], texts with a unit, or quantities. Where
    walls and sizes are to be added first, `mesh_now=False` leaves the meshing to update().
    Raises InputError for a setting or a source that cannot be used.
    """
    from advlayers import layer_mesh

    mesh_object = layer_mesh.create(source, **settings)
    if mesh_now:
        layer_mesh.update(mesh_object)
    return mesh_object


@_action
def make_wall(mesh_object, references, condition: str = "Wall", label: str = "", **values):
    """Adds a wall to a layer mesh: `make_wall(mesh, ["Edge1", "Edge2"], first_height="0.1 mm")`.

    References are names on the meshed object, or pairs of an object and names. With faces too,
    layers grow on their side only; faces alone stand for all their boundary edges. Condition:
    "Wall", or "Match" or "Off" for edges that layers run along or that have none, or "Boundary" or
    "Smooth" for edges that part their faces, or do not, whatever feature_angle says. The values
    are those of one wall on the reference page. Raises InputError.
    """
    from advlayers import controls

    return controls.make(controls.Wall, mesh_object, references, label, condition, values)


@_action
def make_size(mesh_object, references, label: str = "", **values):
    """Adds a local size to a layer mesh: `make_size(mesh, ["Face2"], size="2 mm")`.

    The values are those of one size on the reference page. Raises InputError.
    """
    from advlayers import controls

    return controls.make(controls.Size, mesh_object, references, label, values=values)


@_action
def make_group(mesh_object, name: str, references):
    """Adds a named group of faces and edges to a layer mesh, for boundary conditions.

    Raises InputError.
    """
    from advlayers import controls

    return controls.make_group(mesh_object, name, references)


@_action
def apply_preset(mesh_object, preset: str) -> None:
    """Gives a layer mesh the settings and walls of a preset: "cfd", "fem" or "washers", in place of
    the walls that it has. Raises InputError."""
    from advlayers import layer_mesh

    layer_mesh.apply_preset(mesh_object, preset)


@_action
def remove(control) -> None:
    """Takes a wall, a size or a group off its layer mesh, and out of the document."""
    control.Document.removeObject(control.Name)


def y_plus(**flow):
    """What a wall distance y+ asks for: `advlayers.y_plus(speed=50, length=1000).first_height`.

    The values are those of a block y_plus on the reference page; the answer has first_height and
    boundary_layer [mm], reynolds, and layers(growth) that reach through the boundary layer.
    Raises InputError.
    """
    from advlayers.settings_check import check_all
    from advlayers.settings_table import Y_PLUS_SETTINGS
    from advlayers.flow_height import estimate

    return estimate(check_all(flow, Y_PLUS_SETTINGS))


@_action
def update(mesh_object) -> None:
    """Meshes a layer mesh with its settings as they stand. Raises InputError, or what the core
    raises; the old mesh stays then."""
    from advlayers import layer_mesh

    layer_mesh.update(mesh_object)

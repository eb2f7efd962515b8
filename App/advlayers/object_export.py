"""Writes the mesh of a document object with the same writers as a batch job."""
from __future__ import annotations

import errno

from advlayers import cad_input, export, quad_centres, stored_mesh
from advlayers.errors import InputError
from advlayers.formats import mesh_parts
from advlayers.outputs import Outputs
from advlayers.sentence import Sentence
from advlayers.settings_check import check_all
from advlayers.settings_table import EXPORT_SETTINGS


def export_mesh(mesh_object, path: str, **options) -> None:
    """The ending says the format, and options are what a job may say of files: `scale=0.001`.
    Raises InputError for a format that cannot be written or cannot carry the mesh, an object that
    has no mesh, or a file that cannot be written; nothing half-written remains."""
    export.check_format("file", path, freecad=True)
    checked = check_all(options, EXPORT_SETTINGS)
    mesh = stored_mesh.read(mesh_object)
    order = 2 if len(mesh.mid_nodes) else 1
    nine = checked["quad_nodes"] == 9
    if nine and order == 1:
        raise InputError("quad_nodes", "goes with order 2 only, got 9")
    export.check_carries("file", path, export.Asked(
        mesh.named, order, quad_nodes=checked["quad_nodes"]))
    parts = mesh_parts.of_mesh(mesh, mesh.named, mesh_object.LayerGroups)
    if nine:
        parts = quad_centres.added(parts, cad_input.model_of(mesh_object).project)
    product = export.Product(parts.scaled(checked["scale"]), checked, mesh_object.Document)
    try:
        with Outputs() as outputs:
            outputs.write(path, lambda temporary: export.FORMATS[export.format_of(path)].write(
                temporary, product))
            outputs.publish()
    except OSError as error:
        raise InputError("", "{} cannot be written: {}", path, _reason(error)) from error


def _reason(error: OSError):
    """As far as we have words for it; else what the system says."""
    return {
        errno.ENOENT: Sentence("the folder does not exist"),
        errno.EACCES: Sentence("it is not allowed to write there"),
        errno.EROFS: Sentence("it is not allowed to write there"),
        errno.ENOSPC: Sentence("the disk is full"),
        errno.EIO: Sentence("nothing arrived there: the disk may be full"),
    }.get(error.errno, error.strerror or str(error))

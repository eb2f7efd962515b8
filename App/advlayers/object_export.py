"""Writes the mesh of a document object with the same writers as a batch job."""
from __future__ import annotations

import errno
import os

from advlayers import cad_input, export, stored_mesh
from advlayers.errors import InputError
from advlayers.extrusion import of_settings
from advlayers.file_mesh import Form
from advlayers.formats import mesh_parts, polymesh
from advlayers.layer_mesh import window_watch
from advlayers.outputs import Outputs
from advlayers.sentence import Sentence
from advlayers.settings_check import check_all
from advlayers.settings_table import EXPORT_SETTINGS, JOB_SETTINGS, setting


_FORMS = tuple(setting(key, JOB_SETTINGS) for key in ("extrude", "volume"))


def export_mesh(mesh_object, path: str, **options) -> None:
    """The ending says the format; `options` are what a job may say of files, `scale=0.001`, and of
    what becomes of the mesh in them: `extrude={"thickness": 2}` or `volume={}`.

    Raises InputError for a format that cannot be written or cannot carry the mesh, an object that
    has no mesh, or a file that cannot be written; nothing half-written remains.
    """
    export.check_format("file", path, freecad=True)
    checked = check_all(options, EXPORT_SETTINGS + _FORMS)
    form = Form(checked["extrude"] and of_settings(checked["extrude"]), checked["volume"],
                checked["quad_nodes"])
    mesh = stored_mesh.read(mesh_object)
    order = 2 if len(mesh.mid_nodes) else 1
    form.check(order)
    export.check_carries("file", path, form.asked(mesh.named, order))
    parts = form.made(
        mesh_parts.of_mesh(mesh, mesh.named, mesh_object.LayerGroups),
        cad_input.model_of(mesh_object) if form.needs_model else None, mesh_object.Label,
        mesh_object.Size.Value, lambda: window_watch.get()([])).parts
    export.check_kinds("file", path, parts)
    product = export.Product(parts.scaled(checked["scale"]), checked, mesh_object.Document)
    try:
        with Outputs() as outputs:
            if export.format_of(path) == polymesh.NAME.lower():
                outputs.make_folder(os.path.dirname(path) or ".")
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

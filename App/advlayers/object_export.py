"""Writes the mesh of a document object with the same writers as a batch job."""
from __future__ import annotations

import errno

from advlayers import export, stored_mesh
from advlayers.errors import InputError
from advlayers.sentence import Sentence


def export_mesh(mesh_object, path: str) -> None:
    """The ending says the format. Raises InputError for a format that cannot be written, an object
    that has no mesh, or a file that cannot be written; nothing half-written remains."""
    export.check_format("file", path, freecad=True)
    mesh = stored_mesh.read(mesh_object)
    product = export.Product(mesh, mesh.groups, mesh_object.Document, mesh_object.FemMesh)
    try:
        with export.Outputs() as outputs:
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

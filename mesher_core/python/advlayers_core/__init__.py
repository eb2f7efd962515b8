"""Layered quad-dominant surface meshes on CAD faces.

    model = read_brep(text)                    # or read_file("wing.step")
    mesher = Mesher(model, Settings(size=30, first_height=7, growth=1.1))
    for report in mesher:                      # one per layer and patch
        print(report)
    mesh = mesher.result()                     # mesh.nodes, mesh.quads, mesh.triangles, ...

Lengths are in mm, angles in degrees.
"""
import os as _os
import sys as _sys

_before = _sys.getdlopenflags() if hasattr(_os, "RTLD_DEEPBIND") else None
if _before is not None and _os.path.isdir(_os.path.join(_os.path.dirname(__file__), "libs")):
    # A wheel's own libraries come before those that the program itself is linked with.
    _sys.setdlopenflags(_before | _os.RTLD_DEEPBIND)
try:
    from ._core import (Cancelled, ChildFailed, GeometryError, InternalError, InvalidInput,
                        LayerReport, Mesh, Mesher, Model, RunContext, Settings, __version__,
                        answer_of_child, answer_parent, brep_of_file, estimate, kernel_version,
                        number_rows, read_brep, read_file, resolve_wall, schema)
except ModuleNotFoundError as error:
    if error.name != __name__ + "._core":
        raise
    raise ImportError(
        "the meshing core is not built for this Python ({}.{}); build it with `./dev install` in "
        "the add-on's folder".format(*_sys.version_info[:2])) from error
finally:
    if _before is not None:
        _sys.setdlopenflags(_before)

__all__ = ["Cancelled", "ChildFailed", "GeometryError", "InternalError", "InvalidInput",
           "LayerReport", "Mesh", "Mesher", "Model", "RunContext", "Settings", "__version__",
           "answer_of_child", "answer_parent", "brep_of_file", "estimate", "kernel_version",
           "number_rows", "read_brep", "read_file", "resolve_wall", "schema"]

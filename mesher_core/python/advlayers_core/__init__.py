"""Layered quad-dominant surface meshes on CAD faces.

    model = read_brep(text)                    # or read_file("wing.step")
    mesher = Mesher(model, Settings(size=30, first_height=7, growth=1.1))
    for report in mesher:                      # one per layer and patch
        print(report)
    mesh = mesher.result()                     # mesh.nodes, mesh.quads, mesh.triangles, ...

Lengths are in mm, angles in degrees.
"""
try:
    from ._core import (Cancelled, ChildFailed, GeometryError, InternalError, InvalidInput,
                        LayerReport, Mesh, Mesher, Model, RunContext, Settings,
                        answer_of_child, answer_parent, brep_of_file, estimate, number_rows,
                        read_brep, read_file, resolve_wall, schema)
except ModuleNotFoundError as error:
    if error.name != __name__ + "._core":
        raise
    import sys as _sys
    raise ImportError(
        "the meshing core is not built for this Python ({}.{}); build it with `./dev install` in "
        "the add-on's folder".format(*_sys.version_info[:2])) from error

__all__ = ["Cancelled", "ChildFailed", "GeometryError", "InternalError", "InvalidInput",
           "LayerReport", "Mesh", "Mesher", "Model", "RunContext", "Settings", "answer_of_child",
           "answer_parent", "brep_of_file", "estimate", "number_rows", "read_brep", "read_file",
           "resolve_wall", "schema"]

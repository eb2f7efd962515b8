"""Triangulated surfaces: FreeCAD's Mesh objects as shapes of planar faces."""
from __future__ import annotations

from advlayers.errors import InputError

# Every facet becomes a planar face: as patches of their own they make no sense.
FEATURE_ANGLE = 20.0  # [deg]
# Of the diagonal: points of neighbouring triangles are equal in an STL file up to its precision.
_SAME_POINT = 1e-6


def is_mesh(document_object) -> bool:
    return document_object.isDerivedFrom("Mesh::Feature")


def add_shape(mesh_object):
    """Adds the mesh object's surface to its document, as a shape in the place of it. Raises
    InputError; nothing has changed then."""
    from advlayers.language import tr

    if not mesh_object.Mesh.CountFacets:
        raise InputError("", "{} has no face to mesh", mesh_object.Label)
    try:
        shape = _shape_of(mesh_object.Mesh.copy())
    except RuntimeError as error:
        raise InputError("", "{} has no face to mesh: {}", mesh_object.Label, error) from error
    document = mesh_object.Document
    made = document.addObject("Part::Feature", f"{mesh_object.Name}Shape")
    made.Label = tr("{} shape").format(mesh_object.Label)
    made.Shape = shape
    mesh_object.Visibility = False
    return made


def _shape_of(mesh):
    import Part

    if mesh.CountFacets == 0:
        raise RuntimeError("no triangle in it")
    mesh.removeDuplicatedPoints()
    mesh.removeDuplicatedFacets()
    mesh.fixDegenerations(0.0)
    shape = Part.Shape()
    shape.makeShapeFromMesh(mesh.Topology, _SAME_POINT * max(mesh.BoundBox.DiagonalLength, 1e-3))
    return shape

"""What differs between the versions of FreeCAD, 0.20 to 1.1, in one place."""
from __future__ import annotations


class Stateless:
    """The Python object behind a FreeCAD object: saves nothing, as all data lies in properties.

    FreeCAD 0.20 calls the second pair, later versions the first.
    """

    def dumps(self):
        return None

    def loads(self, _state) -> None:
        return None

    def __getstate__(self):
        return None

    def __setstate__(self, _state) -> None:
        return None


def global_placement(document_object):
    """Where it stands in the document; None where it has no place. Links have had it since 0.20,
    some objects of other add-ons have it not."""
    if hasattr(document_object, "getGlobalPlacement"):
        return document_object.getGlobalPlacement()
    return None


def gmsh_source(gmsh_mesh):
    """What a mesh made with Gmsh is of: 0.20 calls it Part, later versions Shape."""
    return getattr(gmsh_mesh, "Part", None) or getattr(gmsh_mesh, "Shape", None)


def as_number(flags):
    """Buttons of a task panel: numbers before Qt 6, flags with it."""
    try:
        return int(flags)
    except TypeError:
        return flags

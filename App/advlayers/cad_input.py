"""CAD files and FreeCAD objects to the core's model.

A file is read in a child process: one that crashes its reader, or keeps it busy without end, is an
error of that file alone. What comes out of it, here as in the core, is BREP text.
"""
from __future__ import annotations

import os
import re
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Mapping, Optional, Tuple

from advlayers import child, document_file, document_values
from advlayers.core_access import load_core
from advlayers.errors import InputError
from advlayers.freecad_versions import global_placement

_FILES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".stl")  # the core reads them
_DOCUMENT = ".fcstd"


@dataclass
class Cad:
    model: Any  # advlayers_core's Model
    text: str  # the shape as BREP
    label: str = ""  # of the object in an FCStd file
    note: str = ""  # how the object was chosen, where there was a choice

    def shape(self):
        """The Part.Shape; its faces and edges have the model's numbers."""
        import Part

        shape = Part.Shape()
        shape.importBrepFromString(self.text)
        return shape


def check_readable(path: str, freecad: bool) -> None:
    """Raises InputError for an unknown ending, a missing file, or one that FreeCAD must read."""
    ending = os.path.splitext(path)[1].lower()
    if ending not in _FILES + (_DOCUMENT,):
        known = " ".join(_FILES + (_DOCUMENT,))
        raise InputError("input", "has the unknown format {} ({}): {}", repr(ending), known, path)
    if not os.path.exists(path):
        raise InputError("input", "does not exist: {}", path)
    if not os.path.isfile(path):
        raise InputError("input", "is no file: {}", path)
    if not os.access(path, os.R_OK):
        raise InputError("input", "cannot be read: {}", path)
    if ending == _DOCUMENT and not freecad:
        raise InputError("input", "needs FreeCAD to be read: run the job with freecadcmd: {}", path)


def read(core, path: str, wanted: Optional[str], sew_tolerance: float = 0.0,
         context: Any = None, parameters: Mapping[str, Any] = MappingProxyType({})) -> Cad:
    """Reads the file, gives a document the parameters, and sews what it holds where the tolerance
    [mm] is not 0. Raises InputError naming it."""
    ending = os.path.splitext(path)[1].lower()
    if wanted is not None and ending != _DOCUMENT:
        raise InputError("object", "is for FCStd files only, got {}", repr(wanted))
    label = note = ""
    try:
        if ending == _DOCUMENT:
            text, label, note = child.call(
                "input", path, os.path.getsize(path), _read_document, path, wanted,
                sew_tolerance, dict(parameters))
        else:
            text = core.brep_of_file(path, sew_tolerance, context)
        return Cad(core.read_brep(text, sew_tolerance, context), text, label, note)
    except (RuntimeError, ValueError, OSError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError("input", "cannot be used: {}: {}", _one_line(error), path) from error


def global_shape(document_object):
    """The object's shape where it stands in the document, with the placements of its parents."""
    import Part

    shape = Part.getShape(document_object)  # ours to place; the geometry is the document's
    placement = global_placement(document_object)
    if placement is not None:
        shape.Placement = placement
    return shape


def model_of(mesh_object):
    """The core's model of what a mesh object meshes."""
    shape = global_shape(mesh_object.Part)
    return load_core().read_brep(shape.exportBrepToString(), mesh_object.SewTolerance.Value)


def _read_document(path: str, wanted: Optional[str], sew_tolerance: float,
                   parameters: Mapping[str, Any]) -> Tuple[str, str, str]:
    """BREP text, label and note; the text has made a model."""
    import FreeCAD

    document_file.check(path)
    document = FreeCAD.openDocument(path, True)
    try:
        document_values.set_values(document, parameters)
        chosen, note = _choose(document, wanted, path)
        shape = global_shape(chosen)
        if shape.isNull() or not shape.Faces:
            raise InputError("input", "holds no face to mesh: {}", path)
        text = shape.exportBrepToString()
        load_core().read_brep(text, sew_tolerance)
        return text, chosen.Label, note
    finally:
        FreeCAD.closeDocument(document.Name)


def _choose(document, wanted: Optional[str], path: str):
    if wanted is not None:
        found = document.getObject(wanted)
        same_label = document.getObjectsByLabel(wanted)
        if found is None and len(same_label) > 1:
            names = ", ".join(sorted(entry.Name for entry in same_label))
            raise InputError("object", "{} is the label of several objects: {}", repr(wanted),
                             names)
        chosen = found or (same_label[0] if same_label else None)
        if chosen is None:
            raise InputError("object", "{} is neither name nor label of an object: {}",
                             repr(wanted), path)
        if not _face_count(chosen):
            raise InputError("object", "{} has no face to mesh: {}", repr(wanted), path)
        return chosen, ""
    shapes = [(entry, _face_count(entry)) for entry in document.Objects
              if not [parent for parent in entry.InList if _face_count(parent)]]
    shapes = [(entry, count) for entry, count in shapes if count]
    if not shapes:
        raise InputError("input", "holds no face to mesh: {}", path)
    chosen, count = max(shapes, key=lambda pair: pair[1])
    note = ""
    if len(shapes) > 1:
        note = (f"of {len(shapes)} shapes in the document, {chosen.Label} ({chosen.Name}, "
                f"{count} faces) was meshed")
    return chosen, note


def _face_count(document_object) -> int:
    import Part

    # The planes of an origin have a face each, which is nobody's shape.
    if document_object.isDerivedFrom("App::OriginFeature"):
        return 0
    shape = Part.getShape(document_object)
    return 0 if shape.isNull() else len(shape.Faces)


def _one_line(error: BaseException) -> str:
    text = " ".join(str(error).split()) or type(error).__name__
    wrapped = re.fullmatch(r"FreeCAD exception thrown \((.*)\)", text)
    return wrapped.group(1) if wrapped else text

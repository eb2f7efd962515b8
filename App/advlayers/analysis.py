"""FEM analyses: one solves with the one mesh that it holds."""
from __future__ import annotations

from typing import Any, Callable, Dict, List, Optional

import FreeCAD

from advlayers.errors import InputError
from advlayers.picked_names import names_on

_observers: List[Any] = []


def analyses_of(mesh_object) -> List:
    return [parent for parent in mesh_object.InList
            if parent.isDerivedFrom("Fem::FemAnalysis") and mesh_object in parent.Group]


def mesh_of(analysis) -> Optional[object]:
    return next((member for member in analysis.Group
                 if member.isDerivedFrom("Fem::FemMeshObject")), None)


def replace(old, new) -> int:
    """`new` takes the place of the mesh `old` in every analysis that holds it; returns in how
    many. `old` stays in the document."""
    analyses = analyses_of(old)
    for analysis in analyses:
        analysis.removeObject(old)
        analysis.addObject(new)
    return len(analyses)


def constraint_groups(mesh_object) -> Dict[str, List[str]]:
    """The groups that FreeCAD's writers look for, by name, with the CAD faces in each.

    The pressure of a constraint acts on a shell mesh only where the mesh has a group of elements
    whose name begins with the constraint's; without it FreeCAD writes no load and no error.
    Raises InputError where a constraint lies on what is no part of the meshed object.
    """
    return {f"{member.Name}_Faces": names_on(mesh_object.Part, member.References)
            for analysis in analyses_of(mesh_object) for member in analysis.Group
            if member.isDerivedFrom("Fem::ConstraintPressure") and member.References}


def constraint_texts(mesh_object) -> List[str]:
    """The constraints that need groups, and their faces, to be compared later."""
    return [" ".join([name, *faces])
            for name, faces in sorted(constraint_groups(mesh_object).items())]


def missing_groups(mesh_object) -> List[str]:
    """Names of groups that constraints need and the mesh does not have, or has of other faces. One
    on what is no part of the meshed object misses none: there is nothing to have."""
    try:
        needed = constraint_texts(mesh_object)
    except InputError:
        return []
    kept = list(mesh_object.MeshedConstraints)
    if not kept and needed:  # maybe of a mesh that was made before they were kept
        fem = mesh_object.FemMesh
        present = {fem.getGroupName(number) for number in fem.Groups}
        return [text.split()[0] for text in needed if text.split()[0] not in present]
    return [text.split()[0] for text in needed if text not in kept]


def watch(refresh: Callable[[Any], None]) -> None:
    """Calls `refresh` with each mesh of an analysis whose members or constraints change: FreeCAD
    itself does not touch the mesh then."""
    if not _observers:
        _observers.append(_Observer(refresh))
        FreeCAD.addDocumentObserver(_observers[0])


class _Observer:
    def __init__(self, refresh: Callable[[Any], None]) -> None:
        self._refresh = refresh

    def slotChangedObject(self, changed, name: str) -> None:
        if name not in ("Group", "References") or changed.Document.Restoring:
            return
        if changed.isDerivedFrom("Fem::FemAnalysis"):
            analyses = [changed]
        elif changed.isDerivedFrom("Fem::Constraint"):
            analyses = [parent for parent in changed.InList
                        if parent.isDerivedFrom("Fem::FemAnalysis")]
        else:
            return
        for analysis in analyses:
            for member in analysis.Group:
                self._refresh(member)

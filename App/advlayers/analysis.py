"""FEM analyses: one solves with the one mesh that it holds."""
from __future__ import annotations

from typing import Dict, List, Optional

from advlayers.picked_names import names_on


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

"""FEM analyses: one solves with the one mesh that it holds."""
from __future__ import annotations

from typing import List, Optional


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

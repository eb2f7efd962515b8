"""Writes I-DEAS universal files: datasets 2411 (nodes), 2412 (elements), 2467 (groups)."""
from __future__ import annotations

from typing import List

from advlayers.mesh_groups import Group

# Thin-shell types as FreeCAD's own reader and writer use them.
_QUAD, _TRIANGLE = 44, 41
_ELEMENT_ENTITY, _NODE_ENTITY = 8, 7


def write_unv(path: str, mesh, groups: List[Group]) -> None:
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write("    -1\n  2411\n")
        for i, point in enumerate(mesh.nodes.tolist(), 1):
            # 17 significant digits: a double comes back as it was.
            file.write("%10d%10d%10d%10d\n%25.16E%25.16E%25.16E\n" % (i, 1, 1, 11, *point))
        file.write("    -1\n    -1\n  2412\n")
        number = 0
        for kind, cells in ((_QUAD, mesh.quads), (_TRIANGLE, mesh.triangles)):
            size = cells.shape[1]
            for cell in (cells + 1).tolist():
                number += 1
                file.write("%10d%10d%10d%10d%10d%10d\n" % (number, kind, 2, 1, 7, size))
                file.write("%10d" * size % tuple(cell) + "\n")
        file.write("    -1\n    -1\n  2467\n")
        for i, group in enumerate(groups, 1):
            file.write("%10d" * 8 % (i, 0, 0, 0, 0, 0, 0, len(group.ids)) + f"\n{group.name}\n")
            entity = _NODE_ENTITY if group.of_nodes else _ELEMENT_ENTITY
            records = ["%10d%10d%10d%10d" % (entity, entry, 0, 0) for entry in group.ids.tolist()]
            for j in range(0, len(records), 2):
                file.write("".join(records[j:j + 2]) + "\n")
        file.write("    -1\n")

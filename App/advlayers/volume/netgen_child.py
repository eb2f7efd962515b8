"""Run by a Python that has Netgen: netgen_child.py SKIN.npz CELLS.npz. Imports nothing of ours."""
import sys

import numpy as np
from netgen.meshing import Element2D, FaceDescriptor, Mesh, MeshPoint, MeshingParameters, Pnt


def main(source: str, target: str) -> None:
    with np.load(source) as given:
        points, triangles, size = given["points"], given["triangles"], float(given["size"])
    mesh = Mesh()
    numbers = [mesh.Add(MeshPoint(Pnt(*point))) for point in points.tolist()]
    face = mesh.Add(FaceDescriptor(surfnr=1, domin=1, domout=0, bc=1))
    for cell in triangles.tolist():
        mesh.Add(Element2D(face, [numbers[k] for k in cell]))
    mesh.GenerateVolumeMesh(MeshingParameters(maxh=size))
    found = np.array([list(point.p) for point in mesh.Points()], float)
    cells = np.array([[v.nr for v in cell.vertices] for cell in mesh.Elements3D()], np.int64)
    if not np.array_equal(found[:len(points)], points):
        sys.exit("it moved the nodes of the surface")
    if not len(cells):
        sys.exit("no tetrahedron came out")
    np.savez(target, points=found, tetrahedra=cells.reshape(-1, 4) - 1)


if __name__ == "__main__":
    main(*sys.argv[1:])

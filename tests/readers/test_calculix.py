"""CalculiX on the .inp of a job: a plate with a hole, in rings of second order about the hole.

A plate of 40 x 20 with a hole of diameter 4, pulled along its length: by meshes of 8 to 31 thousand
nodes of both orders the stress at the hole is 3.185 times that at the ends.
"""
import os
import shutil
import subprocess

import core_meshes
import numpy as np
import pytest
from advlayers import export
from advlayers.formats import inp, mesh_parts

PEAK = 3.185
LEFT, FAR, BOTTOM, HOLE = "Edge1", "Edge3", "Edge4", "Edge5"
STEP = """*MATERIAL,NAME=STEEL
*ELASTIC
210000.,0.3
*SOLID SECTION,ELSET=Face1,MATERIAL=STEEL
1.
*BOUNDARY
Edge1,1,1
Edge4,2,2
*STEP
*STATIC
*CLOAD
{}*NODE FILE
U
*EL FILE,OUTPUT=2D
S
*END STEP
"""


def rings(size, height, growth, layers, turn, order=2):
    return core_meshes.mesh(
        "quarter_plate", size=size, first_height=height, growth=growth, layers=layers, order=order,
        curvature_angle=turn, walls=[{"edges": [HOLE]}], match=[LEFT, BOTTOM], off=["Edge2", FAR])


def solve(parts, folder):
    """By node of the mesh, the stress (xx, yy, zz, xy, yz, zx)."""
    if not shutil.which("ccx"):
        pytest.skip("needs the package calculix-ccx")
    inp.write(str(folder / "plate.inp"), parts, "plane stress")
    with open(folder / "plate.inp", "a", encoding="ascii") as file:
        file.write(STEP.format("".join(
            f"{node + 1},1,{force:.12e}\n" for node, force in sorted(pulls(parts).items()))))
    done = subprocess.run(["ccx", "plate"], cwd=folder, stdin=subprocess.DEVNULL, timeout=120,
                          capture_output=True, text=True, check=False)
    assert "*ERROR" not in done.stdout and (folder / "plate.frd").exists(), done.stdout
    stresses, inside = {}, False
    for line in (folder / "plate.frd").read_text().splitlines():
        inside = line.startswith(" -4  STRESS") or inside and not line.startswith(" -3")
        if inside and line.startswith(" -1"):
            stresses[int(line[3:13])] = [float(line[k:k + 12]) for k in range(13, 85, 12)]
    return stresses


def pulls(parts):
    """Forces at the nodes of the far end that are a tension of 1 there."""
    forces = {}
    for block in parts.of(1):
        shares = [1 / 6, 1 / 6, 4 / 6] if block.kind == "line3" else [1 / 2, 1 / 2]
        for cell in block.cells[block.part == int(FAR[4:])].tolist():
            length = float(np.linalg.norm(parts.nodes[cell[1]] - parts.nodes[cell[0]]))
            for node, share in zip(cell, shares):
                forces[node] = forces.get(node, 0.0) + share * length
    return forces


def peak(parts, folder):
    """The stress along the plate, at the hole and beside it."""
    stresses = solve(parts, folder)
    top = np.flatnonzero(np.linalg.norm(parts.nodes - [0.0, 2.0, 0.0], axis=1) < 1e-9)
    assert len(top) == 1
    return stresses[int(top[0]) + 1][0]


@pytest.mark.parametrize("settings, most_nodes, error", [
    ((2.7, 0.3, 1.4, 5, 18.0), 230, 0.005),
    ((1.5, 0.1, 1.4, 8, 6.0), 850, 0.001),
])
def test_stress_at_a_hole(settings, most_nodes, error, tmp_path):
    parts = mesh_parts.of_mesh(rings(*settings), {})
    assert len(parts.nodes) <= most_nodes
    found = peak(parts, tmp_path)
    assert found == pytest.approx(PEAK, rel=error), (len(parts.nodes), found)


def test_first_order_is_taken_too(tmp_path):
    parts = mesh_parts.of_mesh(rings(1.0, 0.13, 1.3, 8, 9.0, order=1), {})
    assert peak(parts, tmp_path) == pytest.approx(PEAK, rel=0.1)


def test_the_table_says_that_inp_has_second_order():
    export.check_carries("outputs", "plate.inp", export.Asked({}, order=2))
    assert os.path.exists(os.path.join(core_meshes.DATA, "quarter_plate.brep"))

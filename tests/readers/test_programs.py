"""Files as CalculiX, OpenFOAM and the CGNS tools take them."""
import os
import re
import shutil
import subprocess

import numpy as np
import pytest
import strict
from agreement import cells_of, group, owned, same_cells
from mesh_cases import NAMES, case

from advlayers.formats import bdf, cgns, inp, msh, obj, plane, stl, unv


def needs(*programs):
    for program in programs:
        if shutil.which(program) is None:
            pytest.skip(f"{program} is not installed")


def run(folder, *command):
    environment = {**os.environ, "WM_PROJECT_DIR": "/usr/share/openfoam", "OMP_NUM_THREADS": "1"}
    return subprocess.run(command, cwd=folder, env=environment, text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)


# --- CalculiX -------------------------------------------------------------------------------------

STEEL = "*MATERIAL, NAME=STEEL\n*ELASTIC\n210000., .3\n"
# What a plane domain is pulled by, and what each choice of element makes of it: the section, and
# the thickness that the force goes through.
SECTIONS = {
    "shell": "*SHELL SECTION, ELSET=Eall, MATERIAL=STEEL\n0.5\n",
    "reduced shell": "*SHELL SECTION, ELSET=Eall, MATERIAL=STEEL\n0.5\n",
    "membrane": "*MEMBRANE SECTION, ELSET=Eall, MATERIAL=STEEL\n0.5\n",
    "plane stress": "*SOLID SECTION, ELSET=Eall, MATERIAL=STEEL\n0.5\n",
    "plane strain": "*SOLID SECTION, ELSET=Eall, MATERIAL=STEEL\n0.5\n",
}


def solve(folder, deck):
    (folder / "run.inp").write_text(deck)
    ran = run(folder, "ccx", "run")
    assert "*ERROR" not in ran.stdout and ran.returncode == 0, ran.stdout[-2000:]
    return (folder / "run.dat").read_text()


def total_force(text, name):
    found = re.search(rf"total force \(fx,fy,fz\) for set {name} .*\n\s*\n\s*(.*)", text)
    return [float(word) for word in found.group(1).split()]


@pytest.mark.parametrize("elements", SECTIONS)
def test_calculix_solves_a_plane_domain(tmp_path, elements):
    """Pulled by 1 % along x between two sides: the sets of nodes hold the right ones, and the
    elements are not turned over."""
    needs("ccx")
    parts = case("plane")
    if "shell" not in elements and elements != "membrane":
        parts = plane.turned_up(parts, (0, 1))
    inp.write(str(tmp_path / "mesh.inp"), parts, elements)
    left = parts.nodes[np.unique(cells_of(parts, 1, group(parts, "in let", 1))["line2"]), 0]
    assert np.ptp(left) == 0.0
    low = parts.nodes[:, 0].min() == left[0]
    ends = [name for name, nodes in parts.node_sets(1)
            if np.ptp(parts.nodes[nodes, 0]) == 0.0 and parts.nodes[nodes[0], 0] != left[0]]
    pull = 0.1 if low else -0.1
    text = solve(tmp_path, "*INCLUDE, INPUT=mesh.inp\n" + STEEL + SECTIONS[elements] + f"""*STEP
*STATIC
*BOUNDARY
in_let, 1, 1
Nall, 3, 3
{ends[0]}, 1, 1, {pull}
{1 + int(np.lexsort(parts.nodes.T)[0])}, 2, 2
*NODE PRINT, NSET={ends[0]}, TOTALS=ONLY
RF
*END STEP
""")
    # Between half the stiffness of the plate without the hole and that: held in its plane to all
    # sides (E times 1.35 at a Poisson's ratio of 0.3) with the membranes, whose knots ccx stiffens.
    size = np.ptp(parts.nodes, axis=0)
    whole = 210000.0 * 0.5 * size[1] * abs(pull) / size[0]
    force = abs(total_force(text, ends[0].upper())[0])
    most = {"plane strain": 1.2, "membrane": 1.35}.get(elements, 1.05)
    assert 0.5 * whole < force < most * whole


def held(parts, loaded):
    """A deck's set of all nodes but those of these cells."""
    free = np.unique(np.concatenate([rows.ravel() for rows in loaded.values()]))
    fixed = np.setdiff1d(np.arange(len(parts.nodes)), free) + 1
    assert len(fixed)
    return "*NSET, NSET=HELD\n" + "".join(f"{node},\n" for node in fixed.tolist())


STEP = """*STEP
*STATIC
*BOUNDARY
HELD, 1, 3
{}
*NODE PRINT, NSET=HELD, TOTALS=ONLY
RF
*END STEP
"""


def area_vector(parts, cells):
    area = np.zeros(3)
    for kind, rows in cells.items():
        x = parts.nodes[rows]
        area += (np.cross(x[:, 2] - x[:, 0], x[:, 3] - x[:, 1]) if kind.startswith("quad")
                 else np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])).sum(axis=0) / 2.0
    return area


@pytest.mark.parametrize("name", ["solid", "second", "facets"])
def test_calculix_takes_shells(tmp_path, name):
    """Pressure on the elements of a group: along their normals, on their area."""
    needs("ccx")
    parts = case(name)
    inp.write(str(tmp_path / "mesh.inp"), parts)
    chosen = parts.groups[0]
    loaded = cells_of(parts, 2, chosen.parts)
    # So thin that the shells of the corners do not reach through each other.
    section = SECTIONS["shell"].replace("0.5", "0.02")
    text = solve(tmp_path, "*INCLUDE, INPUT=mesh.inp\n" + STEEL + section
                 + held(parts, loaded) + STEP.format(f"*DLOAD\n{chosen.name}, P, 1."))
    area = area_vector(parts, loaded)
    # CalculiX pushes a shell along its normal; the support holds against it.
    assert np.allclose(total_force(text, "HELD"), -area, atol=0.02 * np.linalg.norm(area))


def test_calculix_finds_the_surface_of_edges(tmp_path):
    """A surface made of the sides of elements is where the edges of its group are."""
    needs("ccx")
    parts = plane.turned_up(case("plane"), (0, 1))
    inp.write(str(tmp_path / "mesh.inp"), parts, "plane stress")
    loaded = cells_of(parts, 1, group(parts, "in let", 1))
    text = solve(tmp_path, "*INCLUDE, INPUT=mesh.inp\n" + STEEL + SECTIONS["plane stress"]
                 + held(parts, loaded) + STEP.format("*DSLOAD\nS_in_let, P, 1."))
    lines = loaded["line2"]
    length = np.linalg.norm(parts.nodes[lines[:, 1]] - parts.nodes[lines[:, 0]], axis=1).sum()
    force = total_force(text, "HELD")
    # The pressure pushes into the domain, the support out of it.
    outward = np.sign(parts.nodes[lines[0, 0], 0] - parts.nodes[:, 0].mean())
    assert force[0] == pytest.approx(outward * 0.5 * length, rel=1e-3)


@pytest.mark.parametrize("name, surface, number", [("extruded", "front", 1001),
                                                   ("extruded second", "front", 1001),
                                                   ("filled", "bottom", 5),
                                                   ("filled second", "bottom", 5)])
def test_calculix_takes_solids(tmp_path, name, surface, number):
    """A non-positive jacobian would end the run; pressure on the surface of some faces."""
    needs("ccx")
    parts = case(name)
    parts = parts.with_blocks(block for block in parts.blocks if block.kind != "pyramid5")
    inp.write(str(tmp_path / "mesh.inp"), parts)
    loaded = cells_of(parts, 2, [number])
    text = solve(tmp_path, "*INCLUDE, INPUT=mesh.inp\n" + STEEL
                 + "*SOLID SECTION, ELSET=Eall, MATERIAL=STEEL\n" + held(parts, loaded)
                 + STEP.format(f"*DSLOAD\nS_{surface}, P, 1."))
    area = area_vector(parts, loaded)
    assert np.allclose(total_force(text, "HELD"), area, atol=1e-3 * np.linalg.norm(area))


# --- CGNS -----------------------------------------------------------------------------------------

@pytest.mark.parametrize("name", NAMES)
def test_cgns_is_in_order(tmp_path, name):
    needs("cgnscheck")
    parts = case(name)
    cgns.write(str(tmp_path / "mesh.cgns"), parts)
    text = run(tmp_path, "cgnscheck", "-v", "mesh.cgns").stdout
    assert "ERROR" not in text and "checking complete" in text, text[-2000:]
    warnings = set(re.findall(r"WARNING:(.*)", text))
    assert warnings <= {"exponents not given"}, warnings
    families = set(re.findall(r'Family="(.*)"', text))
    # What lies inside a surface bounds nothing, unless it was asked for.
    inside = {"Edge" + str(number) for number in parts.part_numbers(1)} if name in (
        "solid", "second", "nine") else set()
    wanted = set(owned(parts, 2)) | (set(owned(parts, 1)) - inside)
    assert families == {owner.replace(" ", "_") for owner in wanted}


@pytest.mark.parametrize("name", ["extruded", "filled"])
def test_cgns_to_ugrid(tmp_path, name):
    """What the CGNS library reads, written by its own converter and read as UGRID."""
    needs("cgns_to_aflr3")
    parts = case(name)
    cgns.write(str(tmp_path / "mesh.cgns"), parts)
    ran = run(tmp_path, "cgns_to_aflr3", "mesh.cgns", "mesh.b8.ugrid")
    assert ran.returncode == 0, ran.stdout
    points, cells, _surfaces = strict.ugrid(str(tmp_path / "mesh.b8.ugrid"))
    assert np.array_equal(points, parts.nodes)
    volume = {kind: rows for kind, rows in cells.items() if kind not in ("tri3", "quad4")}
    volume["pyramid5"] = volume["pyramid5"][:, [0, 3, 4, 1, 2]]
    same_cells(parts, volume, [3])


# --- OpenFOAM -------------------------------------------------------------------------------------

CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1; writePrecision 17;
"""


@pytest.fixture
def foam(tmp_path):
    needs("checkMesh")
    (tmp_path / "system").mkdir()
    (tmp_path / "system" / "controlDict").write_text(CONTROL)
    for name in ("fvSchemes", "fvSolution"):
        (tmp_path / "system" / name).write_text(
            "FoamFile { version 2.0; format ascii; class dictionary; object " + name + "; }\n"
            + "\n".join(f"{part} {{}}" for part in (
                "ddtSchemes", "gradSchemes", "divSchemes", "laplacianSchemes",
                "interpolationSchemes", "snGradSchemes")))
    return tmp_path


def volume_only(name):
    """OpenFOAM wants every side of a cell to fit a side of the next one or to be on a patch."""
    parts = case(name)
    if name == "filled":
        parts = parts.with_blocks(block for block in parts.blocks if block.kind != "pyramid5")
    return parts


@pytest.mark.parametrize("ending", ["msh", "unv"])
def test_openfoam_takes_volumes(foam, ending):
    parts = volume_only("extruded")
    path = str(foam / f"mesh.{ending}")
    if ending == "msh":
        msh.write(path, parts, "2.2")
        ran = run(foam, "gmshToFoam", "mesh.msh")
    else:
        unv.write(path, parts)
        ran = run(foam, "ideasUnvToFoam", "mesh.unv")
    assert ran.returncode == 0, ran.stdout[-2000:]
    boundary = (foam / "constant" / "polyMesh" / "boundary").read_text()
    patches = dict(re.findall(r"^    (\S+)\s*\n\s*\{[^}]*nFaces\s+(\d+);", boundary, re.M))
    for name, numbers in owned(parts, 2).items():
        count = sum(len(rows) for rows in cells_of(parts, 2, numbers).values())
        found = {patch.strip('"'): int(faces) for patch, faces in patches.items()}
        plain = [patch for patch in found if patch in (name, name.replace(" ", "_"))]
        assert plain and found[plain[0]] == count, (name, found)
    text = run(foam, "checkMesh").stdout
    assert "Mesh OK" in text, text[-3000:]
    # checkMesh says it of the volumes as they are, not of their sizes.
    least = float(re.search(r"Min volume = ([-+.0-9e]+?)\.? ", text).group(1))
    total = float(re.search(r"Total volume = ([-+.0-9e]+?)\.? ", text).group(1))
    assert least > 0.0
    from agreement import signed_volume

    assert total == pytest.approx(sum(
        signed_volume(parts.nodes, block.kind, block.cells).sum() for block in parts.of(3)),
        rel=1e-3)


@pytest.mark.parametrize("ending", ["obj", "stl", "nas"])
@pytest.mark.parametrize("name", ["solid", "facets"])
def test_openfoam_takes_surfaces(foam, name, ending):
    parts = case(name)
    path = str(foam / f"mesh.{ending}")
    {"obj": obj, "stl": stl, "nas": bdf}[ending].write(path, parts)
    text = run(foam, "surfaceCheck", f"mesh.{ending}").stdout
    assert "Surface has no illegal triangles" in text, text[-2000:]
    assert "Surface is closed" in text and "consistent normal) : 1" in text
    # In a Nastran file a property is a CAD face; groups are sets there.
    names = (parts.name(2, number) for number in parts.part_numbers(2)) if ending == "nas" else (
        owned(parts, 2))
    for owner in names:
        assert re.search(rf"^{owner}\s+\d+", text, re.M), (owner, text)


def test_points_are_the_same_after_openfoam(foam):
    parts = volume_only("extruded")
    msh.write(str(foam / "mesh.msh"), parts, "2.2")
    run(foam, "gmshToFoam", "mesh.msh")
    text = (foam / "constant" / "polyMesh" / "points").read_text()
    points = np.array(re.findall(r"^\(([-+.0-9e]+) ([-+.0-9e]+) ([-+.0-9e]+)\)", text, re.M), float)
    assert np.array_equal(ordered_points(points), ordered_points(parts.nodes))


def ordered_points(points):
    points = np.asarray(points)
    return points[np.lexsort(points.T)]

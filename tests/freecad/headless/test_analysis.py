"""A layer mesh as the mesh of a FEM analysis."""
import os
import subprocess

import advlayers
import FreeCAD
import ObjectsFem
import pytest
from advlayers import analysis, check, layer_mesh


@pytest.fixture
def pressed(box):
    """An analysis of a shell with a pressure on one face, whose mesh is a layer mesh."""
    document = box.Document
    made = ObjectsFem.makeAnalysis(document, "Study")
    material = ObjectsFem.makeMaterialSolid(document, "Steel")
    material.Material = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.3"}
    fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
    fixed.References = [(box, "Face1")]
    pressure = ObjectsFem.makeConstraintPressure(document, "Pressure")
    pressure.References = [(box, "Face6")]
    pressure.Pressure = "1 MPa" if isinstance(pressure.Pressure, FreeCAD.Units.Quantity) else 1.0
    thickness = ObjectsFem.makeElementGeometry2D(document, 1.0, "Thickness")
    made.addObjects([material, fixed, pressure, thickness])
    return made


def solver_input(study, folder):
    """The lines that FreeCAD writes for CalculiX."""
    from femtools import ccxtools

    make = getattr(ObjectsFem, "makeSolverCalculixCcxTools", None) or getattr(
        ObjectsFem, "makeSolverCalculiXCcxTools")
    solver = make(study.Document)
    study.addObject(solver)
    solver.AnalysisType = "static"
    study.Document.recompute()
    tools = ccxtools.FemToolsCcx(study, solver)
    tools.update_objects()
    tools.setup_working_dir(str(folder))
    assert tools.check_prerequisites() == ""
    tools.write_inp_file()
    with open(tools.inp_file_name, encoding="utf-8") as file:
        return file.read().splitlines()


def test_pressure_acts_on_the_elements_of_its_face(box, pressed, tmp_path):
    mesh = advlayers.make_layer_mesh(box, mesh_now=False, size=5, first_height=0.5, layers=2)
    pressed.addObject(mesh)
    advlayers.update(mesh)
    groups = {mesh.FemMesh.getGroupName(i): mesh.FemMesh.getGroupElements(i)
              for i in mesh.FemMesh.Groups}
    assert groups["Pressure_Faces"] == groups["Face6"]
    lines = solver_input(pressed, tmp_path)
    start = next(i for i, line in enumerate(lines) if line.startswith("*DLOAD"))
    loaded = []
    for line in lines[start + 1:]:
        if line.startswith("*") and not line.startswith("**"):
            break
        if line and not line.startswith("**"):
            loaded.append(int(line.split(",")[0]))
    assert set(loaded) == set(groups["Face6"])


def test_a_document_is_solved_without_the_add_on(box, pressed, tmp_path):
    """FreeCAD without us writes the same input for its solver."""
    mesh = advlayers.make_layer_mesh(box, mesh_now=False, size=5, first_height=0.5, layers=2)
    pressed.addObject(mesh)
    advlayers.update(mesh)
    with_add_on = tmp_path / "with"
    with_add_on.mkdir()
    lines = solver_input(pressed, with_add_on)
    path = str(tmp_path / "study.FCStd")
    box.Document.saveCopy(path)
    code = f"""
import sys, FreeCAD
from femtools import ccxtools
document = FreeCAD.openDocument({path!r})
assert document.LayerMesh.Proxy is None and "advlayers" not in sys.modules
study = document.Study
solver = next(entry for entry in study.Group if "Solver" in entry.TypeId)
tools = ccxtools.FemToolsCcx(study, solver)
tools.update_objects()
tools.setup_working_dir({str(tmp_path)!r})
assert tools.check_prerequisites() == ""
tools.write_inp_file()
"""
    done = subprocess.run(
        ["freecadcmd", "-c", code], stdin=subprocess.DEVNULL, capture_output=True, text=True,
        timeout=60, check=False, env={**os.environ, "FREECAD_USER_HOME": str(tmp_path)})
    assert done.returncode == 0, done.stdout + done.stderr
    (written,) = tmp_path.glob("*.inp")
    bare = written.read_text(encoding="utf-8").splitlines()
    assert sum(line.startswith("*DLOAD") for line in bare) == 1
    assert len(bare) == len(lines) > 500


def test_a_pressure_that_came_later_puts_the_mesh_out_of_date(box, pressed):
    mesh = advlayers.make_layer_mesh(box, size=5)
    assert mesh.State == layer_mesh.UP_TO_DATE
    pressed.addObject(mesh)
    assert mesh.State == layer_mesh.OUT_OF_DATE
    warnings = [finding.text for finding in check.check(mesh) if finding.severity == "warning"]
    assert len([text for text in warnings if text.startswith("Pressure came after")]) == 1
    advlayers.update(mesh)
    assert mesh.State == layer_mesh.UP_TO_DATE
    assert not [finding for finding in check.check(mesh) if "came after" in finding.text]


def test_a_pressure_that_acts_elsewhere_now(box, pressed):
    mesh = advlayers.make_layer_mesh(box, mesh_now=False, size=5)
    pressed.addObject(mesh)
    advlayers.update(mesh)
    pressure = box.Document.Pressure
    pressure.References = [(box, "Face5")]
    assert mesh.State == layer_mesh.OUT_OF_DATE
    advlayers.update(mesh)
    groups = {mesh.FemMesh.getGroupName(i): mesh.FemMesh.getGroupElements(i)
              for i in mesh.FemMesh.Groups}
    assert groups["Pressure_Faces"] == groups["Face5"]
    pressed.removeObject(pressure)
    assert mesh.State == layer_mesh.UP_TO_DATE  # a group too many does no harm


def test_a_new_pressure_in_the_analysis(box, pressed):
    mesh = advlayers.make_layer_mesh(box, mesh_now=False, size=5)
    pressed.addObject(mesh)
    advlayers.update(mesh)
    late = ObjectsFem.makeConstraintPressure(box.Document, "Late")
    late.References = [(box, "Face4")]
    pressed.addObject(late)
    assert mesh.State == layer_mesh.OUT_OF_DATE
    assert analysis.missing_groups(mesh) == ["Late_Faces"]


def test_membership(box, pressed):
    first = advlayers.make_layer_mesh(box, size=5)
    assert analysis.analyses_of(first) == [] and analysis.mesh_of(pressed) is None
    pressed.addObject(first)
    assert analysis.analyses_of(first) == [pressed] and analysis.mesh_of(pressed) is first
    second = advlayers.make_layer_mesh(box, size=4)
    assert analysis.replace(first, second) == 1
    assert analysis.mesh_of(pressed) is second and first not in pressed.Group

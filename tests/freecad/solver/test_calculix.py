"""A layer mesh under load: CalculiX takes it as shells and gives what beam theory gives."""
import advlayers
import FreeCAD
import ObjectsFem
import pytest
from femtools import ccxtools

LENGTH, WIDTH, THICKNESS = 100.0, 20.0, 2.0  # mm
FORCE, MODULUS = 10.0, 210000.0  # N, MPa


@pytest.fixture
def document():
    made = FreeCAD.newDocument("Cantilever")
    yield made
    FreeCAD.closeDocument(made.Name)


def edge_at(shape, x):
    """Name of the straight edge that lies at x."""
    for i, edge in enumerate(shape.Edges, 1):
        if edge.BoundBox.XMin == edge.BoundBox.XMax == x:
            return f"Edge{i}"
    raise AssertionError(f"no edge at x = {x}")


def analysis_of(document):
    plate = document.addObject("Part::Plane", "Plate")
    plate.Length, plate.Width = LENGTH, WIDTH
    document.recompute()
    fixed_edge, loaded_edge = edge_at(plate.Shape, 0.0), edge_at(plate.Shape, LENGTH)

    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    name = "makeSolverCalculiXCcxTools"
    make_solver = getattr(ObjectsFem, name, None) or ObjectsFem.makeSolverCalculixCcxTools
    solver = make_solver(document)
    solver.AnalysisType = "static"
    material = ObjectsFem.makeMaterialSolid(document, "Steel")
    material.Material = {**material.Material, "Name": "Steel", "YoungsModulus": f"{MODULUS} MPa",
                         "PoissonRatio": "0.3", "Density": "7900 kg/m^3"}
    shell = ObjectsFem.makeElementGeometry2D(document, THICKNESS, "Shell")
    fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
    fixed.References = [(plate, fixed_edge)]
    force = ObjectsFem.makeConstraintForce(document, "Force")
    force.References = [(plate, loaded_edge)]
    force.Force = FORCE if isinstance(force.Force, float) else f"{FORCE} N"
    force.Direction = (plate, ["Face1"])
    # FEM takes the nodes of a group that bears a constraint's name.
    mesh = advlayers.make_layer_mesh(plate, size=5, first_height=1, growth=1.3,
                                     groups={"Fixed_Nodes": [fixed_edge]})
    for member in (solver, material, shell, fixed, force, mesh):
        analysis.addObject(member)
    document.recompute()
    return analysis, solver, mesh


def test_a_cantilever(document, tmp_path):
    analysis, solver, mesh = analysis_of(document)
    assert mesh.QuadPercent > 90.0
    run = ccxtools.FemToolsCcx(analysis, solver)
    run.update_objects()
    run.setup_working_dir(str(tmp_path))
    run.setup_ccx()
    assert run.check_prerequisites() == ""
    run.purge_results()
    run.write_inp_file()
    assert run.ccx_run() == 0
    run.load_results()
    result = next(entry for entry in analysis.Group if hasattr(entry, "DisplacementLengths"))
    inertia = WIDTH * THICKNESS ** 3 / 12.0
    expected = FORCE * LENGTH ** 3 / (3.0 * MODULUS * inertia)
    assert max(result.DisplacementLengths) == pytest.approx(expected, rel=0.05)

"""Layer meshes under load: CalculiX takes them as shells and, filled, as solids, and gives what
beam theory gives."""
import advlayers
import FreeCAD
import ObjectsFem
import pytest
from advlayers import volume_fill
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


def analysis_of(document, body, fixed_part, loaded_part, direction):
    """Of steel, held and pushed; what its mesh is comes later."""
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    name = "makeSolverCalculiXCcxTools"
    make_solver = getattr(ObjectsFem, name, None) or ObjectsFem.makeSolverCalculixCcxTools
    solver = make_solver(document)
    solver.AnalysisType = "static"
    material = ObjectsFem.makeMaterialSolid(document, "Steel")
    material.Material = {**material.Material, "Name": "Steel", "YoungsModulus": f"{MODULUS} MPa",
                         "PoissonRatio": "0.3", "Density": "7900 kg/m^3"}
    fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
    fixed.References = [(body, fixed_part)]
    force = ObjectsFem.makeConstraintForce(document, "Force")
    force.References = [(body, loaded_part)]
    force.Force = FORCE if isinstance(force.Force, float) else f"{FORCE} N"
    force.Direction = (body, [direction])
    analysis.addObjects([solver, material, fixed, force])
    return analysis, solver


def largest_displacement(analysis, solver, folder):
    """And the lines of the deck that CalculiX read."""
    result, deck = solved(analysis, solver, folder)
    return max(result.DisplacementLengths), deck


def solved(analysis, solver, folder):
    """FreeCAD's result, and the lines of the deck that CalculiX read."""
    analysis.Document.recompute()
    run = ccxtools.FemToolsCcx(analysis, solver)
    run.update_objects()
    run.setup_working_dir(str(folder))
    run.setup_ccx()
    assert run.check_prerequisites() == ""
    run.purge_results()
    run.write_inp_file()
    assert run.ccx_run() == 0
    run.load_results()
    result = next(entry for entry in analysis.Group if hasattr(entry, "DisplacementLengths"))
    with open(run.inp_file_name, encoding="utf-8") as file:
        return result, file.read().splitlines()


@pytest.mark.parametrize("order, kinds", [(1, {"S3", "S4"}), (2, {"S6", "S8"})])
def test_a_cantilever(document, tmp_path, order, kinds):
    plate = document.addObject("Part::Plane", "Plate")
    plate.Length, plate.Width = LENGTH, WIDTH
    document.recompute()
    fixed_edge, loaded_edge = edge_at(plate.Shape, 0.0), edge_at(plate.Shape, LENGTH)
    analysis, solver = analysis_of(document, plate, fixed_edge, loaded_edge, "Face1")
    analysis.addObject(ObjectsFem.makeElementGeometry2D(document, THICKNESS, "Shell"))
    # FEM takes the nodes of a group that bears a constraint's name.
    mesh = advlayers.make_layer_mesh(plate, size=5, first_height=1, growth=1.3, order=order,
                                     groups={"Fixed_Nodes": [fixed_edge]})
    assert mesh.QuadPercent > 90.0
    analysis.addObject(mesh)
    found, deck = largest_displacement(analysis, solver, tmp_path)
    written = {line.split("TYPE=")[1].split(",")[0].strip().upper() for line in
               map(str.upper, deck) if line.startswith("*ELEMENT") and "TYPE=" in line}
    assert written & kinds and written <= kinds
    inertia = WIDTH * THICKNESS ** 3 / 12.0
    expected = FORCE * LENGTH ** 3 / (3.0 * MODULUS * inertia)
    assert found == pytest.approx(expected, rel=0.05 if order == 1 else 0.02)


EXPANSION, HOT, COLD = 1.2e-5, 400.0, 300.0  # 1/K, K


def heated(document, body, cold_part, hot_part):
    """Held and kept at COLD at one end, at HOT at the other, stress-free at COLD."""
    analysis, solver = analysis_of(document, body, cold_part, hot_part, "Face1")
    analysis.removeObject(document.Force)
    solver.AnalysisType, solver.ThermoMechSteadyState = "thermomech", True
    document.Steel.Material = {
        **document.Steel.Material, "ThermalConductivity": "50 W/m/K",
        "ThermalExpansionCoefficient": f"{EXPANSION} m/m/K", "SpecificHeat": "500 J/kg/K"}
    initial = ObjectsFem.makeConstraintInitialTemperature(document, "Initial")
    initial.initialTemperature = COLD
    analysis.addObject(initial)
    for name, part, kelvin in (("Cold", cold_part, COLD), ("Hot", hot_part, HOT)):
        constraint = ObjectsFem.makeConstraintTemperature(document, name)
        constraint.References = [(body, part)]
        constraint.Temperature = kelvin
        analysis.addObject(constraint)
    return analysis, solver


def check_heated(result, mesh):
    """The temperature falls along the way, at the mid nodes too; and the beam grows by its mean."""
    x = [mesh.Nodes[number].x for number in result.NodeNumbers]
    for at, kelvin in zip(x, result.Temperature):
        assert kelvin == pytest.approx(COLD + (HOT - COLD) * at / LENGTH, abs=0.05)
    assert len(x) == mesh.NodeCount
    longer = max(vector.x for vector in result.DisplacementVectors)
    assert longer == pytest.approx(EXPANSION * (HOT - COLD) / 2.0 * LENGTH, rel=0.02)


@pytest.mark.parametrize("order", [1, 2])
def test_a_heated_plate(document, tmp_path, order):
    plate = document.addObject("Part::Plane", "Plate")
    plate.Length, plate.Width = LENGTH, WIDTH
    document.recompute()
    analysis, solver = heated(document, plate, edge_at(plate.Shape, 0.0),
                              edge_at(plate.Shape, LENGTH))
    analysis.addObject(ObjectsFem.makeElementGeometry2D(document, THICKNESS, "Shell"))
    mesh = advlayers.make_layer_mesh(plate, size=5, first_height=1, growth=1.3, order=order)
    analysis.addObject(mesh)
    check_heated(solved(analysis, solver, tmp_path)[0], mesh.FemMesh)


def test_a_heated_solid(document, tmp_path):
    beam = document.addObject("Part::Box", "Beam")
    beam.Length, beam.Width, beam.Height = LENGTH, 10.0, 10.0
    document.recompute()
    faces = {round(face.CenterOfMass.x, 6): f"Face{i}"
             for i, face in enumerate(beam.Shape.Faces, 1) if face.Area < 200.0}
    analysis, solver = heated(document, beam, faces[0.0], faces[LENGTH])
    mesh = advlayers.make_layer_mesh(beam, size=4, first_height=1, layers=1, order=2)
    volume = volume_fill.fill(mesh)
    analysis.addObject(volume)
    check_heated(solved(analysis, solver, tmp_path)[0], volume.FemMesh)


def test_a_solid_cantilever(document, tmp_path):
    """Filled with tetrahedra of second order; a beam that gives in shear, too."""
    side = 10.0
    beam = document.addObject("Part::Box", "Beam")
    beam.Length, beam.Width, beam.Height = LENGTH, side, side
    document.recompute()
    faces = {round(face.CenterOfMass.x, 6): f"Face{i}"
             for i, face in enumerate(beam.Shape.Faces, 1) if face.Area < 2 * side * side}
    top = next(f"Face{i}" for i, face in enumerate(beam.Shape.Faces, 1)
               if face.CenterOfMass.z == side)
    analysis, solver = analysis_of(document, beam, faces[0.0], faces[LENGTH], top)
    mesh = advlayers.make_layer_mesh(beam, size=4, first_height=1, layers=1, order=2)
    analysis.addObject(volume_fill.fill(mesh))
    found, deck = largest_displacement(analysis, solver, tmp_path)
    assert any("C3D10" in line.upper() for line in deck)
    inertia = side ** 4 / 12.0
    shear = FORCE * LENGTH * 1.2 * 2.0 * 1.3 / (MODULUS * side ** 2)
    expected = FORCE * LENGTH ** 3 / (3.0 * MODULUS * inertia) + shear
    assert found == pytest.approx(expected, rel=0.02)

"""Batch jobs as a person runs them."""
import json

import pytest

from batch_runs import HOSTS, run

_SHAPES = """
import FreeCAD, Mesh, Part
folder = {folder!r}
box = Part.makeBox(30, 20, 10)
box.exportStep(folder + "/box.step")
box.exportIges(folder + "/box.iges")
box.exportBrep(folder + "/box.brep")
box.exportStl(folder + "/box.stl")
Part.makeCompound([face.copy() for face in box.Faces]).exportBrep(folder + "/loose.brep")
Part.makeCompound([]).exportBrep(folder + "/empty.brep")
Part.makeLine((0, 0, 0), (1, 0, 0)).exportBrep(folder + "/line.brep")
document = FreeCAD.newDocument("two")
small = document.addObject("Part::Cylinder", "Small")
small.Label = "The rod"
large = document.addObject("Part::Box", "Large")
group = document.addObject("App::Part", "Moved")
group.Placement.Base = FreeCAD.Vector(1000, 0, 0)
group.addObject(large)
document.recompute()
document.saveAs(folder + "/two.FCStd")
nothing = FreeCAD.newDocument("nothing")
nothing.saveAs(folder + "/nothing.FCStd")
"""


@pytest.fixture(scope="session")
def shapes(tmp_path_factory):
    """CAD files made once by FreeCAD."""
    folder = tmp_path_factory.mktemp("shapes")
    made = run(["freecadcmd", "-c", _SHAPES.format(folder=str(folder))])
    assert made.status == 0, made.stderr
    (folder / "garbage.step").write_text("this is no STEP file\n")
    (folder / "garbage.brep").write_text("this is no BREP file\n")
    (folder / "garbage.FCStd").write_text("this is no zip file\n")
    (folder / "garbage.stl").write_text("this is no STL file\n")
    (folder / "zero.step").write_text("")
    return folder


@pytest.fixture
def job(tmp_path, shapes):
    """Writes a job file; its input lies among the shapes."""
    def write(name="job.json", **values):
        if "input" in values:
            values["input"] = str(shapes / values["input"])
        path = tmp_path / name
        path.write_text(json.dumps(values))
        return str(path)
    return write


@pytest.fixture(params=sorted(HOSTS))
def batch(request, tmp_path):
    """Runs jobs in FreeCAD or in plain Python, from another folder than the job's."""
    def run_jobs(*paths):
        return run(HOSTS[request.param] + list(paths), cwd="/")
    run_jobs.freecad = request.param == "freecadcmd"
    return run_jobs

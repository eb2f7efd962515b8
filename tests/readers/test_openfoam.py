"""OpenFOAM on what a job alone makes: checkMesh on plates, wedges and filled solids, and a flow."""
import json
import os
import re
import subprocess
import sys

import core_meshes
import foam_case
import pytest

BATCH = os.path.join(os.path.dirname(core_meshes.DATA), os.pardir, "App", "advlayers_batch.py")


def case_of(folder, shape, **job):
    """A case whose mesh is that of the job."""
    with open(folder / "job.json", "w", encoding="utf-8") as file:
        json.dump({"input": os.path.join(core_meshes.DATA, f"{shape}.brep"),
                   "outputs": ["case/constant/polyMesh"], "report": "report.json", **job}, file)
    foam_case.write(folder / "case")
    done = subprocess.run([sys.executable, BATCH, str(folder / "job.json")], timeout=120,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return folder / "case"


def checked(folder, shape, **job):
    said = foam_case.run("checkMesh", case_of(folder, shape, **job))
    assert "Mesh OK." in said, said
    return said


def number_after(said, words):
    return float(re.search(re.escape(words) + r" *=? *(-?[\d.]+\d(?:e[-+]?\d+)?)", said).group(1))


@pytest.mark.parametrize("direction", [[0, 0, 1], [0, 0, -1]])
def test_a_plate(tmp_path, direction):
    said = checked(tmp_path, "square", size=1.0, layers=3, groups={"inlet": ["Edge1"]},
                   extrude={"thickness": 2.0, "cells": 2, "direction": direction,
                            "patch_types": {"front": "patch", "back": "patch"}})
    found = foam_case.patches(said)
    assert set(found) == {"inlet", "Edge2", "Edge3", "Edge4", "front", "back"}
    assert found["front"] == found["back"] and found["inlet"] == 20
    assert number_after(said, "Total volume") == pytest.approx(200.0, rel=1e-5)


@pytest.mark.parametrize("core", ["quads", "triangles"])
def test_a_wedge_about_an_edge(tmp_path, core):
    said = checked(tmp_path, "square", size=1.0, first_height=0.3, layers=2, core=core,
                   walls=[{"edges": ["Edge3"]}], off=["Edge1", "Edge2", "Edge4"],
                   extrude={"axis_direction": [1, 0, 0], "angle": 4.0})
    assert "Wedge front with angle 2 degrees" in said
    assert set(foam_case.patches(said)) == {"Edge2", "Edge3", "Edge4", "front", "back"}


def test_a_filled_solid(tmp_path):
    said = checked(tmp_path, "drilled_plate", size=2.0, first_height=0.5, layers=1,
                   groups={"hole wall": ["Face7"]}, volume={})
    volume = number_after(said, "Total volume")
    assert volume == pytest.approx(core_meshes.SOLIDS["drilled_plate"][4], rel=0.01)
    with open(tmp_path / "report.json", encoding="utf-8") as file:
        assert json.load(file)["volume"]["volume"] == pytest.approx(volume, rel=1e-5)


def test_flow_about_an_airfoil(tmp_path):
    """NACA 0012 in 20 chords, Re 1000, no incidence: drag coefficients of 0.12 to 0.13 are
    published."""
    case = case_of(
        tmp_path, "airfoil", size=2500, first_height=2.0, growth=1.15, layers=22,
        curvature_angle=6, size_growth=1.25, walls=[{"edges": ["Edge3", "Edge4"]}],
        sizes=[{"edges": ["Edge3", "Edge4"], "size": 25}], scale=0.001,
        groups={"airfoil": ["Edge3", "Edge4"], "farfield": ["Edge1", "Edge2"]},
        extrude={"thickness": 100, "patch_types": {"airfoil": "wall"}})
    assert "Mesh OK." in foam_case.run("checkMesh", case)
    said = foam_case.run("simpleFoam", case)
    assert re.search(r"SIMPLE solution converged in \d+ iterations", said)
    last = said[said.rindex("Coefficients"):]
    assert 0.115 < number_after(last, "Cd       :") < 0.135
    assert -0.005 < number_after(last, "Cl       :") < 0.005

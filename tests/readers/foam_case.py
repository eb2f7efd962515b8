"""A case around a polyMesh: what OpenFOAM's programs ask for, and running them."""
import os
import re
import shutil
import subprocess

import pytest

HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
_FILES = {
    "system/controlDict": """application simpleFoam; startFrom startTime; startTime 0;
        stopAt endTime; endTime 600; deltaT 1; writeControl timeStep; writeInterval 600;
        functions { forces { type forceCoeffs; libs ("libforces.so"); patches (airfoil);
        rho rhoInf; rhoInf 1; CofR (0.25 0 0); liftDir (0 1 0); dragDir (1 0 0);
        pitchAxis (0 0 1); magUInf 1; lRef 1; Aref 0.1; } }""",
    "system/fvSchemes": """ddtSchemes { default steadyState; }
        gradSchemes { default Gauss linear; }
        divSchemes { default none; div(phi,U) bounded Gauss linearUpwind grad(U);
        div((nuEff*dev2(T(grad(U))))) Gauss linear; }
        laplacianSchemes { default Gauss linear corrected; }
        interpolationSchemes { default linear; } snGradSchemes { default corrected; }""",
    "system/fvSolution": """solvers {
        p { solver GAMG; smoother GaussSeidel; tolerance 1e-8; relTol 0.05; }
        U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-9; relTol 0.1; } }
        SIMPLE { nNonOrthogonalCorrectors 1; consistent yes;
        residualControl { p 1e-5; U 1e-6; } }
        relaxationFactors { equations { U 0.9; } }""",
    "constant/transportProperties": "transportModel Newtonian; nu [0 2 -1 0 0 0 0] 1e-3;",
    "constant/turbulenceProperties": "simulationType laminar;",
    "0/U": """dimensions [0 1 -1 0 0 0 0]; internalField uniform (1 0 0);
        boundaryField { airfoil { type noSlip; }
        farfield { type freestreamVelocity; freestreamValue uniform (1 0 0); }
        "(front|back)" { type empty; } }""",
    "0/p": """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
        boundaryField { airfoil { type zeroGradient; }
        farfield { type freestreamPressure; freestreamValue uniform 0; }
        "(front|back)" { type empty; } }""",
}
_CLASSES = {"0/U": "volVectorField", "0/p": "volScalarField"}


def write(folder):
    for name, text in _FILES.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="ascii") as file:
            file.write(HEADER.format(_CLASSES.get(name, "dictionary"), os.path.basename(name)))
            file.write(text + "\n")


def run(program, folder, seconds=120):
    """What it printed; it must end well."""
    if not shutil.which(program):
        pytest.skip("needs the package openfoam")
    home = os.environ.get("WM_PROJECT_DIR") or "/usr/share/openfoam"
    done = subprocess.run([program, "-case", str(folder)], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          timeout=seconds, check=False, env={**os.environ, "WM_PROJECT_DIR": home})
    assert done.returncode == 0, done.stdout
    return done.stdout


def patches(said):
    """What checkMesh lists: name -> number of faces."""
    return {name: int(faces) for name, faces in
            re.findall(r"^ +(\S+) +(\d+) +\d+ +ok \(non-closed", said, re.M)}

"""The first height that a dimensionless wall distance y+ asks for, and how thick the boundary layer
is that the layers should reach through: estimates for a smooth flat plate or a smooth pipe.

Re = density * speed * length / viscosity, with the distance from the leading edge or the pipe's
diameter. Wall shear stress = c_f/2 * density * speed^2, friction velocity u = sqrt(stress /
density), height = y+ * viscosity / (density * u). It is the height of the whole first layer: its
middle lies at y+/2.

Plate, at the distance `length`, after H. Schlichting, Boundary-Layer Theory: below Re = 5e5
c_f = 0.664 / sqrt(Re) and a thickness of 5 length / sqrt(Re) (Blasius); above it
c_f = (2 log10(Re) - 0.65)^-2.3 (fits to 1e9) and 0.37 length / Re^0.2. Pipe, developed flow:
c_f = 16 / Re below 2300 (Hagen and Poiseuille), above it Prandtl's law for smooth pipes,
1 / sqrt(f) = 2 log10(Re sqrt(f)) - 0.8 with c_f = f / 4; the boundary layer fills the pipe's
radius.
"""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple

from advlayers.errors import InputError
from advlayers.sentence import Sentence

# Density [kg/m^3] and dynamic viscosity [Pa s]: air of the standard atmosphere at sea level, 15 C;
# water at 20 C.
FLUIDS = {"air": (1.225, 1.789e-5), "water": (998.2, 1.002e-3)}
PLATE, PIPE = "plate", "pipe"
_LAMINAR_PLATE, _LAMINAR_PIPE = 5e5, 2300.0
_MM = 1000.0  # in a metre


@dataclass(frozen=True)
class Estimate:
    first_height: float  # [mm]
    boundary_layer: float  # thickness [mm]
    reynolds: float

    def layers(self, growth: float) -> int:
        """How many layers reach through the boundary layer."""
        ratio = self.boundary_layer / self.first_height
        if growth <= 1.0:
            return max(1, math.ceil(ratio))
        return max(1, math.ceil(math.log1p(ratio * (growth - 1.0)) / math.log(growth)))

    def said(self, growth: float) -> Sentence:
        return Sentence(
            "first height {} mm (Reynolds number {}); the boundary layer is some {} mm thick: {} "
            "layers of growth {}",
            (f"{self.first_height:.4g}", f"{self.reynolds:.3g}", f"{self.boundary_layer:.3g}",
             str(self.layers(growth)), f"{growth:g}"))


def estimate(flow: Mapping[str, Any]) -> Estimate:
    """Of a checked block `y_plus`. Raises InputError where its fluid is left open."""
    density, viscosity = _fluid(flow)
    kinematic = viscosity / density  # [m^2/s]
    length = flow["length"] / _MM
    reynolds = flow["speed"] * length / kinematic
    friction, thickness = (_pipe if flow["flow"] == PIPE else _plate)(reynolds)
    velocity = flow["speed"] * math.sqrt(0.5 * friction)
    return Estimate(flow["y_plus"] * kinematic / velocity * _MM, thickness * flow["length"],
                    reynolds)


def of_settings(settings: Mapping[str, Any]) -> Optional[Estimate]:
    """What the block of checked settings asks for, if there is one. Raises InputError."""
    flow = settings.get("y_plus")
    if flow is None:
        return None
    if settings["first_height"] is not None:
        raise InputError("y_plus", "and {} exclude each other", "first_height")
    return estimate(flow)


def _fluid(flow: Mapping[str, Any]) -> Tuple[float, float]:
    own = (flow["density"], flow["viscosity"])
    if own == (None, None):
        return FLUIDS[flow["fluid"]]
    if None in own:
        raise InputError("y_plus", "needs both density and viscosity, or none of them")
    return own


def _plate(reynolds: float) -> Tuple[float, float]:
    """Local friction coefficient, and the boundary layer's thickness over the length."""
    if reynolds < _LAMINAR_PLATE:
        return 0.664 / math.sqrt(reynolds), 5.0 / math.sqrt(reynolds)
    return (2.0 * math.log10(reynolds) - 0.65) ** -2.3, 0.37 / reynolds ** 0.2


def _pipe(reynolds: float) -> Tuple[float, float]:
    if reynolds < _LAMINAR_PIPE:
        return 16.0 / reynolds, 0.5
    root = 8.0  # 1 / sqrt(f): the law contracts by a tenth in each step
    for _ in range(50):
        root = 2.0 * math.log10(reynolds / root) - 0.8
    return 0.25 / root ** 2, 0.5

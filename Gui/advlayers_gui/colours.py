"""Colours of elements: one scale per field, the same in the view and in its legend."""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, List, Optional, Tuple

import numpy as np

from advlayers.language import tr
from advlayers.mesh_data import ASPECT, DIAGNOSTICS, HEIGHT, LAYERS, QUALITY

# From bad to good, or from low to high; distinct for colour-blind eyes as well.
_HEAT = ((0.70, 0.09, 0.17), (0.94, 0.54, 0.38), (0.97, 0.86, 0.68), (0.57, 0.77, 0.87),
         (0.13, 0.40, 0.67))
_DEPTH = ((0.09, 0.21, 0.45), (0.16, 0.44, 0.67), (0.33, 0.66, 0.76), (0.62, 0.83, 0.78),
          (0.89, 0.94, 0.82))
_RISE = ((0.89, 0.93, 0.97), (0.62, 0.76, 0.87), (0.99, 0.82, 0.48), (0.93, 0.50, 0.22),
         (0.60, 0.10, 0.12))
# Below, nought, above.
_SIGNED = ((0.13, 0.40, 0.67), (0.57, 0.77, 0.87), (0.93, 0.95, 0.93), (0.94, 0.60, 0.42),
           (0.70, 0.09, 0.17))
CORE_COLOUR = (0.86, 0.87, 0.89)


@dataclass(frozen=True)
class Scale:
    """How the values of a field become colours; NaN becomes that of the core."""

    title: str
    low: float
    high: float
    stops: Tuple[Tuple[float, float, float], ...]
    logarithmic: bool = False
    whole: bool = False  # the values are whole numbers
    open_ended: bool = False  # there may be values beyond the ends; they have the ends' colours

    def ranged(self, span: Optional[Tuple[float, float]],
               logarithmic: Optional[bool]) -> Scale:
        """With another range, or spread otherwise over it; None leaves either as it is."""
        low, high = span or (self.low, self.high)
        spread = self.logarithmic if logarithmic is None else logarithmic
        return replace(self, low=low, high=high, logarithmic=spread and low > 0.0,
                       whole=self.whole and not spread and low == round(low) and high - low >= 1.0,
                       open_ended=self.open_ended or span is not None)

    def rgb(self, values):
        """(n, 3) from 0 to 1"""
        values = np.asarray(values, float)
        known = np.isfinite(values)
        colours = self.at(self._share(np.where(known, values, self.low)))
        colours[~known] = CORE_COLOUR
        return colours

    def at(self, share):
        """(n, 3) from 0 to 1; a share of 0 is the low end, 1 the high one."""
        ends = np.linspace(0.0, 1.0, len(self.stops))
        return np.stack([np.interp(share, ends, channel) for channel in zip(*self.stops)],
                        axis=-1)

    def labels(self, count: int) -> List[Tuple[float, str]]:
        """Up to `count` of them with their shares, from low to high; whole numbers once each."""
        shares = np.linspace(0.0, 1.0, count)
        if self.whole:
            spread = self.high - self.low
            shares = np.unique(np.round(self.low + shares * spread) - self.low) / spread
        return [(share, self._label_at(share)) for share in shares.tolist()]

    def _label_at(self, share: float) -> str:
        value = self.low * (self.high / self.low) ** share if self.logarithmic \
            else self.low + share * (self.high - self.low)
        beyond = {0.0: "≤ ", 1.0: "≥ "}.get(share, "") if self.open_ended else ""
        return beyond + (f"{value:.0f}" if self.whole else f"{value:.3g}")

    def _share(self, values):
        low, high = self.low, self.high
        if self.logarithmic:
            low, high, values = np.log(low), np.log(high), np.log(np.maximum(values, self.low))
        return np.clip((values - low) / max(high - low, 1e-30), 0.0, 1.0)


def packed(rgb) -> Any:
    """(n,) uint32, 0xRRGGBBAA, of (n, 3) from 0 to 1."""
    parts = (np.clip(rgb, 0.0, 1.0) * 255.0 + 0.5).astype(np.uint32)
    return (parts[:, 0] << 24) | (parts[:, 1] << 16) | (parts[:, 2] << 8) | np.uint32(255)


def title_of(field: str) -> str:
    """In the user's language."""
    return {LAYERS: tr("Layer"), QUALITY: tr("Quality"), ASPECT: tr("Aspect ratio"),
            HEIGHT: tr("Height error [%]"), DIAGNOSTICS: tr("Diagnostics")}[field]


def layer_scale(highest: int) -> Scale:
    return Scale(title_of(LAYERS), 1.0, float(max(highest, 2)), _DEPTH, whole=True)


def layer_colours(layers, highest: int):
    """Packed; the core, layer 0, is pale."""
    values = np.where(np.asarray(layers) > 0, layers, np.nan)
    return packed(layer_scale(highest).rgb(values))


def quality_scale() -> Scale:
    return Scale(title_of(QUALITY), 0.0, 1.0, _HEAT)


def aspect_scale(highest: float) -> Scale:
    return Scale(title_of(ASPECT), 1.0, max(float(highest), 2.0), _RISE, logarithmic=True)


def height_scale() -> Scale:
    return Scale(title_of(HEIGHT), -10.0, 10.0, _SIGNED, open_ended=True)

"""Settings that go together, by one word: what a job, a script or the window asks for at first."""
from __future__ import annotations

from typing import Any, Dict, Mapping

from advlayers.errors import InputError

# A tangent seam is no wall, and a circle has 36 segments.
_FINE = {"curvature_angle": 10.0}
_SHAPE = {"feature_angle": 15.0, **_FINE}

PRESETS: Dict[str, Dict[str, Any]] = {
    # Layers from every sharp edge until they are as high as wide.
    "cfd": {**_SHAPE, "layers": "isotropic", "growth": 1.2},
    # No layers: an isotropic mesh of quads.
    "fem": {**_SHAPE, "walls": []},
    # Two rings of square quads about every hole, nothing elsewhere.
    "washers": {**_SHAPE, "walls": [{"edges": ["holes"], "aspect_ratio": 1.0, "layers": 2,
                                     "growth": 1.0}], "others": "off"},
}


def applied(settings: Mapping[str, Any]) -> Dict[str, Any]:
    """The settings with those of their preset where they say nothing themselves, and round curves
    where they say nothing of the size. Raises InputError."""
    given = {**_FINE, **settings} if settings.get("size") is None else dict(settings)
    word = given.pop("preset", None)
    if word is None:
        return given
    if word not in PRESETS:
        allowed = " or ".join(f'"{name}"' for name in PRESETS)
        raise InputError("preset", "must be {}, got {}", allowed, repr(word))
    return {**PRESETS[word], **given}

"""What the user has set under Edit > Preferences: defaults of the window, never of scripts."""
from __future__ import annotations

from typing import Any, Dict

import FreeCAD

from advlayers import presets
from advlayers.settings_table import property_name, setting

PATH = "User parameter:BaseApp/Preferences/Mod/AdvancingLayers"
# Settings that the page offers, by the type of their entry.
_FLOATS = ("growth", "feature_angle", "curvature_angle")


def settings() -> Dict[str, Any]:
    """Those of a new layer mesh that are not as it has them by itself."""
    kept = FreeCAD.ParamGet(PATH)
    usual = {key: setting(key).default for key in (*_FLOATS, "layers", "core", "threads")}
    usual.update(presets.applied({}))  # of a mesh without a size, which a new one is
    found: Dict[str, Any] = {
        key: kept.GetFloat(property_name(setting(key)), usual[key]) for key in _FLOATS}
    found["layers"] = kept.GetInt("Layers", setting("layers").default)
    # Most people's layers are to end where they are as high as wide; jobs say what they want.
    if kept.GetBool("Isotropic", True):
        found["layers"] = "isotropic"
    found["core"] = setting("core").choices[kept.GetInt("Core", 0)]
    found["threads"] = kept.GetInt("Threads", setting("threads").default)
    return {key: value for key, value in found.items() if value != usual[key]}


def live_preview() -> bool:
    """Whether a run draws its layers as they grow."""
    return FreeCAD.ParamGet(PATH).GetBool("LivePreview", True)


def preview_rate() -> int:
    """Pictures per second of a run, at most."""
    return max(1, FreeCAD.ParamGet(PATH).GetInt("PreviewRate", 10))

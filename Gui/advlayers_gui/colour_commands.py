"""Commands that show layer meshes coloured by one of their fields, or plain again."""
from __future__ import annotations

from typing import Dict, Tuple

from advlayers.mesh_data import ASPECT, DIAGNOSTICS, HEIGHT, LAYERS, QUALITY
from advlayers_gui import selected
from advlayers_gui.command import Command, do, in_code
from advlayers_gui.resources import icon

_PLAIN = "Faces & Wireframe"  # as FreeCAD shows a FEM mesh at first


class _Colour(Command):
    """Shows the selected layer meshes, or all of the document, in a display mode."""

    MODE = ""

    def IsActive(self) -> bool:
        return super().IsActive() and bool(selected.all_layer_meshes())

    def run(self) -> None:
        for mesh in selected.layer_meshes_or_all():
            view = f"{in_code(mesh)}.ViewObject"
            do(f"{view}.DisplayMode = {self.MODE!r}")
            do(f"{view}.Visibility = True")
            if mesh.Part is not None:
                do(f"{in_code(mesh.Part)}.ViewObject.Visibility = False")


class ColourByLayer(_Colour):
    NAME = "ColourByLayer"
    MENU = "Layer"
    TOOLTIP = "Colours the elements by the layer that they belong to"
    MODE = LAYERS


class ColourByQuality(_Colour):
    NAME = "ColourByQuality"
    MENU = "Quality"
    TOOLTIP = "Colours the elements by their quality, from 0 to 1"
    MODE = QUALITY


class ColourByAspectRatio(_Colour):
    NAME = "ColourByAspectRatio"
    MENU = "Aspect Ratio"
    TOOLTIP = "Colours the elements by their longest side over their shortest"
    MODE = ASPECT


class ColourByHeightError(_Colour):
    NAME = "ColourByHeightError"
    MENU = "Height Error"
    TOOLTIP = ("Colours the elements of layers by how far their height is from the one asked for")
    MODE = HEIGHT


class ColourByDiagnostics(_Colour):
    NAME = "ColourByDiagnostics"
    MENU = "Diagnostics"
    TOOLTIP = "Shows the poor elements, and the places that the mesher's messages are about"
    MODE = DIAGNOSTICS


class Uncoloured(_Colour):
    NAME = "Uncoloured"
    MENU = "No Colours"
    TOOLTIP = "Shows the elements in one colour, as FreeCAD shows a FEM mesh"
    MODE = _PLAIN


class ColourBy:
    """One button with a menu of all of them."""

    NAME = "ColourBy"
    MENU = "Colour by"
    TOOLTIP = "Colours the selected layer meshes, or all of the document, by one of their fields"

    MEMBERS = (ColourByLayer, ColourByQuality, ColourByAspectRatio, ColourByHeightError,
               ColourByDiagnostics, Uncoloured)

    def GetCommands(self) -> Tuple[str, ...]:
        return tuple(f"AdvLayers_{kind.NAME}" for kind in self.MEMBERS)

    def GetResources(self) -> Dict[str, str]:
        return {"Pixmap": icon(f"AdvLayers_{self.MEMBERS[0].NAME}"), "MenuText": self.MENU,
                "ToolTip": self.TOOLTIP}

    def IsActive(self) -> bool:
        return self.MEMBERS[0]().IsActive()

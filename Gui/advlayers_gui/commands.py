"""The workbench's commands, and where they are offered."""
from __future__ import annotations

from typing import List

import FreeCADGui

import advlayers_commands
from advlayers_gui import colour_commands, help_command, make_commands, mesh_commands, tree_light

# In the order of toolbar and menu; None: a separator.
COMMANDS = (
    make_commands.LayerMesh, make_commands.Wall, make_commands.Size, make_commands.Group, None,
    mesh_commands.Update, mesh_commands.Check, mesh_commands.FollowReferences,
    mesh_commands.AcceptReferences, None, colour_commands.ColourBy, None,
    mesh_commands.Export, mesh_commands.ToMesh, mesh_commands.FillVolume, mesh_commands.TakeOver,
    None, help_command.Help,
)
# What a right click on a layer mesh, or on its children, offers.
CONTEXT = ("Wall", "Size", "Group", "Update", "Check", "FollowReferences", "AcceptReferences",
           "ColourBy", "Export", "ToMesh", "FillVolume")


def register() -> List[str]:
    """Makes the commands known to FreeCAD, once; returns their names as the toolbar has them."""
    tree_light.watch()
    known = FreeCADGui.listCommands()
    for kind in (*colour_commands.ColourBy.MEMBERS, *filter(None, COMMANDS)):
        # Another command of that name would leave the buttons of the first one to themselves.
        if _name(kind) not in known:
            advlayers_commands.add(_name(kind), kind())
    return [_name(kind) if kind else "Separator" for kind in COMMANDS]


def _name(kind) -> str:
    return f"AdvLayers_{kind.NAME}"


def context_commands() -> List[str]:
    """For the selection as it is."""
    from advlayers_gui import selected

    return [f"AdvLayers_{name}" for name in CONTEXT] if selected.layer_meshes() else []

"""The command that opens the manual."""
from __future__ import annotations

from advlayers_gui.command import Command


class Help(Command):
    NAME = "Help"
    MENU = "Help on Advancing Layers"
    TOOLTIP = "Opens the manual: first steps, every setting, the method"

    def IsActive(self) -> bool:
        return True

    def run(self) -> None:
        from advlayers_gui import help_window

        help_window.show()

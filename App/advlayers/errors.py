"""What goes wrong and whose fault it is; the messages name the thing and its value."""
from __future__ import annotations


class InputError(ValueError):
    """The caller's fault: a setting, a name, a file. `key` is the setting it came in by."""

    def __init__(self, key: str, text: str) -> None:
        super().__init__(f"{key} {text}" if key else text)
        self.key = key


class CoreMissing(RuntimeError):
    """The compiled core is not there, or not for this Python."""


class Stopped(Exception):
    """The work was stopped on request."""

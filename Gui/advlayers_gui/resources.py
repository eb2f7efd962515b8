"""Pictures and other files of the window."""
from __future__ import annotations

import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def folder(name: str) -> str:
    return os.path.join(ROOT, "Resources", name)


def icon(name: str) -> str:
    return os.path.join(folder("icons"), f"{name}.svg")

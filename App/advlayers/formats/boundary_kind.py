"""What a solver is to take a boundary for, by its name, where its format asks for that."""
from __future__ import annotations

# Words within a name, in the order in which they are looked for.
_WORDS = (
    ("symmetry", ("symmetry", "symm", "sym_", "_sym")),
    ("patch", ("inlet", "outlet", "inflow", "outflow", "far", "open", "freestream")),
)


def boundary_kind(name: str) -> str:
    """"symmetry", "patch" (an inlet, an outlet, a far field) or else "wall"."""
    lower = name.lower()
    for kind, words in _WORDS:
        if lower == "sym" or any(word in lower for word in words):
            return kind
    return "wall"

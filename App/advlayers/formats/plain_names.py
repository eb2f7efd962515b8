"""Names as formats allow them: letters, digits and a few signs, up to some length, all unlike."""
from __future__ import annotations

import re
from typing import Dict, Iterable, Set


def plain_names(names: Iterable[str], limit: int, ignore_case: bool = False) -> Dict[str, str]:
    """By the name as it is given; other signs become "_", and a number parts those that would be
    the same."""
    found: Dict[str, str] = {}
    taken: Set[str] = set()
    for name in names:
        if name in found:
            continue
        stem = re.sub(r"[^A-Za-z0-9_.-]", "_", name)[:limit]
        if not stem[:1].isalpha():
            stem = f"g{stem}"[:limit]
        plain, number = stem, 1
        while (plain.upper() if ignore_case else plain) in taken:
            number += 1
            ending = f"_{number}"
            plain = stem[:limit - len(ending)] + ending
        taken.add(plain.upper() if ignore_case else plain)
        found[name] = plain
    return found

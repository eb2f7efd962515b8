"""What the user is told of a mesh: in English in reports, in their own language in the window."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Tuple


@dataclass(frozen=True)
class Sentence:
    """An English form with a {} for each of its values; `./dev translations` finds the form where
    it stands as a literal, here and in the core."""

    form: str
    values: Tuple[str, ...] = ()

    @property
    def english(self) -> str:
        return self.form.format(*self.values)

    @property
    def translated(self) -> str:
        from advlayers.language import tr

        return tr(self.form).format(*self.values)


def of_diagnostic(entry: Mapping[str, Any]) -> Sentence:
    """Of an entry of a report; one of an earlier version has the English text alone."""
    if "form" in entry:
        return Sentence(entry["form"], tuple(entry["values"]))
    return Sentence("{}", (entry["text"],))

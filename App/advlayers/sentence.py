"""What the user is told: in English in reports and in Python, in their own language in the window.
"""
from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, Callable, Mapping, Tuple

# "walls[0].first_height", "sizes: size", "growth".
_KEY = re.compile(r"(?P<key>[a-z_]+)(?:\[(?P<number>\d+)\])?(?:(?:\.|: )(?P<rest>.+))?")


@dataclass(frozen=True)
class Sentence:
    """An English form with a {} for each of its values; `./dev translations` finds the form where
    it stands as a literal, here, in the core, and in an InputError. A value may be a sentence too.
    """

    form: str
    values: Tuple[Any, ...] = ()

    @property
    def english(self) -> str:
        return _filled(self.form, self.values, lambda said: said.english, str)

    @property
    def translated(self) -> str:
        from advlayers.language import tr

        return _filled(tr(self.form), self.values, lambda said: said.translated, _words)


def _filled(form: str, values: Tuple[Any, ...], say: Callable[[Sentence], str],
            show: Callable[[str], str]) -> str:
    if not values:
        return form
    return form.format(*[say(value) if isinstance(value, Sentence) else show(str(value))
                         for value in values])


def of_error(error: BaseException) -> Sentence:
    """What any error has to say: one of ours, one of the core's, or another."""
    if hasattr(error, "sentence"):
        return error.sentence
    if hasattr(error, "form"):
        return _of_parts(error.form, error.values)
    return Sentence("{}", (str(error) or type(error).__name__,))


def of_diagnostic(entry: Mapping[str, Any]) -> Sentence:
    """Of an entry of a report; one of an earlier version has the English text alone."""
    if "form" in entry:
        return _of_parts(entry["form"], entry["values"])
    return Sentence("{}", (entry["text"],))


def _of_parts(form: str, values) -> Sentence:
    return Sentence(form, tuple(
        _of_parts(value["form"], value["values"]) if isinstance(value, Mapping) else value
        for value in values))


def listed(separator: str, parts) -> Sentence:
    """The parts in one sentence: "{}; {}; {}"."""
    parts = tuple(parts)
    return Sentence(separator.join(["{}"] * len(parts)), parts)


# --- names of ours among the values ---------------------------------------------------------------

def _words(value: str) -> str:
    """As the window calls a setting, or why layers ended; anything else as it is."""
    return setting_words(value) or stop_words(value) or value


def _nothing(_key: str) -> str:
    return ""


# What a setting is called, by its key; empty for what is no setting.
_name_of: Callable[[str], str] = _nothing


def tell_settings(name_of: Callable[[str], str]) -> None:
    """The table of settings says what they are called."""
    global _name_of
    _name_of = name_of


def setting_words(path: str) -> str:
    """ "First height" of "first_height", "Walls 1: Layers" of "walls[0].layers"; empty for what is
    no setting."""
    from advlayers.language import tr

    match = _KEY.fullmatch(path)
    name = _name_of(match["key"]) if match else ""
    if not name:
        return ""
    words = tr(name)
    if match["number"]:
        words += f" {int(match['number']) + 1}"
    rest = match["rest"]
    return f"{words}: {setting_words(rest) or rest}" if rest else words


def stop_words(reason: str) -> str:
    """Why layers ended somewhere; empty for what is no such reason."""
    said = {
        "layers-reached": Sentence("all layers made"),
        "isotropic": Sentence("as high as wide"),
        "collision": Sentence("another front is too near"),
        "closed": Sentence("the fronts have met"),
        "blocked": Sentence("no valid element fits"),
        "merged": Sentence("joined with its neighbour"),
        "neighbour-stopped": Sentence("the layers beside have ended"),
        "surface-bends": Sentence("the surface bends too sharply"),
    }.get(reason)
    return said.translated if said else ""

"""What goes wrong and whose fault it is; the messages name the thing and its value."""
from __future__ import annotations

from typing import Any

from advlayers.sentence import Sentence, of_error


class InputError(ValueError):
    """The caller's fault: a setting, a name, a file. `key` is the setting it came in by, and the
    first word of the message; `form` goes on in English, with a {} for each of the values."""

    def __init__(self, key: str, form: str, *values: Any) -> None:
        self.key = key
        self.sentence = _sentence(form, values)
        if key:
            self.sentence = Sentence("{} {}", (key, self.sentence))
        super().__init__(self.sentence.english)

    def __reduce__(self):
        """Errors of child processes come over as bytes."""
        return _of_sentence, (self.key, self.sentence)


class CoreMissing(RuntimeError):
    """The compiled core is not there, or not for this Python."""

    def __init__(self, form: str, *values: Any) -> None:
        self.sentence = _sentence(form, values)
        super().__init__(self.sentence.english)


class Stopped(Exception):
    """The work was stopped on request."""


def _of_sentence(key: str, sentence: Sentence) -> InputError:
    error = InputError("", sentence.form, *sentence.values)
    error.key = key
    return error


def _sentence(form: str, values) -> Sentence:
    """An error among the values is the reason for this one."""
    return Sentence(form, tuple(of_error(value) if isinstance(value, BaseException) else value
                                for value in values))

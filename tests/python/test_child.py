"""What is done in a child process: its results, its errors, its end."""
import os
import signal

import pytest
from advlayers import child
from advlayers.errors import InputError


def act(function, size=100):
    return child.call("input", "a.file", size, function)


def test_results_come_over_and_nothing_else_changes():
    seen = []
    assert act(lambda: seen.append(1) or {"points": [1.5, None], "name": "ä"}) == {
        "points": [1.5, None], "name": "ä"}
    assert seen == []


def test_errors_come_over_as_they_are():
    def refuse():
        raise InputError("initial_mesh", "has {} nodes", InputError("", "line {}", 3))

    with pytest.raises(InputError) as caught:
        act(refuse)
    assert str(caught.value) == "initial_mesh has line 3 nodes"
    assert caught.value.key == "initial_mesh"
    assert caught.value.sentence.values[1].form == "has {} nodes"
    with pytest.raises(ZeroDivisionError):
        act(lambda: 1 / 0)


def test_an_error_that_cannot_be_copied_keeps_its_text():
    class Odd(Exception):
        pass

    def fail():
        raise Odd("line 7")

    with pytest.raises(RuntimeError, match="line 7"):
        act(fail)


@pytest.mark.parametrize("number", [signal.SIGSEGV, signal.SIGABRT])
def test_a_crash_names_key_and_file(number):
    with pytest.raises(InputError, match="input is damaged: .*: a.file"):
        act(lambda: os.kill(os.getpid(), number))


def test_memory_has_an_end():
    with pytest.raises(InputError, match="MB: a.file"):
        act(lambda: bytearray(2 ** 34))

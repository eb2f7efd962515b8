"""What is done in a child process: its results, its errors, its end."""
import os
import signal
import sys
import threading

import child_acts
import pytest
from advlayers import child
from advlayers.errors import InputError


def call(act, *given):
    return child.call("input", "a.file", 100, act, *given)


def test_results_come_over_and_nothing_else_changes():
    result = call(child_acts.note)
    assert (result["points"], result["name"]) == ([1.5, None], "ä")
    assert result["process"] != os.getpid()
    assert child_acts.seen == []


def test_errors_come_over_as_they_are():
    with pytest.raises(InputError) as caught:
        call(child_acts.refuse)
    assert str(caught.value) == "initial_mesh has line 3 nodes"
    assert caught.value.key == "initial_mesh"
    assert caught.value.sentence.values[1].form == "has {} nodes"
    with pytest.raises(ZeroDivisionError):
        call(child_acts.divide)


def test_an_error_that_cannot_be_copied_keeps_its_text():
    with pytest.raises(RuntimeError, match="line 7"):
        call(child_acts.fail)


@pytest.mark.parametrize("number", [signal.SIGSEGV, signal.SIGABRT])
def test_a_crash_names_key_and_file(number):
    with pytest.raises(InputError, match="input is damaged: .*: a.file"):
        call(child_acts.kill, number)


def test_memory_has_an_end():
    with pytest.raises(InputError, match="MB: a.file"):
        call(child_acts.eat)


def test_a_program_that_is_not_there_is_named(monkeypatch):
    monkeypatch.setattr(sys, "executable", "/no/such/python3")
    with pytest.raises(InputError, match="no process can be started .*/no/such/python3.*: a.file"):
        call(child_acts.note)


def test_other_threads_go_on():
    results = []
    threads = [threading.Thread(target=lambda: results.append(call(child_acts.note)))
               for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len({result["process"] for result in results}) == 3

"""Collections of Python's garbage in a run's own thread."""
import gc
import threading
import weakref

import pytest

import advlayers_core as core
from advlayers.meshing import Run


class Ring:
    """Refers to itself, as a panel does by its widgets' signals."""

    def __init__(self):
        self.itself = self


class NoLayers:
    def __iter__(self):
        return iter(())

    def result(self):
        return None


@pytest.fixture
def collections_on_demand():
    gc.disable()
    yield
    gc.enable()


def test_a_worker_collects_nothing(collections_on_demand):
    ring, threads = Ring(), []
    alive = weakref.finalize(ring, lambda: threads.append(threading.current_thread()))
    del ring

    def make_mesher():
        gc.collect()
        return NoLayers()

    Run(core.RunContext(), make_mesher).finish(lambda _reports: None)
    assert alive.alive
    gc.collect()
    assert threads == [threading.main_thread()]

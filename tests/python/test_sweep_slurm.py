"""Sweeps as an array of a Slurm of one node; stopped in the middle, and gone on with."""
import os
import shutil
import subprocess

import pytest

from advlayers.sweep import places
from row_orders import Orders
from slurm_node import SlurmNode
from test_sweep import wait_until

pytestmark = pytest.mark.skipif(
    shutil.which("slurmctld") is None or shutil.which("slurmd") is None or os.geteuid() != 0,
    reason="needs slurm-wlm and root")


@pytest.fixture(scope="module")
def slurm(tmp_path_factory):
    with SlurmNode(tmp_path_factory.mktemp("slurm")):
        yield


def test_an_array_does_every_row_once_also_after_a_stop(slurm, tmp_path):
    orders = Orders(tmp_path, 5)
    running = places.Slurm(str(tmp_path), ["--time=00:05:00"]).run(orders.files)
    orders.let_go()
    first = next(running)
    running.close()  # as Ctrl-C does
    wait_until(lambda: not queue())
    assert f"r{first}" in orders.journal()
    over = sorted(places.Slurm(str(tmp_path)).run(orders.files))
    assert over == list(range(5))
    assert orders.journal() == orders.names()


def queue():
    return subprocess.run(["squeue", "--noheader"], capture_output=True, text=True,
                          check=True).stdout.strip()

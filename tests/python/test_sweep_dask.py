"""Sweeps on a Dask cluster of two workers: one is killed, the connection cut, nothing is lost."""
import json
import os
import signal
import socket
import subprocess
import sys
import threading

import pytest

from advlayers.sweep import places
from row_orders import Orders
from test_sweep import wait_until

pytest.importorskip("distributed")


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    """Scheduler and two workers of one thread each: port, and the workers' processes."""
    folder = tmp_path_factory.mktemp("dask")
    file = folder / "scheduler.json"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "cwd": folder}
    scheduler = subprocess.Popen(
        [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port",
         "0", "--no-dashboard", "--scheduler-file", str(file)], **quiet)
    workers = [subprocess.Popen(
        [sys.executable, "-m", "distributed.cli.dask_worker", "--scheduler-file", str(file),
         "--nthreads", "1", "--no-nanny", "--no-dashboard", "--local-directory", str(folder)],
        **quiet) for _ in range(2)]
    wait_until(file.exists)
    yield file, workers
    for process in (*workers, scheduler):
        process.kill()
        process.wait()


class Relay:
    """Hands bytes on between whoever connects and the scheduler, until it is cut."""

    def __init__(self, port):
        self._port, self._open = port, []
        self._server = socket.create_server(("127.0.0.1", 0))
        self.address = "tcp://127.0.0.1:%d" % self._server.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        while True:
            near = self._server.accept()[0]
            far = socket.create_connection(("127.0.0.1", self._port))
            self._open += [near, far]
            for a, b in ((near, far), (far, near)):
                threading.Thread(target=self._hand_on, args=(a, b), daemon=True).start()

    @staticmethod
    def _hand_on(a, b):
        try:
            while True:
                data = a.recv(65536)
                if not data:
                    break
                b.sendall(data)
        except OSError:
            pass
        for end in (a, b):
            end.close()

    def cut(self):
        for end in self._open:
            try:
                end.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
        self._open = []


def test_a_killed_worker_and_a_cut_connection_lose_no_row(cluster, tmp_path):
    file, workers = cluster
    orders = Orders(tmp_path, 6)
    relay = Relay(int(json.loads(file.read_text())["address"].rsplit(":", 1)[1]))
    over = []
    thread = threading.Thread(
        target=lambda: over.extend(places.Dask(address=relay.address).run(orders.files)))
    thread.start()
    wait_until(lambda: len(orders.begun_rows()) >= 2)  # each worker is at a row
    os.kill(workers[0].pid, signal.SIGKILL)
    relay.cut()
    orders.let_go()
    thread.join(120)
    assert not thread.is_alive()
    assert sorted(over) == list(range(6))
    assert orders.journal() == orders.names()


def test_a_scheduler_that_is_not_there_is_named(monkeypatch):
    monkeypatch.setattr(places, "_CONNECT", 1)
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
    with pytest.raises(places.SweepError, match="Dask scheduler"):
        list(places.Dask(address=f"tcp://127.0.0.1:{port}").run(["x"]))

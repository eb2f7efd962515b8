"""A Slurm of one node that this process starts and ends: controller and node daemon, no accounts.

Needs root, as the node daemon does.
"""
import os
import subprocess
import time

_CONFIG = """
ClusterName=one
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmdPort={node_port}
AuthType=auth/none
CredType=cred/none
SlurmUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/ctld.pid
SlurmdPidFile={folder}/node.pid
SlurmctldLogFile={folder}/ctld.log
SlurmdLogFile={folder}/node.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2
MpiDefault=none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


class SlurmNode:
    """Within the block SLURM_CONF names its configuration."""

    def __init__(self, folder, cpus=2, port=36817):
        self._folder, self._cpus, self._port = str(folder), cpus, port
        self._daemons = []

    def __enter__(self):
        for part in ("state", "spool"):
            os.makedirs(os.path.join(self._folder, part), exist_ok=True)
        path = os.path.join(self._folder, "slurm.conf")
        with open(path, "w", encoding="utf-8") as file:
            file.write(_CONFIG.format(host=os.uname().nodename.split(".")[0], port=self._port,
                                      node_port=self._port + 1, folder=self._folder,
                                      cpus=self._cpus))
        os.environ["SLURM_CONF"] = path
        for command in (["slurmctld", "-D", "-f", path], ["slurmd", "-D", "-f", path]):
            self._daemons.append(subprocess.Popen(command, stdout=subprocess.DEVNULL,
                                                  stderr=subprocess.DEVNULL))
        self._wait()
        return self

    def _wait(self):
        end = time.monotonic() + 60
        while time.monotonic() < end:
            said = subprocess.run(["sinfo", "--noheader", "--format=%t"], capture_output=True,
                                  text=True, check=False).stdout
            if said.strip() in ("idle", "mix", "alloc"):
                return
            time.sleep(0.5)
        raise RuntimeError(f"the node does not come up: {said}")

    def __exit__(self, *_error):
        for daemon in reversed(self._daemons):
            daemon.terminate()
            daemon.wait()
        del os.environ["SLURM_CONF"]

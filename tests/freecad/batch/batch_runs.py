"""Starts batch jobs in processes of their own and keeps what they said."""
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
BATCH = str(ROOT / "App" / "advlayers_batch.py")


@dataclass
class Ran:
    status: int
    stdout: str
    stderr: str

    @property
    def lines(self):
        return self.stderr.splitlines()


def run(command, **options):
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=120, **options)
    return Ran(done.returncode, done.stdout, done.stderr)


HOSTS = {"freecadcmd": ["freecadcmd", BATCH], "python": [sys.executable, BATCH]}


def files(folder):
    return sorted(entry for entry in os.listdir(folder) if entry != "job.json")

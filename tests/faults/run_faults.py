"""Lets every call of a job that touches its outputs fail in turn, as a full or broken disk would:
no output may be lost or half there, and no job may end with 0 without what was asked for.

    run_faults.py [first [last]]    exit status 1 where one is

One line for each call that was made to fail, then the sums by call.
"""
import errno
import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OUTPUTS = ["a.vtu", "b.unv", "c.vtu", "d.unv", "e.vtu"]
OLD = "older"


def build(folder):
    library = os.path.join(folder, "fail_nth.so")
    subprocess.run(["cc", "-shared", "-fPIC", "-o", library,
                    str(Path(__file__).with_name("fail_nth.c")), "-ldl"], check=True)
    return library


def run(library, folder, number, error):
    """(name of the call that failed or None, exit status, files of the folder by name)"""
    made = os.path.join(folder, "made")
    os.makedirs(made)
    for name in OUTPUTS[::2]:
        Path(made, name).write_text(OLD)
    job = {"input": str(ROOT / "tests" / "data" / "square.brep"), "size": 5.0, "first_height": 0.5,
           "layers": 2, "outputs": OUTPUTS, "report": "r.json"}
    Path(made, "job.json").write_text(json.dumps(job))
    said = os.path.join(folder, "said")
    done = subprocess.run(
        ["/usr/bin/python3", str(ROOT / "App" / "advlayers_batch.py"),
         os.path.join(made, "job.json")], stdin=subprocess.DEVNULL, capture_output=True, text=True,
        env={**os.environ, "LD_PRELOAD": library, "FAULT_FOLDER": made, "FAULT_NAME": said,
             "FAULT_CALL": str(number), "FAULT_ERROR": str(error)})
    files = {name: Path(made, name).read_text() if Path(made, name).is_file() else None
             for name in os.listdir(made) if name != "job.json"}
    return Path(said).read_text().strip() if os.path.exists(said) else None, done, files


def fault(done, files, whole):
    """What is wrong, or nothing."""
    before = {name: OLD for name in OUTPUTS[::2]}
    names = {name for name in files if not name.startswith(".advlayers-")}
    if done.returncode == 0:
        good = names == whole and all(files[name] not in (OLD, "") for name in names)
        return "" if good else "status 0 without all that was asked for"
    if {name: files[name] for name in names} != before:
        return f"status {done.returncode}, and the files have changed"
    if len(done.stderr.strip().splitlines()) != 1:
        return f"status {done.returncode}, {len(done.stderr.splitlines())} lines"
    return ""


def main():
    first, last = (int(word) for word in (sys.argv[1:] + ["1", "1000000"][len(sys.argv) - 1:])[:2])
    whole = {*OUTPUTS, "r.json"}
    tried, wrong = Counter(), 0
    with tempfile.TemporaryDirectory() as top:
        library = build(top)
        for number in range(first, last + 1):
            error = (errno.ENOSPC, errno.EIO)[number % 2]
            with tempfile.TemporaryDirectory(dir=top) as folder:
                name, done, files = run(library, folder, number, error)
            if name is None:
                break
            found = fault(done, files, whole)
            wrong += bool(found)
            tried[name] += 1
            print(number, name, errno.errorcode[error], found or "holds", flush=True)
    print(dict(tried), f"{wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

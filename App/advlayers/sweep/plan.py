"""What is to be done for each row: its job, what tells it from others, and where its record is."""
from __future__ import annotations

import copy
import hashlib
import json
import os
import re
import shutil
import sys
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Tuple

import advlayers
from advlayers.core_access import load_core
from advlayers.settings_table import EXPORT_SETTINGS, JOB_SETTINGS, MESH_SETTINGS
from advlayers.sweep.errors import SweepError
from advlayers.sweep.table import NAME, Row

CAD, INFO = "cad.", "info."
_APP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BATCH = os.path.join(_APP, "advlayers_batch.py")
ROW_PROGRAM = os.path.join(_APP, "advlayers", "sweep", "row.py")
_PATH_KEYS = ("input", "outputs", "report", "picture", "initial_mesh")
_STEP = re.compile(r"\.?([^.\[\]]+)|\[([0-9]+)\]")
_NEEDS_FREECAD = (".fcstd", ".stl")


@dataclass(frozen=True)
class Limits:
    """Of one row; None: none."""
    seconds: Optional[float] = None
    megabytes: Optional[float] = None


@dataclass(frozen=True)
class Task:
    row: Row
    job: Dict[str, Any]
    digest: str  # of all that its outputs depend on
    order_file: str  # what row.py reads
    record_file: str  # what row.py writes when the row is done


def plan(columns: List[str], rows: List[Row], job_path: str, folder: str,
         limits: Limits) -> List[Task]:
    """Checks the columns, and writes the orders of the rows into the folder. Raises SweepError."""
    template = _read_job(job_path)
    _check_columns(columns, template)
    where = os.path.dirname(os.path.abspath(job_path))
    os.makedirs(os.path.join(folder, "rows"), exist_ok=True)
    os.makedirs(os.path.join(folder, "pictures"), exist_ok=True)
    made_by = _versions()
    contents: Dict[str, str] = {}
    tasks = [_task(row, template, where, folder, limits, made_by, contents) for row in rows]
    _check_outputs(tasks)
    return tasks


def _task(row: Row, template: Mapping[str, Any], where: str, folder: str, limits: Limits,
          made_by: str, contents: Dict[str, str]) -> Task:
    job = job_of(row, template, where)
    base = os.path.join(folder, "rows", row.name)
    job.setdefault("report", base + ".report.json")
    job.setdefault("picture", os.path.join(folder, "pictures", row.name + ".png"))
    inputs = [job[key] for key in ("input", "initial_mesh") if isinstance(job.get(key), str)]
    for path in inputs:
        if path not in contents:
            contents[path] = _digest_of_file(path)
    digest = hashlib.sha256(json.dumps(
        [job, made_by, [contents[path] for path in inputs]], sort_keys=True).encode()).hexdigest()
    task = Task(row, job, digest, base + ".order.json", base + ".record.json")
    order = {"name": row.name, "digest": digest, "job": job, "job_file": base + ".job.json",
             "command": host(job) + [BATCH], "record": task.record_file,
             "journal": os.path.join(folder, "journal.csv"),
             "files": [*job.get("outputs", ()), job["report"], job["picture"]],
             "seconds": limits.seconds, "megabytes": limits.megabytes}
    _write_if_other(task.order_file, order)
    return task


def job_of(row: Row, template: Mapping[str, Any], where: str) -> Dict[str, Any]:
    """The job file's job with the row's values in their places, and absolute paths."""
    job = copy.deepcopy(dict(template))
    words = {NAME: row.name, **row.values}
    for column, value in row.values.items():
        if column.startswith(CAD):
            job.setdefault("parameters", {})[column[len(CAD):]] = value
        elif _root(column) in _keys():
            _put(job, column, value)
    for key in _PATH_KEYS:
        value = job.get(key)
        if isinstance(value, str):
            job[key] = _path(key, value, words, where, row)
        elif isinstance(value, list):
            job[key] = [_path(key, entry, words, where, row) for entry in value]
    return job


def host(job: Mapping[str, Any]) -> List[str]:
    """The program that runs the job: FreeCAD where it must, since it takes a second to start."""
    files = [job.get("input"), *job.get("outputs", ())]
    if any(str(path).lower().endswith(_NEEDS_FREECAD) for path in files):
        for name in ("freecadcmd", "FreeCADCmd"):
            if shutil.which(name):
                return [name]
        raise SweepError("FCStd and STL files need FreeCAD, and there is no freecadcmd on the path")
    return [sys.executable]


def is_done(task: Task) -> bool:
    """Whether the row's files are there, as they were written for just this order."""
    record = record_of(task)
    if record is None or record["digest"] != task.digest or record["status"] not in (0, 2):
        return False
    try:
        return all([os.stat(path).st_size, os.stat(path).st_mtime_ns] == stamp
                   for path, stamp in record["files"].items())
    except OSError:
        return False


def record_of(task: Task) -> Optional[Dict[str, Any]]:
    try:
        with open(task.record_file, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return None


def _keys() -> Tuple[str, ...]:
    return tuple(entry.key for entry in JOB_SETTINGS + EXPORT_SETTINGS + MESH_SETTINGS)


def _root(column: str) -> str:
    return re.split(r"[.\[]", column, maxsplit=1)[0]


def _check_columns(columns: List[str], template: Mapping[str, Any]) -> None:
    named = set(re.findall(r"\{([^{}]+)\}", json.dumps(
        [template.get(key) for key in _PATH_KEYS])))
    for column in columns:
        known = (column == NAME or column.startswith((CAD, INFO))
                 or _root(column) in _keys())
        if not known and column not in named:
            raise SweepError(f"the column {column!r} is neither a key of jobs, nor a parameter "
                             "(cad.OBJECT.NAME), nor named in a path of the job; one that is for "
                             "the results alone begins with info.")
    for word in sorted(named - set(columns)):
        raise SweepError(f"a path of the job names {{{word}}}, which is no column of the table")


def _check_outputs(tasks: List[Task]) -> None:
    taken: Dict[str, str] = {}
    for task in tasks:
        for path in (*task.job.get("outputs", ()), task.job["report"], task.job["picture"]):
            real = os.path.realpath(path)
            if real in taken:
                raise SweepError(f"the rows {taken[real]} and {task.row.name} would both write "
                                 f"{path}: put {{name}} into the paths of the job")
            taken[real] = task.row.name


def _put(job: Dict[str, Any], column: str, value: Any) -> None:
    steps = [int(number) if number else key for key, number in _STEP.findall(column)]
    place: Any = job
    for step, following in zip(steps, steps[1:]):
        try:
            if isinstance(place, dict) and step not in place:
                place[step] = [] if isinstance(following, int) else {}
            place = place[step]
        except (LookupError, TypeError) as error:
            raise SweepError(f"the column {column!r} leads to nothing in the job") from error
    try:
        place[steps[-1]] = value
    except (LookupError, TypeError) as error:
        raise SweepError(f"the column {column!r} leads to nothing in the job") from error


def _path(key: str, text: Any, words: Mapping[str, Any], where: str, row: Row) -> str:
    try:
        filled = re.sub(r"\{([^{}]+)\}", lambda found: str(words[found.group(1)]), str(text))
    except KeyError as error:
        raise SweepError(f"the row {row.name} has no {error.args[0]}, which {key} names") from error
    return os.path.normpath(os.path.join(where, filled))


def _read_job(path: str) -> Dict[str, Any]:
    try:
        with open(path, encoding="utf-8-sig") as file:
            job = json.load(file)
    except (OSError, ValueError) as error:
        raise SweepError(f"cannot read the job {path}: {error}") from error
    if not isinstance(job, dict):
        raise SweepError(f"the job {path} must hold one JSON object")
    return job


def _versions() -> str:
    """A core that was built anew makes other meshes, though its number is the same."""
    core = load_core()
    library = sys.modules[f"{core.__name__}._core"].__file__
    return f"{advlayers.__version__} {_digest_of_file(library)}"


def _digest_of_file(path: str) -> str:
    digest = hashlib.sha256()
    try:
        with open(path, "rb") as file:
            for piece in iter(lambda: file.read(1 << 20), b""):
                digest.update(piece)
    except OSError:
        return ""  # the row itself will say so
    return digest.hexdigest()


def _write_if_other(path: str, order: Mapping[str, Any]) -> None:
    text = json.dumps(order, indent=1)
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            if file.read() == text:
                return
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".new", path)

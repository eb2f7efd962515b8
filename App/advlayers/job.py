"""A batch job: what a job file says, checked as far as it can be before anything is read."""
from __future__ import annotations

import json
import os
import sys
from dataclasses import dataclass, field
from typing import Any, Dict, Mapping, Optional, Tuple

from advlayers import (
    cad_input, document_values, export, extrusion, faceted, flow_height, initial_mesh, presets)
from advlayers.errors import InputError
from advlayers.file_mesh import Form
from advlayers.formats import polymesh
from advlayers.settings_check import check_all
from advlayers.settings_table import EXPORT_SETTINGS, JOB_SETTINGS, MESH_SETTINGS

_MOST_DIGITS = 300  # of a whole number; what has more is infinite, which no setting may be


@dataclass(frozen=True)
class Job:
    input_name: str  # as the job file has it
    input: str  # all paths are absolute
    object: Optional[str]
    settings: Dict[str, Any]  # every key of MESH_SETTINGS, checked
    export: Dict[str, Any]  # every key of EXPORT_SETTINGS, checked
    outputs: Tuple[str, ...]
    report: Optional[str]
    strict: bool
    parameters: Mapping[str, Any] = field(default_factory=dict)  # of the document
    picture: Optional[str] = None
    extrude: Optional[extrusion.Extrusion] = None
    volume: Optional[Dict[str, Any]] = None  # the checked block

    @property
    def form(self) -> Form:
        return Form(self.extrude, self.volume, self.export["quad_nodes"])

    @property
    def asked(self) -> export.Asked:
        return self.form.asked(self.settings["groups"], self.settings["order"])


def read_job(path: str) -> Job:
    """Reads and checks a job file; relative paths in it are relative to the file.

    Raises InputError.
    """
    given = _read_json(path)
    if str(given.get("input", "")).lower().endswith(".stl"):
        given.setdefault("feature_angle", faceted.FEATURE_ANGLE)
    values = check_all(presets.applied(given), JOB_SETTINGS + EXPORT_SETTINGS + MESH_SETTINGS)
    folder = os.path.dirname(os.path.abspath(path))
    if values[initial_mesh.KEY] is not None:
        values[initial_mesh.KEY] = os.path.normpath(os.path.join(folder, values[initial_mesh.KEY]))
    job = Job(
        input_name=values["input"],
        input=os.path.normpath(os.path.join(folder, values["input"])),
        object=values["object"],
        settings={entry.key: values[entry.key] for entry in MESH_SETTINGS},
        export={entry.key: values[entry.key] for entry in EXPORT_SETTINGS},
        outputs=tuple(os.path.normpath(os.path.join(folder, out)) for out in values["outputs"]),
        report=values["report"] and os.path.normpath(os.path.join(folder, values["report"])),
        strict=values["strict"],
        parameters=values["parameters"],
        picture=values["picture"] and os.path.normpath(os.path.join(folder, values["picture"])),
        extrude=values["extrude"] and extrusion.of_settings(values["extrude"]),
        volume=values["volume"],
    )
    flow_height.of_settings(job.settings)  # refuses what contradicts itself
    job.form.check(job.settings["order"])
    _check_files(job, path)
    return job


def in_freecad() -> bool:
    """Whether FreeCAD is the host: it is loaded then, and not looked for otherwise."""
    return "FreeCAD" in sys.modules


def _read_json(path: str) -> Dict[str, Any]:
    def no_doubles(pairs):
        seen = {}
        for key, value in pairs:
            if key in seen:
                raise InputError(key, "is given twice")
            seen[key] = value
        return seen

    def whole(text: str):
        """Python refuses to read, or takes long for, numbers beyond all ranges."""
        return int(text) if len(text) < _MOST_DIGITS else float(text)

    try:
        with open(path, encoding="utf-8-sig") as file:
            values = json.load(file, object_pairs_hook=no_doubles, parse_int=whole)
    except OSError as error:
        raise InputError("", "cannot read the job file: {}", error.strerror) from error
    except UnicodeDecodeError as error:
        raise InputError("", "the job file is not UTF-8 text") from error
    except RecursionError as error:
        raise InputError("", "the job file is nested too deeply") from error
    except json.JSONDecodeError as error:
        raise InputError("", "the job file is no JSON: {} in line {}", error.msg,
                         error.lineno) from error
    if not isinstance(values, dict):
        raise InputError("", "the job file must hold one JSON object")
    return values


def _check_files(job: Job, job_path: str) -> None:
    cad_input.check_readable(job.input, in_freecad())
    initial = job.settings[initial_mesh.KEY]
    if initial is not None:
        initial_mesh.check_readable(initial, in_freecad())
    if job.parameters and not job.input.lower().endswith(".fcstd"):
        raise InputError(document_values.KEY, "is for FCStd files only, got {}", job.input_name)
    if not job.outputs and not job.report and not job.picture:
        raise InputError("outputs", "names no file, and there is no report: nothing to do")
    taken = {os.path.realpath(job.input): "the input", os.path.realpath(job_path): "the job file"}
    if initial is not None:
        taken[os.path.realpath(initial)] = "the initial mesh"
    targets = [(f"outputs[{i}]", path) for i, path in enumerate(job.outputs)]
    targets += [(key, path) for key, path in (("report", job.report), ("picture", job.picture))
                if path]
    for key, path in targets[:len(job.outputs)]:
        export.check_format(key, path, in_freecad())
        export.check_carries(key, path, job.asked)
        beside = export.beside(path)
        if beside:
            targets.append((key, beside))
    for key, path in targets:
        real = os.path.realpath(path)
        if real in taken:
            raise InputError(key, "would overwrite {}: {}", taken[real], path)
        taken[real] = key
        _check_target(key, path)
    for key, path, ending in (("report", job.report, ".json"), ("picture", job.picture, ".png")):
        if path and (not path.lower().endswith(ending) or os.path.islink(path)):
            raise InputError(key, "must be a file of its own that ends in {}, got {}", ending, path)


def _check_target(key: str, path: str) -> None:
    folder = os.path.dirname(path)
    of_folders = os.path.basename(path) == polymesh.NAME
    if of_folders and not os.path.exists(folder):  # "constant", of a new case
        folder = os.path.dirname(folder)
    if not os.path.isdir(folder):
        raise InputError(key, "lies in a folder that does not exist: {}", folder)
    if not os.access(folder, os.W_OK | os.X_OK):
        raise InputError(key, "lies in a folder that cannot be written to: {}", folder)
    if len(os.fsencode(os.path.basename(path))) > os.pathconf(folder, "PC_NAME_MAX"):
        raise InputError(key, "has a name that is too long for its folder: {}", path)
    if os.path.isdir(path) and not of_folders:
        raise InputError(key, "is a folder: {}", path)
    if os.path.lexists(path) and not os.path.isfile(path) and not of_folders:
        raise InputError(key, "is no regular file: {}", path)
    if os.path.exists(path) and not os.access(path, os.W_OK):
        raise InputError(key, "cannot be overwritten: {}", path)

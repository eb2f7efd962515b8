"""Runs one checked job from the CAD file to the mesh files."""
from __future__ import annotations

import json
import os
import time
from dataclasses import replace
from typing import Any, Callable, Dict, List, Optional

import numpy as np

from advlayers import (
    cad_input, export, features, flow_height, initial_mesh, limits, picture)
from advlayers.core_access import load_core
from advlayers.errors import InputError
from advlayers.file_mesh import FileMesh
from advlayers.formats import mesh_parts
from advlayers.job import Job
from advlayers.meshing import Run, core_settings
from advlayers.outputs import Outputs
from advlayers.report import has_error, info, make_report, make_strict
from advlayers.settings_check import check_names

# Called now and then with what the run does ("layers 40 %") and the core's new reports.
Watch = Callable[[str, List[Any]], None]


def run_job(job: Job, watch: Watch) -> Dict[str, Any]:
    """Meshes and writes every output and the report, all of them or none; returns the report.

    Raises InputError, or what the core raises.
    """
    core = load_core()
    context = core.RunContext()
    begin = time.perf_counter()
    watch("read", [])
    cad = cad_input.read(core, job.input, job.object, job.settings["sew_tolerance"], context,
                         job.parameters)
    found = features.expanded(job.settings, cad.model)
    job = replace(job, settings=found)
    check_names(found, cad.model.face_count, cad.model.edge_count, job.input_name)
    _check_shape(job, cad.model)
    settings = {**found, initial_mesh.KEY: _initial_mesh(job)}
    seconds = {"read": time.perf_counter() - begin}

    try:
        for_core = core_settings(core, settings, cad.model.diagonal)
        many = limits.check(core, cad.model, for_core, settings, context)
        mesher = core.Mesher(cad.model, for_core, context)
    except core.InvalidInput as error:
        raise InputError("", "{}", error) from error
    words = f" ({many.english})" if many else ""
    mesh = Run(context, lambda: mesher).finish(
        lambda reports: watch(_stage(context) + words, reports))
    seconds.update(mesh.seconds)

    watch("write", [])
    start = time.perf_counter()
    parts = mesh_parts.of_mesh(mesh, job.settings["groups"], job.settings["layer_groups"])
    made = job.form.made(parts, cad.model, job.input_name, for_core.size,
                         lambda: watch("write", []))
    for i, path in enumerate(job.outputs):
        export.check_kinds(f"outputs[{i}]", path, made.parts)
    product = export.Product(made.parts.scaled(job.export["scale"]), job.export)
    try:
        _add_document(job, cad, mesh, made, product)
        seconds["mesh_object"] = time.perf_counter() - start
        with Outputs() as outputs:
            start = time.perf_counter()
            for path in job.outputs:
                writer = export.FORMATS[export.format_of(path)].write
                outputs.make_folder(os.path.dirname(path))
                outputs.write(path, lambda temporary: writer(temporary, product))
            seconds["write"] = time.perf_counter() - start
            seconds["total"] = time.perf_counter() - begin
            report = _report(job, cad, mesh, made, seconds)
            if job.picture:
                outputs.write(job.picture, lambda temporary: picture.write(temporary, made.parts))
            if job.report:
                outputs.write(job.report, lambda temporary: _write_json(temporary, report))
            outputs.publish()
    except OSError as error:
        raise InputError("outputs", "cannot be written: {}", error) from error
    finally:
        _close(product.document)
    return report


def _check_shape(job: Job, model) -> None:
    """Raises InputError where an output cannot hold a mesh of this shape."""
    faces = job.settings["faces"]
    boxes = [box for number, box in enumerate(model.face_boxes, 1)
             if box and (faces == "all" or f"Face{number}" in faces)]
    if boxes:
        low, high = np.min([box[0] for box in boxes], axis=0), np.max(
            [box[1] for box in boxes], axis=0)
        for i, path in enumerate(job.outputs):
            export.check_shape(f"outputs[{i}]", path, job.asked, low, high)


def _stage(context) -> str:
    stage, share = context.progress
    return f"{stage} {100.0 * share:.0f} %"


def _initial_mesh(job: Job) -> Optional[initial_mesh.Arrays]:
    path = job.settings[initial_mesh.KEY]
    return None if path is None else initial_mesh.read(path)


def _report(job: Job, cad: cad_input.Cad, mesh, made: FileMesh,
            seconds: Dict[str, float]) -> Dict[str, Any]:
    notes = [info("object-chosen", cad.note)] if cad.note else []
    flow = flow_height.of_settings(job.settings)
    if flow is not None:
        notes.append(info("y-plus", "y+: " + flow.said(job.settings["growth"]).english))
    report = make_report(job.input_name, mesh, notes + made.notes, seconds)
    if made.figures:
        report["volume"] = made.figures
    if job.strict:
        make_strict(report)
    return report


def exit_status(report: Dict[str, Any]) -> int:
    """0: all meshed; 2: meshed, with trouble that the report names."""
    return 2 if has_error(report) else 0


def _add_document(job: Job, cad: cad_input.Cad, mesh, made: FileMesh,
                  product: export.Product) -> None:
    """Makes what a FreeCAD document needs, and nothing where none is asked for."""
    if ".fcstd" not in {export.format_of(path) for path in job.outputs}:
        return
    import FreeCAD

    from advlayers import fem_mesh, layer_mesh, volume_fill

    product.document = FreeCAD.newDocument("AdvancingLayers", hidden=True)
    product.document.Label = os.path.splitext(os.path.basename(job.input))[0]
    source = product.document.addObject("Part::Feature", "Shape")
    source.Label = cad.label or "Shape"
    source.Shape = cad.shape()
    mesh_object = layer_mesh.create(source, **job.settings)
    parts = mesh_parts.of_mesh(mesh, job.settings["groups"], job.settings["layer_groups"])
    layer_mesh.set_mesh(mesh_object, mesh, fem_mesh.to_fem_mesh(parts),
                        layer_mesh.made_from(mesh_object))
    if job.volume:
        volume_fill.add_object(mesh_object, made.parts)
    product.document.recompute()


def _close(document: Optional[Any]) -> None:
    if document is not None:
        import FreeCAD

        FreeCAD.closeDocument(document.Name)


def _write_json(path: str, report: Dict[str, Any]) -> None:
    # A name that is no text is escaped, as JSON does.
    with open(path, "w", encoding="utf-8", errors="backslashreplace") as file:
        json.dump(report, file, indent=1, ensure_ascii=False, allow_nan=False)
        file.write("\n")

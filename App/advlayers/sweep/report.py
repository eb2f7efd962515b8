"""What came out of a sweep, in one place: results.csv, results.json, and index.html with the small
pictures and the figures drawn over each number that varies."""
from __future__ import annotations

import csv
import html
import json
import os
from typing import Any, Dict, List, Sequence, Tuple

import advlayers
from advlayers.sweep import plan
from advlayers.sweep.plan import Task

STATES = {0: "meshed", 1: "failed", 2: "meshed, with errors"}
WAITING = "not done"
FIGURES = ("nodes", "quads", "triangles", "quad_percent", "layer_quad_percent",
           "angles_45_135_percent", "min_angle", "max_angle", "inverted")
_PLOTTED = (("elements", "elements"), ("quad_percent", "quads [%]"),
            ("min_angle", "least angle [°]"))
_WIDTH, _HEIGHT, _MARGIN = 260, 170, 40  # of a plot [px]
_STYLE = """body{font:14px sans-serif;margin:2em;color:#222}table{border-collapse:collapse}
td,th{padding:.3em .7em;border-bottom:1px solid #ddd;text-align:right}td:first-child,
th:first-child{text-align:left}img{width:160px;display:block}.failed{color:#a00}
.left{text-align:left}svg{margin:.5em}"""


def results(columns: Sequence[str], tasks: Sequence[Task]) -> List[Dict[str, Any]]:
    """A line for each row of the table, in its order."""
    found = []
    for task in tasks:
        record = plan.record_of(task)
        if record is not None and record["digest"] != task.digest:
            record = None
        line: Dict[str, Any] = {column: task.row.values.get(column) for column in columns}
        line["name"] = task.row.name
        line["state"] = STATES[record["status"]] if record else WAITING
        figures = record["figures"] if record else {}
        line.update({key: figures.get(key) for key in FIGURES})
        line["seconds"] = record["seconds"] if record else None
        line["host"] = record["host"] if record else None
        line["message"] = record["message"] if record else ""
        line["picture"] = task.job["picture"]
        found.append(line)
    return found


def write(folder: str, title: str, columns: Sequence[str], lines: Sequence[Dict[str, Any]]) -> None:
    shown = [key for key in lines[0] if key != "picture"]
    with _replacing(os.path.join(folder, "results.csv")) as file:
        table = csv.DictWriter(file, shown, extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        table.writerows(lines)
    with _replacing(os.path.join(folder, "results.json")) as file:
        json.dump({"version": advlayers.__version__, "columns": list(columns),
                   "rows": [{key: line[key] for key in shown} for line in lines]}, file, indent=1)
    with _replacing(os.path.join(folder, "index.html")) as file:
        file.write(_page(folder, title, columns, lines))


class _replacing:
    """A text file that takes the place of an older one when it is whole."""

    def __init__(self, path: str) -> None:
        self._path = path

    def __enter__(self):
        self._file = open(self._path + ".new", "w", encoding="utf-8", newline="")
        return self._file

    def __exit__(self, kind, _error, _trace) -> None:
        self._file.close()
        if kind is None:
            os.replace(self._path + ".new", self._path)


def _page(folder: str, title: str, columns: Sequence[str],
          lines: Sequence[Dict[str, Any]]) -> str:
    counts = {state: sum(line["state"] == state for line in lines)
              for state in (*STATES.values(), WAITING)}
    said = ", ".join(f"{count} {state}" for state, count in counts.items() if count)
    heads = [*columns, "", "state", "quads", "triangles", "quads [%]", "least angle [°]",
             "seconds"]
    rows = "\n".join(_row(folder, columns, line) for line in lines)
    return (f"<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>{html.escape(title)}"
            f"</title><style>{_STYLE}</style></head><body>\n<h1>{html.escape(title)}</h1>\n"
            f"<p>{len(lines)} rows: {said}. Also as <a href=\"results.csv\">CSV</a> and "
            f"<a href=\"results.json\">JSON</a>.</p>\n{_plots(columns, lines)}\n<table><tr>"
            + "".join(f"<th>{html.escape(head)}</th>" for head in heads)
            + f"</tr>\n{rows}\n</table></body></html>\n")


def _row(folder: str, columns: Sequence[str], line: Dict[str, Any]) -> str:
    cells = [f"<td>{html.escape(_shown(line[column]))}</td>" for column in columns]
    picture = os.path.relpath(line["picture"], folder).replace(os.sep, "/")
    seen = line["quads"] is not None and os.path.exists(line["picture"])
    cells.append(f'<td><img loading="lazy" alt="" src="{html.escape(picture, quote=True)}"></td>'
                 if seen else "<td></td>")
    if line["quads"] is None:
        cells.append(f'<td class="left failed" colspan="6">{html.escape(line["state"])} '
                     f'{html.escape(line["message"])}</td>')
    else:
        cells += [f"<td>{html.escape(_shown(line[key]))}</td>" for key in (
            "state", "quads", "triangles", "quad_percent", "min_angle", "seconds")]
    return "<tr>" + "".join(cells) + "</tr>"


def _shown(value: Any) -> str:
    if value is None:
        return ""
    return f"{value:.5g}" if isinstance(value, float) else str(value)


def _plots(columns: Sequence[str], lines: Sequence[Dict[str, Any]]) -> str:
    drawn = []
    for column in columns:
        if len({line[column] for line in lines if _is_number(line[column])}) < 2:
            continue
        for key, title in _PLOTTED:
            points = [(float(line[column]), _figure(line, key)) for line in lines
                      if _is_number(line[column]) and line["quads"] is not None]
            if points:
                drawn.append(_plot(column, title, points))
    return "\n".join(drawn)


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _figure(line: Dict[str, Any], key: str) -> float:
    return float(line["quads"] + line["triangles"] if key == "elements" else line[key])


def _plot(column: str, title: str, points: Sequence[Tuple[float, float]]) -> str:
    """A dot for each row."""
    x, y = ([point[k] for point in points] for k in (0, 1))

    def place(values, value, length, upwards):
        span = max(values) - min(values) or 1.0
        share = (value - min(values)) / span
        return _MARGIN + (1 - share if upwards else share) * (length - 1.5 * _MARGIN) - (
            _MARGIN / 2 if upwards else 0)

    dots = "".join(f'<circle cx="{place(x, a, _WIDTH, False):.1f}" '
                   f'cy="{place(y, b, _HEIGHT, True):.1f}" r="2.5"/>' for a, b in points)
    left, bottom = _MARGIN - 6, _HEIGHT - _MARGIN + 6
    marks = [(left, bottom + 14, "start", f"{min(x):.4g}"),
             (_WIDTH - _MARGIN / 2, bottom + 14, "end", f"{max(x):.4g}"),
             (left - 3, bottom, "end", f"{min(y):.4g}"), (left - 3, 26, "end", f"{max(y):.4g}"),
             (_WIDTH / 2, _HEIGHT - 4, "middle", html.escape(column)),
             (left, 12, "start", html.escape(title))]
    words = "".join(f'<text x="{a:.0f}" y="{b:.0f}" text-anchor="{anchor}" font-size="10">{text}'
                    "</text>" for a, b, anchor, text in marks)
    return (f'<svg width="{_WIDTH}" height="{_HEIGHT}" fill="#164e8c">'
            f'<path d="M{left} 20V{bottom}H{_WIDTH - 10}" fill="none" stroke="#999"/>'
            f'{dots}<g fill="#222">{words}</g></svg>')

"""Prints a job's report as a short table: report_table.py report.json"""
import json
import sys

ROWS = (
    ("nodes", "{nodes}"),
    ("quads", "{quads} ({quad_percent:.2f} %)"),
    ("triangles", "{triangles}"),
    ("quads in the layers", "{layer_quad_percent:.2f} %"),
    ("angles from 45 to 135 degrees", "{angles_45_135_percent:.2f} %"),
    ("smallest and largest angle", "{min_angle:.1f} and {max_angle:.1f} degrees"),
    ("inverted elements", "{inverted}"),
)


def main(path):
    with open(path, encoding="utf-8") as file:
        report = json.load(file)
    print(f"\n{report['input']}")
    for name, form in ROWS:
        print(f"  {name:32s}{form.format(**report)}")
    for patch in report["patches"]:
        faces = ", ".join(patch["faces"][:4]) + ("…" if len(patch["faces"]) > 4 else "")
        print(f"  {'patch of ' + faces:32s}{patch['layers']} layers, {patch['quads']} quads, "
              f"{patch['triangles']} triangles")
    seconds = {key: value for key, value in report["seconds"].items() if value >= 0.0005}
    print(f"  {'seconds':32s}" + ", ".join(f"{key} {value:.2f}" for key, value in seconds.items()))
    for entry in report["diagnostics"]:
        print(f"  {entry['severity']}: {entry['text']}")


main(sys.argv[1])

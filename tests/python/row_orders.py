"""Orders of a sweep whose rows do not mesh: each says that it has begun, waits to be let go, and
writes its report. So a test can stop, kill and cut while rows run, without waiting for clocks."""
import json
import sys

_PROGRAM = """
import json, os, sys, time
job = json.load(open(sys.argv[-1]))
with open(job["begun"], "a") as file:
    file.write("%s\\n" % job["name"])
while not os.path.exists(job["go"]):
    time.sleep(0.02)
figures = dict.fromkeys(("nodes", "quads", "triangles", "quad_percent", "layer_quad_percent",
                         "angles_45_135_percent", "min_angle", "max_angle", "inverted"), 1)
json.dump(figures, open(job["report"], "w"))
"""


class Orders:
    def __init__(self, folder, count):
        self.folder = folder
        self.begun, self.go = folder / "begun", folder / "go"
        program = folder / "row_program.py"
        program.write_text(_PROGRAM)
        self.files = []
        for i in range(count):
            base = str(folder / f"r{i}")
            job = {"name": f"r{i}", "begun": str(self.begun), "go": str(self.go),
                   "report": base + ".report.json"}
            order = {"name": f"r{i}", "digest": "d", "job": job, "job_file": base + ".job.json",
                     "command": [sys.executable, str(program)], "record": base + ".record.json",
                     "journal": str(folder / "journal.csv"), "files": [job["report"]],
                     "seconds": None, "megabytes": None}
            (folder / f"r{i}.order.json").write_text(json.dumps(order))
            self.files.append(base + ".order.json")

    def begun_rows(self):
        return self.begun.read_text().split() if self.begun.exists() else []

    def let_go(self):
        self.go.write_text("")

    def journal(self):
        """The names of the rows that were done, each as often as it was."""
        path = self.folder / "journal.csv"
        lines = path.read_text().splitlines() if path.exists() else []
        return sorted(line.split(",")[0] for line in lines)

    def names(self):
        return sorted(f"r{i}" for i in range(len(self.files)))

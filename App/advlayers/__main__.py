"""The command `advlayers`: sweeps of many meshes, single jobs, versions.

Runs as `python3 -m advlayers`, and as `python3 App/advlayers` from a checkout.
"""
import os
import sys

USAGE = """usage: advlayers sweep TABLE.csv JOB.json [option ...]   one mesh for every row (--help)
       advlayers job JOB.json [more.json ...]          meshes jobs, in FreeCAD where one needs it
       advlayers version                               what is installed here
"""
_FOLDER = os.path.dirname(os.path.abspath(__file__))


def main() -> int:
    # Run as a folder, its modules would stand at the top: `child`, `limits`, `report`.
    sys.path[:] = [path for path in sys.path if os.path.abspath(path or ".") != _FOLDER]
    app = os.path.dirname(_FOLDER)
    if app not in sys.path:
        sys.path.insert(0, app)
    from advlayers import core_wheel

    if core_wheel.is_built_here():
        sys.path.insert(0, os.path.dirname(core_wheel.PACKAGE))
    command, arguments = (sys.argv[1] if len(sys.argv) > 1 else ""), sys.argv[2:]
    try:
        if command == "sweep":
            from advlayers.sweep import command as sweep

            return sweep.main(arguments)
        if command == "job" and arguments:
            return _run_jobs(arguments)
        if command == "version":
            from advlayers import versions

            print(versions.text())
            return 0
    except RuntimeError as error:
        print(f"advlayers: {error}", file=sys.stderr)
        return 1
    print(USAGE, end="", file=sys.stdout if command in ("help", "--help", "-h") else sys.stderr)
    return 0 if command in ("help", "--help", "-h") else 1


def _run_jobs(jobs) -> int:
    import json
    import subprocess

    from advlayers.sweep import plan

    def host(path):
        try:
            with open(path, encoding="utf-8-sig") as file:
                return plan.host(json.load(file))
        except (OSError, ValueError, AttributeError):
            return [sys.executable]  # says what is wrong with the file

    statuses = [subprocess.run([*host(job), plan.BATCH, job], stdin=subprocess.DEVNULL,
                               check=False).returncode for job in jobs]
    return 1 if 1 in statuses else max(statuses)


if __name__ == "__main__":
    sys.exit(main())

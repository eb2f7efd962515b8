"""The page on scripting and the README say what is so: their code runs, from top to bottom."""
import os
import re

import FreeCAD

ROOT = os.path.join(os.path.dirname(__file__), "..", "..", "..")
PAGE, README = os.path.join(ROOT, "docs", "python.md"), os.path.join(ROOT, "README.md")


def code_of(page):
    with open(page, encoding="utf-8") as file:
        return re.findall(r"```python\n(.*?)```", file.read(), re.DOTALL)


def test_the_code_of_the_page_runs(capsys):
    blocks = code_of(PAGE)
    assert len(blocks) >= 5
    names = {}
    try:
        for block in blocks:
            exec(compile(block, PAGE, "exec"), names)
        printed = capsys.readouterr().out
        assert "growth must be >= 1 and <= 10, got 0.5" in printed and "Out of date" in printed
        assert names["mesh"].State == "Up to date"
        assert os.path.getsize(os.path.join(names["folder"], "duct.vtu")) > 1000
        assert len(names["result"].quads) > 0
    finally:
        FreeCAD.closeDocument("Duct")


def test_the_console_code_of_the_readme_runs(capsys):
    code = next(block for block in code_of(README) if "make_layer_mesh" in block)
    names = {}
    try:
        exec(compile(code, README, "exec"), names)
        assert "Up to date []" in capsys.readouterr().out
        assert names["mesh"].QuadPercent > 95
    finally:
        FreeCAD.closeDocument(names["doc"].Name)

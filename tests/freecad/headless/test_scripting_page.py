"""The page on scripting says what is so: its code runs, from top to bottom."""
import os
import re

import FreeCAD

PAGE = os.path.join(os.path.dirname(__file__), "..", "..", "..", "docs", "python.md")


def test_the_code_of_the_page_runs(capsys):
    with open(PAGE, encoding="utf-8") as file:
        blocks = re.findall(r"```python\n(.*?)```", file.read(), re.DOTALL)
    assert len(blocks) >= 5
    names = {}
    try:
        for block in blocks:
            exec(compile(block, PAGE, "exec"), names)
        printed = capsys.readouterr().out
        assert "growth must be >= 1, got 0.5" in printed and "Out of date" in printed
        assert names["mesh"].State == "Up to date"
        assert os.path.getsize(os.path.join(names["folder"], "duct.vtu")) > 1000
        assert len(names["result"].quads) > 0
    finally:
        FreeCAD.closeDocument("Duct")

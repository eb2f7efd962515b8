"""Whatever a window shows goes through the translations."""
import ast
import glob
import os

import pytest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WINDOW = sorted(glob.glob(os.path.join(ROOT, "*", "advlayers*", "*.py")))
# What puts a text before the user's eyes.
SHOWING = {
    "QLabel", "QPushButton", "QCheckBox", "QGroupBox", "QListWidgetItem", "QTableWidgetItem",
    "setText", "setToolTip", "setTitle", "setWindowTitle", "setLabelText", "setCancelButtonText",
    "setHorizontalHeaderLabels", "setStatusTip", "addTab", "addItem", "addItems", "addAction",
    "addRow", "showText", "say", "fail", "tool_button", "warning", "openTransaction",
    "getSaveFileName", "PrintMessage", "PrintWarning", "PrintError"}
NAME_OF_OURS = "Advancing Layers"  # the same in every language


def untranslated(tree):
    """Literals with words that are shown as they are: line and text."""
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and _name(call) in SHOWING:
            for part in (*call.args, *(keyword.value for keyword in call.keywords)):
                yield from _literals(part)


def _literals(node):
    if isinstance(node, ast.Call):  # its arguments are its own affair: tr("...")
        yield from _literals(node.func)  # but "...".format() is shown
        return
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        words = node.value.replace(NAME_OF_OURS, "")
        if any(letter.isalpha() for letter in words):
            yield node.lineno, node.value
    for child in ast.iter_child_nodes(node):
        yield from _literals(child)


def _name(call):
    return getattr(call.func, "id", getattr(call.func, "attr", ""))


@pytest.mark.parametrize("path", WINDOW, ids=os.path.basename)
def test_no_text_is_shown_as_it_stands_in_the_code(path):
    with open(path, encoding="utf-8") as file:
        assert list(untranslated(ast.parse(file.read()))) == []


def test_such_a_text_would_be_found():
    code = 'box.setToolTip("Not in {} tongues".format(1)); say(f"{x} mm" if y else "no")'
    assert [text for _line, text in untranslated(ast.parse(code))] == [
        "Not in {} tongues", " mm", "no"]
    assert not list(untranslated(ast.parse('say(tr("words"), wrong=True); say("…")')))

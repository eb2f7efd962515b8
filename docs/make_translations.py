"""Collects the texts of the window into Resources/translations/*.ts and compiles them to *.qm.

Run by `./dev translations`. Qt's own collector reads neither the table of settings, whose sentences
are tooltips, nor the commands' names; what it would find is found here as well. Translations that
are there are kept. A new language: a new file advlayers_LANGUAGE.ts (or an empty one) and this
script.

The .qm files are committed: an add-on is installed as a checkout, and nothing builds it then.
"""
import ast
import glob
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from xml.sax.saxutils import escape

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
for part in ("App", os.path.join("mesher_core", "python")):
    sys.path.insert(0, os.path.join(ROOT, part))
FOLDER = os.path.join(ROOT, "Resources", "translations")
# A Sentence or an error, its variable's name where it has one, and literals one after the other.
_CORE_SENTENCE = re.compile(
    r'\b(?:Sentence|InvalidInput|GeometryError)(?:\s+\w+)?\(\s*((?:"[^"\\]*"\s*)+)')
_LITERAL = re.compile(r'"([^"]*)"')
# Functions and classes that say something, and which argument it is.
_SAYING = {"tr": 0, "Sentence": 0, "CoreMissing": 0, "Format": 0, "InputError": 1}
PROPERTY, WINDOW, WORKBENCH = "App::Property", "AdvancingLayers", "Workbench"


def texts():
    """Every text once: (context, source), in a fixed order."""
    # The second: a setting, and what is wrong with it.
    found = {(WORKBENCH, "Advancing Layers"): None, (WINDOW, "{} {}"): None}
    code = os.path.join(ROOT, "*", "advlayers*", "**", "*.py")
    for path in sorted(glob.glob(code, recursive=True)):
        with open(path, encoding="utf-8") as file:
            found.update(dict.fromkeys(_of_code(ast.parse(file.read()))))
    found.update(dict.fromkeys(_of_tables()))
    for path in sorted(glob.glob(os.path.join(ROOT, "mesher_core", "src", "*", "*.[ch]*"))):
        with open(path, encoding="utf-8") as file:
            found.update(dict.fromkeys(_of_core(file.read())))
    for path in sorted(glob.glob(os.path.join(ROOT, "Resources", "ui", "*.ui"))):
        found.update(dict.fromkeys(_of_form(path)))
    return sorted(found)


def _of_code(tree):
    for node in ast.walk(tree):
        if isinstance(node, ast.ClassDef):
            yield from _of_class(node)
        elif isinstance(node, ast.Call):
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            if name in _SAYING and len(node.args) > _SAYING[name]:
                form = node.args[_SAYING[name]]
                for choice in (form.body, form.orelse) if isinstance(form, ast.IfExp) else (form,):
                    if _says_something(_text(choice)):
                        yield WINDOW, _text(choice)
            elif name == "addProperty":
                yield from _of_property([_text(argument) for argument in node.args])
        elif isinstance(node, ast.Tuple):
            yield from _of_property([_text(element) for element in node.elts])


def _of_property(words):
    """Its type, its name, its group and what it is there for, as far as they are literals; two of
    them may stand the other way round, and the group may be missing."""
    if len(words) > 2 and any(word.startswith("App::Property") for word in words[:2]):
        name = next(word for word in words[:2] if not word.startswith("App::Property"))
        for text in (_apart(name), *words[2:]):
            if text:
                yield PROPERTY, text


def _apart(name):
    """ "First Height" of "FirstHeight": so FreeCAD shows a property."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def _of_core(source):
    """The forms of the core's sentences."""
    for literals in _CORE_SENTENCE.findall(source):
        form = "".join(_LITERAL.findall(literals))
        if _says_something(form):
            yield WINDOW, form


def _says_something(text):
    return any(letter.isalpha() for letter in text)


def _of_class(node):
    """A command's menu text and tooltip, which FreeCAD translates by the command's name; the
    tooltip of a child's references; the step of undo that a panel makes."""
    texts_of = {}
    for line in node.body:
        if isinstance(line, ast.Assign) and isinstance(line.targets[0], ast.Name):
            texts_of[line.targets[0].id] = _text(line.value)
    if texts_of.get("NAME"):
        for key in ("MENU", "TOOLTIP"):
            yield f"AdvLayers_{texts_of['NAME']}", texts_of[key]
    if texts_of.get("REFERENCES"):
        yield from ((PROPERTY, text) for text in (
            texts_of["REFERENCES"], "References", node.name))  # its values' group has its name
    if "NAME" not in texts_of and texts_of.get("TITLE"):
        yield WINDOW, texts_of["TITLE"]


def _of_tables():
    from advlayers import settings_table as table

    for entry in table.MESH_SETTINGS:
        if entry.group:
            yield from ((PROPERTY, text) for text in (
                entry.doc, _apart(table.property_name(entry)), entry.group))
        yield from ((WINDOW, choice) for choice in entry.choices)
    radius = table.setting("radius", table.REFINEMENT_SETTINGS)
    for entry in (*table.WALL_SETTINGS, *table.SIZE_SETTINGS, radius):
        yield from ((WINDOW, choice) for choice in entry.choices)
        if entry.key not in ("edges", "faces"):
            yield from ((PROPERTY, text) for text in (
                entry.doc, table.optional_doc(entry), _apart(table.property_name(entry))))
    for entry in (*table.Y_PLUS_SETTINGS, table.setting("preset")):
        yield PROPERTY, entry.doc
        yield from ((WINDOW, choice) for choice in entry.choices)
    for key in table.keys():
        yield WINDOW, table.label(key)


def _of_form(path):
    root = ElementTree.parse(path).getroot()
    context = root.findtext("class")
    for text in root.iter("string"):
        if _says_something(text.text or ""):
            yield context, text.text


def _text(node):
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""


def kept(path):
    """The translations of a .ts file."""
    if not os.path.exists(path) or not os.path.getsize(path):
        return {}
    found = {}
    for context in ElementTree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.findtext("translation")
            if translation:
                found[context.findtext("name"), message.findtext("source")] = translation
    return found


def write(path, found, translations):
    language = os.path.basename(path)[len("advlayers_"):-len(".ts")]
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>",
             f'<TS version="2.1" language="{language}" sourcelanguage="en">']
    contexts = sorted({context for context, _source in found})
    for context in contexts:
        lines += ["<context>", f"    <name>{escape(context)}</name>"]
        for source in (source for other, source in found if other == context):
            text = translations.get((context, source), "")
            kind = "" if text else ' type="unfinished"'
            lines += ["    <message>", f"        <source>{escape(source)}</source>",
                      f"        <translation{kind}>{escape(text)}</translation>",
                      "    </message>"]
        lines.append("</context>")
    lines.append("</TS>")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def main():
    found = texts()
    for path in sorted(glob.glob(os.path.join(FOLDER, "advlayers_*.ts"))):
        translations = kept(path)
        write(path, found, translations)
        open_ones = [text for text in found if text not in translations]
        print(f"{os.path.basename(path)}: {len(found)} texts, {len(open_ones)} not translated")
        subprocess.run(["lrelease", "-silent", "-nounfinished", path], check=True,
                       env={**os.environ, "QT_SELECT": "5"})


if __name__ == "__main__":
    main()

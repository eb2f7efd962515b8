"""Writes what the docs tell of the sources: the graphs of modules in architecture.md, and the files
and thresholds on the pages in docs/core.

Run by `./dev docs`; needs no build. `--check` writes nothing and names the pages that are not
current; the tests ask the same. What stands between the markers is written here, the rest by hand.
"""
from __future__ import annotations

import ast
import glob
import os
import re
import sys
from typing import Dict, Iterable, List, NamedTuple, Set

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DOCS = os.path.join(ROOT, "docs")
SOURCES = os.path.join(ROOT, "mesher_core", "src")
CORE_TESTS = os.path.join(ROOT, "tests", "core")
PACKAGES = ("App/advlayers", "Gui/advlayers_gui")
ARCHITECTURE = os.path.join(DOCS, "architecture.md")
MODULES = ("base", "geometry", "mesh", "sizing", "boundary", "triangulate", "layers", "measure",
           "core", "quads", "imprint", "mend", "mesher")

_CONSTANT = re.compile(
    r"^\s*(?:inline |static )*const(?:expr)? (?:unsigned |std::)?(double|int|size_t|uint32_t|float)"
    r" (k[A-Z]\w*(?: = [^,;]+, k[A-Z]\w*)*) = ([^;]+);(?: *// ?(.*))?$")


def text_of(path: str) -> str:
    with open(path, encoding="utf-8") as file:
        return file.read()


def between(text: str, name: str, content: str) -> str:
    """The text with other content between its markers of this name."""
    begin, end = f"<!-- {name}: written by ./dev docs -->", f"<!-- end of {name} -->"
    head, found, rest = text.partition(begin)
    _, closed, tail = rest.partition(end)
    if not found or not closed:
        raise SystemExit(f"no place for {name}")
    return f"{head}{begin}\n{content.strip()}\n{end}{tail}"


def table(header: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    lines = [list(header), *map(list, rows)]
    lines.insert(1, ["---"] * len(lines[0]))
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


# Marks for nothing or everything are no thresholds, nor are the lengths of enumerations.
_MARK = re.compile(r"^(-\d|std::numeric_limits<.*>::(min|max|infinity)\(\))$")
_LENGTHS = {"kRunStages"}


# --- the core -----------------------------------------------------------------------------------

def files_of(module: str) -> List[str]:
    return sorted(glob.glob(os.path.join(SOURCES, module, "*.[ch]*")))


def includes() -> Dict[str, Set[str]]:
    """The modules whose headers a module's files include."""
    return {module: {name for path in files_of(module)
                     for name in re.findall(r'#include "(\w+)/', text_of(path))} - {module}
            for module in MODULES}


def reduced(graph: Dict[str, Set[str]]) -> Dict[str, Set[str]]:
    """Without the arrows that a way over others makes needless."""
    def reach(start: str) -> Set[str]:
        found: Set[str] = set()
        waiting = list(graph[start])
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                waiting.extend(graph[name])
        return found
    return {name: {to for to in graph[name]
                   if not any(to in reach(other) for other in graph[name] - {to})}
            for name in graph}


def core_graph() -> str:
    graph = includes()
    drawn = [f"  {name} --> {to}" for name, found in reduced(graph).items()
             for to in sorted(found, key=MODULES.index)]
    rows = []
    for module in MODULES:
        names = ", ".join(sorted(graph[module], key=MODULES.index)) or "nothing of ours"
        rows.append((f"[{module}](core/{module}.md)", names))
    return "\n".join(["```mermaid", "graph BT", *drawn, "```", "",
                      "An arrow leads to what is included; those that follow from others are left "
                      "out. In full:", "",
                      table(("module", "includes"), rows)])


def first_words(path: str) -> str:
    """What a header says that it is: its first comment's first sentence."""
    words = []
    for line in text_of(path).splitlines():
        if not line.startswith("//"):
            break
        words.append(line[2:].strip())
    return re.split(r"(?<=[.;]) ", " ".join(words))[0].rstrip(".:;").replace("|", "\\|")


def file_table(module: str) -> str:
    headers = [path for path in files_of(module) if path.endswith(".h")]
    return table(("file", "what it is"),
                 ((os.path.basename(path)[:-2], first_words(path)) for path in headers))


class Threshold(NamedTuple):
    module: str
    file: str  # without its ending
    name: str
    value: str
    reason: str


def _comment_above(lines: List[str], at: int) -> str:
    words: List[str] = []
    while at > 0 and lines[at - 1].strip().startswith("//"):
        at -= 1
        words.insert(0, lines[at].strip().lstrip("/").strip())
    return " ".join(words)


def _named_values(names: str, last: str) -> Iterable[List[str]]:
    """Of "kA = 1, kB" and "2": kA, 1 and kB, 2."""
    for part in f"{names} = {last}".split(", k"):
        name, _, value = part.partition(" = ")
        yield [name if name.startswith("k") else "k" + name, value]


def thresholds_of(path: str) -> List[Threshold]:
    found: List[Threshold] = []
    lines = text_of(path).splitlines()
    shared = ""  # a comment above stands for the constants below it that have none beside them
    for at, line in enumerate(lines):
        match = _CONSTANT.match(line)
        if not match:
            if not line.strip().startswith("//"):
                shared = ""
            continue
        _, names, value, beside = match.groups()
        above = _comment_above(lines, at)
        over = above or ("" if beside else shared)
        shared = "" if beside else over
        reason = " ".join(part for part in (over, beside) if part)
        for name, number in _named_values(names, value):
            if name in _LENGTHS or _MARK.match(number.strip()):
                continue
            found.append(Threshold(os.path.basename(os.path.dirname(path)),
                                   os.path.splitext(os.path.basename(path))[0], name,
                                   number.strip(), reason.replace("|", "\\|")))
    return found


def thresholds(module: str) -> List[Threshold]:
    return [found for path in files_of(module) for found in thresholds_of(path)]


def tests_of(module: str, file: str) -> List[str]:
    """Tests of the core that include a source's header, or are named for it on its page."""
    header = f'#include "{module}/{file}.h"'
    found = {os.path.relpath(path, CORE_TESTS)
             for path in glob.glob(os.path.join(CORE_TESTS, "*", "*.cpp"))
             if header in text_of(path)}
    named = re.search(rf"^\* `{file}`: (.*)$", page_text(module), re.M)
    if named:
        found.update(re.findall(r"`([\w/.]+\.(?:cpp|py))`", named.group(1)))
    return sorted(found)


def threshold_table(module: str) -> str:
    rows = [(f"`{found.name}`", f"`{found.value}`", found.reason, found.file,
             ", ".join(f"`{test}`" for test in tests_of(module, found.file)))
            for found in thresholds(module)]
    if not rows:
        return "None."
    return table(("constant", "value", "what it is, and why", "file", "tests"), rows)


def page_of(module: str) -> str:
    return os.path.join(DOCS, "core", f"{module}.md")


def page_text(module: str) -> str:
    return text_of(page_of(module))


def core_page(module: str) -> str:
    text = between(page_text(module), "files", file_table(module))
    return between(text, "thresholds", threshold_table(module))


# --- App and Gui --------------------------------------------------------------------------------

def python_modules() -> Dict[str, str]:
    """Name -> path, of both packages."""
    found = {}
    for package in PACKAGES:
        folder = os.path.join(ROOT, package)
        for path in glob.glob(os.path.join(folder, "**", "*.py"), recursive=True):
            parts = os.path.relpath(path, os.path.dirname(folder))[:-3].split(os.sep)
            found[".".join(parts if parts[-1] != "__init__" else parts[:-1])] = path
    return found


def imported(nodes: Iterable[ast.AST], modules: Dict[str, str]) -> Set[str]:
    """Modules of ours that these statements import."""
    names = set()
    for node in nodes:
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.update(f"{node.module}.{alias.name}" if f"{node.module}.{alias.name}" in modules
                         else node.module for alias in node.names)
    return names & set(modules)


def short(names: Set[str], package: str) -> str:
    return ", ".join(sorted(name[len(package) + 1:] if name.startswith(package + ".") else name
                            for name in names))


def python_graph() -> str:
    modules = python_modules()
    rows = []
    for name, path in sorted(modules.items()):
        tree = ast.parse(text_of(path))
        at_load = imported(tree.body, modules)
        later = imported(ast.walk(tree), modules) - at_load - {name}
        package = name.split(".")[0]
        words = (ast.get_docstring(tree) or "").partition("\n\n")[0]
        said = re.split(r"(?<=[.;]) ", " ".join(words.split()))[0].rstrip(".:;")
        rows.append((name, said.replace("|", "\\|"), short(at_load, package),
                     short(later, package)))
    return table(("module", "what it is", "imports when loaded", "imports inside functions"), rows)


# --- all ----------------------------------------------------------------------------------------

def pages() -> Dict[str, str]:
    """Path -> what it should hold."""
    text = between(text_of(ARCHITECTURE), "core graph", core_graph())
    found = {ARCHITECTURE: between(text, "import graph", python_graph())}
    found.update((page_of(module), core_page(module)) for module in MODULES)
    return found


def stale() -> List[str]:
    return [os.path.relpath(path, ROOT) for path, text in pages().items()
            if text_of(path) != text]


def main() -> int:
    if "--check" in sys.argv[1:]:
        for path in stale():
            print(f"{path} is not current: ./dev docs", file=sys.stderr)
        return 1 if stale() else 0
    for path, text in pages().items():
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())

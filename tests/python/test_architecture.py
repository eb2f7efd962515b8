"""What docs/architecture.md says must stay true of the order of modules, read off the sources."""
import ast
import glob
import os
import re
import sys

import pytest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SOURCES = os.path.join(ROOT, "mesher_core", "src")
ARCHITECTURE = os.path.join(ROOT, "docs", "architecture.md")
# Headers of OpenCASCADE have no folder and end so.
OCCT = re.compile(r'#include <\w+\.hxx>')


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def core_files():
    return sorted(glob.glob(os.path.join(SOURCES, "*", "*.[ch]*")))


def module_of(path):
    return os.path.basename(os.path.dirname(path))


def written_order():
    """Of the core's modules, each with its place; those in braces share one."""
    order = re.search(r"\*\*Order\.\*\* (.*?) →\s+bindings", text_of(ARCHITECTURE), re.S).group(1)
    places = [part.strip() for part in " ".join(order.split()).split("→")]
    return {name.strip(): k for k, part in enumerate(places)
            for name in part.strip("{}").split(",")}


def included_modules(path):
    return set(re.findall(r'#include "(\w+)/', text_of(path)))


def test_the_order_names_every_module():
    assert set(written_order()) == {module_of(path) for path in core_files()}


def test_no_file_of_the_core_includes_against_the_order():
    order = written_order()
    against = [(os.path.relpath(path, SOURCES), module)
               for path in core_files() for module in included_modules(path)
               if module != module_of(path) and order[module] >= order[module_of(path)]]
    assert against == []


def test_opencascade_is_included_in_geometry_alone():
    including = {module_of(path) for path in core_files() if OCCT.search(text_of(path))}
    assert including == {"geometry"}


def test_the_steps_of_a_layer_are_drawn_in_their_order():
    code = text_of(os.path.join(SOURCES, "layers", "patch_layers.cpp"))
    steps = re.findall(r'\{Step::k\w+, "([\w-]+)",', code)
    assert len(steps) > 1
    drawn = re.search(r"layers/\s+layer after layer: (.*?)\n +▼", text_of(ARCHITECTURE), re.S)
    assert " ".join(drawn.group(1).split()).split(" · ") == [
        step.replace("-", " ") for step in steps]


def test_a_degree_is_defined_once():
    defining = [os.path.relpath(path, SOURCES) for path in core_files()
                if re.search(r"\bkDegree = ", text_of(path))]
    assert defining == [os.path.join("base", "angles.h")]


# --- pages that a script writes -----------------------------------------------------------------

@pytest.fixture(scope="module")
def structure():
    sys.path.insert(0, os.path.join(ROOT, "docs"))
    try:
        import make_structure
    finally:
        sys.path.pop(0)
    return make_structure


def test_graphs_files_and_thresholds_in_the_docs_are_current(structure):
    assert structure.stale() == [], "run ./dev docs"


def test_the_pages_are_those_of_the_modules(structure):
    assert set(structure.MODULES) == set(written_order())
    pages = {os.path.basename(path)[:-3]
             for path in glob.glob(os.path.join(ROOT, "docs", "core", "*.md"))}
    assert pages == set(structure.MODULES)


def test_every_threshold_has_its_reason_beside_it_and_a_test(structure):
    found = [threshold for module in structure.MODULES
             for threshold in structure.thresholds(module)]
    assert found
    bare = [f"{t.module}/{t.file} {t.name}" for t in found if len(t.reason) < 3]
    assert bare == []
    tests = {(t.module, t.file): structure.tests_of(t.module, t.file) for t in found}
    assert [source for source, names in tests.items() if not names] == []
    missing = [name for names in tests.values() for name in names
               if not os.path.exists(os.path.join(ROOT, "tests", "core", name))]
    assert missing == []


def test_a_threshold_is_told_with_its_comment(structure, tmp_path):
    source = tmp_path / "layers" / "some.cpp"
    source.parent.mkdir()
    source.write_text("// In heights.\nconstexpr double kNear = 2.0, kFar = 4.0;\n\n"
                      "constexpr int kMost = 3;  // passes\nconstexpr int kNone = -1;\n"
                      "constexpr double kBare = 1.5;\n")
    assert [(t.file, t.name, t.value, t.reason) for t in structure.thresholds_of(str(source))] == [
        ("some", "kNear", "2.0", "In heights."), ("some", "kFar", "4.0", "In heights."),
        ("some", "kMost", "3", "passes"), ("some", "kBare", "1.5", "")]


# --- Python -------------------------------------------------------------------------------------

def python_modules():
    """Name -> path, of both packages."""
    found = {}
    for package in ("App/advlayers", "Gui/advlayers_gui"):
        folder = os.path.join(ROOT, package)
        for path in glob.glob(os.path.join(folder, "**", "*.py"), recursive=True):
            parts = os.path.relpath(path, os.path.dirname(folder))[:-3].split(os.sep)
            found[".".join(parts if parts[-1] != "__init__" else parts[:-1])] = path
    return found


def imports_at_load(path, modules):
    """Modules of ours that a file imports when it is loaded itself."""
    names = set()
    for node in ast.parse(text_of(path)).body:
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.update(f"{node.module}.{alias.name}" if f"{node.module}.{alias.name}" in modules
                         else node.module for alias in node.names)
    return names & set(modules)


def circle_in(graph):
    """Names that import each other in a ring; empty where there is none."""
    done = set()

    def walk(name, trail):
        if name in trail:
            return trail[trail.index(name):]
        if name in done:
            return []
        for other in sorted(graph[name]):
            ring = walk(other, trail + [name])
            if ring:
                return ring
        done.add(name)
        return []

    return next((ring for ring in (walk(name, []) for name in sorted(graph)) if ring), [])


def test_no_modules_import_each_other_when_they_are_loaded():
    modules = python_modules()
    assert len(modules) > 50
    assert circle_in({name: imports_at_load(path, modules)
                      for name, path in modules.items()}) == []


def test_a_circle_would_be_found():
    assert circle_in({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c"]
    assert circle_in({"a": {"b", "c"}, "b": {"c"}, "c": set()}) == []


@pytest.mark.parametrize("forbidden", ["PySide", "FreeCADGui"])
def test_app_loads_no_window(forbidden):
    modules = python_modules()
    loading = [name for name, path in modules.items() if name.split(".")[0] == "advlayers"
               and re.search(rf"^(import|from) {forbidden}\b", text_of(path), re.M)]
    assert loading == []

"""The reference page says what the program does."""
import importlib.util
import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def reference():
    spec = importlib.util.spec_from_file_location(
        "make_reference", os.path.join(ROOT, "docs", "make_reference.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_page_is_up_to_date():
    made = reference()
    with open(made.PAGE, encoding="utf-8") as file:
        assert file.read() == made.page(), "run ./dev docs"


def test_the_stub_is_up_to_date():
    made = reference()
    with open(made.STUB, encoding="utf-8") as file:
        assert file.read() == made.stub(), "run ./dev docs"


def test_the_copy_of_the_schema_is_up_to_date():
    made = reference()
    with open(made.SCHEMA_FILE, encoding="utf-8") as file:
        assert file.read() == made.schema(), "run ./dev docs"

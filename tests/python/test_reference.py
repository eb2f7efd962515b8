"""The reference page says what the program does."""
import importlib.util
import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def test_the_page_is_up_to_date():
    spec = importlib.util.spec_from_file_location(
        "make_reference", os.path.join(ROOT, "docs", "make_reference.py"))
    reference = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(reference)
    with open(reference.PAGE, encoding="utf-8") as file:
        assert file.read() == reference.page(), "run ./dev docs"

"""What errors and diagnostics have to say, in parts that other languages can use."""
import advlayers_core as core
import pytest
from advlayers.errors import InputError
from advlayers.sentence import Sentence, of_diagnostic, of_error
from core_meshes import mesh, mesher


def test_an_error_of_the_core_has_its_parts():
    with pytest.raises(core.InvalidInput) as caught:
        mesher("box", walls=[{"edges": ["Edge1"], "thickness": 1e-3}])
    error = caught.value
    assert error.form == "{}: {} ({})" and error.values[0] == "walls"
    assert error.values[1]["form"] == "thickness {} mm is less than the first height {} mm"
    assert error.values[1]["values"][0] == "0.001" and error.values[2] == "Edge1"
    assert of_error(error).english == str(error)


def test_a_diagnostic_gives_the_reasons_as_a_sentence_of_their_own():
    made = mesh("box", walls=[{"edges": ["Edge1"]}], layers=400)
    (entry,) = [entry for entry in made.diagnostics if entry["code"] == "wall-short-of-layers"][:1]
    assert entry["form"] == "{}: {}" and {"form", "values"} == set(entry["values"][1])
    assert of_diagnostic(entry).english == entry["text"]


def test_a_report_of_before_there_were_forms():
    assert of_diagnostic({"text": "as {it} was"}).english == "as {it} was"


def test_an_error_may_be_the_reason_for_another():
    inner = InputError("size", "must be {}, got {}", Sentence("{} and {}", ("> 0", "< 9 mm")), 10)
    assert str(inner) == "size must be > 0 and < 9 mm, got 10" and inner.key == "size"
    outer = InputError("", "{} cannot be meshed: {}", "Face1", inner)
    assert str(outer) == f"Face1 cannot be meshed: {inner}"
    assert of_error(outer).values[1] is inner.sentence
    assert of_error(ZeroDivisionError()).english == "ZeroDivisionError"
    assert of_error(ValueError("a {brace}")).english == "a {brace}"

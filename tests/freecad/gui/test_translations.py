"""German and French: the compiled files hold what the sources say, and the window speaks it."""
import glob
import os
import re
import string
import sys

import advlayers
import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from advlayers import check, mesh_data
from advlayers.language import tr
from advlayers.sentence import Sentence, of_diagnostic
from window import ROOT, child, edit, events, panel_of, press_cancel

sys.path.append(os.path.join(ROOT, "docs"))
import make_translations  # noqa: E402

SOURCES = sorted(glob.glob(os.path.join(make_translations.FOLDER, "advlayers_*.ts")))


def test_there_are_two_languages():
    assert [os.path.basename(path) for path in SOURCES] == ["advlayers_de.ts", "advlayers_fr.ts"]


@pytest.mark.parametrize("path", SOURCES, ids=os.path.basename)
def test_the_compiled_file_holds_every_translation(path):
    translator = QtCore.QTranslator()
    assert translator.load(path[:-len(".ts")] + ".qm")
    translations = make_translations.kept(path)
    for (context, source), translation in translations.items():
        assert translator.translate(context, source) == translation
    assert [text for text in make_translations.texts() if text not in translations] == []


def fields(text):
    return sorted(str(field) for _text, field, _form, _conversion in string.Formatter().parse(text)
                  if field is not None)


@pytest.mark.parametrize("path", SOURCES, ids=os.path.basename)
def test_translations_keep_what_is_filled_in(path):
    for (_context, source), translation in make_translations.kept(path).items():
        assert fields(translation) == fields(source), source
        numbers = re.findall(r"\d+", source)
        assert sorted(re.findall(r"\d+", translation)) == sorted(numbers), source


def test_the_window_speaks_german():
    FreeCADGui.activateWorkbench("AdvancingLayersWorkbench")
    try:
        FreeCADGui.setLocale("German")
        events(0.2)
        assert tr("Stop") == "Anhalten"
        bar = FreeCADGui.getMainWindow().findChild(QtGui.QToolBar, "Advancing Layers")
        shown = {action.text() for action in bar.actions()}
        assert {"Netz aktualisieren", "Wand"} <= shown
        doc = "The object whose faces are meshed."
        assert FreeCAD.Qt.translate("App::Property", doc).startswith("Das Objekt")
    finally:
        FreeCADGui.setLocale("English")
        events(0.2)
    assert tr("Stop") == "Stop"


def forms_of(sentence):
    """Its own and those of the sentences within it, as far as they have a word."""
    found = {sentence.form} if any(letter.isalpha() for letter in sentence.form) else set()
    return found.union(*(forms_of(value) for value in sentence.values
                         if isinstance(value, Sentence)))


@pytest.mark.parametrize("language, words", (
    ("German", "Schichten von 30"), ("French", "couches complètes sur 30")))
def test_what_the_mesher_has_to_say_is_translated(box, language, words):
    mesh = advlayers.make_layer_mesh(
        box, size=2.0, layers=30, walls=[{"edges": ["Edge1"]}], match=["Edge5", "Edge9"])
    assert mesh.Messages and all(" (" in text for text in mesh.Messages)  # in English, with a code
    FreeCADGui.setLocale(language)
    try:
        found = check.check(mesh)
        assert any(words in finding.text for finding in found)
        report = mesh_data.of_object(mesh).report
        forms = {text for _context, text in make_translations.texts()}
        for entry in report["diagnostics"]:
            sentence = of_diagnostic(entry)
            assert sentence.english == entry["text"]
            assert forms_of(sentence) <= forms
            assert sentence.translated != entry["text"]
    finally:
        FreeCADGui.setLocale("English")
        events()
    assert any("layers of 30" in finding.text for finding in check.check(mesh))


def cut_off(page):
    """Fields of settings that reach over the page's edge, or have no room for a number."""
    fields = [widget for widget in page.findChildren(QtGui.QWidget) if widget.isVisible()
              and re.match("(LayerMesh|Wall|Size)_", widget.objectName())]
    return [field.objectName() for field in fields
            if field.mapTo(page, QtCore.QPoint(field.width(), 0)).x() > page.width()
            or (isinstance(field, QtGui.QAbstractSpinBox)
                and field.width() < field.fontMetrics().boundingRect("0.0000").width() + 20)]


@pytest.mark.parametrize("language", ("English", "German", "French"))
def test_the_panel_is_as_wide_as_its_room(box, language):
    """Longer words would have the right side of every page cut off."""
    FreeCADGui.setLocale(language)
    try:
        mesh = advlayers.make_layer_mesh(box, size=3.0)
        advlayers.make_wall(mesh, ["Edge1"], first_height=0.2)
        edit(mesh)
        child(QtGui.QGroupBox, "AdvLayersAdvanced").setChecked(True)
        child(QtGui.QTableWidget, "AdvLayersConditions").selectRow(0)
        events()
        form = panel_of(mesh).form
        for page in range(3):
            child(QtGui.QTabWidget, "AdvLayersTabs").setCurrentIndex(page)
            events()
            assert form.visibleRegion().boundingRect().width() == form.width()
            assert cut_off(child(QtGui.QTabWidget, "AdvLayersTabs").currentWidget()) == []
        press_cancel()
    finally:
        FreeCADGui.setLocale("English")
        events()

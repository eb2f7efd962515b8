"""Every way in which meshing and its commands can fail says so: in the panel, or in one message of
a command, in words that the user understands, in the user's language."""
import re

import advlayers
import advlayers_core as core
import FreeCADGui
import pytest
from PySide import QtGui

from advlayers import layer_mesh
from advlayers.errors import CoreMissing
from advlayers.sentence import of_diagnostic
from advlayers.volume import fill
from advlayers_gui import mesh_task
from window import (
    answer_message, child, click, edit, events, panel_of, press_cancel, press_ok, run, select,
    status, wait_for)

# What is wrong, in the words of each language.
LANGUAGES = ("English", "German", "French")
LEFT_IN_ENGLISH = re.compile(
    r"\b(the|must|got|has|have|with|which|of|is|are|there|and|for|it|its|no|not|give|pick)\b")


@pytest.fixture(autouse=True)
def english_afterwards():
    yield
    FreeCADGui.setLocale("English")
    events()


def spoken(language, text):
    """The text, where it is in that language and says what it says as a sentence of a window."""
    assert len(text.split()) >= 3, text
    assert not re.search(r"Traceback|\{|\[Errno|first_height|initial_mesh", text), text
    if language != "English":
        assert not LEFT_IN_ENGLISH.search(re.sub(r"/\S+", "", text)), text  # paths have any words
    return text


@pytest.fixture
def mesh(box):
    made = opened(box)
    yield made
    if FreeCADGui.Control.activeDialog():
        press_cancel()


def opened(box):
    """A mesh with a wall of its own, its panel open."""
    made = advlayers.make_layer_mesh(box, size=3.0, mesh_now=False)
    advlayers.make_wall(made, ["Edge1"], first_height=0.2)
    edit(made)
    return made


def refusal(mesh_object, language):
    """What the panel says to Mesh."""
    click("AdvLayersMeshButton")
    wait_for(lambda: not panel_of(mesh_object).meshing)
    label = child(QtGui.QLabel, "AdvLayersStatus")
    assert label.isVisible() and "color" in label.styleSheet()  # said as an error
    assert FreeCADGui.Control.activeDialog() and mesh_object.FemMesh.NodeCount == 0
    return spoken(language, status())


def set_field(name, value):
    child(QtGui.QWidget, f"LayerMesh_{name}").setProperty("rawValue", value)


def no_size(_mesh):
    set_field("size", 0.0)


def tiny_size(_mesh):
    set_field("size", 1e-6)


def no_height(_mesh):
    set_field("first_height", 0.0)


def lost_face(mesh):
    mesh.Faces = ["Face99"]


def wall_of_nothing(mesh):
    mesh.WallList[0].References = []


def thickness_below_the_height(mesh):
    mesh.WallList[0].Thickness = 0.1


def rules_that_exclude_each_other(mesh):
    mesh.WallList[0].AspectRatio = 5.0


def wall_twice(mesh):
    advlayers.make_wall(mesh, ["Edge1"])


def wall_and_match(mesh):
    advlayers.make_wall(mesh, ["Edge1"], condition="Match")


def vertex_without_size(mesh):
    advlayers.make_size(mesh, ["Vertex1"], segments=3)


def refinement_in_words(_mesh):
    child(QtGui.QPlainTextEdit, "LayerMesh_refinements").setPlainText("somewhere here")


def no_part(mesh):
    mesh.Part = None


def part_without_faces(mesh):
    line = mesh.Document.addObject("Part::Line", "Line")
    mesh.Document.recompute()
    mesh.WallList = []
    mesh.Part = line


def initial_mesh_of_another_shape(mesh):
    other = mesh.Document.addObject("Part::Sphere", "Sphere")
    mesh.Document.recompute()
    mesh.InitialMesh = advlayers.make_layer_mesh(other, size=2.0, walls=())
    panel_of(mesh)._forms[1].load()


def initial_mesh_without_elements(mesh):
    mesh.InitialMesh = mesh.Document.addObject("Fem::FemMeshObject", "Empty")
    panel_of(mesh)._forms[1].load()


SPOILT = (
    (no_size, ("Size must be > 0 mm", "Elementgröße", "Taille")),
    (tiny_size, ("Size is too small", "zu klein", "trop petite")),
    (no_height, ("First height must be > 0 mm", "Erste Höhe", "Première hauteur")),
    (lost_face, ("Face99 is not there any more", "gibt es nicht mehr", "n'existe plus")),
    (wall_of_nothing, ("refers to nothing", "bezieht sich auf nichts", "ne se rapporte à rien")),
    (thickness_below_the_height, ("less than the first height", "geringer", "inférieure")),
    (rules_that_exclude_each_other, ("exclude each other", "schließen einander aus", "s'excluent")),
    (wall_twice, ("Edge1 is listed twice", "doppelt", "deux fois")),
    (wall_and_match, ("both Walls and Match", "sowohl unter Wände als auch unter Entlang",
                      "à la fois dans Parois et dans Suivre")),
    (vertex_without_size, ("surroundings of Vertex1", "Umgebung von Vertex1",
                           "environs de Vertex1")),
    (refinement_in_words, ("x y z size radius", "x y z Größe Radius", "x y z taille rayon")),
    (no_part, ("nothing to mesh", "nichts zu vernetzen", "rien à mailler")),
    (part_without_faces, ("no face to mesh", "keine Fläche", "pas de face")),
    (initial_mesh_of_another_shape, ("off the shape", "neben der Form", "de la forme")),
    (initial_mesh_without_elements, ("no surface elements", "keine Flächenelemente",
                                     "pas d'éléments de surface")),
)


@pytest.mark.parametrize("language, cases", (
    ("English", SPOILT), ("German", SPOILT[::2]), ("French", SPOILT[1::2])), ids=LANGUAGES)
def test_the_panel_says_what_is_wrong(box, language, cases):
    FreeCADGui.setLocale(language)
    for spoil, words in cases:
        mesh = opened(box)
        spoil(mesh)
        assert words[LANGUAGES.index(language)] in refusal(mesh, language), spoil.__name__
        press_cancel()
        for entry in box.Document.Objects:
            if entry is not box:
                box.Document.removeObject(entry.Name)


def test_the_panel_names_the_remedy_for_a_missing_core(mesh, monkeypatch):
    def missing():
        raise CoreMissing("the meshing core is not built for this FreeCAD (Python {}): run "
                          "\"./dev build\" in {} and start FreeCAD again ({})", "3", "here", "why")

    monkeypatch.setattr(mesh_task, "load_core", missing)
    FreeCADGui.setLocale("German")
    assert '"./dev build"' in refusal(mesh, "German")


def test_the_fault_of_a_face_is_translated():
    """The fault within the sentence is said in the user's language too."""
    entry = {"form": "{} is not meshed: {}", "values": [
        "Face1", {"form": "{} has no curve", "values": ["Edge7"]}]}
    FreeCADGui.setLocale("German")
    assert of_diagnostic(entry).english == "Face1 is not meshed: Edge7 has no curve"
    assert of_diagnostic(entry).translated == "Face1 wird nicht vernetzt: Edge7 hat keine Kurve"


# --- commands -------------------------------------------------------------------------------------

def messages(command):
    """The one message of a command in each language."""
    told = []
    for language in LANGUAGES:
        FreeCADGui.setLocale(language)
        seen = []
        answer_message(seen)
        run(command)
        wait_for(lambda: seen, 20.0)
        assert len(seen) == 1
        told.append(spoken(language, seen[0]))
    return told


@pytest.fixture
def finished(box):
    """A mesh of one face, which is not closed; selected."""
    made = advlayers.make_layer_mesh(box, size=5.0, faces=["Face1"])
    select((made, ""))
    return made


@pytest.fixture
def saving(monkeypatch):
    """Where the dialog of Export is told to write to."""
    def to(path):
        monkeypatch.setattr(QtGui.QFileDialog, "getSaveFileName",
                            lambda *_arguments: (str(path), ""))
    return to


def expect(texts, words):
    for text, expected in zip(texts, words):
        assert expected in text


def test_export_without_a_mesh(box, saving, tmp_path):
    select((advlayers.make_layer_mesh(box, mesh_now=False), ""))
    saving(tmp_path / "never.vtu")
    expect(messages("Export"), ("no mesh yet", "noch kein Netz", "pas encore"))


def test_export_where_nothing_can_be_written(finished, saving, tmp_path):
    target = tmp_path / "missing" / "mesh.vtu"
    saving(target)
    told = messages("Export")
    expect(told, ("cannot be written", "lässt sich nicht schreiben", "ne peut pas être écrit"))
    assert all(str(target) in text for text in told)


def test_filling_what_is_not_closed(finished):
    expect(messages("FillVolume"), ("is not closed", "nicht geschlossen", "pas fermé"))


def test_filling_without_gmsh(finished, monkeypatch):
    for program in ("gmsh", "python_with_netgen"):
        monkeypatch.setattr(fill, program, lambda: "")
    closed = advlayers.make_layer_mesh(finished.Part, size=4)
    select((closed, ""))
    expect(messages("FillVolume"), ("Neither Gmsh nor Netgen", "Weder Gmsh noch Netgen",
                                    "Ni Gmsh ni Netgen"))


def test_an_update_that_fails(finished):
    finished.Growth = 0.5
    expect(messages("Update"), ("Growth must be >= 1", "Wachstumsfaktor", "Croissance"))
    assert finished.QuadCount > 0  # the mesh before


def test_nothing_selected(box):
    FreeCADGui.Selection.clearSelection()
    expect(messages("LayerMesh"), ("Select the shape", "Wählen Sie", "Sélectionnez"))


def test_stopping_is_told(mesh):
    set_field("size", 0.3)
    FreeCADGui.setLocale("German")
    child(QtGui.QAbstractButton, "AdvLayersMeshButton").click()
    assert panel_of(mesh).meshing
    click("AdvLayersMeshButton")
    wait_for(lambda: not panel_of(mesh).meshing)
    assert status() == "Angehalten; das Netz ist das vorige."


def test_what_the_fields_round_stays_exact(box):
    """Numbers of a macro are not rounded by opening the panel and leaving it with OK."""
    made = advlayers.make_layer_mesh(box, size=3.123456789, first_height=0.0123456789,
                                     growth=1.234567, layers=2)
    advlayers.make_wall(made, ["Edge1"], first_height=0.0234567891)
    advlayers.update(made)
    edit(made)
    child(QtGui.QTableWidget, "AdvLayersConditions").selectRow(0)
    press_ok()
    assert (made.Size.Value, made.FirstHeight.Value, made.Growth) == (
        3.123456789, 0.0123456789, 1.234567)
    assert made.WallList[0].FirstHeight.Value == 0.0234567891
    assert made.State == layer_mesh.UP_TO_DATE


def test_a_field_holds_what_the_schema_allows(box):
    opened(box)
    growth = child(QtGui.QDoubleSpinBox, "LayerMesh_growth")
    (row,) = [row for row in core.schema()["mesh"] if row["key"] == "growth"]
    growth.setValue(2 * row["highest"])
    assert growth.value() == row["highest"]
    press_cancel()

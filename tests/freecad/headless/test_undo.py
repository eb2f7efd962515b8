"""Undo, redo and cancelled transactions: the mesh goes with the other properties."""
import advlayers
import FreeCAD
import pytest
from advlayers import layer_mesh, mesh_history


@pytest.fixture
def mesh():
    document = FreeCAD.newDocument("Undo")
    document.UndoMode = 1
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    made = advlayers.make_layer_mesh(box, size=5, first_height=0.5, layers=2)
    document.clearUndos()
    yield made
    FreeCAD.closeDocument(document.Name)


def mesh_with(mesh, size):
    FreeCAD.setActiveDocument(mesh.Document.Name)  # transactions are also those of the active one
    mesh.Document.openTransaction(f"size {size}")
    mesh.Size = size
    advlayers.update(mesh)
    mesh.Document.recompute()
    mesh.Document.commitTransaction()
    return mesh.FemMesh.Nodes


def whole(mesh):
    """Figures and mesh belong together, and the mesh is known to be up to date."""
    mesh.Document.recompute()
    return (mesh.QuadCount == mesh.FemMesh.QuadrangleCount
            and mesh.NodeCount == mesh.FemMesh.NodeCount
            and mesh.State == layer_mesh.UP_TO_DATE)


def test_undo_and_redo_of_several_meshes(mesh):
    nodes = [mesh.FemMesh.Nodes] + [mesh_with(mesh, size) for size in (4, 3, 2)]
    assert len({len(entry) for entry in nodes}) == 4
    for expected in nodes[-2::-1]:
        mesh.Document.undo()
        assert mesh.FemMesh.Nodes == expected and whole(mesh)
    for expected in nodes[1:]:
        mesh.Document.redo()
        assert mesh.FemMesh.Nodes == expected and whole(mesh)


def test_a_new_mesh_after_an_undo(mesh):
    first = mesh.FemMesh.Nodes
    mesh_with(mesh, 4)
    mesh.Document.undo()
    mesh_with(mesh, 3)
    mesh.Document.undo()
    assert mesh.FemMesh.Nodes == first and whole(mesh)
    mesh.Document.redo()
    assert mesh.Size.Value == 3 and whole(mesh)


def test_a_cancelled_transaction(mesh):
    before = mesh.FemMesh.Nodes
    mesh.Document.openTransaction("cancelled")
    for size in (4, 3):
        mesh.Size = size
        advlayers.update(mesh)
    mesh.Document.abortTransaction()
    assert mesh.FemMesh.Nodes == before and mesh.Size.Value == 5 and whole(mesh)


def test_undo_of_making_and_of_deleting(mesh):
    before, name = mesh.FemMesh.Nodes, mesh.Name
    document = mesh.Document
    document.openTransaction("delete")
    document.removeObject(name)
    document.commitTransaction()
    document.undo()
    assert document.getObject(name).FemMesh.Nodes == before and whole(document.getObject(name))
    document.openTransaction("make")
    made = advlayers.make_layer_mesh(document.Box, size=3).Name
    nodes = document.getObject(made).FemMesh.Nodes
    document.commitTransaction()
    document.undo()
    assert document.getObject(made) is None
    document.redo()
    assert document.getObject(made).FemMesh.Nodes == nodes and whole(document.getObject(made))


def test_undo_of_a_wall(mesh):
    document = mesh.Document
    document.openTransaction("wall")
    advlayers.make_wall(mesh, ["Edge1"], first_height=0.25)
    advlayers.update(mesh)
    document.commitTransaction()
    settings, nodes = layer_mesh.settings_of(mesh), mesh.FemMesh.Nodes
    document.undo()
    assert mesh.WallList == [] and whole(mesh)
    document.redo()
    assert layer_mesh.settings_of(mesh) == settings
    assert mesh.FemMesh.Nodes == nodes and whole(mesh)


def test_meshes_of_two_documents_do_not_mix(mesh):
    other = FreeCAD.newDocument("Other")
    try:
        other.UndoMode = 1
        box = other.addObject("Part::Box", "Box")
        box.Length = 50
        other.recompute()
        second = advlayers.make_layer_mesh(box, size=5)
        assert second.Name == mesh.Name
        kept = second.FemMesh.Nodes
        before = mesh.FemMesh.Nodes
        mesh_with(second, 4)
        mesh_with(mesh, 4)
        other.undo()
        assert second.FemMesh.Nodes == kept
        mesh.Document.undo()
        assert mesh.FemMesh.Nodes == before
    finally:
        FreeCAD.closeDocument(other.Name)


def test_meshes_beyond_what_all_may_take_are_lost_aloud(mesh, monkeypatch, capfd):
    """The last mesh but one is always kept; the others go, and the object says so."""
    monkeypatch.setattr(mesh_history, "_MOST", 1)
    sizes = (4, 3, 2)
    nodes = [mesh_with(mesh, size) for size in sizes]
    mesh.Document.undo()
    assert mesh.FemMesh.Nodes == nodes[1] and whole(mesh)
    capfd.readouterr()
    mesh.Document.undo()
    text = "".join(capfd.readouterr())
    assert f"{mesh.Label}: the mesh of this step is not kept any more" in text
    assert mesh.Size.Value == 4 and mesh.State == layer_mesh.NOT_MESHED
    assert mesh.FemMesh.NodeCount == mesh.NodeCount == mesh.QuadCount == 0
    advlayers.update(mesh)
    assert mesh.FemMesh.Nodes == nodes[0] and whole(mesh)


def test_redo_of_a_mesh_after_one_was_lost(mesh, monkeypatch):
    nodes = [mesh_with(mesh, size) for size in (4, 3)]
    monkeypatch.setattr(mesh_history, "_MOST", 1)
    mesh_with(mesh, 2)
    for _step in range(3):
        mesh.Document.undo()
    assert mesh.State == layer_mesh.NOT_MESHED and mesh.FemMesh.NodeCount == 0
    states = []
    for _step in range(3):
        mesh.Document.redo()
        mesh.Document.recompute()
        states.append(mesh.State == layer_mesh.NOT_MESHED or whole(mesh))
        assert (mesh.FemMesh.NodeCount == 0) == (mesh.State == layer_mesh.NOT_MESHED)
    assert all(states) and len(nodes) == 2


def test_a_freecad_that_does_not_let_its_mesh_be_filled_is_given_one():
    class Guarded:
        def __init__(self, *other):
            if other:
                raise ReferenceError("This object is immutable")

    class Holder:
        FemMesh, ViewObject = Guarded(), None

    holder, fem = Holder(), object()
    mesh_history._fill(holder, fem)
    assert holder.FemMesh is fem

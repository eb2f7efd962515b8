"""Meshes before and after, for undo, redo and cancelled transactions.

FreeCAD brings back every property of an undone transaction but the mesh: the copy that it keeps
shares the mesh with the object. So each mesh gets an id in a property that is brought back, and
once FreeCAD is done, an object whose id is not that of its mesh is given the mesh of that id.
"""
from __future__ import annotations

import uuid
from typing import Any, Callable, Dict, List, Tuple

import FreeCAD

from advlayers.fem_mesh import compact
from advlayers.window import draw_view, redraw_view

_Key = Tuple[str, str]  # names of document and object

# What the kept meshes may take, in all documents together, and what each node and each element of
# a mesh takes, measured with 200 000 of them [bytes].
_MOST, _OF_ENTITY = 2**30, 170

_kept: Dict[Tuple[_Key, str], Any] = {}  # object and id to FemMesh that it held, oldest first
_held: Dict[_Key, str] = {}  # the id of the mesh that the object holds
# That mesh as it was given. FreeCAD has made a copy of it; another one would keep the window
# waiting. Missing for a restored object.
_given: Dict[_Key, Any] = {}
_observers: List[Any] = []


def watch(document_object, on_lost: Callable[[Any], None]) -> None:
    """Takes note of the mesh that a new or restored object holds. `on_lost` is called with the
    object when an undo or a redo leads to a mesh that is not kept any more."""
    if not _observers:
        _observers.append(_Observer(on_lost))
        FreeCAD.addDocumentObserver(_observers[0])
    key = _key(document_object)
    _forget(key)
    _held[key] = document_object.MeshId


def store(document_object, fem) -> None:
    """Gives the object a new mesh. A window shows it in the next turn of its event loop."""
    document = document_object.Document
    if document.UndoMode:
        _keep(document_object)
        # No undo or redo goes back further; one for the transaction under way.
        _trim(_key(document_object), document.UndoCount + document.RedoCount + 1)
    _give(document_object, fem, uuid.uuid4().hex)
    document_object.MeshId = _held[_key(document_object)]


def _keep(document_object) -> None:
    key = _key(document_object)
    given = _given.pop(key, None)
    _kept[key, _held[key]] = compact(document_object.FemMesh) if given is None else given


def _trim(key: _Key, count: int) -> None:
    """Lets the oldest meshes go: those of the object beyond the count, and those of any beyond what
    all may take, but for the newest, which a cancelled transaction brings back."""
    own = [entry for entry in _kept if entry[0] == key]
    for entry in own[:max(len(own) - count, 0)]:
        del _kept[entry]
    while len(_kept) > 1 and sum(map(_size, _kept.values())) > _MOST:
        del _kept[next(iter(_kept))]


def _size(fem) -> int:
    return _OF_ENTITY * (fem.NodeCount + fem.FaceCount)


def _give(document_object, fem, name: str) -> None:
    _fill(document_object, fem)
    _held[_key(document_object)] = name
    if document_object.Document.UndoMode:
        _given[_key(document_object)] = fem


def _fill(document_object, fem) -> None:
    """An assignment copies the mesh and draws it in one step, and a window waits for both. Called
    once more, the constructor of the mesh that the object holds copies alone."""
    try:
        document_object.FemMesh.__init__(fem)
    except ReferenceError:  # as FreeCAD answers other changes of that mesh
        document_object.FemMesh = fem
    else:
        redraw_view(document_object)


def _key(document_object) -> _Key:
    return document_object.Document.Name, document_object.Name


def _forget(key: _Key) -> None:
    for entry in [entry for entry in _kept if entry[0] == key]:
        del _kept[entry]
    _given.pop(key, None)


class _Observer:
    """FreeCAD calls these once a transaction has been undone, redone or given up."""

    def __init__(self, on_lost: Callable[[Any], None]) -> None:
        self._on_lost = on_lost

    def slotUndoDocument(self, document) -> None:
        self._bring_back(document)

    def slotRedoDocument(self, document) -> None:
        self._bring_back(document)

    def slotAbortTransaction(self, document) -> None:
        self._bring_back(document)

    def slotDeletedDocument(self, document) -> None:
        for key in [key for key in _held if key[0] == document.Name]:
            _forget(key)
            del _held[key]

    def _bring_back(self, document) -> None:
        for key, held in list(_held.items()):
            document_object = document.getObject(key[1]) if key[0] == document.Name else None
            if document_object is None:
                continue
            if document_object.MeshId != held:
                self._exchange(document_object)
            else:
                draw_view(document_object)  # it may have been deleted before its turn came

    def _exchange(self, document_object) -> None:
        name = document_object.MeshId
        fem = _kept.pop((_key(document_object), name), None)
        if fem is None:
            self._on_lost(document_object)
            return
        _keep(document_object)
        _give(document_object, fem, name)
        document_object.purgeTouched()

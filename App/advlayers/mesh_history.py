"""Meshes before and after, for undo, redo and cancelled transactions.

FreeCAD brings back every property of an undone transaction but the mesh: the copy that it keeps
shares the mesh with the object. So each mesh gets an id in a property that is brought back, and
once FreeCAD is done, an object whose id is not that of its mesh is given the mesh of that id.
"""
from __future__ import annotations

import uuid
from typing import Any, Dict, List, Tuple

import FreeCAD

_Key = Tuple[str, str]  # names of document and object

_others: Dict[_Key, Dict[str, Any]] = {}  # id to FemMesh that the object held, oldest first
_held: Dict[_Key, str] = {}  # the id of the mesh that the object holds
# That mesh as it was given. FreeCAD has made a copy of it; another one would keep the window
# waiting. Missing for a restored object.
_given: Dict[_Key, Any] = {}
_observers: List[Any] = []


def watch(document_object) -> None:
    """Takes note of the mesh that a new or restored object holds."""
    if not _observers:
        _observers.append(_Observer())
        FreeCAD.addDocumentObserver(_observers[0])
    key = _key(document_object)
    _others[key] = {}
    _held[key] = document_object.MeshId
    _given.pop(key, None)


def store(document_object, fem) -> None:
    """Gives the object a new mesh."""
    document = document_object.Document
    if document.UndoMode:
        _keep(document_object)
        kept = _others[_key(document_object)]
        # No undo or redo goes back further; one for the transaction under way.
        while len(kept) > document.UndoCount + document.RedoCount + 1:
            del kept[next(iter(kept))]
    _give(document_object, fem, uuid.uuid4().hex)
    document_object.MeshId = _held[_key(document_object)]


def _keep(document_object) -> None:
    key = _key(document_object)
    given = _given.pop(key, None)
    _others[key][_held[key]] = document_object.FemMesh.copy() if given is None else given


def _give(document_object, fem, name: str) -> None:
    document_object.FemMesh = fem
    _held[_key(document_object)] = name
    if document_object.Document.UndoMode:
        _given[_key(document_object)] = fem


def _key(document_object) -> _Key:
    return document_object.Document.Name, document_object.Name


def _bring_back(document) -> None:
    for key, held in list(_held.items()):
        document_object = document.getObject(key[1]) if key[0] == document.Name else None
        if document_object is not None and document_object.MeshId != held:
            fem = _others[key].pop(document_object.MeshId, None)
            if fem is not None:
                _keep(document_object)
                _give(document_object, fem, document_object.MeshId)
                document_object.purgeTouched()


class _Observer:
    """FreeCAD calls these once a transaction has been undone, redone or given up."""

    def slotUndoDocument(self, document) -> None:
        _bring_back(document)

    def slotRedoDocument(self, document) -> None:
        _bring_back(document)

    def slotAbortTransaction(self, document) -> None:
        _bring_back(document)

    def slotDeletedDocument(self, document) -> None:
        for key in [key for key in _held if key[0] == document.Name]:
            del _held[key], _others[key]
            _given.pop(key, None)

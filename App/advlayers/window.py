"""What the window, where there is one, is told of a document object. Nothing else under App/ knows
of it; it makes itself known here when it starts."""
from __future__ import annotations

from typing import Any, Callable, Optional

_views: Optional[Callable[[], Any]] = None
_update_beside: Optional[Callable[[Any, Any], None]] = None


def register(views: Callable[[], Any], update: Callable[[Any, Any], None]) -> None:
    """`views` loads and gives what makes views of objects: attach_to(), show_mesh() and
    keep_all_faces(); `update` meshes while the window lives on."""
    global _views, _update_beside
    _views, _update_beside = views, update


def attach_view(document_object) -> None:
    """Gives the object our view provider where there is a window: files saved without one carry
    none, and FreeCAD restores the object without asking for it."""
    if _views:
        _views().attach_to(document_object)


def show_mesh(document_object) -> None:
    """Its first mesh takes the place of the shape in the window: both at once cover each other."""
    if _views:
        _views().show_mesh(document_object)


def can_update_beside() -> bool:
    return _update_beside is not None


def update_beside(document_object, task) -> None:
    """Meshes while the window lives on, once the recompute that asks for it is over."""
    if _update_beside:
        _update_beside(document_object, task)


def prepare_view(document_object) -> None:
    """Before a mesh is read from a file: it is drawn as soon as it is there."""
    if _views:
        _views().keep_all_faces(document_object)


def redraw_view(document_object) -> None:
    """In the next turn of the event loop: the mesh was changed without FreeCAD's notice."""
    if document_object.ViewObject is not None:
        document_object.ViewObject.Proxy.redraw()


def draw_view(document_object) -> None:
    """At once, if that is still to be done."""
    if document_object.ViewObject is not None:
        document_object.ViewObject.Proxy.draw()

"""What the window, where there is one, is told of a document object. Nothing else under App/
imports any of it."""
from __future__ import annotations

import FreeCAD


def attach_view(document_object) -> None:
    """Gives the object our view provider where there is a window: files saved without one carry
    none, and FreeCAD restores the object without asking for it."""
    if FreeCAD.GuiUp:
        from advlayers_gui import view_provider

        view_provider.attach_to(document_object)


def show_mesh(document_object) -> None:
    """Its first mesh takes the place of the shape in the window: both at once cover each other."""
    if FreeCAD.GuiUp:
        from advlayers_gui import view_provider

        view_provider.show_mesh(document_object)


def update_beside(document_object, task) -> None:
    """Meshes while the window lives on, once the recompute that asks for it is over."""
    from advlayers_gui import automatic_update

    automatic_update.ask(document_object, task)


def prepare_view(document_object) -> None:
    """Before a mesh is read from a file: it is drawn as soon as it is there."""
    if FreeCAD.GuiUp:
        from advlayers_gui import view_provider

        view_provider.keep_all_faces(document_object)


def redraw_view(document_object) -> None:
    """In the next turn of the event loop: the mesh was changed without FreeCAD's notice."""
    if document_object.ViewObject is not None:
        document_object.ViewObject.Proxy.redraw()


def draw_view(document_object) -> None:
    """At once, if that is still to be done."""
    if document_object.ViewObject is not None:
        document_object.ViewObject.Proxy.draw()

"""What every Python object behind a FreeCAD object has in common."""
from __future__ import annotations

import FreeCAD


class Stateless:
    """Saves nothing of its own: all data lies in properties.

    FreeCAD 0.20 calls the second pair, later versions the first.
    """

    def dumps(self):
        return None

    def loads(self, _state) -> None:
        return None

    def __getstate__(self):
        return None

    def __setstate__(self, _state) -> None:
        return None


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

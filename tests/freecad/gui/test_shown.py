"""What a document written without a window shows when one opens it."""
import shutil
import subprocess

import FreeCAD

from window import events

WITHOUT_WINDOW = """
import FreeCAD, Part, advlayers
document = FreeCAD.newDocument("Written")
box = document.addObject("Part::Box", "Box")
bare = document.addObject("Part::Cylinder", "Bare")
document.recompute()
advlayers.make_layer_mesh(box, size=3, first_height=0.5, layers=1)
layers = advlayers.layer_mesh.create(bare)
advlayers.make_wall(layers, ["Edge1"])
document.saveAs({path!r})
"""


def test_the_mesh_or_else_the_shape_is_shown(tmp_path):
    path = str(tmp_path / "written.FCStd")
    script = tmp_path / "write.py"
    script.write_text(WITHOUT_WINDOW.format(path=path))
    subprocess.run([shutil.which("freecadcmd"), str(script)], stdin=subprocess.DEVNULL,
                   stdout=subprocess.DEVNULL, timeout=120, check=True)
    document = FreeCAD.openDocument(path)
    try:
        events(0.2)
        shown = {entry.Name: entry.ViewObject.Visibility for entry in document.Objects}
        meshed, bare = document.Box, document.Bare
        assert not shown[meshed.Name] and shown[bare.Name]
        (mesh_of_box,) = [entry for entry in document.Objects
                          if getattr(entry, "Part", None) == meshed]
        assert shown[mesh_of_box.Name]
        (wall,) = [entry for entry in document.Objects if entry.Name.startswith("Wall")]
        assert shown[wall.Name]
    finally:
        FreeCAD.closeDocument(document.Name)

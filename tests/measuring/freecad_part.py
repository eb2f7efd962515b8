"""FreeCAD's Part module in Debian's own Python, where shapes are made."""
import sys

try:
    import FreeCAD
except ImportError:
    sys.path.append("/usr/lib/freecad-python3/lib")
    import FreeCAD
import Part

__all__ = ["FreeCAD", "Part"]

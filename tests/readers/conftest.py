import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
for part in ("App", os.path.join("mesher_core", "python"), os.path.join("tests", "python"),
             os.path.join("tests", "readers")):
    sys.path.insert(0, os.path.join(ROOT, part))

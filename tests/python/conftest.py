import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
for part in ("App", os.path.join("mesher_core", "python")):
    sys.path.insert(0, os.path.join(ROOT, part))

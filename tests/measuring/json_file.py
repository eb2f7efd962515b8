"""What a benchmark or a soak has measured, for programs to read."""
import json
import os
from typing import Any


def write_json(path: str, measured: Any) -> None:
    """Makes the folder where it is missing."""
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        json.dump(measured, stream, indent=1)

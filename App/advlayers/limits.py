"""What a mesh may take: refused beforehand, with the number and the setting that drives it."""
from __future__ import annotations

import os
from typing import Any, Dict, Mapping, Optional

from advlayers.errors import InputError
from advlayers.sentence import Sentence

KEYS = ("max_elements", "max_memory", "max_seconds")
# Where nothing is said: what people wait for, on the machine that it is.
_ELEMENTS, _SECONDS = 2_000_000, 600.0
_PART_OF_MEMORY = 0.8
_MANY = 200_000  # elements that are told before they are made


def machine_limits() -> Dict[str, float]:
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2 ** 20
    return {"max_elements": _ELEMENTS, "max_memory": _PART_OF_MEMORY * memory,
            "max_seconds": _SECONDS}


def check(core, model, core_settings, settings: Mapping[str, Any],
          context: Any = None) -> Optional[Sentence]:
    """What is to be said of a mesh of many elements before it is made. Raises InputError where the
    estimate passes a limit of the settings, or of the machine where they say 0."""
    found = core.estimate(model, core_settings, context)
    machine = machine_limits()
    for key, value in zip(KEYS, (found["elements"], found["megabytes"], found["seconds"])):
        most = settings[key] or machine[key]
        if value > most:
            raise InputError(
                found["driver"], "asks for some {} elements, {} MB and {} s; {} allows {}",
                f"{found['elements']:.2g}", f"{found['megabytes']:.2g}",
                f"{found['seconds']:.2g}", key, f"{most:.7g}")
    if found["elements"] <= _MANY:
        return None
    return Sentence("the mesh will have some {} elements", (f"{found['elements']:.2g}",))

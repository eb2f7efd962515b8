"""References in a document, by their names on the object that is meshed."""
from __future__ import annotations

from typing import Any, Iterable, List, Sequence, Tuple, Union

from advlayers import cad_input
from advlayers.errors import InputError
from advlayers.references import Picker

# "Face1", or an object and one or more of its names, as FreeCAD's selection gives them.
Reference = Union[str, Tuple[Any, Union[str, Sequence[str]]]]


def link_value(source, names: Iterable[str]) -> List[Tuple[Any, Tuple[str, ...]]]:
    """The value of an App::PropertyLinkSubList."""
    names = tuple(names)
    return [(source, names)] if names else []


def names_on(source, references: Iterable[Reference]) -> List[str]:
    """The names that `references` have on `source`, each once. What was picked on another object
    (a body's feature, a member of a part) is looked for at the same place of `source`.

    Raises InputError where it is not found there.
    """
    names: List[str] = []
    for reference in references:
        owner, subs = (source, reference) if isinstance(reference, str) else reference
        for sub in (subs,) if isinstance(subs, str) else subs:
            name = sub if owner is source else _place_on(source, owner, sub)
            if name not in names:
                names.append(name)
    return names


def _place_on(source, owner, sub: str) -> str:
    last = sub.rsplit(".", 1)[-1]
    if not last:
        raise InputError("references", "names all of {}: pick its faces or edges", owner.Label)
    if last.startswith("?"):
        return last
    theirs = Picker(cad_input.global_shape(owner))
    ours = Picker(cad_input.global_shape(source))
    wanted = theirs.pick(last)
    for pick in ours.all_like(last):
        if ours.same(wanted, pick):
            return pick.name
    raise InputError("references", "names {} of {}, which is no part of {}", last, owner.Label,
                     source.Label)

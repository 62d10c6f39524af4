"""Signatures of operations, scripts and functions, for ``help`` and editors."""

from __future__ import annotations

import inspect

_TYPES = {
    "bool": bool,
    "int": int,
    "real": float,
    "text": str,
    "vertex": int,
    "halfedge": int,
    "edge": int,
    "face": int,
}


class _Written:
    """A default as the program writes it."""

    def __init__(self, text):
        self.text = text

    def __repr__(self):
        return self.text


def _default(text):
    if text is None:
        return inspect.Parameter.empty
    if text in ("true", "false"):
        return text == "true"
    for convert in (int, float):
        try:
            return convert(text)
        except ValueError:
            pass
    return _Written(text)


def signature(parameters, options, result):
    """The signature of what takes a mesh, some parameters, and options by name."""
    kind = inspect.Parameter
    # The mesh goes by its place alone: a parameter may be called so, too.
    mesh = "mesh"
    while any(one.name == mesh for one in parameters):
        mesh = f"_{mesh}"
    all_of_it = [kind(mesh, kind.POSITIONAL_ONLY)]
    for one in parameters:
        is_late = _is_late(all_of_it, one.default)
        place = kind.KEYWORD_ONLY if is_late else kind.POSITIONAL_OR_KEYWORD
        annotation = _TYPES.get(one.type, one.type)
        made = kind("name", place, default=_default(one.default), annotation=annotation)
        # A name that Python has a keyword for, as `lambda`, is one as well, which `inspect` refuses.
        made._name = one.name
        all_of_it.append(made)
    all_of_it += [kind(name, kind.KEYWORD_ONLY, default=None) for name in options]
    annotation = inspect.Signature.empty if result is None else _TYPES.get(result, result)
    return inspect.Signature(all_of_it, return_annotation=annotation)


def _is_late(earlier, default):
    """Whether a parameter without a default comes behind one with a default."""
    empty = inspect.Parameter.empty
    late = any(one.kind is one.KEYWORD_ONLY for one in earlier)
    return late or (default is None and any(one.default is not empty for one in earlier))

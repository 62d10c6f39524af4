"""Programs: from files, from texts, and from other processes."""

from __future__ import annotations

import os

from ._hedgerow import Program, check_text
from .errors import ArgumentError

__all__ = ["check", "load", "program", "rebuild"]

#: Programs that came from other processes, by their texts: a worker compiles each once.
_KNOWN: dict = {}
_MOST_KNOWN = 64


def program(text, name="program.hedge"):
    """A program from a text, proved and compiled.

    ``name`` is what messages call it; files that it uses are looked for beside it.

    >>> import hedgerow
    >>> ops = hedgerow.program("script count_them() { print \\"{count(faces)} faces\\" }")
    >>> ops.count_them(hedgerow.Mesh.cube())
    6 faces
    Report({})
    """
    _expect_text(text, "`load` reads files")
    return Program._parse(name, text)


def load(path):
    """A program from a file, or from the library: ``load("std/remesh.hedge")``."""
    return Program._read(os.fspath(path))


def check(text, name="program.hedge"):
    """What is wrong or doubtful in a text, as dictionaries; empty if all is proved.

    >>> [found["code"] for found in check("op flip(e: edge) { }")][:1]
    ['missing-side']
    """
    _expect_text(text, "`check(open(path).read(), path)` checks a file")
    return check_text(name, text)


def _expect_text(text, advice):
    """Raises an exception unless something is the text of a program, not the path of one."""
    if not isinstance(text, str):
        raise TypeError(f"a program is a text, not {type(text).__name__}; {advice}")
    if text.endswith(".hedge") and "\n" not in text and not text.lstrip().startswith("//"):
        raise ArgumentError(f"`{text}` is a path, not the text of a program; {advice}", "wrong-argument")


def rebuild(texts):
    """The program of the texts of another one; the same texts give the same program again."""
    key = tuple(texts)
    found = _KNOWN.get(key)
    if found is None:
        while len(_KNOWN) >= _MOST_KNOWN:
            _KNOWN.pop(next(iter(_KNOWN)))
        found = _KNOWN[key] = Program._rebuild(texts)
    return found

"""Pictures of operations and meshes."""

from __future__ import annotations

import numbers
import os

from ._hedgerow import picture_sizes, write_file
from .errors import ArgumentError


def expect_size(name, size):
    """Raises an exception unless something is the size of a picture of a mesh."""
    least, most = picture_sizes()
    if not (isinstance(size, numbers.Real) and least <= size <= most):
        message = f"`{name}` is a number of pixels from {least} to {most}, not {size!r}"
        raise ArgumentError(message, "wrong-argument")


def _save(path, what, ending, content):
    """Writes a picture to a file of its kind: whole, or not at all."""
    path = os.fspath(path)
    if not str(path).lower().endswith(ending):
        message = f"the picture of {what} is a {ending} file, not `{path}`"
        raise ArgumentError(message, "wrong-argument")
    write_file(path, content)


class Diagram:
    """The picture of an operation, before and after. A notebook shows it."""

    def __init__(self, name, svg, text):
        self.name = name
        #: The picture as SVG.
        self.svg = svg
        #: The picture with characters.
        self.text = text

    def save(self, path):
        """Writes the SVG to an ``.svg`` file: whole, or not at all."""
        _save(path, "an operation", ".svg", self.svg.encode())

    def _repr_svg_(self):
        return self.svg

    def __str__(self):
        return self.text

    def __repr__(self):
        return f"<diagram of {self.name}>"


class Picture:
    """The picture of a mesh. A notebook shows it."""

    def __init__(self, png):
        #: The picture as PNG.
        self.png = png

    def save(self, path):
        """Writes the PNG to a ``.png`` file: whole, or not at all."""
        _save(path, "a mesh", ".png", self.png)

    def _repr_png_(self):
        return self.png

    def __repr__(self):
        return "<picture of a mesh>"


class Proof:
    """What is proved of an operation."""

    def __init__(self, told):
        #: Its name.
        self.op = told["op"]
        #: The level of the meshes that it is for: ``map``, ``surface`` or ``simple``.
        self.level = told["level"]
        #: The levels that a mesh keeps which has them.
        self.keeps = told["keeps"]
        #: For each rule what is proved of it.
        self.rules = told["rules"]
        #: The operations that it calls, if it is one in steps.
        self.calls = told["calls"]

    def __repr__(self):
        keeps = ", ".join(self.keeps) or "nothing more than a map"
        return f"<proof of {self.op}: for level {self.level}, keeps {keeps}>"

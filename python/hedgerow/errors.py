"""What can go wrong. The text of an error is what the command line shows."""

from __future__ import annotations

__all__ = [
    "ArgumentError",
    "BusyError",
    "Error",
    "FileError",
    "MeshError",
    "ProgramError",
    "RunError",
]


class Error(Exception):
    """Something was not done; the mesh is as it was, but after a :class:`RunError` of a script.

    ``code`` is the stable name of what is wrong (``hedgerow explain CODE`` tells more),
    ``diagnostics`` are dictionaries with ``code``, ``severity``, ``message``, ``file``, ``line``,
    ``column``, ``notes`` and ``fixes``.
    """

    def __init__(self, text, code="", diagnostics=(), report=None):
        super().__init__(text, code, list(diagnostics), report)
        self.code = code
        self.diagnostics = list(diagnostics)
        self.report = report

    def __str__(self):
        return self.args[0]


class ProgramError(Error):
    """A program is wrong, or not proved."""


class ArgumentError(Error, ValueError):
    """An argument does not fit the parameter."""


class MeshError(Error, ValueError):
    """Arrays or a file are no mesh, or a mesh is none that the operation is for."""


class RunError(Error, RuntimeError):
    """Something failed while it ran; ``report`` is what a script did so far."""


class FileError(Error, OSError):
    """A file cannot be read or written."""

    __str__ = Error.__str__


class BusyError(Error, RuntimeError):
    """The mesh is in use: something runs on it, here or in another thread."""

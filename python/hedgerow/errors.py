"""What can go wrong. The text of an error is what the command line shows.

Besides these there are Python's own: ``TypeError`` for a value of another type than the parameter,
``KeyError`` and ``AttributeError`` for a name that there is not, ``ValueError`` for a number out of the
range of what is made (``Mesh.icosphere(99)``) or for the truth of a live mask, and ``KeyboardInterrupt``
for Ctrl-C, which ends a script after the step that it is at.
"""

from __future__ import annotations

import errno
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import Report

__all__ = [
    "ArgumentError",
    "BusyError",
    "Error",
    "FileError",
    "MeshError",
    "MissingFileError",
    "ProgramError",
    "RunError",
]


class Error(Exception):
    """Something was not done; the mesh is as it was, except if what was called stopped midway: a script
    and a function keep what they did until then, and ``each`` what it applied.

    ``code`` is the stable name of what is wrong (``hedgerow explain CODE`` tells more),
    ``diagnostics`` are dictionaries with ``code``, ``severity``, ``message``, ``file``, ``line``,
    ``column``, ``notes`` and ``fixes``. ``applied`` is ``None``, but of an exception of ``each``, also of
    a ``KeyboardInterrupt``: a bool for each element, whether the operation was applied there.
    """

    applied: Any = None

    def __init__(
        self,
        text: str,
        code: str = "",
        diagnostics: Iterable[dict[str, Any]] = (),
        report: Report | None = None,
    ) -> None:
        super().__init__(text, code, list(diagnostics), report)
        self.code = code
        self.diagnostics = list(diagnostics)
        self.report = report

    def __str__(self) -> str:
        return self.args[0]


class ProgramError(Error):
    """A program is wrong, or not proved: of :func:`hedgerow.program` and :func:`hedgerow.load`. There is
    one diagnostic for each place."""


class ArgumentError(Error, ValueError):
    """An argument does not fit: one too many or missing, a number that is none of an element of this mesh
    or of one that has been erased, a value that is not finite, an array of another shape or length, a size
    of a picture that is out of range, a direction of view that is none."""


class MeshError(Error, ValueError):
    """Arrays or bytes are no mesh (``no-mesh``; the text names the first place, as an edge of three
    faces), or the mesh is none that the operation is for (``below-level``), or has an attribute of the
    same name with values of another type (``attribute-conflict``)."""


class RunError(Error, RuntimeError):
    """Something failed while it ran: an ``assert``, an operation that a script ``must`` apply and that
    refused, a division by zero, too large a number. An operation has done nothing then; a script and a
    function keep what they did so far, which ``report`` tells."""


class FileError(Error, OSError):
    """A file cannot be read or written, or what is in it is not a mesh; the text names the file and the
    line, and is the ``strerror``."""

    def __init__(
        self,
        text: str,
        code: str = "",
        diagnostics: Iterable[dict[str, Any]] = (),
        report: Report | None = None,
    ) -> None:
        super().__init__(text, code, diagnostics, report)
        # `OSError` has taken the arguments for those of its own.
        self.errno = errno.ENOENT if isinstance(self, FileNotFoundError) else None
        self.strerror = text
        del self.filename

    __str__ = Error.__str__


class MissingFileError(FileError, FileNotFoundError):
    """A :class:`FileError`: there is no such file, or no such folder to write to."""


class BusyError(Error, RuntimeError):
    """The mesh is in use: something runs on it, here or in another thread."""

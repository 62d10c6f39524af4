"""hedgerow: operations on halfedge meshes that are drawn before and after, proved, and run.

>>> import hedgerow
>>> mesh = hedgerow.Mesh.icosphere(2)
>>> report = hedgerow.std.remesh.remesh(mesh, target=0.2)
>>> report["split"].applied > 0
True

A program is a text, or a file; its operations, scripts and functions are attributes:

>>> ops = hedgerow.program('''
... /// Rotates an edge between two triangles by one corner.
... op flip(e: edge) {
...   before {
...     face f0: v0 -a-> v1 -b-> v2 -c-> v0
...     face f1: v1 -d-> v0 -g-> v3 -h-> v1
...     edge e: a | d
...   }
...   guard simple
...   after {
...     face f0: v3 -a-> v2 -c-> v0 -g-> v3
...     face f1: v2 -d-> v3 -h-> v1 -b-> v2
...     edge e: a | d
...   }
... }
... fn long(e: edge, most: real = 0.3) -> bool { length(e) > most }
... ''')
>>> can = ops.flip.can(mesh)
>>> edge = can.argmax()
>>> r = ops.flip(mesh, edge)
>>> bool(r), r.created, r.erased
(True, Elements(), Elements())
>>> can.dtype, ops.flip.why(mesh, edge)
(dtype('bool'), None)
>>> int(ops.long(mesh, most=0.4).sum())
0
"""

from __future__ import annotations

import importlib

from . import errors
from ._elements import ElementTable
from ._hedgerow import (
    Applied,
    Elements,
    Function,
    LiveMask,
    Op,
    Parameter,
    Program,
    Refused,
    Script,
)
from ._mesh import Mesh, Trial
from ._pictures import Diagram, Picture, Proof
from ._programs import check, load, program
from ._report import Count, Report
from .errors import (
    ArgumentError,
    BusyError,
    Error,
    FileError,
    MeshError,
    ProgramError,
    RunError,
)

__version__ = "0.1.0"

__all__ = [
    "Applied",
    "ArgumentError",
    "BusyError",
    "Count",
    "Diagram",
    "ElementTable",
    "Elements",
    "Error",
    "FileError",
    "Function",
    "LiveMask",
    "Mesh",
    "MeshError",
    "Op",
    "Parameter",
    "Picture",
    "Program",
    "ProgramError",
    "Proof",
    "Refused",
    "Report",
    "RunError",
    "Script",
    "Trial",
    "check",
    "errors",
    "load",
    "program",
    "std",
]


def __getattr__(name):
    # The library is read when it is wanted, and what needs more than numpy is not asked for before.
    if name in ("std", "gym"):
        return importlib.import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

"""Arrays of numpy as the compiled part takes and gives them."""

from __future__ import annotations

import itertools

import numpy as np

from .errors import ArgumentError, MeshError

_WIDTHS = {"vec2": (2,), "vec3": (3,), "vec4": (4,), "mat3": (3, 3), "mat4": (4, 4)}
_TYPES = {(): "real", (2,): "vec2", (3,): "vec3", (4,): "vec4", (3, 3): "mat3", (4, 4): "mat4"}


def shaped(numbers, width, single):
    """Rows of ``width`` numbers; matrices, which come column by column, as matrices."""
    if width in (9, 16):
        size = 3 if width == 9 else 4
        numbers = numbers.reshape(-1, size, size).swapaxes(1, 2)
    else:
        numbers = numbers.reshape(-1, width)
    numbers = np.ascontiguousarray(numbers)
    return numbers[0] if single else numbers


def frozen(array):
    """The array, which cannot be written: it is a copy, and what is written is set by name."""
    array.flags.writeable = False
    return array


def _wrong(message, error=ArgumentError):
    return error(message, "wrong-argument")


def coordinates(vertices, error=MeshError):
    """Coordinates of vertices as one row of numbers; two coordinates get a third, 0."""
    try:
        array = np.asarray(vertices)
    except ValueError as why:
        raise _wrong(f"vertices are rows of 3 numbers: {why}", error) from None
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise _wrong(f"vertices are rows of 3 numbers (or 2), not of shape {array.shape}", error)
    if array.dtype.kind not in "fiu":
        raise _wrong(f"vertices are numbers, not {array.dtype}", error)
    if array.shape[1] == 2:
        array = np.column_stack([array, np.zeros(len(array))])
    return np.ascontiguousarray(array, dtype=np.float64).reshape(-1)


def _too_large(array):
    """One of whole numbers that does not fit into 64 bits; ``None`` if all do, or some are none."""
    if array.dtype == object:
        all_whole = all(isinstance(one, (int, np.integer)) for one in array.flat)
        return next((one for one in array.flat if not -(2**63) <= one < 2**63), None) if all_whole else None
    most = array.max() if array.dtype.kind == "u" and array.size else 0
    return most if most > np.iinfo(np.int64).max else None


def _integers(array, what, error=MeshError, too_large=None):
    """Whole numbers in a row. ``too_large`` words the error about one that does not fit."""
    if (wrong := _too_large(array)) is not None:
        raise _wrong(too_large(wrong) if too_large else f"{what} are too large", error)
    if array.size and array.dtype.kind not in "iu":
        raise _wrong(f"{what} are whole numbers, not {array.dtype}", error)
    return np.ascontiguousarray(array, dtype=np.int64).reshape(-1)


def _corners(faces):
    """The corners of lists and arrays one after the other, whose types may differ."""
    what = "corners of faces"
    if all(isinstance(face, (list, tuple)) for face in faces):
        corners = list(itertools.chain.from_iterable(faces))
        types = set(map(type, corners))
        if not types.isdisjoint((bool, np.bool_)):
            raise _wrong(f"{what} are whole numbers, not bool", MeshError)
        if all(issubclass(one, (int, np.integer)) for one in types):
            try:
                return np.array(corners, dtype=np.int64)
            except OverflowError:
                raise _wrong(f"{what} are too large", MeshError) from None
        rows = [corners]
    else:
        rows = [_corners([face]) if isinstance(face, (list, tuple)) else face for face in faces]
    try:
        rows = [np.asarray(row) for row in rows]
    except ValueError:
        rows = [np.zeros((0, 0))]
    if any(row.ndim != 1 for row in rows):
        raise _wrong("faces are rows of corners, or lists of corners", MeshError)
    if len({row.dtype for row in rows}) > 1:
        # numpy would make reals of integers of which some have no sign.
        rows = [_integers(row, what) for row in rows]
    return _integers(np.concatenate(rows), what)


def polygons(faces):
    """Corners of faces one after the other, and where each face ends."""
    if isinstance(faces, memoryview) or hasattr(faces, "__array__"):
        faces = np.asarray(faces)
    if isinstance(faces, np.ndarray) and faces.dtype != object:
        array = faces
    else:
        faces = list(faces)
        try:
            lengths = np.fromiter((len(face) for face in faces), np.int64, len(faces))
        except TypeError:
            raise _wrong("faces are rows of corners, or lists of corners", MeshError) from None
        if len(faces) == 0 or (lengths != lengths[0]).any():
            return _corners(faces), np.cumsum(lengths)
        array = _corners(faces).reshape(len(faces), lengths[0])
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, 3)
    if array.ndim != 2:
        raise _wrong(f"faces are rows of corners, not of shape {array.shape}", MeshError)
    count, sides = array.shape
    return _integers(array, "corners of faces"), sides * np.arange(1, count + 1, dtype=np.int64)


def numbers(elements, kind, places):
    """Numbers of elements of a kind in a row; also those at which one bool for each place holds."""
    try:
        array = np.asarray(elements)
    except ValueError as why:
        raise _wrong(f"numbers of elements: {why}") from None
    if array.ndim != 1:
        raise _wrong(f"numbers of elements stand in a row, not in shape {array.shape}")
    if array.dtype == bool:
        if len(array) != places:
            raise _wrong(f"a mask of elements has {places} places, not {len(array)}")
        array = np.flatnonzero(array)
    too_large = f"there is no {kind} {{}}".format
    return _integers(array, "numbers of elements", ArgumentError, too_large)


def attribute(values, slots, ids, what):
    """Values of an attribute, one for each place or for each living element: one row of them, with
    zeros where none lives, and the name of their type."""
    try:
        array = np.asarray(values)
    except ValueError as why:
        raise _wrong(f"{what}: {why}") from None
    if _too_large(array) is not None:
        raise _wrong(f"{what} has a value that is too large")
    if array.dtype.kind not in "biuf":
        raise _wrong(f"{what} cannot have values of {array.dtype}: numbers and bools alone")
    shape = array.shape
    # One value for all of them, unless it is exactly one for each.
    if shape[:1] == (slots,):
        pass
    elif shape[:1] == (len(ids),):
        array = np.zeros((slots, *shape[1:]), array.dtype)
        array[ids] = values
    elif shape in _TYPES:
        array = np.broadcast_to(array, (slots, *shape))
    else:
        raise _wrong(
            f"{what} is of {len(ids)} elements (or {slots} places: the greatest number and one more), "
            f"not {shape[0]}"
        )
    of_one = array.shape[1:]
    if of_one not in _TYPES:
        raise _wrong(f"{what} cannot have values of shape {of_one}")
    kind = array.dtype.kind
    if of_one == () and kind == "b":
        return np.ascontiguousarray(array), "bool"
    if of_one == () and kind in "iu":
        return np.ascontiguousarray(array, dtype=np.int64), "int"
    if len(of_one) == 2:
        array = array.swapaxes(1, 2)
    return np.ascontiguousarray(array, dtype=np.float64).reshape(-1), _TYPES[of_one]


def of_column(numbers, word):
    """The array of a column: a value for each place."""
    if word in _WIDTHS:
        width = int(np.prod(_WIDTHS[word]))
        numbers = shaped(numbers, width, False)
    return frozen(numbers)

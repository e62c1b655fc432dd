"""Arrays that the module does not read as they are: other types, lists, indices. SPDX-License-Identifier: MIT"""
import os

import numpy as np

from ._core import Mesh
from ._hints import shown

_EXACT_BELOW = 2**53  # every whole number up to this one is a double


def _masked(values):
    """The place of the first masked element, as a tuple; None without one."""
    if isinstance(values, np.ma.MaskedArray):
        places = np.argwhere(np.ma.getmaskarray(values))
        return tuple(map(int, places[0])) if len(places) else None
    if isinstance(values, (list, tuple)):
        for i, value in enumerate(values):
            place = _masked(value) if isinstance(value, (list, tuple, np.ma.MaskedArray)) else None
            if place is not None:
                return (i, *place)
    return None


def unmasked(values, name):
    """np.asarray(values), which forgets the masks of masked arrays, or the array that has __dlpack__ alone.

    Raises ValueError for a masked element, and TypeError for an array on another device.
    """
    if hasattr(values, "__dlpack__") and not hasattr(values, "__array__"):
        device = values.__dlpack_device__()[0]
        if device != 1:
            raise TypeError(f"{name} is on another device (number {int(device)} of DLPack); it must be on the CPU")
        return np.from_dlpack(values)
    place = _masked(values)
    if place is not None:
        at = "[" + ", ".join(map(str, place)) + "]" if place else ""
        raise ValueError(f"{name}{at} is masked; leave its row out, or fill it in with numpy.ma's filled")
    return np.asarray(values)


def is_file_name(thing):
    return isinstance(thing, os.PathLike) or isinstance(thing, str) and bool(os.path.splitext(thing)[1])


def _no_numbers(values, name):
    """What is said of a thing that is no array of numbers."""
    names = () if isinstance(values, Mesh) else ("positions", "points", "vertices")
    own = next((own for own in names if hasattr(values, own)), None)
    return (f"{name} {shown(values)}; it must be real numbers" +
            (f", such as its .{own}; as_mesh takes the whole mesh" if own else "") +
            ("; read_mesh reads a mesh from a file" if is_file_name(values) else ""))


def elements(array):
    """The elements of an array, in a message about their type."""
    if array.dtype.kind in "US":
        return "strings" + (f", such as {array.flat[0].item()!r}" if array.size else "")
    return f"elements of type {array.dtype}"


def _converted(values, name):
    if isinstance(values, tuple) and hasattr(values, "positions"):  # a MeshFile
        raise TypeError(_no_numbers(values, name))
    try:
        return unmasked(values, name)
    except ValueError as error:  # rows of different lengths
        if _masked(values) is not None:
            raise
        raise ValueError(f"{name} is no array: {error}") from None


def _array(values, name):
    array = _converted(values, name)
    if array.ndim == 0 and array.dtype.kind not in "fiu" and not hasattr(values, "__float__"):
        raise TypeError(_no_numbers(values, name))
    if array.dtype.kind == "O":  # rows of different lengths too, for an old NumPy
        for item in array.flat:
            if not hasattr(item, "__float__"):
                raise TypeError(f"{name} has an element that {shown(item)}; its elements must be real numbers")
    elif array.dtype.kind not in "fiu":
        raise TypeError(f"{name} has {elements(array)}; they must be real numbers")
    return array


def exact_doubles(values, name):
    """The numbers as an array of float64, or as the array of float32 that they are, with the same values.

    Raises TypeError for what is no real number, and ValueError naming the first element that no double equals.
    """
    array = _array(values, name)
    if array.dtype.kind == "f" and array.dtype.itemsize in (4, 8) and array.dtype.isnative:
        return array  # as it is, without a copy: a memory-mapped file is one of these
    if array.dtype.kind == "f" and array.dtype.itemsize <= 8 or array.dtype.kind in "iu" and array.dtype.itemsize <= 4:
        return array.astype(np.float64)
    if array.dtype.kind in "iu" and (array.size == 0 or (array.max() <= _EXACT_BELOW and array.min() >= -_EXACT_BELOW)):
        return array.astype(np.float64)
    doubles = np.empty(array.shape)
    for place in np.ndindex(array.shape):
        number = array[place]
        if isinstance(number, np.integer):
            number = int(number)
        try:
            double = float(number)
        except OverflowError:
            double = np.inf
        if double != number and number == number:
            at = ", ".join(str(i) for i in place)
            raise ValueError(f"{name}[{at}] is {number}, which no double equals")
        doubles[place] = double
    return doubles


def places(several, count, what):
    """The places among `count` items that a mask or several whole numbers name, as int64 from 0 to count - 1."""
    array = None if isinstance(several, (tuple, str, bytes)) else unmasked(several, "the index")
    if array is not None and array.size == 0 and isinstance(several, list):
        array = array.astype(np.int64)
    if array is None or array.dtype.kind not in "biu" or array.ndim != 1:
        given = (type(several).__name__ if array is None or array.ndim == 0 else
                 f"an array of {array.dtype} of shape {array.shape}")
        raise TypeError(f"the index is {given}; it must be a whole number, a slice, a bool for each {what}, or several "
                        "whole numbers")
    if array.dtype.kind == "b":
        if len(array) != count:
            raise IndexError(f"the mask has {len(array)} bools; there must be one for each {what}, {count}")
        return np.flatnonzero(array).astype(np.int64)
    wrong = np.flatnonzero((array < -count) | (array >= count))
    if wrong.size:
        raise IndexError(f"there is no {what} {array[wrong[0]]}; there are {count}")
    array = array.astype(np.int64)
    return np.where(array < 0, array + count, array)


def indices(values, name, columns):
    """Whole numbers in [0, 2^32 - 2] as uint32 of shape (rows, columns), or (rows,) for 0 columns, without gaps."""
    array = _converted(values, name)
    if array.size == 0 and array.ndim <= 2:
        array = np.empty((0, columns) if columns else (0,), np.uint32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} has {elements(array)}; they must be whole numbers")
    wanted = (f"(n, {columns})", 2) if columns else ("(n,)", 1)
    if array.ndim != wanted[1] or columns and array.shape[1] != columns:
        raise ValueError(f"{name} has the shape {array.shape}; it must be {wanted[0]}")
    wrong = (array < 0) | (array > 2**32 - 2)
    if wrong.any():
        row = int(np.argmax(wrong.any(axis=1) if columns else wrong))
        raise ValueError(f"{name}[{row}] is {array[row].tolist()}; indices are in [0, 2^32 - 2]")
    return np.ascontiguousarray(array, np.uint32)

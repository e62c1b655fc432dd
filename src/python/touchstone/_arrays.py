"""Arrays that the module does not read as they are: other types, lists, indices. SPDX-License-Identifier: MIT"""
import numpy as np

_EXACT_BELOW = 2**53  # every whole number up to this one is a double


def _array(values, name):
    try:
        array = np.asarray(values)
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{name} is no array: {error}") from None
    if array.dtype.kind == "O":  # rows of different lengths too, for an old NumPy
        for item in array.flat:
            if not hasattr(item, "__float__"):
                found = type(item).__name__
                raise TypeError(f"{name} has an element of type {found}; its elements must be real numbers")
    elif array.dtype.kind not in "fiu":
        raise TypeError(f"{name} has elements of type {array.dtype}; they must be real numbers")
    return array


def exact_doubles(values, name):
    """The numbers as an array of float64 with the same values.

    Raises TypeError for what is no real number, and ValueError naming the first element that no double equals.
    """
    array = _array(values, name)
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


def indices(values, name, columns):
    """Whole numbers in [0, 2^32 - 2] as uint32 of shape (rows, columns), or (rows,) for 0 columns, without gaps."""
    array = np.asarray(values)
    if array.size == 0 and array.ndim <= 2:
        array = np.empty((0, columns) if columns else (0,), np.uint32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} has elements of type {array.dtype}; they must be whole numbers")
    wanted = (f"(n, {columns})", 2) if columns else ("(n,)", 1)
    if array.ndim != wanted[1] or columns and array.shape[1] != columns:
        raise ValueError(f"{name} has the shape {array.shape}; it must be {wanted[0]}")
    wrong = (array < 0) | (array > 2**32 - 2)
    if wrong.any():
        row = int(np.argmax(wrong.any(axis=1) if columns else wrong))
        raise ValueError(f"{name}[{row}] is {array[row].tolist()}; indices are in [0, 2^32 - 2]")
    return np.ascontiguousarray(array, np.uint32)

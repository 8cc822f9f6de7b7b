# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments as the arrays that the extension module takes. Each array is right, or an error names the row."""

from __future__ import annotations

import json
from operator import index as integer_of
from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from ._errors import CircleVoronoiError

Floats = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int32]

# Larger whole numbers need not be doubles.
_LARGEST_WHOLE = 2**53


def matrix(data: Any, columns: Sequence[str], name: str) -> Floats:
    """Return `data` as an array of doubles, one row for each item and one column for each name."""
    array = array_of(data, name)
    if array.size == 0 and array.ndim <= 2:
        return np.empty((0, len(columns)))
    if array.ndim == 2 and array.shape[1] == len(columns):
        return _doubles(array, columns)
    shape = f"(n, {len(columns)})"
    if array.ndim == 1 and array.dtype == object:
        # NumPy keeps rows of different lengths as objects.
        for row, item in enumerate(array):
            length = _length(item)
            if length != len(columns):
                raise CircleVoronoiError(
                    f"Row {row} of {name} has {_counted(length, 'number')}; expected {len(columns)}"
                    f" ({', '.join(columns)}).",
                    circle=row,
                )
    raise CircleVoronoiError(f"{name} has the shape {array.shape}; expected {shape}: {', '.join(columns)}.")


def column(data: Any, count: int | None, name: str) -> Floats:
    """Return `data` as a one-dimensional array of doubles; a single number is repeated `count` times."""
    array = array_of(data, name)
    if array.ndim == 0 and count is not None:
        array = np.full(count, array[()])
    if array.ndim != 1:
        raise CircleVoronoiError(f"{name} has the shape {array.shape}; expected (n,).")
    if count is not None and len(array) != count:
        raise CircleVoronoiError(f"{name} has {_counted(len(array), 'number')}; expected {count}.")
    return _doubles(array.reshape(-1, 1), [name])[:, 0] if len(array) > 0 else np.empty(0)


def rows_from(
    data: Any, first: Any, second: Any, r: Any, names: Sequence[str], call: str, radius: float | None = None
) -> Floats:
    """Return rows of three numbers: those of `data`, points with `r`, or columns. `radius` is the default of `r`."""
    if data is None and first is not None:
        if second is None:
            raise CircleVoronoiError(f"{names[0]} needs {names[1]}, an array of the same length.")
        data, first = first, None
    if first is not None:
        columns = ", ".join(f"{name}={name}" for name in names)
        sentence = f"{names[0]} names a column of a table; pass arrays as {call}({columns})."
        raise CircleVoronoiError(sentence, "badOption")
    if second is not None:
        head = column(data, None, names[0])
        radii = column(radius if r is None else r, len(head), names[2])
        return np.column_stack([head, column(second, len(head), names[1]), radii])
    if r is not None:
        points = matrix(data, names[:2], "places" if names[0] == "lon" else "points")
        return np.column_stack([points, column(r, len(points), names[2])])
    return matrix(data, names, "circles")


def finite_points(data: Any, name: str) -> Floats:
    """Return points as an array of shape (n, 2) without NaN and infinity."""
    points = matrix(data, ("x", "y"), name)
    finite = np.isfinite(points).all(axis=1)
    if not finite.all():
        row = int(np.argmin(finite))
        raise CircleVoronoiError(f"Row {row} of {name} is not finite: {tuple(points[row])}.", "nonFinite", row)
    return points


def point(data: Any, name: str) -> tuple[float, float]:
    """Return one finite point."""
    try:
        row = finite_points([data], name)[0]
    except CircleVoronoiError as error:
        raise CircleVoronoiError(f"{name} must be two finite numbers, x and y (got {data!r}).", error.code) from None
    return float(row[0]), float(row[1])


def indices(data: Any, name: str) -> Indices:
    """Return whole numbers as a one-dimensional array of 32-bit integers."""
    array = np.atleast_1d(array_of(data, name))
    if array.ndim != 1:
        raise CircleVoronoiError(f"{name} has the shape {array.shape}; expected (n,).")
    if array.size == 0:
        return np.empty(0, dtype=np.int32)
    are_whole = all(_integer(item) is not None for item in array) if array.dtype.kind == "O" else array.dtype.kind in "iu"
    if not are_whole or np.any(array < 0) or np.any(array > np.iinfo(np.int32).max):
        raise CircleVoronoiError(f"{name} must be whole numbers from 0.")
    return np.ascontiguousarray(array, dtype=np.int32)


def index(value: Any, count: int, name: str) -> int:
    """Return the index of one of `count` items."""
    number = _integer(value)
    if number is None:
        raise CircleVoronoiError(f"{name} must be a whole number (got {value!r}).")
    if not 0 <= number < count:
        raise CircleVoronoiError(f"{name} must be from 0 to {count - 1} (got {number}).")
    return number


def choice(value: Any, choices: Sequence[str], name: str) -> str:
    """Return one of the allowed words."""
    if not isinstance(value, str) or value not in choices:
        raise CircleVoronoiError(f"{name} must be one of {', '.join(choices)} (got {value!r}).", "badOption")
    return str(value)


def positive(value: Any, name: str) -> float:
    """Return a positive finite number, which is an option."""
    number = _number_option(value, name)
    if not (0 < number < np.inf):
        raise CircleVoronoiError(f"{name} must be a positive number (got {value!r}).", "badOption")
    return number


def optional_number(value: Any, name: str) -> float | None:
    """Return a number, which is an option, or None."""
    return None if value is None else _number_option(value, name)


def box(value: Any, name: str) -> list[float]:
    """Return least x and y, largest x and y as four numbers, which are an option."""
    try:
        numbers = column(value, None, name)
    except CircleVoronoiError:
        numbers = np.empty(0)
    if len(numbers) != 4:
        message = f"{name} must be four numbers: least x and y, largest x and y (got {value!r})."
        raise CircleVoronoiError(message, "badOption")
    return [float(number) for number in numbers]


def whole(value: Any, least: int, most: int, name: str) -> int:
    """Return a whole number in a range."""
    number = _integer(value)
    if number is None or not least <= number <= most:
        raise CircleVoronoiError(f"{name} must be a whole number from {least} to {most} (got {value!r}).", "badOption")
    return number


def mapping(value: Any, name: str) -> Mapping[Any, Any]:
    """Return a mapping."""
    if not isinstance(value, Mapping):
        raise CircleVoronoiError(f"{name} must be a mapping (got {value!r}).")
    return value


def json_object(value: Mapping[Any, Any]) -> str:
    """Return a JSON object. Numbers of NumPy become numbers, times ISO 8601 texts, and missing values null.

    Raises
    ------
    TypeError, ValueError, RecursionError
        The mapping has something else.
    """
    return json.dumps(_json_value(value), allow_nan=False)


def _json_value(value: Any) -> Any:
    # NaN and missing times differ from themselves; for NA of pandas, a comparison is NA.
    if type(value).__name__ == "NAType":
        return None
    if isinstance(value, Mapping):
        members = {_json_name(name): _json_value(item) for name, item in value.items()}
        if len(members) < len(value):
            raise ValueError("a name is repeated")
        return members
    if isinstance(value, (list, tuple)):
        return [_json_value(item) for item in value]
    if isinstance(value, np.ndarray):
        return [_json_value(item) for item in value] if value.ndim > 0 else _json_value(value[()])
    if isinstance(value, np.datetime64):
        return None if np.isnat(value) else str(value)
    if isinstance(value, (np.bool_, np.integer)):
        return value.item()
    if isinstance(value, (float, np.floating)):
        return float(value) if value == value else None
    if hasattr(value, "isoformat"):
        return value.isoformat() if value == value else None
    return value


def _json_name(name: Any) -> str:
    if isinstance(name, (str, int, np.integer)) and not isinstance(name, bool):
        return str(name)
    raise TypeError(f"the name {name!r} is neither a text nor a whole number")


def items_of(data: Any, name: str) -> list[Any]:
    """Return the items of an iterable. Exceptions of its iterator pass through."""
    if not hasattr(data, "__iter__") or isinstance(data, (str, bytes, memoryview)):
        raise CircleVoronoiError(f"{name} must be a sequence (got {type(data).__name__}).")
    return list(data)


def array_of(data: Any, name: str) -> npt.NDArray[Any]:
    """Return any array, buffer or iterable as an array of any type and shape."""
    try:
        return _array(data, name)
    except CircleVoronoiError:
        raise
    except (TypeError, ValueError, BufferError, NotImplementedError) as error:
        raise CircleVoronoiError(f"{name} must be an array of numbers (got {type(data).__name__}: {error}).") from error


def _number_option(value: Any, name: str) -> float:
    """Return a number, which is an option."""
    try:
        return float(column([value], 1, name)[0])
    except CircleVoronoiError:
        raise CircleVoronoiError(f"{name} must be a number (got {value!r}).", "badOption") from None


def _integer(value: Any) -> int | None:
    """Return a whole number; None if it is a truth value or something else."""
    if isinstance(value, (bool, np.bool_)):
        return None
    try:
        return integer_of(value)
    except TypeError:
        return None


def _array(data: Any, name: str) -> npt.NDArray[Any]:
    if isinstance(data, np.ma.MaskedArray):
        mask = np.broadcast_to(data.mask, data.shape)
        if mask.any():
            row = int(np.argwhere(mask)[0][0]) if mask.ndim > 0 else 0
            raise CircleVoronoiError(f"Row {row} of {name} is masked.", circle=row)
        return np.asarray(data.data)
    if data is None:
        raise CircleVoronoiError(f"{name} must be an array of numbers (got None).")
    # The items of a memory view of several dimensions cannot be listed.
    if isinstance(data, (np.ndarray, memoryview)) or hasattr(data, "__array__"):
        return np.asarray(data)
    if isinstance(data, (str, bytes)):
        raise CircleVoronoiError(f"{name} must be an array of numbers (got {data!r}).")
    items = list(data) if hasattr(data, "__iter__") else data
    try:
        array = np.asarray(items)
        # One text or complex number would turn all others into such.
        return array if array.dtype.kind in "fiub" else np.asarray(items, dtype=object)
    except ValueError:  # rows of different lengths, which newer versions of NumPy refuse
        rows = np.empty(len(items), dtype=object)
        rows[:] = items
        return rows


def _doubles(array: npt.NDArray[Any], columns: Sequence[str]) -> Floats:
    if array.dtype.kind in "fb":
        return np.ascontiguousarray(array, dtype=np.float64)
    if array.dtype.kind in "iu":
        large = (array > _LARGEST_WHOLE) | (array < -_LARGEST_WHOLE if array.dtype.kind == "i" else False)
        if np.any(large):
            row, place = np.argwhere(large)[0]
            raise CircleVoronoiError(
                f"Row {row}: {columns[place]} is {array[row, place]}, a whole number that is no double.", circle=int(row)
            )
        return np.ascontiguousarray(array, dtype=np.float64)
    result = np.empty(array.shape)
    for row, items in enumerate(array):
        for place, item in enumerate(items):
            result[row, place] = _number(item, row, columns[place])
    return result


def _length(item: Any) -> int:
    """Return the number of items of a row; 1 if it is no sequence."""
    try:
        return 1 if isinstance(item, (str, bytes)) else len(item)
    except (TypeError, ValueError):
        return 1


def _number(item: Any, row: int, name: str) -> float:
    if isinstance(item, (str, bytes, complex, np.complexfloating, np.datetime64, np.timedelta64)) or item is None:
        raise CircleVoronoiError(f"Row {row}: {name} is not a real number (got {item!r}).", circle=row)
    try:
        return float(item)
    except (TypeError, ValueError, OverflowError):
        raise CircleVoronoiError(f"Row {row}: {name} is not a number (got {item!r}).", circle=row) from None


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"

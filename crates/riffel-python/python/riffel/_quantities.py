"""What users write, as numbers and arrays in SI: checked, named, and copied only where it must be."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal, TypeAlias

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel import _riffel

Kind: TypeAlias = Literal["length", "speed", "frequency", "ratio", "mass", "force", "area"]
"""What a quantity measures."""

Floats: TypeAlias = npt.NDArray[np.float64]
Complexes: TypeAlias = npt.NDArray[np.complex128]

Quantity: TypeAlias = "float | str"
"""A number in SI or a string with its unit, such as "30 mm" or "80 km/h"."""

OR_ZERO = -float(np.finfo(np.float64).tiny)
"""The number that all others are above where zero is allowed."""

Quantities: TypeAlias = "float | str | Sequence[float | str] | npt.NDArray[Any] | xr.DataArray | Mapping[str, Any]"
"""One quantity, several, or a window ``{"min": ..., "max": ..., "points": ...}`` as in a case file."""


def scalar(value: Any, name: str, kind: Kind, *, least: float = 0.0) -> float:
    """One quantity above `least` in SI."""
    number = _number(value, name, kind)
    if not (np.isfinite(number) and number > least):
        raise ValueError(f"{name} is {value}, but must be finite and {_above(least)}")
    return number


def _above(least: float) -> str:
    return {0.0: "greater than zero", OR_ZERO: "zero or more"}.get(least, f"greater than {least}")


def _number(value: Any, name: str, kind: Kind) -> float:
    if isinstance(value, str):
        try:
            return _riffel.si(value, kind)
        except ValueError as error:
            raise ValueError(f"{name}: {error}") from None
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise ValueError(f"{name} is {value!r}, but must be a number in SI or a string with a unit")
    return float(value)


def is_scalar(value: Any) -> bool:
    """Whether it is one quantity and not an array of one."""
    return isinstance(value, (str, int, float, np.integer, np.floating))


def array(value: Any, name: str, kind: Kind, *, least: float = 0.0) -> Floats:
    """Quantities in SI as a contiguous array of one dimension; that of the user where it is one already."""
    if isinstance(value, Mapping):
        return window(value, name, kind)
    if is_scalar(value):
        return np.array([scalar(value, name, kind, least=least)])
    factor = 1.0
    if isinstance(value, xr.DataArray):
        factor = unit_factor(value, name, kind)
        value = value.values
    if isinstance(value, (list, tuple)) and any(isinstance(item, str) for item in value):
        value = np.array([_number(item, f"{name}[{index}]", kind) for index, item in enumerate(value)])
    numbers = real(value, name)
    if factor != 1.0:
        numbers = numbers * factor
    return checked(numbers, name, least)


def signed(value: Any, name: str, kind: Kind) -> Floats:
    """Quantities of either sign in SI; a window is one of an array."""
    if is_scalar(value):
        value = [value]
    if isinstance(value, (list, tuple)):
        value = np.array([_number(item, f"{name}[{index}]", kind) for index, item in enumerate(value)])
    return array(value, name, kind, least=-np.inf)


def real(value: Any, name: str, *, dimensions: int = 1) -> Floats:
    """Real numbers as a contiguous array, without a copy where it is one already."""
    try:
        numbers = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name} is no array of numbers: {error}") from None
    if numbers.dtype == bool or not (
        np.issubdtype(numbers.dtype, np.floating) or np.issubdtype(numbers.dtype, np.integer)
    ):
        raise ValueError(f"{name} has the dtype {numbers.dtype}, but must be real numbers")
    if numbers.ndim != dimensions:
        counted = "one dimension" if dimensions == 1 else f"{dimensions} dimensions"
        raise ValueError(f"{name} has {numbers.ndim} dimensions, but must have {counted}")
    if numbers.size == 0:
        raise ValueError(f"{name} is empty, but must have a value")
    return np.ascontiguousarray(numbers, dtype=np.float64)


def checked(numbers: Floats, name: str, least: float) -> Floats:
    """Numbers that are all finite and above `least`."""
    wrong = ~(np.isfinite(numbers) & (numbers > least))
    if wrong.any():
        index = int(np.flatnonzero(wrong)[0])
        raise ValueError(f"{name}[{index}] is {numbers[index]}, but must be finite and {_above(least)}")
    return numbers


def unit_factor(values: xr.DataArray, name: str, kind: Kind) -> float:
    """SI units in one unit of the attribute ``units``; 1 where there is none."""
    units = values.attrs.get("units")
    if units is None or units in ("", "1"):
        if units is not None and kind != "ratio":
            raise ValueError(f"{name} has units \"{units}\", but must be a {kind}")
        return 1.0
    try:
        return _riffel.si(f"1 {units}", kind)
    except ValueError as error:
        raise ValueError(f"{name} has units \"{units}\": {error}") from None


def window(value: Mapping[str, Any], name: str, kind: Kind) -> Floats:
    """The equally spaced values of a window as the case file writes it."""
    low, high, points = limits(value, name, kind)
    return _riffel.axis(low, high, points)


def limits(value: Mapping[str, Any], name: str, kind: Kind) -> tuple[float, float, int]:
    """Ends and number of values of a window."""
    if set(value) != {"min", "max", "points"}:
        raise ValueError(f"{name} has the keys {sorted(value)}, but must have min, max and points")
    points = value["points"]
    if isinstance(points, bool) or not isinstance(points, (int, np.integer)):
        raise ValueError(f"{name}.points is {points!r}, but must be a whole number")
    low = scalar(value["min"], f"{name}.min", kind)
    high = scalar(value["max"], f"{name}.max", kind)
    return low, high, int(points)


def spaced(value: Any, name: str, kind: Kind) -> tuple[float, float, int]:
    """Ends and number of equally spaced values."""
    if isinstance(value, Mapping):
        return limits(value, name, kind)
    values = array(value, name, kind)
    if values.size < 2:
        raise ValueError(f"{name} has one value, but a ridge is searched between two or more")
    steps = np.diff(values)
    # To the rounding of positions that were written with nine digits.
    if not np.allclose(steps, steps.mean(), rtol=1e-6, atol=0.0) or steps[0] <= 0.0:
        raise ValueError(f"{name} must rise in equal steps, or be a window with min, max and points")
    return float(values[0]), float(values[-1]), int(values.size)

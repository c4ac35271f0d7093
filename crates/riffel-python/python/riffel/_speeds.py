"""Speeds of the traffic, as users write them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel._quantities import Quantity, array, is_scalar, scalar

Speeds: TypeAlias = "Quantity | tuple[Quantity, Quantity] | Sequence[Any] | npt.NDArray[Any] | xr.DataArray"
"""A speed, a range from one to another as a pair or "60 km/h..90 km/h", or a list of these."""


def ranges(speed: Speeds, name: str = "speed") -> list[str]:
    """Speeds and ranges in m/s as a question has them, each as common as any other."""
    if isinstance(speed, str) and ".." in speed:
        first, last = speed.split("..", 1)
        return [_range(first.strip(), last.strip(), name)]
    if is_scalar(speed):
        return [f"{scalar(speed, name, 'speed')!r} m/s"]
    if isinstance(speed, tuple):
        if len(speed) != 2:
            raise ValueError(f"{name} is a tuple of {len(speed)}, but a range is (slowest, fastest); several speeds are a list")
        slowest, fastest = speed
        return [_range(slowest, fastest, name)]
    if isinstance(speed, (np.ndarray, xr.DataArray)):
        return [f"{value!r} m/s" for value in array(speed, name, "speed").tolist()]
    if not isinstance(speed, list):
        raise ValueError(f"{name} is of type {type(speed).__name__}, but must be a speed, a range or a list of these")
    if not speed:
        raise ValueError(f"{name} is empty, but must have a value")
    return [found for index, one in enumerate(speed) for found in ranges(one, f"{name}[{index}]")]


def _range(slowest: Any, fastest: Any, name: str) -> str:
    low, high = scalar(slowest, f"{name}[0]", "speed"), scalar(fastest, f"{name}[1]", "speed")
    if low > high:
        raise ValueError(f"{name} is {slowest} to {fastest}, but must be from the slower to the faster")
    return f"{low!r} m/s..{high!r} m/s"

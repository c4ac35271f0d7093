"""Runs of a train whose axle boxes were listened to."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import TypeAlias

import numpy.typing as npt
import xarray as xr

from riffel._quantities import Floats, Quantities, Quantity, array, is_scalar, real, scalar

AxleBoxRun: TypeAlias = (
    "str | os.PathLike[str] | Sequence[str | os.PathLike[str]] | Mapping[str, npt.ArrayLike] | npt.ArrayLike | xr.DataArray"
)
"""A file, several files, or accelerations in m/s² of one channel or of several by name."""


def checked_run(run: AxleBoxRun) -> list[str] | list[tuple[str, Floats]]:
    """Paths, or channels by name."""
    if isinstance(run, (str, os.PathLike)):
        return [os.fspath(run)]
    if isinstance(run, Mapping):
        return [(str(name), real(values, f"run[{name!r}]")) for name, values in run.items()]
    if isinstance(run, (list, tuple)) and run and all(isinstance(one, (str, os.PathLike)) for one in run):
        return [os.fspath(path) for path in run]
    return [("rail", real(run, "run"))]


def checked_place(
    run: list[str] | list[tuple[str, Floats]],
    rate: Quantity | None,
    speed: Quantities | None,
    odometer: Quantities | None,
) -> tuple[float | None, tuple[float | None, Floats | None, Floats | None]]:
    """Samples per second, and constant speed, speeds or odometer."""
    of_files = isinstance(run[0], str)
    if not of_files:
        if rate is None:
            raise ValueError("rate is missing: arrays have no times, give the samples per second")
        if (speed is None) == (odometer is None):
            raise ValueError("speed and odometer: give one of the two")
    elif odometer is not None or not (speed is None or is_scalar(speed)):
        raise ValueError("a speed for each sample and an odometer go with arrays; files have columns of their own")
    per_second = None if rate is None else scalar(rate, "rate", "frequency")
    if odometer is not None:
        return per_second, (None, None, real(odometer, "odometer"))
    if speed is None:
        return per_second, (None, None, None)
    if is_scalar(speed):
        return per_second, (scalar(speed, "speed", "speed"), None, None)
    return per_second, (None, array(speed, "speed", "speed", least=-float("inf")), None)

"""Runs of a train whose axle boxes were listened to."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import TypeAlias

import numpy.typing as npt
import xarray as xr

from riffel import _riffel
from riffel._quantities import Floats, Quantities, Quantity, array, is_scalar, real, scalar

AxleBoxRun: TypeAlias = (
    "str | os.PathLike[str] | Sequence[str | os.PathLike[str]] | Mapping[str, npt.ArrayLike] | npt.ArrayLike | xr.DataArray"
)
"""A file, several files, or accelerations in m/s² of one channel or of several by name."""


def run_in_question(
    run: AxleBoxRun, rate: Quantity | None, speed: Quantities | None, odometer: Quantities | None
) -> list[str] | _riffel.AxleBoxRun:
    """Files of a run, or its arrays in their place."""
    if isinstance(run, (str, os.PathLike)):
        run = [run]
    if isinstance(run, (list, tuple)) and run and all(isinstance(one, (str, os.PathLike)) for one in run):
        if odometer is not None or not (speed is None or is_scalar(speed)):
            raise ValueError("a speed for each sample and an odometer go with arrays; files have columns of their own")
        return [os.fspath(path) for path in run]
    if isinstance(run, Mapping):
        channels = [(str(name), real(values, f"run[{name!r}]")) for name, values in run.items()]
    else:
        channels = [("rail", real(run, "run"))]
    if rate is None:
        raise ValueError("rate is missing: arrays have no times, give the samples per second")
    if (speed is None) == (odometer is None):
        raise ValueError("speed and odometer: give one of the two")
    place: float | Floats | tuple[Floats]
    if odometer is not None:
        place = (real(odometer, "odometer"),)
    elif is_scalar(speed):
        place = scalar(speed, "speed", "speed")
    else:
        place = array(speed, "speed", "speed", least=-float("inf"))
    return _riffel.AxleBoxRun(channels, scalar(rate, "rate", "frequency"), place)

"""Records of a rail that users give: a file, heights or spectra."""

from __future__ import annotations

import datetime
import os
from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel import _riffel
from riffel._quantities import Quantity
from riffel._spectra import labels_of, levels_of
from riffel.roughness import Roughness, stretches_of

RailRecord: TypeAlias = (
    "npt.ArrayLike | xr.DataArray | xr.Dataset | Sequence[xr.DataArray] | Roughness | str | os.PathLike[str]"
)
"""Heights of a rail, a `Dataset` of the heights of several, one-third-octave spectra, or a file of either."""

Levels: TypeAlias = "xr.DataArray | Sequence[xr.DataArray] | str | os.PathLike[str]"
"""One-third-octave spectra, or a file of spectra or of a profile."""

Date: TypeAlias = "str | datetime.date"
"""A date, or its text as in 2026-01-31 or 31.01.2026."""


def record_in_question(record: RailRecord, name: str, spacing: Quantity | None) -> str | _riffel.Record:
    """A record under its name in a question: a file, or what is in memory."""
    if isinstance(record, (str, os.PathLike)):
        return os.fspath(record)
    if isinstance(record, Roughness):
        record = record.spectra if record.profile is None else record.profile
    spectra = checked_spectra(record, name)
    if spectra is not None:
        return _riffel.Record(name, spectra)
    heights = {str(rail): record[rail] for rail in record} if isinstance(record, xr.Dataset) else {name: record}
    if not heights:
        raise ValueError(f"{name} is a Dataset without heights")
    rails = {rail: stretches_of(values, spacing, name=_called(name, rail)) for rail, values in heights.items()}
    steps = [step for _, step in rails.values()]
    if not np.allclose(steps, steps[0], rtol=1e-6, atol=0.0):
        raise ValueError(f"{name} has rails with different steps: {steps}")
    return _riffel.Record(name, (steps[0], [(rail, stretches) for rail, (stretches, _) in rails.items()]))


def _called(name: str, rail: str) -> str:
    return name if rail == name else f"{name}[{rail!r}]"


def checked_spectra(record: Any, name: str) -> list[Any] | None:
    """Labels, wavelengths and levels of spectra; None where it is something else."""
    if isinstance(record, xr.DataArray) and "wavelength" in record.dims:
        return [(labels_of(record), levels_of(record, name))]
    if isinstance(record, (list, tuple)) and record and all(isinstance(one, xr.DataArray) for one in record):
        return [(labels_of(one), levels_of(one, f"{name}[{index}]")) for index, one in enumerate(record)]
    return None


def levels_in_question(record: Levels, name: str) -> str | _riffel.Record:
    """The same where heights alone are not enough."""
    if not isinstance(record, (str, os.PathLike)) and checked_spectra(record, name) is None:
        raise ValueError(
            f"{name} is of type {type(record).__name__}, but must be a DataArray over wavelength, a sequence of these or"
            " a file"
        )
    return record_in_question(record, name, None)

"""Results as `xarray` objects with units and long names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr
from xarray.backends import BackendArray
from xarray.core import indexing

from riffel._quantities import Complexes, Floats

WAVELENGTH = {"units": "m", "long_name": "wavelength of the corrugation"}
SPEED = {"units": "m/s", "long_name": "speed of the vehicle"}
FREQUENCY = {"units": "Hz", "long_name": "frequency"}
NORMALIZED = {"units": "1", "long_name": "W1/(mu P0 V xi0), growth where its real part is negative"}
GROWTH_RATE = {"units": "1", "long_name": "growth rate of the amplitude per passage of a wheel"}
CONVENTIONS = {"time_factor": "exp(+i omega t)", "braking": "positive"}


class GrowthRate(BackendArray):
    """The growth rate of a map: a factor times the real part of the normalised dissipation, taken when it is read.

    A map of a million points takes milliseconds; a second array of its size would cost as much again.
    """

    def __init__(self, normalized: Complexes, factor: float) -> None:
        self.normalized = normalized
        self.factor = factor
        self.shape = normalized.shape
        self.dtype = np.dtype(np.float64)

    def __getitem__(self, key: indexing.ExplicitIndexer) -> npt.NDArray[Any]:
        found: npt.NDArray[Any] = indexing.explicit_indexing_adapter(
            key, self.shape, indexing.IndexingSupport.BASIC, self._read
        )
        return found

    def _read(self, key: tuple[Any, ...]) -> npt.NDArray[Any]:
        rates: npt.NDArray[Any] = self.factor * self.normalized[key].real
        return rates


def coordinate(name: str, values: npt.ArrayLike, attributes: Mapping[str, Any]) -> xr.Variable:
    """A coordinate along the dimension of its own name."""
    return xr.Variable((name,), values, attributes)


def with_growth(growth: xr.Dataset, normalized: Complexes, factor: float) -> xr.Dataset:
    """The map with its values."""
    variables = growth.variables
    variables["normalized_dissipation"].data = normalized
    variables["growth_rate"].data = indexing.LazilyIndexedArray(GrowthRate(normalized, factor))
    return growth


def growth_map(wavelength: Floats, speed: Floats, title: str | None) -> xr.Dataset:
    """A map over speed and wavelength, to which `with_growth` gives its values."""
    dimensions = ("speed", "wavelength")
    nothing = np.broadcast_to(np.complex128(0.0), (speed.size, wavelength.size))
    return xr.Dataset(
        {
            "normalized_dissipation": xr.Variable(dimensions, nothing, NORMALIZED),
            "growth_rate": xr.Variable(dimensions, nothing.real, GROWTH_RATE),
        },
        {"speed": coordinate("speed", speed, SPEED), "wavelength": coordinate("wavelength", wavelength, WAVELENGTH)},
        attributes(title),
    )


def attributes(title: str | None) -> dict[str, Any]:
    """Attributes of every result."""
    named = {"title": title} if title is not None else {}
    return {**named, **CONVENTIONS}

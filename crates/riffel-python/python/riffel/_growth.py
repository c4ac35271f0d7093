"""Growth as `xarray` objects: maps, ridges and their branches."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr
from xarray.backends import BackendArray
from xarray.core import indexing

from riffel import _datasets
from riffel._quantities import Complexes, Floats


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


def growth_map(
    wavelength: Floats, speed: Floats, normalized: Complexes, factor: float, title: str | None
) -> xr.Dataset:
    """A map over speed and wavelength."""
    dimensions = ("speed", "wavelength")
    return xr.Dataset(
        {
            "normalized_dissipation": xr.Variable(dimensions, normalized, _datasets.NORMALIZED),
            "growth_rate": xr.Variable(dimensions, growth_rate(normalized, factor), _datasets.GROWTH_RATE),
        },
        {
            "speed": _datasets.coordinate("speed", speed, _datasets.SPEED),
            "wavelength": _datasets.coordinate("wavelength", wavelength, _datasets.WAVELENGTH),
        },
        _datasets.attributes(title),
    )


def growth_rate(normalized: Complexes, factor: float) -> Any:
    """The growth rate of a map, as the data of a variable."""
    return indexing.LazilyIndexedArray(GrowthRate(normalized, factor))


def bay_maps(
    maps: Sequence[Complexes], factor: float, wavelength: Floats, speed: Floats, title: str | None
) -> xr.Dataset:
    """Maps over the places of the wheel in a sleeper bay."""
    places = [growth_map(wavelength, speed, values, factor, title).load() for values in maps]
    names = xr.Variable("place", ["over support", "mid-span", "mean"], {"long_name": "place of the wheel"})
    return xr.concat(places, xr.DataArray(names, name="place"), combine_attrs="override")


def ridge(
    found: tuple[Sequence[Floats], npt.NDArray[np.bool_], float | None], speeds: Floats, title: str | None
) -> xr.Dataset:
    """The ridge over speed."""
    (place, frequency, normalized, rate), edges, best = found
    edge = {"long_name": "whether a wavelength outside the window would grow faster"}
    attributes = _datasets.attributes(title)
    attributes["best_fit_frequency_hz"] = np.nan if best is None else best
    return xr.Dataset(
        {
            "wavelength": ("speed", place, _datasets.WAVELENGTH),
            "frequency": ("speed", frequency, _datasets.FREQUENCY),
            "normalized_dissipation_re": ("speed", normalized, _datasets.NORMALIZED),
            "growth_rate": ("speed", rate, _datasets.GROWTH_RATE),
            "at_edge": ("speed", edges, edge),
        },
        {"speed": ("speed", speeds, _datasets.SPEED)},
        attributes,
    )


def ridge_branches(found: Sequence[Any], speeds: Floats, title: str | None) -> xr.Dataset:
    """The branches of the ridge over branch and speed."""
    # A speed given twice has two rows of the same values.
    values = np.full((5, len(found), speeds.size), np.nan)
    edges = np.zeros((len(found), speeds.size), dtype=bool)
    for index, (_, columns, at_edge) in enumerate(found):
        place = {float(at): row for row, at in enumerate(columns[0])}
        rows = np.array([place.get(float(at), -1) for at in speeds])
        here = rows >= 0
        edges[index, here] = at_edge[rows[here]]
        for table, column in zip(values, columns, strict=True):
            table[index, here] = column[rows[here]]
    grid = ("branch", "speed")
    edge = {"long_name": "whether a wavelength outside the window would grow faster"}
    known = [entry for entry, _, _ in found]
    frequencies = [entry["frequency"] for entry in known]
    highest = [entry["growth_rate"] for entry in known]
    names = np.array([entry["mechanism"] or "" for entry in known], dtype=str)
    return xr.Dataset(
        {
            "wavelength": (grid, values[1], _datasets.WAVELENGTH),
            "frequency": (grid, values[2], _datasets.FREQUENCY),
            "normalized_dissipation_re": (grid, values[3], _datasets.NORMALIZED),
            "growth_rate": (grid, values[4], _datasets.GROWTH_RATE),
            "at_edge": (grid, edges, edge),
            "best_fit_frequency": ("branch", frequencies, _datasets.FREQUENCY),
            "highest_growth_rate": ("branch", highest, _datasets.GROWTH_RATE),
            "mechanism": ("branch", names, {"long_name": "resonance of the case that the branch follows"}),
        },
        {
            "branch": ("branch", np.arange(len(found)), {"long_name": "branch, the strongest first"}),
            "speed": ("speed", speeds, _datasets.SPEED),
        },
        _datasets.attributes(title),
    )


def on_irregular_supports(found: Sequence[list[float]], title: str | None) -> xr.Dataset:
    """Growth on supports at drawn distances, beside that on equal ones."""
    places, along, even, stand = found
    growth = {"units": "1", "long_name": "growth rate per passage"}
    shares = np.arange(len(even)) / len(even)
    return xr.Dataset(
        {
            "growth_rate": ("position", along, growth),
            "even_growth_rate": ("place_in_bay", even, {**growth, "long_name": "the same on equal supports"}),
            "support_position": ("support", stand, {"units": "m", "long_name": "where a support stands"}),
        },
        {
            "position": ("position", places, {"units": "m", "long_name": "place of the wheel"}),
            "place_in_bay": ("place_in_bay", shares, {"units": "1", "long_name": "place over the support spacing"}),
        },
        _datasets.attributes(title),
    )

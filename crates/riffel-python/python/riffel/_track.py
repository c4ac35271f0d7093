"""Receptances and decay rates of a track as `xarray` objects."""

from __future__ import annotations

from collections.abc import Sequence

import xarray as xr

from riffel import _datasets
from riffel._quantities import Complexes, Floats


def receptance(
    frequencies: Floats,
    joints: Sequence[tuple[str, str, Complexes]],
    resonances: Sequence[tuple[str, float, float]] | None,
    title: str | None,
) -> xr.Dataset:
    """Receptances of the joints of the loop over frequency."""
    attributes = _datasets.attributes(title)
    if resonances is not None:
        attributes["resonances"] = [name for name, _, _ in resonances]
        attributes["resonance_frequencies_hz"] = [place for _, place, _ in resonances]
    return xr.Dataset(
        {key: ("frequency", values, {"units": "m/N", "long_name": f"receptance, {name}"}) for key, name, values in joints},
        {"frequency": ("frequency", frequencies, _datasets.FREQUENCY)},
        attributes,
    )


def decay_rate(rates: Sequence[tuple[float, float, bool]]) -> xr.DataArray:
    """Decay rates over the one-third octaves of EN 15461."""
    return xr.DataArray(
        [rate for _, rate, _ in rates],
        {
            "frequency": ("frequency", [place for place, _, _ in rates], _datasets.FREQUENCY),
            "upper_bound": ("frequency", [bound for _, _, bound in rates]),
        },
        ("frequency",),
        "decay_rate",
        {"units": "dB/m", "long_name": "track decay rate"},
    )

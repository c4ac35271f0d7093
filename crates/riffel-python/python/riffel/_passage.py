"""A wheel along a rail in time, and a rail under many wheels, as `xarray` objects."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel import _datasets, _riffel
from riffel._quantities import Quantity, scalar
from riffel.roughness import stretches_of

_COURSE = {
    "height": ("m", "height of the rail, positive upward"),
    "normal_force": ("N", "normal force"),
    "tangential_force": ("N", "creep force"),
    "creepage": ("1", "creepage"),
    "dissipation": ("J/m", "energy dissipated in a metre, at the wheel centre"),
    "approach": ("m", "approach of wheel and rail, below zero their distance"),
}
_HARMONICS = {
    "normal_force_n": ("normal_force_harmonics", "N"),
    "tangential_force_n": ("tangential_force_harmonics", "N"),
    "creepage": ("creepage_harmonics", "1"),
    "dissipation_j_per_m": ("dissipation_harmonics", "J/m"),
}
_LEVEL = {"units": "dB re 1 µm", "long_name": "one-third-octave level"}


def checked_surface(
    profile: npt.ArrayLike | xr.DataArray | None,
    spacing: Quantity | None,
    sinusoid: Sequence[Quantity] | None,
) -> tuple[float, float] | tuple[float, float, Any]:
    """What the extension takes: amplitude and wavelength, or start, spacing and heights."""
    if (profile is None) == (sinusoid is None):
        raise ValueError("give either profile or sinusoid")
    if sinusoid is not None:
        if not isinstance(sinusoid, (tuple, list)) or len(sinusoid) != 2:
            raise ValueError(f"sinusoid is {sinusoid!r}, but must be an amplitude and a wavelength")
        if spacing is not None:
            raise ValueError("spacing is for a profile")
        amplitude, wavelength = sinusoid
        return scalar(amplitude, "sinusoid[0]", "length"), scalar(wavelength, "sinusoid[1]", "length")
    assert profile is not None
    stretches, step = stretches_of(profile, spacing, name="profile")
    if len(stretches) > 1 or stretches[0][1].size < np.size(profile):
        raise ValueError("profile has gaps: take a stretch without")
    start, heights = stretches[0]
    return start, step, heights


def simulate(
    case: _riffel.Case,
    surface: tuple[float, float] | tuple[float, float, Any],
    speed: float,
    step: float | None,
    contact_filter: bool,
    title: str | None,
) -> xr.Dataset:
    """One passage, or one wave of the settled state with its harmonics."""
    course, told = _riffel.simulate(case, surface, speed, step, contact_filter)
    harmonics = told.pop("harmonics", None)
    columns: dict[str, Any] = {
        name: ("position", course[name], {"units": unit, "long_name": words})
        for name, (unit, words) in _COURSE.items()
    }
    coordinates: dict[str, Any] = {
        "position": ("position", course["position"], {"units": "m", "long_name": "place of the wheel centre"})
    }
    if harmonics is not None:
        for key, (name, unit) in _HARMONICS.items():
            values = np.array([complex(*harmonic[key]) for harmonic in harmonics])
            words = f"{name.replace('_', ' ')} for exp(+i n omega t), means at n = 0"
            columns[name] = ("harmonic", values, {"units": unit, "long_name": words})
        coordinates["harmonic"] = ("harmonic", np.arange(len(harmonics)), {"units": "1", "long_name": "harmonic"})
    return xr.Dataset(columns, coordinates, {**_datasets.attributes(title), "speed": speed, **told})


def evolve(
    case: _riffel.Case,
    surface: tuple[float, float] | tuple[float, float, Any],
    periodic: bool,
    traffic: str | dict[str, Any] | tuple[float, float],
    passages: int,
    step: float | None,
    contact_filter: bool,
    title: str | None,
) -> xr.Dataset:
    """Levels and profiles over passages."""
    found, kept, heights, spacing, remarks = _riffel.evolve(
        case, surface, periodic, traffic, passages, step, contact_filter
    )
    stages, bands = found["stages"], found["bands"]

    def over_passages(key: str, unit: str, words: str) -> tuple[str, Any, dict[str, str]]:
        return "passages", np.array(stages[key], dtype=np.float64), {"units": unit, "long_name": words}

    def of_bands(key: str, unit: str, words: str) -> tuple[str, Any, dict[str, str]]:
        values = np.array([band[key] for band in bands], dtype=np.float64)
        return "wavelength", values, {"units": unit, "long_name": words}

    def of_both(key: str, attributes: dict[str, str]) -> tuple[tuple[str, str], Any, dict[str, str]]:
        return ("passages", "wavelength"), np.array([band[key] for band in bands]).T, attributes

    growth = "growth rate of the amplitude per passage"
    shift = "shift of the waves per passage, in the direction of travel"
    loss = "share of the time without contact of the passage before"
    pattern = {}
    if "support_pattern_level_db" in stages:
        words = "level of the waves that fit between two supports"
        pattern["support_pattern_level"] = over_passages("support_pattern_level_db", "dB re 1 µm", words)
    return xr.Dataset(
        {
            **pattern,
            "level": of_both("level_db", _LEVEL),
            "linear_level": of_both("linear_level_db", {**_LEVEL, "long_name": "level of the linear loop"}),
            "shift": of_both("shift_m", {"units": "m", "long_name": "shift of the waves, in the direction of travel"}),
            "first_growth_rate": of_bands("first_growth_per_passage", "1", f"{growth}, first step"),
            "linear_growth_rate": of_bands("first_linear_growth_per_passage", "1", f"{growth}, linear loop"),
            "last_growth_rate": of_bands("last_growth_per_passage", "1", f"{growth}, last quarter"),
            "saturation_level": of_bands("saturation_level_db", "dB re 1 µm", "level where growth has stopped"),
            "first_drift": of_bands("first_shift_m_per_passage", "m", f"{shift}, first step"),
            "linear_drift": of_bands("linear_shift_m_per_passage", "m", f"{shift}, linear loop"),
            "mean_depth": over_passages("mean_depth_m", "m", "depth worn off everywhere"),
            "contact_loss_fraction": over_passages("contact_loss_fraction", "1", loss),
            "minimum_normal_force": over_passages("minimum_normal_force_n", "N", "least normal force of that passage"),
            "maximum_normal_force": over_passages("maximum_normal_force_n", "N", "largest normal force of that passage"),
            "height": (("profile_passages", "position"), heights, {"units": "m", "long_name": "height of the ring"}),
        },
        {
            "passages": ("passages", np.array(stages["passages"]), {"units": "1", "long_name": "wheels so far"}),
            "wavelength": (
                "wavelength",
                np.array([band["wavelength_m"] for band in bands]),
                _datasets.WAVELENGTH,
            ),
            "profile_passages": ("profile_passages", np.array(kept), {"units": "1", "long_name": "wheels so far"}),
            "position": (
                "position",
                spacing * np.arange(heights.shape[1]),
                {"units": "m", "long_name": "position on the ring"},
            ),
        },
        {
            **_datasets.attributes(title),
            "speed": found["speed_m_per_s"],
            "step": found["step_m"],
            "remarks": remarks,
        },
    )

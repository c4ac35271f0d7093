"""A wheel along a rail in time, and a rail under many wheels, as `xarray` objects."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
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
    "lateral_force": ("N", "creep force across the rail"),
    "creepage": ("1", "creepage"),
    "lateral_creepage": ("1", "lateral creepage"),
    "dissipation": ("J/m", "energy dissipated in a metre, at the wheel centre"),
    "approach": ("m", "approach of wheel and rail, below zero their distance"),
}
_HARMONICS = {
    "normal_force_n": ("normal_force_harmonics", "N"),
    "tangential_force_n": ("tangential_force_harmonics", "N"),
    "lateral_force_n": ("lateral_force_harmonics", "N"),
    "creepage": ("creepage_harmonics", "1"),
    "lateral_creepage": ("lateral_creepage_harmonics", "1"),
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
    transient: bool,
    title: str | None,
) -> xr.Dataset:
    """One passage, or one wave of the settled state with its harmonics."""
    if transient and len(surface) != 2:
        raise ValueError("transient is for a sinusoid")
    course, told = _riffel.simulate(case, surface, speed, step, contact_filter, transient)
    energy = told.pop("energy_at_rail", None)
    harmonics, contacts = told.pop("harmonics", None), told.pop("contacts", None)
    columns, coordinates = _course(course)
    if harmonics is not None:
        for key, (name, unit) in _HARMONICS.items():
            if key not in harmonics[0]:
                continue
            rows = [harmonics] if contacts is None else [contact["harmonics"] for contact in contacts]
            values = np.array([[complex(*harmonic[key]) for harmonic in row] for row in rows])
            words = f"{name.replace('_', ' ')} for exp(+i n omega t), means at n = 0"
            where: tuple[str, ...] = ("harmonic",) if contacts is None else ("contact", "harmonic")
            columns[name] = (where, values[0] if contacts is None else values, {"units": unit, "long_name": words})
        if energy is not None:
            words = "energy at the rail harmonics for exp(+i n omega t), mean at n = 0"
            values = np.array([complex(*pair) for pair in energy])
            columns["energy_at_rail_harmonics"] = ("harmonic", values, {"units": "J/m", "long_name": words})
        coordinates["harmonic"] = ("harmonic", np.arange(len(harmonics)), {"units": "1", "long_name": "harmonic"})
    if contacts is not None:
        coordinates["contact"] = _contacts(contacts)
    return xr.Dataset(columns, coordinates, {**_datasets.attributes(title), "speed": speed, **told})


def on_smooth_rail(case: _riffel.Case, speed: float, step: float | None, title: str | None) -> xr.Dataset:
    """The end of what follows a push on a smooth rail, and its ranges."""
    course, found, remarks = _riffel.on_smooth_rail(case, speed, step)
    columns, coordinates = _course(course)
    contacts = found["contacts"]
    coordinates["contact"] = _contacts(contacts)
    coordinates["bound"] = ("bound", ["least", "largest"], {"long_name": "bound"})
    for key, (name, unit) in _HARMONICS.items():
        if key not in contacts[0]:
            continue
        values = np.array([contact[key] for contact in contacts])
        words = f"range of the {name.removesuffix('_harmonics').replace('_', ' ')} over the last half second"
        columns[name.replace("harmonics", "range")] = (("contact", "bound"), values, {"units": unit, "long_name": words})
    for name, unit, words in (
        ("stick_fraction", "1", "share of the time below the creepage of the greatest creep force"),
        ("mean_dissipation_j_per_m", "J/m", "mean energy dissipated in a metre"),
    ):
        columns[name.removesuffix("_j_per_m")] = _datasets.column("contact", contacts, name, unit, words)
    if len(contacts) == 1:
        for name in _COURSE:
            if name in columns and name != "height":
                _, values, attributes = columns[name]
                columns[name] = (("contact", "position"), values[np.newaxis], attributes)
    told = {
        "outcome": found["outcome"],
        "rolled": found["rolled_s"],
        # An attribute of a file cannot be nothing.
        "frequency": np.nan if found["frequency_hz"] is None else found["frequency_hz"],
        "linear_unstable_roots": found["linear_unstable_roots"],
        "linear_frequency": np.nan if found["linear_frequency_hz"] is None else found["linear_frequency_hz"],
        "remarks": remarks,
    }
    return xr.Dataset(columns, coordinates, {**_datasets.attributes(title), "speed": speed, **told})


def _course(course: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Columns and coordinates of one course, or of several contacts."""
    columns: dict[str, Any] = {
        name: (
            ("contact", "position") if course[name].ndim == 2 else "position",
            course[name],
            {"units": unit, "long_name": words},
        )
        for name, (unit, words) in _COURSE.items()
        if name in course
    }
    place = {"units": "m", "long_name": "place of the centre of the first wheel"}
    return columns, {"position": ("position", course["position"], place)}


def _contacts(contacts: Sequence[dict[str, Any]]) -> tuple[str, list[str], dict[str, str]]:
    """Names of contacts as a coordinate, such as "1 right"."""
    names = [f"{contact['wheel']} {contact['rail']}" for contact in contacts]
    return "contact", names, {"long_name": "wheel and rail"}


def evolve(
    case: _riffel.Case,
    surface: tuple[float, float] | tuple[float, float, Any],
    periodic: bool,
    traffic: _riffel.Traffic,
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

    of_bands = partial(_datasets.column, "wavelength", bands)

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

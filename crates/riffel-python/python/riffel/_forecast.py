"""Forecasts and comparisons as `xarray` objects."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
import xarray as xr

from riffel import _datasets
from riffel._quantities import OR_ZERO, Floats, array
from riffel._spectra import levels


def forecast(found: Mapping[str, Any], limit: str, title: str | None) -> xr.Dataset:
    """Levels over passages and wavelength."""
    decibels = {"units": "dB re 1 µm", "long_name": "one-third-octave level"}
    attributes = _datasets.attributes(title)
    for name, key in (
        ("grinding_interval_passages", "grinding_interval"),
        ("linear_range_passages", "linear_passages"),
        ("linear_force_ratio_now", "linear_force_ratio"),
        ("passages_per_day", "passages_per_day"),
    ):
        attributes[name] = np.nan if found[key] is None else found[key]
    attributes["limit"] = limit
    attributes["limit_reached"] = found["limit_reached"]
    attributes["remarks"] = found["remarks"]
    if found["findings"]:
        attributes["findings"] = found["findings"]
    dataset = xr.Dataset(
        {
            "level": (("passages", "wavelength"), found["level"], decibels),
            "level_now": ("wavelength", found["now"], decibels),
            "growth_rate": ("wavelength", found["growth_rate"], _datasets.GROWTH_RATE),
            "limit": ("wavelength", found["limit"], {**decibels, "long_name": "limit of the level"}),
            "passages_to_limit": (
                "wavelength",
                found["passages_to_limit"],
                {"units": "1", "long_name": "axle passages to the limit"},
            ),
        },
        {
            "passages": ("passages", found["passages"], {"units": "1", "long_name": "axle passages"}),
            "mgt": ("passages", found["mgt"], {"units": "1e9 kg", "long_name": "million gross tonnes"}),
            "wavelength": ("wavelength", found["wavelength"], _datasets.WAVELENGTH),
            "nominal_mm": ("wavelength", found["nominal"], {"units": "mm", "long_name": "nominal wavelength"}),
        },
        attributes,
    )
    return dataset.assign(_hardening(found["hardening"]) | _cracks(found["cracks"]))


def _hardening(rows: Sequence[Mapping[str, Any]]) -> dict[str, xr.DataArray]:
    """Where flow that hardens takes the bands; nothing where no law hardens."""
    if not rows:
        return {}
    wavelengths = [row["wavelength_m"] for row in rows]

    def column(key: str, name: str) -> xr.DataArray:
        _, values, said = _datasets.column("wavelength", rows, key, "1", name)
        return xr.DataArray(values, {"wavelength": wavelengths}, attrs=said)

    return {
        "runaway_number": column("runaway_number", "above one the wave outgrows its hardening"),
        "hardened_wave_ratio": column("hardened_wave_ratio", "what flow multiplies the wave by until it rests"),
    }


def _cracks(rows: Sequence[Mapping[str, Any]]) -> dict[str, xr.DataArray]:
    """Contact fatigue beside wear over the phases of the waves; nothing where fatigue is not among the laws."""
    if not rows:
        return {}
    phases = [row["phase"] for row in rows[:4]]
    wavelengths = [row["wavelength_m"] for row in rows[::4]]
    coordinates = {"wavelength": wavelengths, "phase": phases}

    def table(key: str, units: str, name: str) -> xr.DataArray:
        values = np.array([row[key] for row in rows]).reshape(-1, 4)
        return xr.DataArray(values, coordinates, attrs={"units": units, "long_name": name})

    return {
        "fatigue_index": table("fatigue_index", "1", "fatigue index of the surface"),
        "damage_per_passage": table("damage_per_passage", "1", "damage by Tγ per passage"),
        "wear_per_passage": table("wear_m_per_passage", "m", "depth of wear per passage"),
        "crack_growth_per_passage": table("crack_growth_m_per_passage", "m", "growth of a crack per passage, less wear"),
        "crack_length": table("crack_length_m", "m", "length of a crack after the most passages"),
    }


def comparison(outcomes: Sequence[Mapping[str, Any]], title: str | None) -> xr.Dataset:
    """Growth on variants of a case, side by side."""
    rates = [outcome["growth_rate_per_passage"] for outcome in outcomes]
    bands = levels([band["wavelength_m"] for band in rates[0]], np.zeros(len(rates[0])))

    column = partial(_datasets.column, "variant", outcomes)
    texts = partial(_datasets.texts, "variant", outcomes)
    attributes = _datasets.attributes(title)
    attributes["no_effect"] = [outcome["no_effect"] for outcome in outcomes if outcome["no_effect"]]
    return xr.Dataset(
        {
            "growth_rate": (
                ("variant", "wavelength"),
                np.array([[band["growth_rate_per_passage"] for band in row] for row in rates], float),
                _datasets.GROWTH_RATE,
            ),
            "fastest_wavelength": column("fastest_wavelength_m", "m", "wavelength that grows fastest"),
            "fastest_growth_rate": column("fastest_growth_rate_per_passage", "1", "its growth rate per passage"),
            "ridge_frequency": column("ridge_frequency_hz", "Hz", "frequency that the strongest branch of the ridge follows"),
            "passages_to_limit": column("passages_to_limit", "1", "axle passages to the limit"),
            "months_to_limit": column("months_to_limit", "month", "months to the limit"),
            "limit_reached": texts("limit_reached", "whether the limit is reached"),
            "hold": texts("hold", "what is held where friction or load change"),
            "acts": ("variant", [outcome["acts"] is not False for outcome in outcomes], {"long_name": "whether it acts"}),
        },
        {
            "variant": ("variant", [outcome["title"] for outcome in outcomes]),
            **bands.coords,
        },
        attributes,
    )


def horizon(passages: Any, mgt: Any, months: Any, with_traffic: bool) -> tuple[str, Floats]:
    """How far to look ahead, by one measure; a year where the traffic alone says it."""
    measures = {"passages": passages, "mgt": mgt, "months": months}
    given = {name: array(value, name, "ratio", least=OR_ZERO) for name, value in measures.items() if value is not None}
    if len(given) > 1:
        raise ValueError(f"{' and '.join(given)} exclude each other: give one of them")
    # The wheel of the case alone does not say how often it comes.
    if not given and not with_traffic:
        raise ValueError("passages, mgt or months is missing: say how far to look ahead")
    return next(iter(given.items()), ("months", np.array([12.0])))

"""Rolling contact as `xarray` objects: creep curves and frequency responses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr

from riffel import _datasets
from riffel._quantities import Complexes, Floats


def creep_curve(creepages: Floats, laws: Sequence[tuple[str, str, Floats]], title: str | None) -> xr.Dataset:
    """Tractive ratio over creep law and creepage."""
    ratio = {"units": "1", "long_name": "tractive ratio Q/(mu P)"}
    return xr.Dataset(
        {"tractive_ratio": (("law", "creepage"), np.array([values for _, _, values in laws]), ratio)},
        {
            "law": ("law", [key for key, _, _ in laws], {"long_name": "creep law"}),
            "name": ("law", [name for _, name, _ in laws], {"long_name": "name of the law in figures"}),
            "creepage": ("creepage", creepages, {"units": "1", "long_name": "creepage"}),
        },
        _datasets.attributes(title),
    )


def frequency_response(
    ratios: Floats,
    responses: Sequence[tuple[str, str, str, Complexes, Floats]],
    title: str | None,
    *,
    normalized: bool,
) -> xr.Dataset:
    """Responses over input, output and wavelength."""
    name = "wavelength_over_semi_axis"
    inputs = list(dict.fromkeys(put for put, *_ in responses))
    outputs = list(dict.fromkeys(output for _, output, *_ in responses))
    shape = (len(inputs), len(outputs), ratios.size)
    values = np.array([values for _, _, _, values, _ in responses]).reshape(shape)
    errors = np.array([errors for *_, errors in responses]).reshape(shape)
    long_name = "response over the quasi-static one" if normalized else "response in SI per unit of the input"
    units = {"units": "1"} if normalized else {}
    dims = ("input", "output", name)
    return xr.Dataset(
        {
            "response": (dims, values, {**units, "long_name": long_name}),
            "error": (dims, errors, {**units, "long_name": "largest error of the response by the grid of the contact"}),
        },
        {
            "input": ("input", inputs, {"long_name": "what oscillates"}),
            "output": ("output", outputs, {"long_name": "what answers"}),
            name: (name, ratios, {"units": "1", "long_name": "wavelength over the longitudinal semi-axis"}),
        },
        _datasets.attributes(title),
    )

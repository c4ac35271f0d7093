"""The loop at points of wavelength and speed, as dicts and `xarray` objects."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel import _datasets
from riffel._quantities import array, is_scalar

Columns = Sequence[tuple[str, str, str, npt.NDArray[Any]]]


def one(columns: Columns) -> dict[str, Any]:
    """The numbers of one point, tables inside tables."""
    found: dict[str, Any] = {}
    for key, _, _, values in columns:
        *tables, name = key.split(".")
        table = found
        for part in tables:
            table = table.setdefault(part, {})
        table[name] = values[0].item()
    return found


def many(columns: Columns, speeds: xr.DataArray, wavelengths: xr.DataArray, title: str | None) -> xr.Dataset:
    """The numbers of many points, over the dimensions of both."""
    variables = {
        key: (speeds.dims, values.reshape(speeds.shape), {"units": unit, "long_name": name})
        for key, unit, name, values in columns
    }
    return xr.Dataset(variables, speeds.coords | wavelengths.coords, _datasets.attributes(title))


def sensitivity(found: Sequence[tuple[str, str, float, float, float, float]], title: str | None) -> xr.Dataset:
    """What the growth rate at a point answers to."""
    keys, units, values, derivatives, elasticities, errors = zip(*found, strict=True)
    return xr.Dataset(
        {
            "value": ("key", list(values), {"long_name": "value in SI"}),
            "unit": ("key", list(units), {"long_name": "SI unit of the value"}),
            "derivative": ("key", list(derivatives), {"long_name": "derivative of the growth rate per passage"}),
            "elasticity": ("key", list(elasticities), {"units": "1", "long_name": "elasticity of the growth rate"}),
            "error": ("key", list(errors), {"units": "1", "long_name": "error of the elasticity"}),
        },
        {"key": list(keys)},
        _datasets.attributes(title),
    )


def as_data_array(value: Any, name: str, kind: Any, attributes: Mapping[str, str]) -> xr.DataArray:
    """Quantities with dimensions: those of the user, or one of their own name."""
    if isinstance(value, xr.DataArray):
        if value.size == 0:
            raise ValueError(f"{name} is empty, but must have a value")
        si = array(xr.DataArray(np.ravel(value.values), attrs=value.attrs), name, kind)
        return value.copy(data=si.reshape(value.shape)).assign_attrs(attributes)
    values = array(value, name, kind)
    if is_scalar(value):
        return xr.DataArray(values[0], {name: values[0]}, attrs=attributes)
    return xr.DataArray(values, {name: (name, values, dict(attributes))}, (name,), attrs=attributes)

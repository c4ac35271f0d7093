"""What results as `xarray` objects have in common: units, long names, conventions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

WAVELENGTH = {"units": "m", "long_name": "wavelength of the corrugation"}
SPEED = {"units": "m/s", "long_name": "speed of the vehicle"}
FREQUENCY = {"units": "Hz", "long_name": "frequency"}
NORMALIZED = {"units": "1", "long_name": "W1/(mu P0 V xi0), growth where its real part is negative"}
GROWTH_RATE = {"units": "1", "long_name": "growth rate of the amplitude per passage of a wheel"}
CONVENTIONS = {"time_factor": "exp(+i omega t)", "braking": "positive"}


def coordinate(name: str, values: npt.ArrayLike, attributes: Mapping[str, Any]) -> xr.Variable:
    """A coordinate along the dimension of its own name."""
    return xr.Variable((name,), values, attributes)


def attributes(title: str | None) -> dict[str, Any]:
    """Attributes of every result."""
    return {**titled(title), **CONVENTIONS}


def titled(title: str | None) -> dict[str, Any]:
    """The title as an attribute, if there is one."""
    return {} if title is None else {"title": title}


def said(units: str, name: str) -> dict[str, str]:
    """Units and long name of a variable."""
    return {"units": units, "long_name": name}


def column(dimension: str, rows: Sequence[Mapping[str, Any]], key: str, units: str, name: str) -> Any:
    """A number of each row of a document as a variable, NaN where there is none."""
    return dimension, np.array([row.get(key) for row in rows], float), said(units, name)


def texts(dimension: str, rows: Sequence[Mapping[str, Any]], key: str, name: str) -> Any:
    """A text of each row of a document as a variable, empty where there is none."""
    return dimension, [row[key] or "" for row in rows], {"long_name": name}


def rates(rows: Sequence[Mapping[str, Any]], wavelengths: Sequence[float]) -> Any:
    """The growth rates over wavelength of each row of a document, NaN where there are none."""
    none = [np.nan] * len(wavelengths)
    return np.array([row["growth_rate_per_passage"] or none for row in rows], float)


def along(dimension: str, values: Sequence[float], units: str, name: str) -> tuple[str, Sequence[float], dict[str, str]]:
    """Values along a dimension, with units and long name."""
    return dimension, values, said(units, name)

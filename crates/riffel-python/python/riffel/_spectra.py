"""One-third-octave spectra as arrays."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel import _riffel
from riffel._datasets import WAVELENGTH
from riffel._quantities import Floats, array, real


def spectrum_array(found: tuple[Floats, Floats, Floats]) -> xr.DataArray:
    """Levels over wavelength, of centres, nominal wavelengths and levels."""
    wavelength, nominal, level = found
    return xr.DataArray(
        level,
        {
            "wavelength": ("wavelength", wavelength, WAVELENGTH),
            "nominal_mm": ("wavelength", nominal, {"units": "mm", "long_name": "nominal wavelength"}),
        },
        ("wavelength",),
        "level",
        {"units": "dB re 1 µm", "long_name": "one-third-octave level of roughness"},
    )


def levels_of(spectrum: xr.DataArray, name: str) -> tuple[Floats, Floats]:
    """Wavelengths and levels of a spectrum that a user gave."""
    if not isinstance(spectrum, xr.DataArray):
        raise ValueError(f"{name} is of type {type(spectrum).__name__}, but must be a DataArray over wavelength")
    if spectrum.dims != ("wavelength",):
        raise ValueError(f"{name} has the dimensions {spectrum.dims}, but must have the one dimension wavelength")
    if "wavelength" not in spectrum.coords:
        raise ValueError(f"{name} has no coordinate wavelength")
    units = spectrum.attrs.get("units", "dB re 1 µm")
    if units not in ("dB", "dB re 1 µm", "dB re 1 um", "dB re 1 μm"):
        raise ValueError(f"{name} has units \"{units}\", but must be in dB re 1 µm")
    wavelength = array(spectrum.coords["wavelength"], f"{name}.wavelength", "length")
    return wavelength, _finite(real(spectrum.values, name), name)


def labels_of(spectrum: xr.DataArray) -> list[tuple[str, str]]:
    """What a file said of a spectrum besides its levels: the texts among its attributes."""
    own = ("units", "long_name")
    return [(str(key), text) for key, text in spectrum.attrs.items() if isinstance(text, str) and key not in own]


def _finite(values: Floats, name: str) -> Floats:
    if not np.isfinite(values).all():
        index = int(np.flatnonzero(~np.isfinite(values))[0])
        raise ValueError(f"{name}[{index}] is {values[index]}, but must be finite")
    return values


def levels(wavelength: npt.ArrayLike, level: npt.ArrayLike) -> xr.DataArray:
    """A spectrum from numbers.

    Parameters
    ----------
    wavelength : array
        Nominal or exact centres of one-third octaves in m, or strings with their unit.
    level : array
        Levels in dB re 1 µm.

    Returns
    -------
    xarray.DataArray
        Over exact ``wavelength``, the shortest first.

    Examples
    --------
    >>> riffel.roughness.levels(["40 mm", "31.5 mm"], [3.0, 5.0]).values
    array([5., 3.])
    """
    wavelengths = array(wavelength, "wavelength", "length")
    values = _finite(real(level, "level"), "level")
    if values.shape != wavelengths.shape:
        raise ValueError(f"level has the shape {values.shape}, but there are {wavelengths.size} wavelengths")
    return spectrum_array(_riffel.energy_mean([(wavelengths, values)]))

"""Roughness of rails: profiles and one-third-octave spectra, as arrays.

Heights are in m, positive upward, at equal steps; values that are not a number are gaps. Levels are in dB re 1 µm.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel import _riffel
from riffel._datasets import WAVELENGTH
from riffel._quantities import Floats, Quantity, real, scalar
from riffel._spectra import levels, levels_of, spectrum_array

__all__ = [
    "Analysis",
    "Roughness",
    "analyse",
    "band_pass",
    "compare_with_limit",
    "dominant_wavelengths",
    "energy_mean",
    "level",
    "levels",
    "limits",
    "mean_square",
    "moving_peak_to_peak",
    "moving_rms",
    "read",
    "remove_spikes",
    "roll_over",
    "spectrum",
    "synthesise",
]


@dataclass(frozen=True)
class Analysis:
    """The roughness of one rail."""

    spectrum: xr.DataArray
    """Levels after EN 15610 over ``wavelength``."""
    bands: xr.Dataset
    """Statistics of the bands of grinding over ``band``."""
    blocks: xr.Dataset
    """RMS of consecutive blocks over ``block`` and ``band``, and the highest moving RMS in each."""
    grind: xr.Dataset
    """Lengths over the limit over ``section``: what to grind from where to where."""
    spikes: int
    """Spikes that were removed."""
    pits: int
    """Pits that the wheel bridges."""


@dataclass(frozen=True)
class Roughness:
    """What a file of roughness holds: a profile or spectra."""

    profile: xr.Dataset | None
    """Heights of each rail over ``position``, gaps as NaN."""
    spectra: list[xr.DataArray]
    """Spectra with the other columns of the file in their attributes."""
    warnings: list[str]
    """What was put right in the file."""


def stretches_of(
    heights: npt.ArrayLike, spacing: Quantity | None, start: float = 0.0, name: str = "heights"
) -> tuple[list[Any], float]:
    """Stretches without gaps, each with its beginning, and the step."""
    if isinstance(heights, xr.DataArray):
        if heights.dims != ("position",):
            raise ValueError(f"{name} has the dimensions {heights.dims}, but must have the one dimension position")
        units = heights.attrs.get("units", "m")
        if units != "m":
            heights = heights.copy(data=heights.values * _riffel.si(f"1 {units}", "length"))
        if spacing is None and "position" in heights.coords:
            position = real(heights.coords["position"].values, "position")
            steps = np.diff(position)
            if steps.size == 0 or not np.allclose(steps, steps[0], rtol=1e-6) or steps[0] <= 0.0:
                raise ValueError("position must rise in equal steps")
            spacing, start = float((position[-1] - position[0]) / (position.size - 1)), float(position[0])
        heights = heights.values
    if spacing is None:
        raise ValueError("spacing is missing: heights without positions need the step between them")
    step = scalar(spacing, "spacing", "length")
    values = real(heights, name)
    if np.isinf(values).any():
        raise ValueError(f"{name}[{int(np.flatnonzero(np.isinf(values))[0])}] is infinite")
    gaps = np.isnan(values)
    if not gaps.any():
        return [(start, values)], step
    edges = np.flatnonzero(np.diff(np.concatenate([[True], gaps, [True]]).astype(np.int8)))
    found = [(start + step * begin, values[begin:end]) for begin, end in zip(edges[::2], edges[1::2], strict=True)]
    # A single reading between two gaps says nothing.
    stretches = [(begin, part) for begin, part in found if part.size > 1]
    if not stretches:
        raise ValueError(f"{name} holds gaps only")
    return stretches, step


def _one(heights: npt.ArrayLike, spacing: Quantity | None) -> tuple[Floats, float]:
    stretches, step = stretches_of(heights, spacing)
    if len(stretches) > 1 or stretches[0][1].size < np.size(heights):
        raise ValueError("heights has gaps: treat its stretches one by one")
    return stretches[0][1], step


def read(
    path: str | os.PathLike[str],
    *,
    format: str | os.PathLike[str] | None = None,
    spacing: Quantity | None = None,
    height_unit: str | None = None,
    position_unit: str | None = None,
) -> Roughness:
    """Read a file of roughness, whose layout is found from its first lines.

    Parameters
    ----------
    path : path-like
        Longitudinal profile, or table of one-third-octave levels: text in columns.
    format : path-like, optional
        Reader profile that says how the file is laid out.
    spacing : quantity, optional
        Step between samples of a file without positions.
    height_unit, position_unit : str, optional
        Units of heights and positions, as "mm", whatever the file says.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        For a file that is none of these, with its line, or one whose values are unlike any rail.

    Examples
    --------
    >>> file = riffel.roughness.read("validation/reference/sbb-track-noise/rail_roughness.csv")
    >>> len(file.spectra) > 0 and file.profile is None
    True

    Positions in m and heights in mm, of which the file says nothing:

    >>> import pathlib, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     bare = pathlib.Path(folder) / "trolley.txt"
    ...     lines = (f"{0.002 * k:.3f} {0.02 * np.sin(2 * np.pi * k / 25):.6f}" for k in range(5000))
    ...     written = bare.write_text("\\n".join(lines))
    ...     profile = riffel.roughness.read(bare, height_unit="mm", position_unit="m").profile
    >>> {str(rail): f"{float(abs(profile[rail]).max()):.1e} m" for rail in profile}
    {'column 2': '2.0e-05 m'}
    """
    step = None if spacing is None else scalar(spacing, "spacing", "length")
    layout = (None if format is None else os.fspath(format), step, height_unit, position_unit)
    profile, spectra, warnings = _riffel.read_roughness(os.fspath(path), layout)
    arrays = [spectrum_array(found).assign_attrs(dict(labels)) for labels, found in spectra]
    return Roughness(None if profile is None else _profile(*profile), arrays, warnings)


def _profile(spacing: float, rails: list[tuple[str, list[tuple[float, Floats]]]]) -> xr.Dataset:
    stretches = [stretch for _, rail in rails for stretch in rail]
    first = min(start for start, _ in stretches)
    last = max(start + spacing * (heights.size - 1) for start, heights in stretches)
    samples = round((last - first) / spacing) + 1
    columns = {}
    for name, rail in rails:
        column = np.full(samples, np.nan)
        for start, heights in rail:
            begin = round((start - first) / spacing)
            column[begin : begin + heights.size] = heights
        columns[name] = ("position", column, {"units": "m", "long_name": f"height of the rail, {name}"})
    position = first + spacing * np.arange(samples)
    return xr.Dataset(columns, {"position": ("position", position, {"units": "m", "long_name": "position"})})


def synthesise(recipe: Mapping[str, Any] | None = None) -> xr.Dataset:
    """A profile made to a recipe, by default that of ``cases/roughness-recipe.toml``.

    Parameters
    ----------
    recipe : mapping, optional
        Keys of a recipe file.

    Examples
    --------
    >>> made = riffel.roughness.synthesise({"length": "10 m", "spacing": "1 mm", "rails": ["left"],
    ...     "sinusoid": [{"wavelength": "40 mm", "amplitude": "20 um"}]})
    >>> float(made["left"].max().round(6))
    2e-05
    """
    rails = _riffel.synthesise(None if recipe is None else dict(recipe))
    spacing = rails[0][1]
    return _profile(spacing, [(name, [(0.0, heights)]) for name, _, heights in rails])


def analyse(
    heights: npt.ArrayLike,
    *,
    spacing: Quantity | None = None,
    start: float = 0.0,
    longest_wavelength: Quantity = 2.0,
    window: Quantity | None = None,
    block: Quantity = 10.0,
    limit: str | None = None,
    merge: Quantity = 10.0,
    grinding_length: Quantity = 10.0,
) -> Analysis:
    """Everything about one rail: spikes, levels, bands, limits, what to grind.

    Parameters
    ----------
    heights : array
        Heights in m; NaN are gaps. A `DataArray` over ``position`` needs no `spacing`.
    spacing : quantity
        Step between heights.
    start : float
        Position of the first height in m.
    longest_wavelength : quantity
        Of the spectrum.
    window, block : quantity, optional
        Lengths of the moving window, by default that of each band, and of the blocks.
    limit : str, optional
        Limit of the moving RMS by name or as a TOML file, such as "grassie-1999".
    merge : quantity
        Good length up to which two lengths over the limit are ground as one.
    grinding_length : quantity
        Shortest length that is ground; shorter ones are widened to it.

    Examples
    --------
    >>> position = 1e-3 * np.arange(40_000)
    >>> found = riffel.roughness.analyse(10e-6 * np.sin(2 * np.pi * position / 0.05), spacing="1 mm")
    >>> float(found.spectrum.idxmax("wavelength").round(3)), found.spikes
    (0.05, 0)
    """
    stretches, step = stretches_of(heights, spacing, start)
    found = _riffel.analyse(
        stretches,
        step,
        scalar(longest_wavelength, "longest_wavelength", "length"),
        None if window is None else scalar(window, "window", "length"),
        scalar(block, "block", "length"),
        limit,
        scalar(merge, "merge", "length"),
        scalar(grinding_length, "grinding_length", "length"),
    )
    bands = np.array(found["bands"], dtype=np.float64).reshape(-1, 9).T
    blocks = np.array(found["blocks"], dtype=np.float64)
    sections = np.array(found["sections"], dtype=np.float64).reshape(-1, 5).T
    metres = {"units": "m"}
    names = ("from", "to", "window", "length", "rms", "moving_rms_max", "peak_to_peak_max", "limit", "share_over_limit")
    return Analysis(
        spectrum=spectrum_array(found["spectrum"]),
        bands=xr.Dataset(
            {
                name: ("band", values, {"units": "1"} if name == "share_over_limit" else metres)
                for name, values in zip(names, bands, strict=True)
            }
        ),
        blocks=xr.Dataset(
            {
                "from": ("block", blocks[:, 0], metres),
                "to": ("block", blocks[:, 1], metres),
                "rms": (("block", "band"), blocks[:, 2:6], metres),
                "moving_rms_max": (("block", "band"), blocks[:, 6:], metres),
            }
        ),
        grind=xr.Dataset(
            {
                name: ("section", values, metres if name != "ratio" else {"units": "1"})
                for name, values in zip(("from", "to", "band_from", "band_to", "ratio"), sections, strict=True)
            }
        ),
        spikes=found["spikes"],
        pits=found["pits"],
    )


def spectrum(
    heights: npt.ArrayLike, *, spacing: Quantity | None = None, longest_wavelength: Quantity = 2.0
) -> xr.DataArray:
    """One-third-octave levels by method A of EN 15610, of heights as they are.

    `analyse` removes spikes and rolls the wheel over first.
    """
    stretches, step = stretches_of(heights, spacing)
    longest = scalar(longest_wavelength, "longest_wavelength", "length")
    return spectrum_array(_riffel.third_octaves(stretches, step, longest))


def remove_spikes(heights: npt.ArrayLike, *, spacing: Quantity | None = None) -> tuple[Floats, list[slice]]:
    """Heights without the spikes of EN 15610, and where these were.

    Examples
    --------
    >>> heights = np.zeros(2000)
    >>> heights[1000] = 1e-3
    >>> clean, spikes = riffel.roughness.remove_spikes(heights, spacing=1e-3)
    >>> float(clean.max()), spikes
    (0.0, [slice(999, 1002, None)])
    """
    cleaned, removed = _riffel.remove_spikes(*_one(heights, spacing))
    return cleaned, [slice(*ends) for ends in removed]


def roll_over(
    heights: npt.ArrayLike,
    *,
    spacing: Quantity | None = None,
    radius: Quantity | None = None,
    pit_depth: Quantity | None = None,
) -> tuple[Floats, list[slice]]:
    """The path of a wheel that rolls over, by default of 375 mm as in EN 15610, and the pits that it bridges."""
    rolled, pits = _riffel.roll_over(
        *_one(heights, spacing),
        None if radius is None else scalar(radius, "radius", "length"),
        None if pit_depth is None else scalar(pit_depth, "pit_depth", "length"),
    )
    return rolled, [slice(*ends) for ends in pits]


def band_pass(
    heights: npt.ArrayLike, *, shortest: Quantity, longest: Quantity, spacing: Quantity | None = None
) -> Floats:
    """Heights between two wavelengths, without a shift."""
    values, step = _one(heights, spacing)
    band = scalar(shortest, "shortest", "length"), scalar(longest, "longest", "length")
    return _riffel.band_pass(values, step, *band)


def moving_rms(values: npt.ArrayLike, window: int) -> Floats:
    """Root mean square of each window of `window` consecutive values.

    Examples
    --------
    >>> riffel.roughness.moving_rms([3.0, 4.0, 0.0], 2)
    array([3.53553391, 2.82842712])
    """
    return _riffel.moving_rms(real(values, "values"), _samples(window))


def moving_peak_to_peak(values: npt.ArrayLike, window: int) -> Floats:
    """Largest less smallest value of each window of `window` consecutive values."""
    return _riffel.moving_peak_to_peak(real(values, "values"), _samples(window))


def _samples(window: int) -> int:
    if isinstance(window, bool) or not isinstance(window, (int, np.integer)) or window < 1:
        raise ValueError(f"window is {window!r}, but must be a whole number of samples, one or more")
    return int(window)


def level(mean_square: npt.ArrayLike) -> Floats:
    """Levels in dB re 1 µm of mean squares in m².

    Examples
    --------
    >>> riffel.roughness.level([1e-12])
    array([0.])
    """
    return _riffel.level(real(mean_square, "mean_square"))


def mean_square(level: npt.ArrayLike) -> Floats:
    """Mean squares in m² of levels in dB re 1 µm."""
    return _riffel.mean_square(real(level, "level"))


def energy_mean(spectra: Sequence[xr.DataArray]) -> xr.DataArray:
    """Mean of spectra on mean squares, as EN 15610 averages records.

    Examples
    --------
    >>> one, two = (riffel.roughness.levels([0.04], [level]) for level in (0.0, 10.0))
    >>> riffel.roughness.energy_mean([one, two]).values.round(2)
    array([7.4])
    """
    return spectrum_array(_riffel.energy_mean(_spectra(spectra)))


def _spectra(spectra: Sequence[xr.DataArray]) -> list[tuple[Floats, Floats]]:
    return [levels_of(one, f"spectra[{index}]") for index, one in enumerate(spectra)]


def limits() -> dict[str, xr.DataArray | xr.Dataset]:
    """The limits that come with Riffel by name: levels over ``wavelength``, or RMS over ``band``."""
    found: dict[str, xr.DataArray | xr.Dataset] = {}
    for name, title, edition, source, of_levels, of_rms in _riffel.limits():
        attributes = {"title": title, "edition": edition, "source": source}
        if of_levels is not None:
            found[name] = spectrum_array(of_levels).assign_attrs(attributes)
        else:
            columns = zip(("from", "to", "rms"), np.array(of_rms).T, strict=True)
            found[name] = xr.Dataset(
                {column: ("band", values, {"units": "m"}) for column, values in columns}, attrs=attributes
            )
    return found


def compare_with_limit(spectrum: xr.DataArray, limit: str = "iso-3095-2013") -> xr.Dataset:
    """Levels held against a limit, for the bands that both have; above it where ``excess`` is positive.

    Examples
    --------
    >>> held = riffel.roughness.compare_with_limit(riffel.roughness.levels([0.04], [9.0]))
    >>> bool(held["excess"][0] == held["level"][0] - held["limit"][0])
    True
    """
    wavelength, value, allowed = _riffel.compare_with_limit(*levels_of(spectrum, "spectrum"), limit)
    decibels = {"units": "dB re 1 µm"}
    return xr.Dataset(
        {
            "level": ("wavelength", value, decibels),
            "limit": ("wavelength", allowed, decibels),
            "excess": ("wavelength", value - allowed, {"units": "dB"}),
        },
        {"wavelength": ("wavelength", wavelength, WAVELENGTH)},
        {"limit": limit},
    )


def dominant_wavelengths(
    rail: npt.ArrayLike | Sequence[xr.DataArray], *, spacing: Quantity | None = None
) -> xr.Dataset:
    """Wavelengths that stand 3 dB out of the trend of their neighbours beyond chance.

    Parameters
    ----------
    rail : array or sequence of DataArray
        Heights, or one-third-octave spectra of the same rail.
    spacing : quantity, optional
        Step between heights.

    Returns
    -------
    xarray.Dataset
        Over ``peak``: ``wavelength``, its ends ``from`` and ``to``, ``level``, ``prominence``, ``scatter`` and
        ``false_peaks``, how many as high noise alone would have; NaN where not known.

    Examples
    --------
    >>> made = riffel.roughness.synthesise()
    >>> peaks = riffel.roughness.dominant_wavelengths(made[list(made)[0]])
    >>> peaks.sizes["peak"] > 0
    True
    """
    if isinstance(rail, (list, tuple)) and rail and all(isinstance(one, xr.DataArray) for one in rail):
        found = _riffel.dominant_of_spectra(_spectra(rail))
    else:
        stretches, step = stretches_of(rail, spacing)
        found = _riffel.dominant_of_profile(stretches, step)
    names = {
        "wavelength": "m",
        "from": "m",
        "to": "m",
        "level": "dB re 1 µm",
        "prominence": "dB",
        "scatter": "dB",
        "false_peaks": "1",
    }
    table = np.array([[np.nan if value is None else value for value in peak] for peak in found], dtype=np.float64)
    columns = zip(names.items(), table.reshape(-1, len(names)).T, strict=True)
    return xr.Dataset({name: ("peak", values, {"units": units}) for (name, units), values in columns})

"""Figures in matplotlib, in the colours of the program's own.

Every function draws on the axes it is given, or on new ones, and returns them. Axes are in the units that engineers read:
mm, km/h, Hz, dB re 1 µm.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib.pyplot as plt
import numpy as np
import xarray as xr
from matplotlib.colors import LinearSegmentedColormap, TwoSlopeNorm
from matplotlib.ticker import NullLocator

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    "OKABE_ITO",
    "bands",
    "comparison",
    "creep_curve",
    "forecast",
    "frequency_response",
    "growth_map",
    "receptance",
    "ridge",
    "ridge_branches",
    "sobol_indices",
    "spectrum",
    "tornado",
]

OKABE_ITO = ("#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#f0e442")
"""Palette that remains distinct for colour-blind readers (Okabe & Ito 2008)."""

# Lightness falls in equal steps from pale to dark on either side: the blues of the program for growth, browns of the same
# lightness for decay. Blue and brown are told apart by readers of every colour vision.
_GROWTH = ("#e1f4fb", "#aed9f0", "#81bce2", "#5c9ed2", "#3e80bf", "#2961a7", "#1d438c")
_DECAY = ("#faeee1", "#ebcbac", "#dba97e", "#c78755", "#b16630", "#98460a", "#7d2800")
GROWTH_COLORS = LinearSegmentedColormap.from_list("riffel_growth", (*_DECAY[::-1], "#ffffff", *_GROWTH))
"""Diverging map: browns for decay, white at zero, blues for growth."""


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    return plt.subplots(layout="constrained")[1]


def _finish(ax: Axes, x: str, y: str, title: str | None) -> Axes:
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    ax.grid(True, color="#e4e4e4", linewidth=0.8)
    ax.set_axisbelow(True)
    if title and not ax.get_title(loc="left"):
        ax.set_title(title, loc="left", fontweight="bold")
    return ax


def growth_map(dataset: xr.Dataset, ax: Axes | None = None, *, colorbar: bool = True) -> Axes:
    """Growth rate over wavelength and speed: blue where corrugation grows, brown where it decays.

    Colours are centred at zero and end at the highest growth and the fastest decay. The line is neither growth nor decay.

    Parameters
    ----------
    dataset : xarray.Dataset
        As `riffel.Case.growth_map` returns it.
    ax : Axes, optional
        Where to draw.
    colorbar : bool
        Whether to draw the scale of colours beside.

    Examples
    --------
    >>> ax = riffel.plot.growth_map(case.growth_map())
    >>> ax.get_xlabel()
    'wavelength λ [mm]'
    """
    ax = _axes(ax)
    rate = dataset["growth_rate"].transpose("speed", "wavelength")
    values = rate.values
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    # A map of growth alone, or of decay alone, still has both sides of the scale.
    size = max(abs(low), abs(high)) or 1.0
    norm = TwoSlopeNorm(0.0, low if low < 0.0 else -size, high if high > 0.0 else size)
    x, y = 1e3 * dataset["wavelength"].values, 3.6 * dataset["speed"].values
    mesh = ax.pcolormesh(x, y, values, cmap=GROWTH_COLORS, norm=norm, shading="nearest", rasterized=True)
    if low < 0.0 < high and min(values.shape) > 1:
        ax.contour(x, y, values, levels=[0.0], colors="#0b1f4b", linewidths=1.2)
    if colorbar:
        plt.colorbar(mesh, ax=ax, label="growth rate per passage [-]")
    _finish(ax, "wavelength λ [mm]", "speed V [km/h]", dataset.attrs.get("title"))
    ax.set_xlim(x.min(), x.max())
    ax.set_ylim(y.min(), y.max())
    return ax


def ridge(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """The wavelength of highest growth at each speed, to draw upon a map: open where it sits at the edge of the window."""
    ax = _axes(ax)
    growing = dataset["growth_rate"].values > 0.0
    edge = dataset["at_edge"].values
    x, y = 1e3 * dataset["wavelength"].values, 3.6 * dataset["speed"].values
    # As many marks as can be told apart.
    shown = np.zeros_like(edge)
    shown[:: max(1, edge.size // 40)] = True
    best = dataset.attrs.get("best_fit_frequency_hz", np.nan)
    if np.isfinite(best):
        # As far as the ray stays among the points of the ridge.
        ray = 3.6e-3 * best * np.array([x[growing].min(), x[growing].max()])
        span = np.clip(ray, y[growing].min(), y[growing].max())
        label = f"strongest branch, {best:.0f} Hz"
        ax.plot(1e3 * span / 3.6 / best, span, "--", color=OKABE_ITO[2], linewidth=2.0, label=label)
    for mask, face, label in ((growing & ~edge, "#000000", "strongest growth"), (growing & edge, "none", "at the edge")):
        if (mask & shown).any():
            ax.plot(
                x[mask & shown], y[mask & shown], "o", markersize=4, markerfacecolor=face, markeredgecolor="#000000",
                clip_on=False, label=label, zorder=3,
            )  # fmt: skip
    _finish(ax, "wavelength λ [mm]", "speed V [km/h]", dataset.attrs.get("title"))
    if ax.get_legend_handles_labels()[0]:
        ax.legend(loc="upper left")
    return ax


def ridge_branches(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """The branches of the ridge, to draw upon a map: a line through each, the strongest as wide as two.

    Parameters
    ----------
    dataset : xarray.Dataset
        As `riffel.Case.ridge_branches` returns it.
    ax : Axes, optional
        Where to draw.
    """
    ax = _axes(ax)
    y = 3.6 * dataset["speed"].values
    for index in range(dataset.sizes["branch"]):
        branch = dataset.isel(branch=index)
        mechanism = str(branch["mechanism"].item())
        label = f"{branch['best_fit_frequency'].item():.0f} Hz" + (f", {mechanism}" if mechanism else "")
        color = OKABE_ITO[1 + (index + 1) % (len(OKABE_ITO) - 1)]
        width = 2.4 if index == 0 else 1.2
        ax.plot(1e3 * branch["wavelength"].values, y, "-", color=color, linewidth=width, label=label)
    _finish(ax, "wavelength λ [mm]", "speed V [km/h]", dataset.attrs.get("title"))
    if ax.get_legend_handles_labels()[0]:
        ax.legend(loc="upper left")
    return ax


_JOINTS = {
    "rail_m_per_n": ("rail", "-"),
    "rail_over_support_m_per_n": ("rail over support", "-"),
    "rail_mid_span_m_per_n": ("rail in mid-span", "-"),
    "wheel_m_per_n": ("wheel", "--"),
    "contact_m_per_n": ("contact spring", ":"),
    "total_m_per_n": ("total", "-"),
}


def receptance(dataset: xr.Dataset, ax: Axes | None = None, *, phase: bool = False) -> Axes:
    """Modulus, or phase in degrees, of the receptances of rail, wheel and contact over frequency."""
    ax = _axes(ax)
    named = [key for key in _JOINTS if key in dataset]
    # On discrete supports the rail is shown at both of its typical places.
    if "rail_mid_span_m_per_n" in dataset:
        named.remove("rail_m_per_n")
    for color, key in zip(OKABE_ITO, named, strict=False):
        label, style = _JOINTS[key]
        values = dataset[key].values
        if phase:
            degrees = np.degrees(np.angle(values))
            # A passive structure never leads: -180 to 0 degrees.
            ax.plot(dataset["frequency"], np.where(degrees > 90.0, degrees - 360.0, degrees), style, color=color, label=label)
        else:
            ax.plot(dataset["frequency"], np.abs(values), style, color=color, label=label)
    for name, place in zip(
        dataset.attrs.get("resonances", []), dataset.attrs.get("resonance_frequencies_hz", []), strict=True
    ):
        ax.axvline(place, color="#787878", linewidth=0.8)
        if not phase:
            ax.annotate(
                f"{name} {place:.0f} Hz", (place, 0.02), xycoords=("data", "axes fraction"), rotation=90,
                ha="right", va="bottom", fontsize="small", color="#505050",
            )  # fmt: skip
    ax.set_xscale("log")
    if not phase:
        ax.set_yscale("log")
        ax.legend()
    label = "arg H [°]" if phase else "|H| [m/N]"
    return _finish(ax, "frequency f [Hz]", label, dataset.attrs.get("title"))


def creep_curve(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """Tractive ratio against creepage by every law."""
    ax = _axes(ax)
    looks = {
        "carter-3d": (1, "--"),
        "carter-2d": (6, ":"),
        "johnson-vermeulen": (2, ":"),
        "shen-hedrick-elkins": (3, "--"),
        "polach": (4, "-"),
        "fastsim": (5, "-"),
        "half-space": (0, "-"),
    }
    order = np.argsort(dataset["creepage"].values)
    x = 100.0 * np.concatenate([[0.0], dataset["creepage"].values[order]])
    for law in dataset["law"].values:
        curve = dataset["tractive_ratio"].sel(law=law)
        color, style = looks.get(str(law), (7, "-"))
        y = np.concatenate([[0.0], curve.values[order]])
        ax.plot(x, y, style, color=OKABE_ITO[color], label=str(curve["name"].item()))
    ax.legend()
    ax.set_ylim(bottom=0.0)
    ax.set_xlim(left=0.0)
    return _finish(ax, "creepage ξ [%]", "tractive ratio Q/μP [-]", dataset.attrs.get("title"))


def frequency_response(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """Modulus of the responses of the contact over wavelength, each over its quasi-static value.

    Responses about a table of creepages are in SI and have no common scale: for them there is ``Dataset["response"]``.
    """
    if "creepage" not in dataset["input"].values:
        message = "only responses over quasi-static ones share an axis; plot dataset['response'] input by input"
        raise ValueError(message)
    ax = _axes(ax)
    colors = {"force": 0, "dissipation": 2, "rail_dissipation": 1}
    for put, style in (("creepage", "-"), ("load", "--")):
        for output, color in colors.items():
            values = np.abs(dataset["response"].sel(input=put, output=output))
            name = "energy left on rail" if output == "rail_dissipation" else output
            ax.plot(
                dataset["wavelength_over_semi_axis"], values, style, color=OKABE_ITO[color], label=f"{name} by {put}"
            )
    ax.set_xscale("log")
    ax.set_ylim(bottom=0.0)
    ax.legend(fontsize="small")
    label = "response over quasi-static [-]"
    return _finish(ax, "wavelength λ/a [-]", label, dataset.attrs.get("title"))


def _wavelengths(ax: Axes) -> None:
    """Wavelengths from long to short, as spectra of roughness are drawn, at nominal marks."""
    ax.set_xscale("log")
    low, high = sorted(ax.get_xlim())
    ax.set_xlim(high, low)
    # Every one-third octave where there is room.
    steps = (1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0) if high < 20.0 * low else (1.0, 2.0, 5.0)
    marks = [mark for decade in (1, 10, 100, 1000) for step in steps if low <= (mark := decade * step) <= high]
    ax.set_xticks(marks, [f"{mark:g}" for mark in marks])
    ax.xaxis.set_minor_locator(NullLocator())


def spectrum(level: xr.DataArray, ax: Axes | None = None, *, limit: xr.DataArray | None = None, **line: Any) -> Axes:
    """One-third-octave levels over wavelength, long waves to the left; a limit in vermilion.

    Further arguments go to ``Axes.plot``.
    """
    ax = _axes(ax)
    if limit is not None:
        label = str(limit.attrs.get("edition", "limit"))
        ax.plot(1e3 * limit["wavelength"], limit, "--", color=OKABE_ITO[2], label=label)
    line.setdefault("color", OKABE_ITO[len(ax.lines) % 7] if ax.lines and limit is None else OKABE_ITO[0])
    ax.plot(1e3 * level["wavelength"], level, **{"marker": "o", "markersize": 3.5, **line})
    _wavelengths(ax)
    if ax.get_legend_handles_labels()[0]:
        ax.legend()
    return _finish(ax, "wavelength λ [mm]", "level [dB re 1 µm]", None)


def forecast(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """Levels now and after some passages, with the limit."""
    ax = _axes(ax)
    x = 1e3 * dataset["wavelength"]
    ax.plot(x, dataset["limit"], "--", color=OKABE_ITO[2], label=f"limit, {dataset.attrs.get('limit', '')}")
    ax.plot(x, dataset["level_now"], color=OKABE_ITO[0], label="now", marker="o", markersize=3.5)
    blues = LinearSegmentedColormap.from_list("", _GROWTH[2:])
    later = dataset["level"].where(dataset["passages"] > 0.0, drop=True)
    for index, passages in enumerate(later["passages"].values):
        share = (index + 1) / later.sizes["passages"]
        ax.plot(x, later[index], color=blues(share), label=f"after {passages:.2g} passages")
    _wavelengths(ax)
    ax.legend(fontsize="small")
    return _finish(ax, "wavelength λ [mm]", "level [dB re 1 µm]", dataset.attrs.get("title"))


def comparison(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """Growth rates of a case and its variants over wavelength."""
    ax = _axes(ax)
    for index, variant in enumerate(dataset["variant"].values):
        rates = dataset["growth_rate"].isel(variant=index)
        ax.plot(1e3 * dataset["wavelength"], rates, color=OKABE_ITO[index % 7], label=str(variant))
    ax.axhline(0.0, color="#787878", linewidth=0.8)
    _wavelengths(ax)
    ax.legend()
    return _finish(ax, "wavelength λ [mm]", "growth rate per passage [-]", dataset.attrs.get("title"))


def _named(output: object, unit: object) -> str:
    """An output in words, with its unit."""
    name = str(output or "output").replace("_", " ")
    return name if unit is None else f"{name} [{'-' if unit == '1' else unit}]"


def sobol_indices(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """First-order and total Sobol indices with their intervals, as `riffel.Study.sobol_indices` returns them."""
    ax = _axes(ax)
    places = np.arange(dataset.sizes["parameter"])
    for name, shift, color, label in (("first", -0.18, OKABE_ITO[1], "first order"), ("total", 0.18, OKABE_ITO[2], "total")):
        value = dataset[name].values
        interval = np.abs(np.stack([dataset[f"{name}_low"].values, dataset[f"{name}_high"].values]) - value)
        ax.barh(places + shift, value, height=0.32, color=color, label=label)
        ax.errorbar(value, places + shift, xerr=interval, fmt="none", ecolor="#222222", elinewidth=1.0, capsize=3.0)
    ax.set_yticks(places, dataset["parameter"].values)
    ax.invert_yaxis()
    _finish(ax, f"Sobol indices of {_named(dataset.attrs.get('output'), None)} [-]", "", dataset.attrs.get("title"))
    ax.set_xlim(left=min(0.0, float(dataset["first_low"].min())))
    ax.legend(loc="lower right")
    return ax


def tornado(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """What each parameter does alone, as `riffel.Study.tornado` returns it."""
    ax = _axes(ax)
    places = np.arange(dataset.sizes["parameter"])
    median = float(dataset["median"])
    low, high = dataset.attrs.get("shares", (0.1, 0.9))
    for name, color, share in (("low", OKABE_ITO[6], low), ("high", OKABE_ITO[1], high)):
        ax.barh(places, dataset[name].values - median, left=median, height=0.6, color=color, label=f"at its {share:.0%} quantile")
    ax.axvline(median, color="#222222", linewidth=1.0)
    ax.set_yticks(places, dataset["parameter"].values)
    ax.invert_yaxis()
    _finish(ax, _named(dataset.attrs.get("output"), dataset.attrs.get("units")), "", dataset.attrs.get("title"))
    ax.legend(loc="lower right")
    return ax


def bands(output: xr.DataArray, ax: Axes | None = None, *, shares: tuple[float, ...] = (0.05, 0.25, 0.5, 0.75, 0.95)) -> Axes:
    """Quantiles over the samples of a study of an output over wavelength, as in ``results["mean_growth_rate"]``.

    Parameters
    ----------
    output : xarray.DataArray
        Over ``sample`` and ``wavelength``.
    ax : Axes, optional
        Where to draw.
    shares : tuple of float
        Shares of the quantiles, an odd number of them, symmetric about the middle one, which is drawn as a line.
    """
    ax = _axes(ax)
    quantiles = output.quantile(list(shares), "sample").transpose("quantile", "wavelength").values
    x = 1e3 * output["wavelength"].values
    middle = len(shares) // 2
    for index in range(middle):
        label = f"{shares[index]:.0%} to {shares[-1 - index]:.0%}"
        ax.fill_between(x, quantiles[index], quantiles[-1 - index], color=OKABE_ITO[1], alpha=0.25, linewidth=0, label=label)
    ax.plot(x, quantiles[middle], color=OKABE_ITO[1], label=f"{shares[middle]:.0%}")
    ax.axhline(0.0, color="#222222", linewidth=0.8, linestyle=":")
    _finish(ax, "wavelength λ [mm]", _named(output.name, output.attrs.get("units")), None)
    ax.legend(loc="best")
    return ax

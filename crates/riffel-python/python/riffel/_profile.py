"""Profiles of wheels and rails as `xarray` objects."""

from __future__ import annotations

import os
from typing import Any, Literal, TypeAlias

import numpy as np
import xarray as xr

from riffel import _datasets
from riffel._ask import answer, ask
from riffel._quantities import Quantity

Orientation: TypeAlias = Literal["found", "as-written", "mirrored", "upside-down", "turned"]
"""How the coordinates of a file of a profile stand."""

WEAR = {
    "area_m2": ("m2", "cross section worn off, less what has flowed beyond the nominal profile"),
    "greatest_depth_m": ("m", "greatest depth"),
    "greatest_depth_x_m": ("m", "its lateral coordinate"),
    "shift_x_m": ("m", "by how much the worn profile was moved across"),
    "shift_height_m": ("m", "and upward"),
    "misfit_m": ("m", "root mean square of what is left on the field side of a rail"),
    "tread_wear_m": ("m", "wear of the tread on the datum circle"),
    "flange_height_m": ("m", "height of the flange Sh"),
    "flange_thickness_m": ("m", "thickness of the flange Sd"),
    "flange_gradient_m": ("m", "qR"),
    "w1_m": ("m", "vertical wear of the rail at its crown"),
    "w2_m": ("m", "lateral wear of the rail at the gauge face"),
    "w3_m": ("m", "wear of the rail under 45 degrees at the gauge corner"),
}


def profile(
    file: str | os.PathLike[str],
    *,
    scatter: Quantity | None = None,
    orientation: Orientation | None = None,
) -> xr.Dataset:
    """The outline of a wheel or a rail.

    Parameters
    ----------
    file : str or path-like
        A nominal name such as ``"S1002"`` or ``"60E1"``, or a file: two columns, in mm or m, or of MiniProf, Simpack or Vampire.
    scatter : quantity, optional
        Standard deviation of the points of a file across the profile, which is then a smooth one; by default it goes through them.
    orientation : {"found", "as-written", "mirrored", "upside-down", "turned"}, optional
        How the coordinates of a file stand; by default as they are written in columns and as they are found in other formats.

    Returns
    -------
    xarray.Dataset
        ``height``, ``slope`` and ``curvature`` (positive where the outline is hollow seen from above) over ``x``, positive to
        the field side, every 0.25 mm. Attribute ``remarks``: what scatter does to the curvature, how coordinates were turned.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        For points that are no profile, with file and line.

    Examples
    --------
    >>> rail = riffel.profile("60E1")
    >>> crown = rail["height"].idxmax("x")
    >>> round(float(-1.0 / rail["curvature"].sel(x=crown)), 6)
    0.3
    """
    question = {"file": os.fspath(file), "scatter": scatter, "orientation": orientation}
    document, _, remarks = answer("profile", question)
    outline = document["profiles"][0]
    return xr.Dataset(
        {
            "height": ("x", outline["height_m"], _datasets.said("m", "height")),
            "slope": ("x", outline["slope"], _datasets.said("1", "slope")),
            "curvature": ("x", outline["curvature_1_per_m"], _datasets.said("1/m", "curvature, positive where hollow from above")),
        },
        {"x": _datasets.along("x", outline["x_m"], "m", "lateral coordinate, positive to the field side")},
        {"title": outline["name"], "remarks": remarks},
    )


def profile_wear(
    file: str | os.PathLike[str],
    nominal: str | os.PathLike[str],
    *,
    align: Literal["flange", "field-side", "as-written"] | None = None,
    inclination: str = "none",
    gauge_height: Quantity = "14 mm",
    scatter: Quantity | None = None,
    orientation: Orientation | None = None,
) -> xr.Dataset:
    """What is worn off a wheel or a rail.

    Parameters
    ----------
    file : str or path-like
        The worn profile, as of `profile`.
    nominal : str or path-like
        The profile it had: a nominal name or an earlier file.
    align : {"flange", "field-side", "as-written"}, optional
        By what the worn profile is laid on the nominal one; by default wheels by flange back and tip of the flange, rails by their
        field side.
    inclination : str, default "none"
        By what the nominal rail is inclined, as in ``"1:40"``, for coordinates that are.
    gauge_height : quantity, default "14 mm"
        Depth below the nominal crown at which wear of the gauge face is measured.
    scatter, orientation : optional
        As of `profile`.

    Returns
    -------
    xarray.Dataset
        ``depth`` across the nominal profile into the metal, over ``point``, with the coordinates ``x`` and ``height`` of the
        nominal profile; NaN where nothing is measured. ``area``, ``greatest_depth``, ``shift_x``, ``shift_height``, ``misfit``, and of
        wheels ``tread_wear``, ``flange_height``, ``flange_thickness`` and ``flange_gradient`` (qR), of rails ``w1``, ``w2`` and ``w3``.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        For points that are no profile, with file and line, and profiles that do not fit each other.

    Examples
    --------
    >>> wear = riffel.profile_wear("S1002", "S1002")
    >>> round(1e3 * float(wear["flange_height"]), 3), round(1e3 * float(wear["greatest_depth"]), 3)
    (28.0, 0.0)
    """
    question = {
        "file": file,
        "against": nominal,
        "align": align,
        "inclination": inclination,
        "gauge_height": gauge_height,
        "scatter": scatter,
        "orientation": orientation,
    }
    document = ask("profile", question)
    worn = document["profiles"][0]
    depth = np.array(worn["depth_m"], dtype=float)
    variables: dict[str, Any] = {"depth": ("point", depth, _datasets.said("m", "depth into the metal"))}
    for key, (units, name) in WEAR.items():
        if key in worn:
            value = np.nan if worn[key] is None else worn[key]
            variables[key.removesuffix("_m2").removesuffix("_m")] = ((), value, _datasets.said(units, name))
    return xr.Dataset(
        variables,
        {
            "x": ("point", worn["x_m"], _datasets.said("m", "lateral coordinate, positive to the field side")),
            "height": ("point", worn["height_m"], _datasets.said("m", "height of the nominal profile")),
        },
        {
            "title": worn["name"],
            "nominal": document["nominal"],
            "alignment": document["alignment"],
            "remarks": document["remarks"],
        },
    )

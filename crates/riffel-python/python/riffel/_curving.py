"""Wheelsets on their track and vehicles in curves, of a case, a file or its keys."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
import xarray as xr

from riffel import _datasets, _riffel, _vehicle_in_curve
from riffel._ask import answer, ask
from riffel._case import Case
from riffel._quantities import Quantities, Quantity, scalar, signed
from riffel._traffic import file_or_keys
from riffel._vehicle_in_curve import RAILS

GivenCase: TypeAlias = "Case | str | os.PathLike[str] | Mapping[str, Any]"
"""A case, a file with the tables of curving, or its keys."""

# Of a contact under load; all but the first by their keys.
THEORIES = ["exact", "conformal", "fast", "hertz"]


def curve(
    case: GivenCase, overrides: Mapping[str, Any] | None = None, *, radius: Quantities | None = None
) -> xr.Dataset:
    """A wheelset, a bogie or a vehicle in its curve: how it stands, creepages, forces and wear number of each wheel.

    Parameters
    ----------
    case : Case, path-like or mapping
        A case that holds the tables of curving, a file of these tables, or its keys.
    overrides : mapping, optional
        Values by dotted key.
    radius : quantities, optional
        Radii of curves, above zero to the right, each run through at the lateral acceleration of the case; by default the
        radius of the case alone.

    Returns
    -------
    xarray.Dataset
        Over ``wheelset`` and ``rail``, ``bogie`` for the frames of a vehicle, and over ``radius`` where radii are given;
        values are NaN in curves in which no equilibrium is found. Of a wheel on two points ``second_…`` is the contact of the larger angle, NaN elsewhere.
        Attributes tell ``other_equilibria`` and ``remarks`` of the radius of the case.

    Raises
    ------
    ValueError
        For a key or a value that is not allowed.
    ConvergenceError
        Where no equilibrium is found at the radius of the case.

    Examples
    --------
    >>> bogie = riffel.curve("cases/bogie.toml", radius=["300 m", "1000 m"])
    >>> bogie["angle_of_attack"].sel(wheelset=1).round(4).values.tolist()
    [0.008, 0.0021]
    """
    radii = None if radius is None else signed(radius, "radius", "length")
    return _vehicle_in_curve.curve(_of_curving(case, overrides), radii)


def contact_geometry(
    case: GivenCase,
    overrides: Mapping[str, Any] | None = None,
    *,
    lateral_shift: Quantities | None = None,
    yaw: Quantity = 0.0,
) -> xr.Dataset:
    """Where the wheelset of a case touches its track, and its equivalent conicity.

    Parameters
    ----------
    case : Case, path-like or mapping
        As of `curve`; only the tables of wheels and profiles are needed.
    overrides : mapping, optional
        Values by dotted key.
    lateral_shift : quantities, optional
        To the right positive; by default from -10 to 10 mm every 0.1 mm, as far as both wheels touch their rails.
    yaw : float, optional
        In rad, nose to the right positive.

    Returns
    -------
    xarray.Dataset
        Over ``lateral_shift`` and ``rail``: ``rolling_radius``, ``contact_angle``, place on wheel and track, curvatures, and
        the second point within 0.05 mm, NaN where there is none. ``klingel``, ``harmonic`` and ``regression`` are equivalent
        conicities over ``amplitude``.

    Raises
    ------
    ValueError
        For profiles that do not fit, and where a wheel has left its rail.

    Examples
    --------
    >>> on_track = riffel.contact_geometry("cases/profiles.toml")
    >>> float(on_track["klingel"].sel(amplitude=0.003).round(4))
    0.1771
    """
    shifts = None if lateral_shift is None else signed(lateral_shift, "lateral_shift", "length")
    angle = float(signed(yaw, "yaw", "ratio")[0])
    given = _of_curving(case, overrides)
    found = ask("profile", {"file": given, "wheelset": True, "lateral_shift": shifts, "yaw": angle})
    sides = {
        "rolling_radius": ("m", "rolling radius"),
        "contact_angle": ("rad", "contact angle"),
        "y_wheel": ("m", "place on the wheel, negative towards the flange"),
        "x_track": ("m", "place ahead of the axle"),
        "y_track": ("m", "place to the right of the middle of the track"),
        "z_track": ("m", "place below the crowns"),
        "rail_curvature": ("1/m", "curvature of the rail, positive for a convex head"),
        "wheel_curvature": ("1/m", "curvature of the wheel, positive for a hollow one"),
        "second_gap": ("m", "gap at the second point"),
        "second_y_wheel": ("m", "place of the second point on the wheel"),
    }
    both = {
        key: (
            ("lateral_shift", "rail"),
            np.array([found[f"{rail}_{key}"] for rail in RAILS], float).T,
            _datasets.said(units, name),
        )
        for key, (units, name) in sides.items()
    }
    whole = {
        "roll": ("rad", "roll, right side down positive"),
        "centre_z": ("m", "lowering of the axle"),
        "rolling_radius_difference": ("m", "rolling radius, right less left"),
    }
    conicity = found["equivalent_conicity"]
    rules = {
        rule + name: ("amplitude", np.array(found[rule], float), _datasets.said("1", f"equivalent conicity, {rule}{said}"))
        for name, said, found in [("", "", conicity), ("_en_15302", ", by EN 15302", conicity["en_15302"])]
        for rule in ("klingel", "harmonic", "regression")
    }
    return xr.Dataset(
        {
            **both,
            **{key: ("lateral_shift", found[key], _datasets.said(units, name)) for key, (units, name) in whole.items()},
            **rules,
        },
        {
            "lateral_shift": _datasets.along("lateral_shift", found["lateral_shift"], "m", "lateral shift, to the right positive"),
            "rail": ("rail", RAILS, {"long_name": "rail"}),
            "amplitude": _datasets.along("amplitude", conicity["amplitude_m"], "m", "amplitude, half of peak to peak"),
            "yaw": ((), angle, _datasets.said("rad", "yaw, nose to the right positive")),
        },
        _datasets.titled(given.title),
    )


def contact_under_load(
    case: GivenCase,
    load: Quantity,
    overrides: Mapping[str, Any] | None = None,
    *,
    lateral_shift: Quantities = 0.0,
    yaw: Quantity = 0.0,
) -> xr.Dataset:
    """Both contacts of a wheelset pressed on its track by their own profiles, exact on the half-space.

    Parameters
    ----------
    case : Case, path-like or mapping
        As of `curve`; only the tables of wheels, profiles and steel are needed.
    load : float
        Normal force on each wheel in N.
    overrides : mapping, optional
        Values by dotted key.
    lateral_shift : quantities, optional
        To the right positive.
    yaw : float, optional
        In rad, nose to the right positive.

    Returns
    -------
    xarray.Dataset
        Over ``lateral_shift``, ``rail`` and ``theory`` (exact on the contact plane, conformal on the curved rail, fast after Kik
        and Piotrowski, Hertz): ``approach``, ``peak_pressure``, ``area``, ``length``, ``width``, NaN where a theory has none; over
        the first two ``stiffness`` and ``conformal_stiffness``, equivalent semi-axes and ``turn_of_rail``, which a flat patch leaves out.
        Remarks are attributes.

    Raises
    ------
    ValueError
        For profiles that do not fit, a load that is not positive, and contacts at the end of a profile.

    Examples
    --------
    >>> pressed = riffel.contact_under_load("cases/profiles.toml", "60 kN")
    >>> pressed["peak_pressure"].dims
    ('lateral_shift', 'rail', 'theory')
    """
    shifts = signed(lateral_shift, "lateral_shift", "length")
    angle = float(signed(yaw, "yaw", "ratio")[0])
    force = scalar(load, "load", "force")
    given = _of_curving(case, overrides)
    question = {"file": given, "wheelset": True, "load": force, "lateral_shift": shifts, "yaw": angle}
    found, _, remarks = answer("profile", question)
    rows = found["contacts"]

    def over_theories(key: str) -> np.ndarray[Any, np.dtype[np.float64]]:
        values = [[(of or {}).get(key, np.nan) for of in (row, *(row[name] for name in THEORIES[1:]))] for row in rows]
        return np.array(values, float).reshape(len(shifts), len(RAILS), len(THEORIES))

    def alone(values: list[float | None]) -> np.ndarray[Any, np.dtype[np.float64]]:
        return np.array(values, float).reshape(len(shifts), len(RAILS))

    theories = {
        "approach": ("approach_m", "m", "approach of wheel and rail"),
        "peak_pressure": ("peak_pressure_pa", "Pa", "largest pressure"),
        "area": ("area_m2", "m2", "area of the patch"),
        "length": ("length_m", "m", "length of the patch along the rail"),
        "width": ("width_m", "m", "width of the patch"),
    }
    places = ("lateral_shift", "rail")
    return xr.Dataset(
        {
            **{
                name: ((*places, "theory"), over_theories(key), _datasets.said(units, words))
                for name, (key, units, words) in theories.items()
            },
            "stiffness": (places, alone([row["stiffness_n_per_m"] for row in rows]), _datasets.said("N/m", "contact stiffness")),
            "conformal_stiffness": (
                places,
                alone([(row["conformal"] or {}).get("stiffness_n_per_m") for row in rows]),
                _datasets.said("N/m", "contact stiffness on the curved rail"),
            ),
            "turn_of_rail": (
                places,
                alone([row["turn_of_rail_rad"] for row in rows]),
                _datasets.said("rad", "turn of the rail across the patch"),
            ),
            "semi_axis_longitudinal": (
                places,
                alone([row["equivalent_semi_axes_m"][0] for row in rows]),
                _datasets.said("m", "semi-axis along the rail of the equivalent ellipse"),
            ),
            "semi_axis_lateral": (
                places,
                alone([row["equivalent_semi_axes_m"][1] for row in rows]),
                _datasets.said("m", "semi-axis across the rail of the equivalent ellipse"),
            ),
        },
        {
            "lateral_shift": _datasets.along("lateral_shift", shifts.tolist(), "m", "lateral shift, to the right positive"),
            "rail": ("rail", RAILS, {"long_name": "rail"}),
            "theory": ("theory", THEORIES, {"long_name": "theory of the contact"}),
            "yaw": ((), angle, _datasets.said("rad", "yaw, nose to the right positive")),
            "load": ((), force, _datasets.said("N", "normal force on each wheel")),
        },
        {**_datasets.titled(given.title), "remarks": remarks},
    )


def _of_curving(case: GivenCase, overrides: Mapping[str, Any] | None) -> _riffel.CurvingCase:
    given = case._case if isinstance(case, Case) else file_or_keys(case)
    return _riffel.CurvingCase(given, dict(overrides or {}))

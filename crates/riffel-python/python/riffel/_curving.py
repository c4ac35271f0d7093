"""Profiles of wheels and rails, wheelsets on their track and vehicles in curves as `xarray` objects."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from operator import itemgetter
from typing import Any, Literal, TypeAlias

import numpy as np
import xarray as xr

from riffel import _riffel
from riffel._case import Case
from riffel._quantities import Quantities, Quantity, array, scalar, signed
from riffel._traffic import plain_keys

GivenCase: TypeAlias = "Case | str | os.PathLike[str] | Mapping[str, Any]"
"""A case, a file with the tables of curving, or its keys."""

Orientation: TypeAlias = Literal["found", "as-written", "mirrored", "upside-down", "turned"]
"""How the coordinates of a file of a profile stand."""

RAILS = ["left", "right"]
# Of a contact under load; all but the first by their keys.
THEORIES = ["exact", "conformal", "fast", "hertz"]

# Keys of the document, with units and long names.
WHEELS = {
    "longitudinal_creepage": ("1", "longitudinal creepage, positive in braking"),
    "lateral_creepage": ("1", "lateral creepage in the plane of contact"),
    "spin_1_per_m": ("1/m", "spin creepage"),
    "contact_angle_rad": ("rad", "contact angle"),
    "rolling_radius_m": ("m", "rolling radius"),
    "vertical_load_n": ("N", "vertical load"),
    "normal_force_n": ("N", "normal force"),
    "longitudinal_force_n": ("N", "longitudinal force on the rail"),
    "lateral_force_n": ("N", "lateral force on the rail in the plane of contact"),
    "track_lateral_force_n": ("N", "lateral force on the rail in the plane of the track, to the right positive"),
    "tractive_ratio": ("1", "share of friction |Q|/(mu P)"),
    "t_gamma_n": ("N", "wear number T gamma, without the moment of spin"),
    "on_two_points": ("1", "whether the wheel stands on two points"),
}
WHEELSETS = {
    "lateral_shift_m": ("m", "lateral shift, to the right positive"),
    "yaw_rad": ("rad", "yaw, nose to the right positive"),
    "angle_of_attack_rad": ("rad", "angle of attack, nose to the outside positive"),
    "rotation_ratio": ("1", "rotation over that of pure rolling"),
    "flange_force_n": ("N", "lateral force of a flange that is a spring"),
    "suspension_lateral_force_n": ("N", "lateral force of the suspension on the wheelset"),
    "suspension_yaw_moment_nm": ("N m", "yaw moment of the suspension on the wheelset"),
}
FRAMES = {
    "lateral_shift_m": ("m", "lateral shift of the frame from the chord between its axles"),
    "yaw_rad": ("rad", "yaw of the frame from the tangent in its middle"),
    "inertial_lateral_force_n": ("N", "lateral inertial force of the frame and all it carries but a body"),
    "secondary_lateral_force_n": ("N", "lateral force of the secondary suspension on the frame"),
    "secondary_yaw_moment_nm": ("N m", "yaw moment of the secondary suspension on the frame"),
}
BODY = {
    "lateral_shift_m": ("m", "lateral shift of the body from the chord between the bogies"),
    "yaw_rad": ("rad", "yaw of the body from the tangent in the middle of the vehicle"),
    "inertial_lateral_force_n": ("N", "lateral inertial force of the body"),
}
WHOLE = {
    "uncompensated_lateral_acceleration_m_s2": ("m/s2", "lateral acceleration that the cant leaves, outward positive"),
    "frictional_power_w": ("W", "power of friction"),
    "drive_power_w": ("W", "power of the torques"),
    "curving_resistance_n": ("N", "resistance of the curve"),
    "residual": ("1", "largest residual over the load of a wheel"),
}
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
UNITS = ("_1_per_m", "_m_s2", "_rad", "_nm", "_m", "_n", "_w")


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
    radii = None if radius is None else signed(radius, "radius", "length").tolist()
    title, document = _riffel.curve(_given(case), dict(overrides or {}), radii)
    states: list[Any] = [document]
    numbers = [wheelset["wheelset"] for wheelset in document["wheelsets"]]
    dimensions: tuple[str, ...] = ()
    coordinates: dict[str, Any] = {
        "wheelset": _along("wheelset", numbers, "1", "wheelset, 1 leads"),
        "rail": ("rail", RAILS, {"long_name": "rail"}),
    }
    if radii is not None:
        points = document["over_radius"]
        states, dimensions = [point["equilibrium"] for point in points], ("radius",)
        coordinates["radius"] = _along(
            "radius", [point["radius_m"] for point in points], "m", "radius, to the right positive"
        )
        coordinates["speed"] = _along(
            "radius", [point["speed_m_per_s"] for point in points], "m/s", "speed of the vehicle"
        )

    variables: dict[str, Any] = {}

    def add(name: str, of: tuple[str, ...], said: dict[str, str], value: Callable[[Any], Any]) -> None:
        shape = tuple(len(coordinates[dimension][1]) for dimension in of)
        none = np.full(shape, np.nan)
        values = [none if state is None else np.array(value(state), float).reshape(shape) for state in states]
        variables[name] = ((*dimensions, *of), np.array(values) if dimensions else values[0], said)

    for key, (units, name) in WHEELS.items():
        add(_without_unit(key), ("wheelset", "rail"), _said(units, name), partial(_of_wheels, key))
        if key not in ("vertical_load_n", "on_two_points"):
            said = _said(units, f"{name}, at the second contact")
            add(f"second_{_without_unit(key)}", ("wheelset", "rail"), said, partial(_of_second_contacts, key))
    for key, (units, name) in WHEELSETS.items():
        add(_without_unit(key), ("wheelset",), _said(units, name), partial(_of_wheelsets, key))
    if "frames" in document:
        coordinates["bogie"] = _along("bogie", [1, 2], "1", "bogie, 1 leads")
        for key, (units, name) in FRAMES.items():
            add(f"frame_{_without_unit(key)}", ("bogie",), _said(units, name), partial(_of_frames, key))
        for key, (units, name) in BODY.items():
            add(f"body_{_without_unit(key)}", (), _said(units, name), partial(_of_body, key))
    for key, (units, name) in WHOLE.items():
        add(_without_unit(key), (), _said(units, name), itemgetter(key))
    attributes = {key: document[key] for key in ("other_equilibria", "remarks")}
    return xr.Dataset(variables, coordinates, {**_titled(title), **attributes})


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
    scattered = None if scatter is None else scalar(scatter, "scatter", "length")
    document, remarks = _riffel.profile(os.fspath(file), scattered, orientation)
    outline = document["profiles"][0]
    return xr.Dataset(
        {
            "height": ("x", outline["height_m"], _said("m", "height")),
            "slope": ("x", outline["slope"], _said("1", "slope")),
            "curvature": ("x", outline["curvature_1_per_m"], _said("1/m", "curvature, positive where hollow from above")),
        },
        {"x": _along("x", outline["x_m"], "m", "lateral coordinate, positive to the field side")},
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
    scattered = None if scatter is None else scalar(scatter, "scatter", "length")
    below = scalar(gauge_height, "gauge_height", "length")
    document = _riffel.profile_wear(
        os.fspath(file), os.fspath(nominal), scattered, orientation, align, inclination, below
    )
    worn = document["profiles"][0]
    depth = np.array(worn["depth_m"], dtype=float)
    variables: dict[str, Any] = {"depth": ("point", depth, _said("m", "depth into the metal"))}
    for key, (units, name) in WEAR.items():
        if key in worn:
            value = np.nan if worn[key] is None else worn[key]
            variables[key.removesuffix("_m2").removesuffix("_m")] = ((), value, _said(units, name))
    return xr.Dataset(
        variables,
        {
            "x": ("point", worn["x_m"], _said("m", "lateral coordinate, positive to the field side")),
            "height": ("point", worn["height_m"], _said("m", "height of the nominal profile")),
        },
        {
            "title": worn["name"],
            "nominal": document["nominal"],
            "alignment": document["alignment"],
            "remarks": document["remarks"],
        },
    )


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
        To the right positive; by default from -10 to 10 mm every 0.1 mm.
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
    shifts = np.linspace(-0.01, 0.01, 201) if lateral_shift is None else signed(lateral_shift, "lateral_shift", "length")
    angle = float(signed(yaw, "yaw", "ratio")[0])
    title, found = _riffel.contact_geometry(_given(case), dict(overrides or {}), shifts.tolist(), angle)
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
            _said(units, name),
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
        rule + name: ("amplitude", np.array(found[rule], float), _said("1", f"equivalent conicity, {rule}{said}"))
        for name, said, found in [("", "", conicity), ("_en_15302", ", by EN 15302", conicity["en_15302"])]
        for rule in ("klingel", "harmonic", "regression")
    }
    return xr.Dataset(
        {
            **both,
            **{key: ("lateral_shift", found[key], _said(units, name)) for key, (units, name) in whole.items()},
            **rules,
        },
        {
            "lateral_shift": _along("lateral_shift", found["lateral_shift"], "m", "lateral shift, to the right positive"),
            "rail": ("rail", RAILS, {"long_name": "rail"}),
            "amplitude": _along("amplitude", conicity["amplitude_m"], "m", "amplitude, half of peak to peak"),
            "yaw": ((), angle, _said("rad", "yaw, nose to the right positive")),
        },
        _titled(title),
    )


def _of_wheels(key: str, state: Mapping[str, Any]) -> list[float]:
    return [wheel[key] for wheel in state["wheels"]]


def _of_second_contacts(key: str, state: Mapping[str, Any]) -> list[float]:
    """What the second contacts of wheels on two points have; NaN for those on one."""
    return [wheel.get("second_contact", {}).get(key, np.nan) for wheel in state["wheels"]]


def _of_frames(key: str, state: Any) -> list[Any]:
    return [frame[key] for frame in state["frames"]]


def _of_body(key: str, state: Any) -> Any:
    return state["body"][key]


def _of_wheelsets(key: str, state: Mapping[str, Any]) -> list[float]:
    return [wheelset[key] for wheelset in state["wheelsets"]]


def _given(case: GivenCase) -> _riffel.Case | dict[str, Any] | str:
    if isinstance(case, Case):
        return case._case
    if isinstance(case, Mapping):
        return plain_keys(case)
    return os.fspath(case)


def _said(units: str, name: str) -> dict[str, str]:
    return {"units": units, "long_name": name}


def _along(dimension: str, values: Sequence[float], units: str, name: str) -> tuple[str, Sequence[float], dict[str, str]]:
    return dimension, values, _said(units, name)


def _titled(title: str | None) -> dict[str, Any]:
    return {} if title is None else {"title": title}


def _without_unit(key: str) -> str:
    for unit in UNITS:
        if key.endswith(unit):
            return key.removesuffix(unit)
    return key


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
    given = (_given(case), dict(overrides or {}), force, shifts.tolist(), angle)
    title, found, remarks = _riffel.contact_under_load(*given)
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
                name: ((*places, "theory"), over_theories(key), _said(units, words))
                for name, (key, units, words) in theories.items()
            },
            "stiffness": (places, alone([row["stiffness_n_per_m"] for row in rows]), _said("N/m", "contact stiffness")),
            "conformal_stiffness": (
                places,
                alone([(row["conformal"] or {}).get("stiffness_n_per_m") for row in rows]),
                _said("N/m", "contact stiffness on the curved rail"),
            ),
            "turn_of_rail": (
                places,
                alone([row["turn_of_rail_rad"] for row in rows]),
                _said("rad", "turn of the rail across the patch"),
            ),
            "semi_axis_longitudinal": (
                places,
                alone([row["equivalent_semi_axes_m"][0] for row in rows]),
                _said("m", "semi-axis along the rail of the equivalent ellipse"),
            ),
            "semi_axis_lateral": (
                places,
                alone([row["equivalent_semi_axes_m"][1] for row in rows]),
                _said("m", "semi-axis across the rail of the equivalent ellipse"),
            ),
        },
        {
            "lateral_shift": _along("lateral_shift", shifts.tolist(), "m", "lateral shift, to the right positive"),
            "rail": ("rail", RAILS, {"long_name": "rail"}),
            "theory": ("theory", THEORIES, {"long_name": "theory of the contact"}),
            "yaw": ((), angle, _said("rad", "yaw, nose to the right positive")),
            "load": ((), force, _said("N", "normal force on each wheel")),
        },
        {**_titled(title), "remarks": remarks},
    )

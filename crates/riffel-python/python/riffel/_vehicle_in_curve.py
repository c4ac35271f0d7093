"""A wheelset, a bogie or a vehicle in its curve as an `xarray` object."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from operator import itemgetter
from typing import Any

import numpy as np
import xarray as xr

from riffel import _datasets, _riffel
from riffel._ask import ask
from riffel._quantities import Floats

RAILS = ["left", "right"]

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
UNITS = ("_1_per_m", "_m_s2", "_rad", "_nm", "_m", "_n", "_w")


def curve(case: _riffel.CurvingCase, radii: Floats | None) -> xr.Dataset:
    """How a vehicle stands in its curve, over radii or in that of the case alone."""
    document = ask("curve", {"case": case, "radius": radii})
    states: list[Any] = [document]
    numbers = [wheelset["wheelset"] for wheelset in document["wheelsets"]]
    dimensions: tuple[str, ...] = ()
    coordinates: dict[str, Any] = {
        "wheelset": _datasets.along("wheelset", numbers, "1", "wheelset, 1 leads"),
        "rail": ("rail", RAILS, {"long_name": "rail"}),
    }
    if radii is not None:
        points = document["over_radius"]
        states, dimensions = [point["equilibrium"] for point in points], ("radius",)
        coordinates["radius"] = _datasets.along(
            "radius", [point["radius_m"] for point in points], "m", "radius, to the right positive"
        )
        coordinates["speed"] = _datasets.along(
            "radius", [point["speed_m_per_s"] for point in points], "m/s", "speed of the vehicle"
        )

    variables: dict[str, Any] = {}

    def add(name: str, of: tuple[str, ...], said: dict[str, str], value: Callable[[Any], Any]) -> None:
        shape = tuple(len(coordinates[dimension][1]) for dimension in of)
        none = np.full(shape, np.nan)
        values = [none if state is None else np.array(value(state), float).reshape(shape) for state in states]
        variables[name] = ((*dimensions, *of), np.array(values) if dimensions else values[0], said)

    for key, (units, name) in WHEELS.items():
        add(_without_unit(key), ("wheelset", "rail"), _datasets.said(units, name), partial(_of_wheels, key))
        if key not in ("vertical_load_n", "on_two_points"):
            said = _datasets.said(units, f"{name}, at the second contact")
            add(f"second_{_without_unit(key)}", ("wheelset", "rail"), said, partial(_of_second_contacts, key))
    for key, (units, name) in WHEELSETS.items():
        add(_without_unit(key), ("wheelset",), _datasets.said(units, name), partial(_of_wheelsets, key))
    if "frames" in document:
        coordinates["bogie"] = _datasets.along("bogie", [1, 2], "1", "bogie, 1 leads")
        for key, (units, name) in FRAMES.items():
            add(f"frame_{_without_unit(key)}", ("bogie",), _datasets.said(units, name), partial(_of_frames, key))
        for key, (units, name) in BODY.items():
            add(f"body_{_without_unit(key)}", (), _datasets.said(units, name), partial(_of_body, key))
    for key, (units, name) in WHOLE.items():
        add(_without_unit(key), (), _datasets.said(units, name), itemgetter(key))
    attributes = {key: document[key] for key in ("other_equilibria", "remarks")}
    return xr.Dataset(variables, coordinates, {**_datasets.titled(case.title), **attributes})


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


def _without_unit(key: str) -> str:
    for unit in UNITS:
        if key.endswith(unit):
            return key.removesuffix(unit)
    return key

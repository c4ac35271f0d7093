"""The wheels of a vehicle in its curve."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import xarray as xr

from riffel import _datasets, _riffel
from riffel._case import Case

# Keys of the document, with units and long names.
STATES = {
    "longitudinal_creepage": ("1", "longitudinal creepage, positive in braking"),
    "lateral_creepage": ("1", "lateral creepage in the plane of contact"),
    "spin_1_per_m": ("1/m", "spin creepage"),
    "normal_force_n": ("N", "normal force"),
    "contact_angle_rad": ("rad", "contact angle"),
    "tractive_ratio": ("1", "share of friction |Q|/(mu P)"),
    "share_of_second_contact": ("1", "share of the normal forces of the wheel on the point that the loop leaves out"),
}


def _label(wheel: dict[str, Any]) -> str:
    flange = " flange" if wheel["contact"] == "flange" else ""
    return f"{wheel['wheelset']} {wheel['rail']}{flange}"


def wheels_of_curve(case: Case) -> xr.Dataset:
    """Growth under every wheel of the vehicle in its curve, side by side.

    Parameters
    ----------
    case : Case
        A case that takes its mean state from a curve, by ``contact.from``.

    Returns
    -------
    xarray.Dataset
        Over ``wheel``, wheelset by wheelset from the front and the low rail first, of wheels on two points both contacts: ``growth_map`` by ``speed`` and
        ``map_wavelength``, the growth rate per passage on the grid of the map; ``growth_rate`` by ``wavelength`` under the usual
        traffic of the curve; ``fastest_wavelength``, ``fastest_growth_rate`` and ``fastest_frequency`` there, NaN where nothing grows;
        ``wheelset``, ``rail``, ``side`` and ``contact``; the mean state in the equilibrium of the vehicle under the names of `riffel.curve`;
        ``not_in_loop``, why a wheel has no mean state in the loop and NaN in the place of growth, or nothing. Attributes: radius and
        speed of the curve, and ``wheels``, all that ``riffel map --wheels --json`` says of each.

    Raises
    ------
    ValueError
        For a case without ``contact.from``.

    Examples
    --------
    >>> case = riffel.Case.from_toml("cases/metro-curve.toml")
    >>> wheels = riffel.wheels_of_curve(case.with_({"map.wavelength.points": 21, "map.speed.points": 3}))
    >>> carrying = wheels["fastest_growth_rate"].where(wheels["share_of_second_contact"] <= 0.5)
    >>> str(carrying.idxmax("wheel").values)
    '2 low'
    """
    found, (speeds, map_wavelengths), maps = _riffel.wheels_of_curve(case._case)
    wheels = found["wheels"]
    wavelengths = found["wavelength_m"]
    shape = (len(speeds), len(map_wavelengths))

    column = partial(_datasets.column, "wheel", wheels)
    fastest = partial(_datasets.column, "wheel", [wheel["highest"] or {} for wheel in wheels])
    texts = partial(_datasets.texts, "wheel", wheels)
    on_grid = [np.full(shape, np.nan) if values is None else values.reshape(shape) for values in maps]
    return xr.Dataset(
        {
            "growth_map": (("wheel", "speed", "map_wavelength"), np.array(on_grid), _datasets.GROWTH_RATE),
            "growth_rate": (("wheel", "wavelength"), _datasets.rates(wheels, wavelengths), _datasets.GROWTH_RATE),
            "fastest_wavelength": fastest("wavelength_m", "m", "wavelength that grows fastest under the usual traffic"),
            "fastest_growth_rate": fastest("growth_rate_per_passage", "1", "its growth rate per passage"),
            "fastest_frequency": fastest("frequency_hz", "Hz", "its frequency"),
            "wheelset": ("wheel", [wheel["wheelset"] for wheel in wheels], {"long_name": "wheelset, 1 leads"}),
            "rail": texts("rail", "low or high rail"),
            "side": texts("side", "left or right rail"),
            "contact": texts("contact", "tread, or flange of a wheel on two points"),
            **{key: column(key, *said) for key, said in STATES.items()},
            "not_in_loop": texts("not_in_loop", "why the loop has no mean state there"),
        },
        {
            "wheel": ("wheel", [_label(wheel) for wheel in wheels], {"long_name": "wheel"}),
            "wavelength": ("wavelength", wavelengths, _datasets.WAVELENGTH),
            "speed": ("speed", speeds, _datasets.SPEED),
            "map_wavelength": ("map_wavelength", map_wavelengths, _datasets.WAVELENGTH),
        },
        {
            **_datasets.attributes(case.title),
            "radius_m": found["radius_m"],
            "speed_m_per_s": found["speed_m_per_s"],
            "wheels": wheels,
        },
    )

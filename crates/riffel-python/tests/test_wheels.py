"""The wheels of a vehicle in its curve."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import riffel

FEW = {"map.wavelength.points": 8, "map.speed.points": 4}


# Long: maps the wheels of a bogie twice, here and by the program.
def test_wheels_are_those_of_the_keys(program: Callable[..., Any]) -> None:
    case = riffel.Case.from_toml("cases/metro-curve.toml").with_(FEW)
    wheels = riffel.wheels_of_curve(case)
    assert wheels["growth_map"].sizes == {"wheel": 5, "speed": 4, "map_wavelength": 8}
    assert wheels["wheel"].values.tolist() == ["1 low", "1 high", "1 high flange", "2 low", "2 high"]
    own = case.with_({"contact.from.wheelset": 2, "contact.from.rail": "high"}).growth_map()["growth_rate"]
    np.testing.assert_allclose(wheels["growth_map"].sel(wheel="2 high").values, own.values, rtol=1e-12)
    assert wheels["growth_rate"].max().item() <= wheels["fastest_growth_rate"].max().item()
    found = program(
        "map", "cases/metro-curve.toml", "--wheels", "--json", *(f"--set={key}={value}" for key, value in FEW.items())
    )
    assert wheels.attrs["wheels"] == found["wheels"]
    state = riffel.curve(case).sel(wheelset=1, rail="right")
    assert wheels["lateral_creepage"].sel(wheel="1 low").item() == state["lateral_creepage"].item()


def test_wheels_that_slide_as_a_whole_have_a_loop(nominal: riffel.Case) -> None:
    case = riffel.Case.from_toml("cases/metro-curve.toml")
    keys = {**FEW, "contact.creep_law": "shen-hedrick-elkins", "contact.from.wheelset": 2}
    wheels = riffel.wheels_of_curve(case.with_(keys))
    assert wheels["not_in_loop"].values.tolist() == [""] * 5
    for name in ("growth_map", "growth_rate"):
        assert np.isfinite(wheels[name].values).all()
    with pytest.raises(ValueError, match="contact.from"):
        riffel.wheels_of_curve(nominal)


def test_the_patch_of_the_profiles_enters_the_loop() -> None:
    case = riffel.Case.from_toml("cases/metro-curve.toml").with_({"contact.from.wheelset": 2})
    pressed = case.with_({"contact.from.patch": "non-elliptic"})
    state = riffel.curve(case).sel(wheelset=2, rail="right")
    under = riffel.contact_under_load(
        "cases/metro-curve.toml", state["normal_force"].item(), lateral_shift=state["lateral_shift"].item()
    )
    stiffness = under["stiffness"].sel(rail="right").item()
    told = [remark for remark in pressed.remarks if "right rail the patch is that of the profiles under load" in remark]
    assert f"{1e-6 * stiffness:.0f} MN/m" in told[0]
    rates = [one.point(wavelength="60 mm", speed="45 km/h")["growth_rate_per_passage"] for one in (case, pressed)]
    # The same stiffness on the ellipse of Hertz is another contact.
    by_hand = case.with_({"contact.stiffness": stiffness}).point(wavelength="60 mm", speed="45 km/h")
    assert len({*rates, by_hand["growth_rate_per_passage"]}) == 3


def test_effects_of_a_moving_contact_are_keys() -> None:
    case = riffel.Case.from_toml("cases/metro-curve.toml").with_({"contact.from.wheelset": 2})
    moving = case.with_({"contact.conformity": {"cross_slope": "10 1/m"}})
    growth = moving.point(wavelength="60 mm", speed="45 km/h")["growth_rate_per_passage"]
    without = moving.with_({"contact.conformity.spin": False}).point(wavelength="60 mm", speed="45 km/h")
    assert growth != without["growth_rate_per_passage"]
    with pytest.raises(ValueError, match="must be true or false"):
        moving.with_({"contact.conformity.spin": 3})

"""Profiles, contact geometry and bogies in curves hold what the program prints."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import riffel

CURVE = "cases/bogie.toml"


def test_curve_is_that_of_the_program(program: Callable[..., Any]) -> None:
    document = program("curve", CURVE, "--json", "--radius", "300 m,-300 m")
    bogie = riffel.curve(CURVE)
    assert bogie["t_gamma"].dims == ("wheelset", "rail")
    assert bogie["t_gamma"].values.ravel().tolist() == [wheel["t_gamma_n"] for wheel in document["wheels"]]
    assert bogie["frictional_power"].item() == document["frictional_power_w"]
    assert bogie.attrs["remarks"] == document["remarks"]
    over_radius = riffel.curve(CURVE, radius=["300 m", -300.0])
    assert over_radius["yaw"].dims == ("radius", "wheelset")
    assert (over_radius["yaw"].isel(radius=0) == bogie["yaw"]).all()
    np.testing.assert_allclose(over_radius["yaw"].values[1], -bogie["yaw"].values, atol=1e-10)
    assert np.isnan(bogie["second_normal_force"]).all()


def test_measured_points_are_smoothed(tmp_path: Path) -> None:
    x = np.arange(-30.0, 30.0, 0.2)
    scatter = np.random.default_rng(1).normal(0.0, 0.01, x.size)
    rail = tmp_path / "rail.csv"
    np.savetxt(rail, np.column_stack([x, -(x**2) / 600.0 + scatter]), delimiter=",", header="x_mm,y_mm", comments="")
    through, smooth = riffel.profile(rail), riffel.profile(rail, scatter="10 um")
    assert "the points scatter by" in through.attrs["remarks"][0]
    off = [float(abs(one["curvature"].sel(x=slice(-0.01, 0.01)) + 1.0 / 0.3).max()) for one in (through, smooth)]
    assert off[0] > 100.0 and off[1] < 1.0
    with pytest.raises(ValueError, match="scatter"):
        riffel.profile(rail, scatter="-10 um")


def test_wear_is_that_of_the_program(program: Callable[..., Any]) -> None:
    asked = ("cases/worn-rail.csv", "--against", "60E1", "--json")
    worn = program("profile", *asked)["profiles"][0]
    wear = riffel.profile_wear("cases/worn-rail.csv", "60E1")
    assert float(wear["area"]) == worn["area_m2"]
    assert float(wear["w2"]) == worn["w2_m"]
    depth = wear["depth"].values
    # What the device did not reach is NaN there and null here.
    assert [None if np.isnan(one) else one for one in depth.tolist()] == worn["depth_m"]
    # By NumPy: the area between both outlines, by heights. 3 %: normals and heights leave other ends, and chords are straight.
    rail = riffel.profile("60E1")
    x, y = np.loadtxt("cases/worn-rail.csv", delimiter=",", skiprows=2).T * 1e-3
    across = np.linspace(-0.025, 0.03, 2000)
    lower = np.interp(across, x + float(wear["shift_x"]), y + float(wear["shift_height"]))
    between = np.trapezoid(np.interp(across, rail["x"], rail["height"]) - lower, across)
    inside = (wear["x"].values > -0.025) & (wear["x"].values < 0.03)
    steps = np.hypot(np.diff(wear["x"].values[inside]), np.diff(wear["height"].values[inside]))
    by_depth = np.sum(0.5 * (depth[inside][1:] + depth[inside][:-1]) * steps)
    assert abs(by_depth / between - 1.0) < 0.03
    with pytest.raises(ValueError, match="align is"):
        riffel.profile_wear("cases/worn-rail.csv", "60E1", align="foot")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="orientation is"):
        riffel.profile("cases/worn-rail.csv", orientation="sideways")  # type: ignore[arg-type]


def test_a_loop_takes_its_mean_state_from_the_curve(program: Callable[..., Any]) -> None:
    path = "cases/metro-curve.toml"
    asked = ("point", path, "--wavelength", "60 mm", "--speed", "45 km/h", "--json")
    case = riffel.Case.from_toml(path)
    at_one_point = {"wavelength": "60 mm", "speed": "45 km/h"}

    def growth_of(case: riffel.Case) -> Any:
        return case.point(**at_one_point)["growth_rate_per_passage"]

    growth = growth_of(case)
    assert growth == program(*asked)["growth_rate_per_passage"]
    # In a wide curve the wheel hardly slides: what grows here decays there.
    assert growth_of(case.with_({"curve.radius": "1200 m"})) < 0 < growth
    wheel = riffel.curve(path).isel(wheelset=0, rail=1)
    by_hand = {"contact.normal_load": float(wheel["normal_force"])}
    assert growth_of(case.with_(by_hand)) == growth


def test_a_case_with_the_tables_has_a_curve() -> None:
    text = Path(CURVE).read_text(encoding="utf-8")
    tables = text[text.index("[curve]") : text.index("[contact]")]
    case = riffel.Case.parse(Path("cases/nominal.toml").read_text(encoding="utf-8") + tables)
    wheelset = {"wheelset.mass": 1400, "wheelset.contact_spacing": 1.5, "contact.creep_law": "shen-hedrick-elkins"}
    assert case.curve(wheelset)["lateral_shift"].sel(wheelset=1) < -5e-3
    with pytest.raises(ValueError, match="wheelbase"):
        case.curve(wheelset, radius=2.0)
    with pytest.raises(ValueError, match="curve"):
        riffel.Case.from_toml("cases/nominal.toml").curve()


def test_contact_geometry_is_that_of_the_program(program: Callable[..., Any]) -> None:
    shifts = ["-3 mm", "4.5 mm"]
    document = program(
        "profile", "cases/profiles.toml", "--wheelset", "--json", "--yaw", "2 mrad", f"--lateral-shift={','.join(shifts)}"
    )
    found = riffel.contact_geometry("cases/profiles.toml", lateral_shift=shifts, yaw=0.002)
    for rail in ("left", "right"):
        assert found["rolling_radius"].sel(rail=rail).values.tolist() == document[f"{rail}_rolling_radius"]
    with pytest.raises(ValueError, match="touch"):
        riffel.contact_geometry("cases/profiles.toml", lateral_shift="90 mm")
    with pytest.raises(FileNotFoundError):
        riffel.profile("no-such-file.csv")


def test_contact_under_load_is_that_of_the_program(program: Callable[..., Any]) -> None:
    asked = ("profile", "cases/profiles.toml", "--wheelset", "--json", "--load", "60 kN", "--lateral-shift=2 mm")
    rows = program(*asked)["contacts"]
    found = riffel.contact_under_load("cases/profiles.toml", "60 kN", lateral_shift="2 mm")
    assert found["peak_pressure"].dims == ("lateral_shift", "rail", "theory")
    for row in rows:
        at = found.sel(rail=row["rail"]).isel(lateral_shift=0)
        assert at["stiffness"].item() == row["stiffness_n_per_m"]
        assert at["peak_pressure"].sel(theory="exact").item() == row["peak_pressure_pa"]
        assert at["width"].sel(theory="fast").item() == row["fast"]["width_m"]
        assert at["area"].sel(theory="conformal").item() == row["conformal"]["area_m2"]
        assert at["conformal_stiffness"].item() == row["conformal"]["stiffness_n_per_m"]
    with pytest.raises(ValueError, match="load"):
        riffel.contact_under_load("cases/profiles.toml", "-60 kN")

"""A wheel along a rail in time: that of the program."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import riffel


def test_a_sinusoid_is_that_of_the_program(program: Callable[..., Any], nominal: riffel.Case) -> None:
    options = ("simulate", "cases/nominal.toml", "--speed", "30", "--sinusoid", "60um,55mm", "--json")
    printed = program(*options)
    found = nominal.simulate(sinusoid=("60 um", "55 mm"), speed=30.0)
    assert found.attrs["contact_loss_fraction"] == printed["contact_loss_fraction"]
    forces = [complex(*harmonic["normal_force_n"]) for harmonic in printed["harmonics"]]
    np.testing.assert_array_equal(found.normal_force_harmonics, forces)
    assert float(found.normal_force.max()) == printed["maximum_normal_force_n"]

    worn = nominal.evolve(sinusoid=("60 um", "55 mm"), speed="108 km/h", passages=1000)
    printed = program(*options, "--passages", "1000")
    np.testing.assert_array_equal(worn.level.T, [band["level_db"] for band in printed["bands"]])
    np.testing.assert_array_equal(worn.passages, printed["stages"]["passages"])
    assert worn.height.sizes["profile_passages"] >= 2


# Long: fits a rail on discrete supports in time twice, here and by the program.
def test_traffic_on_supports_is_that_of_the_program(program: Callable[..., Any], tmp_path: Path) -> None:
    losses = {
        "track.pad.loss_factor": 0.0,
        "track.ballast.loss_factor": 0.0,
        "track.pad.damping": "40 kNs/m",
        "track.ballast.damping": "60 kNs/m",
        "rail.loss_factor": 0.01,
    }
    case = riffel.Case.from_toml("cases/discrete-supports.toml").with_(**losses)
    trains = {"vehicle": [{"name": "train", "share": 1.0, "speeds": [{"speed": "100 km/h", "share": 1.0}]}]}
    worn = case.evolve(sinusoid=("1 um", "60 mm"), traffic=trains, passages=1000, step="2 mm")
    traffic = tmp_path / "traffic.toml"
    traffic.write_text('[[vehicle]]\nname = "train"\nshare = 1\nspeed = { mean = "100 km/h" }\n')
    sets = [text for key, value in losses.items() for text in ("--set", f"{key}={value}")]
    out = tmp_path / "out"
    program(
        *("simulate", "cases/discrete-supports.toml", *sets, "--traffic", str(traffic), "--sinusoid", "1um,60mm"),
        *("--passages", "1000", "--step", "2mm", "--json", "-o", str(out)),
    )
    with xr.open_dataset(out / "evolution.nc", engine="scipy") as written:
        assert set(written.variables) == set(worn.variables)
        for name in worn.variables:
            np.testing.assert_array_equal(written[name], worn[name], err_msg=str(name))
    assert (out / "passages.html").exists()
    assert worn.attrs["speed"] == pytest.approx(100.0 / 3.6)
    with pytest.raises(ValueError, match="^give speed or traffic"):
        case.evolve(sinusoid=("1 um", "60 mm"), passages=1)


# Long: follows a wheelset on all axes twice, here and by the program.
def test_all_axes_are_those_of_the_program(program: Callable[..., Any], nominal: riffel.Case) -> None:
    overrides = {
        "track.model": "one-layer",
        "contact.creep_law": "polach",
        "contact.creepage": {"longitudinal": 0.001, "lateral": 0.003},
    }
    case = riffel.Case.from_toml("cases/wheelset-metro-trailer.toml", overrides)
    keys = ("track.model=one-layer", "contact.creep_law=polach", "contact.creepage={longitudinal=0.001, lateral=0.003}")
    sets = [text for key in keys for text in ("--set", key)]
    options = ("simulate", "cases/wheelset-metro-trailer.toml", *sets, "--speed", "15", "--json")
    printed = program(*options, "--sinusoid", "20um,60mm")
    found = case.simulate(sinusoid=("20 um", "60 mm"), speed=15.0)
    assert found.lateral_force.dims == ("contact", "position")
    assert list(found.contact.values) == ["1 right", "1 left"]
    for index, contact in enumerate(printed["contacts"]):
        forces = [complex(*harmonic["lateral_force_n"]) for harmonic in contact["harmonics"]]
        np.testing.assert_array_equal(found.lateral_force_harmonics[index], forces)

    smooth = case.on_smooth_rail(speed=15.0)
    printed = program(*options, "--smooth")
    assert smooth.attrs["outcome"] == printed["outcome"] == "at-rest"
    assert np.isnan(smooth.attrs["frequency"]) and printed["frequency_hz"] is None
    for index, contact in enumerate(printed["contacts"]):
        np.testing.assert_array_equal(smooth.normal_force_range[index], contact["normal_force_n"])
    with pytest.raises(ValueError, match="nothing to swing against"):
        nominal.on_smooth_rail(speed=15.0)


def test_an_exact_contact_is_that_of_the_program(program: Callable[..., Any], nominal: riffel.Case) -> None:
    # A coarse grid, for speed.
    case = nominal.with_({"contact.grid": 16})
    options = ("simulate", "cases/nominal.toml", "--set", "contact.grid=16", "--speed", "30", "--json")
    printed = program(*options, "--sinusoid", "60um,55mm", "--transient")
    found = case.simulate(sinusoid=("60 um", "55 mm"), speed=30.0, transient=True)
    energy = [complex(*pair) for pair in printed["energy_at_rail_j_per_m"]]
    np.testing.assert_array_equal(found.energy_at_rail_harmonics, energy)
    # An inertia stores nothing: what the rail receives is the force of the drive times the mean creepage, but for the elements.
    work = 2000.0 * float(found.creepage_harmonics[0].real)
    assert float(found.energy_at_rail_harmonics[0].real) == pytest.approx(work, rel=0.02)
    with pytest.raises(ValueError, match="is for a sinusoid"):
        case.simulate(np.zeros(2000), spacing="1 mm", speed=30.0, transient=True)


def test_drawn_supports_are_those_of_the_program(program: Callable[..., Any]) -> None:
    case = riffel.Case.from_toml("cases/discrete-supports.toml")
    asked = ("--wavelength", "50 mm", "--speed", "30", "--spacing-deviation", "2 cm", "--supports", "12", "--seed", "7")
    printed = program("point", "cases/discrete-supports.toml", *asked, "--json")["irregular_supports"]
    found = case.growth_on_irregular_supports(
        wavelength="50 mm", speed=30.0, spacing_deviation="2 cm", supports=12, seed=7
    )
    np.testing.assert_array_equal(found.growth_rate, printed["growth_rate_per_passage"])
    np.testing.assert_array_equal(found.support_position, printed["support_position_m"])
    assert float(found.even_growth_rate.mean()) == pytest.approx(printed["even"]["mean"], rel=1e-12)
    with pytest.raises(ValueError, match="quarter of the spacing"):
        case.growth_on_irregular_supports(wavelength=0.05, speed=30.0, spacing_deviation=0.3)


def test_a_profile_is_that_of_the_program(program: Callable[..., Any], nominal: riffel.Case, tmp_path: Any) -> None:
    position = 0.002 * np.arange(2000)
    heights = 1e-5 * np.cos(2.0 * np.pi * position / 0.05)
    rail = xr.DataArray(1e6 * heights, coords={"position": position}, dims="position", attrs={"units": "um"})
    table = tmp_path / "rail.csv"
    rows = "".join(f"{x:.3f},{z!r}\n" for x, z in zip(position, rail.values.tolist(), strict=True))
    table.write_text(f"position_m,height_um\n{rows}")
    printed = program("simulate", "cases/nominal.toml", "--speed", "30", "--profile", str(table), "--json")
    found = nominal.simulate(rail, speed=30.0)
    np.testing.assert_allclose(found.normal_force, printed["normal_force_n"], rtol=1e-9)
    np.testing.assert_allclose(found.position, printed["position_m"], atol=1e-9)


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({}, "give either profile or sinusoid"),
        ({"sinusoid": ("20 um", "55 mm"), "profile": [0.0] * 9}, "give either profile or sinusoid"),
        ({"sinusoid": "20 um"}, "sinusoid is '20 um', but must be an amplitude and a wavelength"),
        ({"sinusoid": ("20 um", "55 kg")}, r"sinusoid\[1\]: "),
        ({"sinusoid": ("20 um", "55 mm"), "step": "20 mm"}, "step is 0.02 m, but must be between"),
        ({"sinusoid": ("20 um", "55 mm"), "speed": 0.01}, "sinusoid is 0.055 m, which passes in 5.50 s"),
        ({"profile": [0.0, float("nan"), 0.0, 0.0], "spacing": 1e-3}, "profile has gaps"),
        ({"profile": [0.0, 1.0]}, "spacing is missing"),
    ],
)
def test_what_is_not_allowed(nominal: riffel.Case, given: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match="^" + sentence):
        nominal.simulate(**{"speed": 30.0, **given})


def test_passages_are_whole(nominal: riffel.Case) -> None:
    wave: dict[str, Any] = {"sinusoid": ("20 um", "55 mm"), "speed": 30.0}
    refused: list[Any] = [0, -1, 2.5, True]
    for passages in refused:
        with pytest.raises(ValueError, match=f"^passages is {passages!r}, but must be a whole number"):
            nominal.evolve(**wave, passages=passages)
    with pytest.raises(ValueError, match="^periodic is for a profile"):
        nominal.evolve(**wave, passages=1, periodic=True)


def test_heights_that_no_rail_has_are_asked_about(nominal: riffel.Case) -> None:
    """Micrometres that are given as metres."""
    heights = 10.0 * np.sin(2 * np.pi * np.arange(3000) * 1e-3 / 0.05)
    remarks = nominal.simulate(profile=heights, spacing=1e-3, speed=30.0).attrs["remarks"]
    assert any("they look like um" in remark for remark in remarks), remarks
    remarks = nominal.simulate(profile=1e-6 * heights, spacing=1e-3, speed=30.0).attrs["remarks"]
    assert not any("look like" in remark for remark in remarks), remarks

"""Roughness and forecasts from arrays."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import riffel
from riffel import roughness


@pytest.fixture(scope="module")
def wave() -> Any:
    """40 m of 10 µm at 50 mm."""
    position = 1e-3 * np.arange(40_000)
    return 10e-6 * np.sin(2.0 * np.pi * position / 0.05)


def test_the_level_of_a_wave(wave: Any) -> None:
    found = roughness.spectrum(wave, spacing="1 mm")
    # A sinusoid of 10 µm: 10 lg(100/2); the Hann window keeps 0.03 dB in the band.
    assert found.max().item() == pytest.approx(10.0 * np.log10(50.0), abs=0.03)
    assert found["nominal_mm"][found.argmax("wavelength")].item() == 50.0
    assert np.allclose(roughness.level(roughness.mean_square(found)), found, atol=1e-12)


def test_analysis_is_that_of_the_program(tmp_path: Path, program: Callable[..., Any]) -> None:
    made = roughness.synthesise()
    name = str(next(iter(made)))
    table = np.column_stack([made["position"], *(made[rail] for rail in made)])
    header = ",".join(["position [m]", *(f"{rail} [m]" for rail in made)])
    path = tmp_path / "profile.csv"
    np.savetxt(path, table, delimiter=",", header=header, comments="", fmt="%.17g")
    written = program("roughness", str(path), "--json", "--limit", "grassie-1999")
    file = roughness.read(path)
    assert file.profile is not None
    found = roughness.analyse(file.profile[name], limit="grassie-1999")
    rail = next(rail for rail in written["rails"] if rail["name"] == name)
    assert rail["removed"] == {"spikes": found.spikes, "pits": found.pits}
    levels = [band["level_db"] for band in rail["spectrum"]]
    # Positions of a file are even to rounding; an array is cut at the same gaps.
    assert np.allclose(found.spectrum, levels, atol=1e-6)


def test_gaps_are_gaps(wave: Any) -> None:
    broken = wave.copy()
    broken[20_000:20_100] = np.nan
    whole, parted = roughness.analyse(wave, spacing=1e-3), roughness.analyse(broken, spacing=1e-3)
    assert np.isclose(parted.bands["rms"][1], whole.bands["rms"][1], rtol=0.05)
    assert parted.bands["length"][0].item() == pytest.approx(39.9, abs=1e-9)
    with pytest.raises(ValueError, match="heights has gaps"):
        roughness.remove_spikes(broken, spacing=1e-3)
    with pytest.raises(ValueError, match="heights holds gaps only"):
        roughness.analyse(np.full(10, np.nan), spacing=1e-3)


def test_grinding_and_limits(wave: Any) -> None:
    found = roughness.analyse(wave, spacing=1e-3, limit="grassie-1999")
    assert found.grind.sizes["section"] == 1
    assert found.grind["ratio"].item() > 1.0
    assert found.blocks["rms"].dims == ("block", "band")
    limits = roughness.limits()
    assert {"iso-3095-2013", "grassie-1999"} <= set(limits)
    assert all(table.attrs["source"] for table in limits.values())
    with pytest.raises(ValueError, match="no limit table has this name"):
        roughness.compare_with_limit(found.spectrum, "none")


@pytest.mark.parametrize(
    ("heights", "spacing", "sentence"),
    [
        (np.zeros(10), None, "spacing is missing"),
        (np.zeros(10), 0.0, "spacing is 0.0"),
        (np.zeros(10), "1 kg", "not a length"),
        (np.zeros((2, 5)), 1e-3, "heights has 2 dimensions"),
        (np.array([1, np.inf]), 1e-3, r"heights\[1\] is infinite"),
        (np.zeros(10), 1e-3, "at least 1 m"),
        ([], 1e-3, "heights is empty"),
        (xr.DataArray(np.zeros(3), dims="time"), 1e-3, r"has the dimensions \('time',\)"),
    ],
)
def test_bad_profiles(heights: Any, spacing: Any, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        roughness.analyse(heights, spacing=spacing)


def test_pieces() -> None:
    values = np.array([3.0, 1.0, 4.0, 1.0, 5.0])
    assert roughness.moving_peak_to_peak(values, 2).tolist() == [2.0, 3.0, 3.0, 4.0]
    with pytest.raises(ValueError, match="window is 0"):
        roughness.moving_rms(values, 0)
    position = 1e-3 * np.arange(20_000)
    long, short = 1e-5 * np.sin(2 * np.pi * position / 0.2), 1e-5 * np.sin(2 * np.pi * position / 0.05)
    kept = roughness.band_pass(long + short, shortest="30 mm", longest="100 mm", spacing=1e-3)
    # Away from the ends what is left of the other wave is that of a Butterworth filter.
    assert np.abs(kept - short)[2000:-2000].max() < 1e-7
    pit = np.zeros(3000)
    pit[1500:1510] = -50e-6
    rolled, pits = roughness.roll_over(pit, spacing=1e-3)
    assert len(pits) == 1
    # A wheel of 375 mm sinks d²/8R = 36 µm into 10 mm; the pit is 11 mm from edge to edge.
    assert rolled.min() == pytest.approx(-(11e-3**2) / (8 * 0.375), rel=0.2)
    with pytest.raises(ValueError, match="do not resolve"):
        roughness.band_pass(pit, shortest=1e-3, longest=2e-3, spacing=1e-3)


def test_dominant_wavelengths_of_profile_and_spectra(wave: Any) -> None:
    noise = np.random.default_rng(1).normal(scale=1e-6, size=wave.size)
    peaks = roughness.dominant_wavelengths(wave + noise, spacing=1e-3)
    assert peaks["wavelength"][0].item() == pytest.approx(0.05, rel=0.02)
    levels = [roughness.levels([0.02, 0.025, 0.0315, 0.04, 0.05, 0.063], [0, 0, 12, 0, 0, 0])]
    assert roughness.dominant_wavelengths(levels)["wavelength"].size <= 1


def test_a_rail_of_two_dates_goes_on_as_it_grew(nominal: riffel.Case) -> None:
    wavelengths = np.array([0.02, 0.025, 0.0315, 0.04, 0.05, 0.063])
    grown = np.array([0.5, 0.5, 2.0, 4.0, 2.0, 1.0])
    now = riffel.roughness.levels(wavelengths, [-11.0, -10.0, -9.0, -8.0, -7.0, -6.0])
    before = riffel.roughness.levels(wavelengths, now.values - grown)
    dates = ["2025-01-01", "2026-01-01"]
    a_year = grown * 365.2425 / 365.0
    found = nominal.forecast(now, earlier=[before], dates=dates, traffic="cases/traffic.toml", months=[12.0])
    assert np.allclose(found["level"][0] - found["level_now"], a_year, rtol=1e-9)
    ground = nominal.forecast(
        now, earlier=[before], dates=dates, traffic="cases/traffic.toml", months=[12.0], from_limit="-6 dB"
    )
    days = ground.attrs["grinding_interval_passages"] / ground.attrs["passages_per_day"]
    assert days == pytest.approx(6.0 / 4.0 * 365.0, rel=1e-9)
    compared = nominal.compare(
        [{"title": "less friction", "contact": {"friction": 0.25}}],
        traffic="cases/traffic.toml", spectrum=now, earlier=[before], dates=dates, from_limit="-6 dB",
    )  # fmt: skip
    assert compared["passages_to_limit"].values[0] == pytest.approx(ground.attrs["grinding_interval_passages"], rel=1e-9)
    assert compared["fastest_wavelength"].values[0] == pytest.approx(0.0398, rel=2e-3)
    line = riffel.Case.from_toml("cases/main-line.toml")
    course = line.noise(now, earlier=[before], dates=dates, speed="100 km/h", traffic="cases/traffic.toml")["course"]
    then = riffel.roughness.levels(wavelengths, now.values + a_year)
    assert course["total_dba"][-1] == pytest.approx(line.noise(then, speed="100 km/h")["level"]["total_dba"], abs=1e-9)
    for given, words in [([], "dates is empty"), (dates[::-1], "days that rise"), (dates[:1], "must be 2 dates")]:
        with pytest.raises(ValueError, match=words):
            nominal.forecast(now, earlier=[before], dates=given, traffic="cases/traffic.toml")


def test_forecast_is_that_of_the_program(nominal: riffel.Case, tmp_path: Path, program: Callable[..., Any]) -> None:
    table = tmp_path / "spectrum.csv"
    wavelengths, levels = [20, 25, 31.5, 40, 50, 63, 80], [2.0, 4.0, 6.0, 5.0, 3.0, 1.0, 0.0]
    rows = [f"{wavelength},{level}" for wavelength, level in zip(wavelengths, levels, strict=True)]
    table.write_text("wavelength [mm],level [dB]\n" + "\n".join(rows) + "\n")
    written = program(
        "forecast", "cases/nominal.toml", "--spectrum", str(table), "--traffic", "cases/traffic.toml", "--json",
        "--passages", "1e6",
    )  # fmt: skip
    now = roughness.levels(1e-3 * np.array(wavelengths), levels)
    found = nominal.forecast(now, traffic="cases/traffic.toml", passages=[1e6])
    text = json.dumps(written)
    for value in found["level"].values.ravel():
        assert repr(float(value)) in text
    in_months = nominal.forecast(now, traffic="cases/traffic.toml", months=[1.0, 6.0])
    assert in_months.sizes["passages"] == 2
    keys = {"vehicle": [{"name": "metro", "share": 1, "speed": {"mean": "60 km/h", "standard_deviation": "5 km/h"}}]}
    assert nominal.forecast(now, traffic=keys, mgt=1.0)["mgt"].item() == pytest.approx(1.0)


def test_hardening_and_cracks() -> None:
    laws = {
        "damage.laws": ["wear", "flow", "fatigue"], "damage.shear_yield": 200e6, "damage.flow.hardening_depth": "0.2 mm",
        "damage.fatigue.crack_growth": "1 mm", "contact.tractive_ratio": 0.5,
    }  # fmt: skip
    case = riffel.Case.from_toml("cases/class-heavy-haul.toml").with_(laws)
    traffic = {"line": {"mgt_per_year": 20}, "vehicle": [{"name": "laden", "share": 1, "speed": {"mean": "60 km/h"}}]}
    found = case.forecast(from_limit=-6.0, traffic=traffic, months=12.0)
    assert found["crack_length"].dims == ("wavelength", "phase")
    assert list(found["phase"].values) == ["crest", "falling-flank", "trough", "rising-flank"]
    assert (found["runaway_number"] < 1).all() and (found["hardened_wave_ratio"] > 0).all()
    assert float(found["crack_length"].max()) > 1e-5
    assert any("makes no corrugation by itself" in finding for finding in found.attrs["findings"])
    plain = riffel.Case.from_toml("cases/class-heavy-haul.toml").forecast(from_limit=-6.0, traffic=traffic, months=12.0)
    assert "crack_length" not in plain and "runaway_number" not in plain and "findings" not in plain.attrs


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({}, "passages, mgt or months is missing"),
        ({"passages": 1e6, "mgt": 3.0}, "passages and mgt exclude each other"),
        ({"passages": -1.0}, r"passages is -1.0"),
        ({"passages": 1e6, "limit": "grassie-1999"}, "must be a table of one-third-octave levels"),
        ({"passages": 1e6, "traffic": "cases/traffic.toml", "speed": 30.0}, "traffic and speed exclude each other"),
        ({"months": 1.0}, "months need traffic with passages_per_day"),
        ({"passages": 1e6, "traffic": {"vehicle": [{"name": "x", "share": 0.5}]}}, "vehicle"),
    ],
)
def test_bad_forecasts(nominal: riffel.Case, arguments: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        nominal.forecast(roughness.levels([0.04], [1.0]), **arguments)


def test_bad_spectra(nominal: riffel.Case) -> None:
    for levels, sentence in (
        (np.ones(3), r"spectrum is \[1\.0,"),
        (xr.DataArray([1.0], dims="x"), r"spectrum has the dimensions \('x',\)"),
        (xr.DataArray([1.0], {"wavelength": [0.04]}, ("wavelength",), attrs={"units": "m"}), 'spectrum has units "m"'),
        (xr.DataArray([1.0], {"wavelength": [0.0365]}, ("wavelength",)), "wavelength of a one-third octave is 0.0365"),
        (xr.DataArray([np.nan], {"wavelength": [0.04]}, ("wavelength",)), r"spectrum\[0\] is nan"),
        (xr.DataArray([1.0], {"wavelength": [1.0]}, ("wavelength",)), "no band of the spectrum"),
    ):
        with pytest.raises(ValueError, match=sentence):
            nominal.forecast(levels, passages=1e6)  # type: ignore[arg-type]


def test_compare(nominal: riffel.Case) -> None:
    both = nominal.compare([{"title": "slower", "speed": {"factor": 0.5}}], speed=30.0)
    # Half the speed at the same frequency is half the wavelength.
    assert both["fastest_wavelength"][1].item() < both["fastest_wavelength"][0].item()
    with pytest.raises(ValueError, match="the file is empty"):
        nominal.compare([{}], speed=30.0)


def test_units_of_files(tmp_path: Path) -> None:
    rows = [(1e-3 * row, 0.02 * np.sin(2 * np.pi * row / 50)) for row in range(5000)]
    file = tmp_path / "mm.txt"
    file.write_text("".join(f"{x:.3f} {height:.6f}\n" for x, height in rows))
    with pytest.raises(ValueError, match="look like mm"):
        riffel.roughness.read(file)
    with pytest.raises(ValueError, match="height_unit: .*no unit of length"):
        riffel.roughness.read(file, height_unit="kg")
    said = riffel.roughness.read(file, height_unit="mm").profile
    file.write_text("# Höhen in mm\n" + file.read_text(), encoding="utf-16")
    read = riffel.roughness.read(file).profile
    assert said is not None and read is not None
    xr.testing.assert_identical(said, read)
    (heights,) = said.values()
    # The reading nearest to a crest of 20 µm is half a step of 1/50 wavelength away; six decimals were written.
    assert float(abs(heights).max()) == pytest.approx(20e-6 * np.cos(np.pi / 50), abs=1e-9)


def test_dates_of_files(tmp_path: Path) -> None:
    file = tmp_path / "dates.csv"
    file.write_text("date,wavelength_mm,level_db\n15.03.2024,40,3\n15.03.2024,50,2\n")
    assert [one.attrs["date"] for one in riffel.roughness.read(file).spectra] == ["2024-03-15"]


def test_a_rail_that_will_be_ground(nominal: riffel.Case, tmp_path: Path, program: Callable[..., Any]) -> None:
    printed = program(
        "forecast", "cases/nominal.toml", "--traffic", "cases/traffic.toml", "--from-limit", "-6 dB", "--json",
    )  # fmt: skip
    found = nominal.forecast(traffic="cases/traffic.toml", from_limit="-6 dB", months=[1.0, 1200.0])
    assert found.attrs["grinding_interval_passages"] == pytest.approx(printed["passages_to_limit"], rel=1e-12)
    assert found.attrs["limit_reached"] == printed["limit_reached"] == "after"
    assert found.attrs["linear_range_passages"] == pytest.approx(printed["valid_to_passages"], rel=1e-12)
    # A hundred years from now the wheel has left the rail.
    assert np.isfinite(found["level"][0]).all() and np.isnan(found["level"][1]).all()
    with pytest.raises(ValueError, match="below the limit"):
        nominal.forecast(traffic="cases/traffic.toml", from_limit=6.0)
    with pytest.raises(ValueError, match="ground cannot be used with --from-limit"):
        nominal.forecast(ground="iso-3095-2013", traffic="cases/traffic.toml", from_limit=-6.0)
    # Levels of one date tell nothing of a rail that will be ground, and that is told.
    beside = nominal.forecast(
        roughness.levels([0.04], [1.0]), traffic="cases/traffic.toml", from_limit=-6.0, months=[1.0, 1200.0]
    )
    assert "of one date" in " ".join(beside.attrs["remarks"])
    assert np.array_equal(beside["level"], found["level"], equal_nan=True)
    pads = {"title": "soft pads", "track": {"pad": {"stiffness": "80 MN/m"}}}
    less = {"title": "less friction", "contact": {"friction": 0.25}}
    compared = nominal.compare([pads, less], traffic="cases/traffic.toml", from_limit=-6.0)
    assert compared["acts"].values.tolist() == [True, False, True]
    assert compared["hold"].values.tolist() == ["", "", "ratio"]
    assert "cannot act" in compared.attrs["no_effect"][0]
    months = compared["months_to_limit"].values
    assert months[0] == pytest.approx(printed["months_to_limit"], rel=1e-12) == months[1]
    # Less friction at the same tractive ratio pulls less and grows slower; at the same force it creeps more.
    ratio = nominal.compare([less], traffic="cases/traffic.toml", from_limit=-6.0, hold="ratio")
    assert ratio["months_to_limit"].values[1] == months[2] > months[0]
    force = nominal.compare([less], traffic="cases/traffic.toml", from_limit=-6.0, hold="force")
    assert force["months_to_limit"].values[1] < months[0]
    with pytest.raises(ValueError, match="must be one of force, ratio, creepage"):
        nominal.compare([less], traffic="cases/traffic.toml", hold="torque")


@pytest.mark.parametrize("hold", [None, "force", "ratio", "creepage"])
def test_comparison_is_that_of_the_program(
    hold: str | None, nominal: riffel.Case, tmp_path: Path, program: Callable[..., Any]
) -> None:
    less = tmp_path / "less.toml"
    less.write_text('title = "less friction"\n[contact]\nfriction = 0.25\n')
    arguments = [] if hold is None else ["--hold", hold]
    outcomes = program(
        "compare", "cases/nominal.toml", "--with", str(less), "--traffic", "cases/traffic.toml", "--from-limit", "-6 dB",
        "--json", *arguments,
    )["outcomes"]  # fmt: skip
    found = nominal.compare([less], traffic="cases/traffic.toml", from_limit="-6 dB", hold=hold)
    assert found["variant"].values.tolist() == [outcome["title"] for outcome in outcomes] == ["as it is", "less friction"]
    assert found["hold"].values.tolist() == ["", hold or "ratio"] == [outcome["hold"] or "" for outcome in outcomes]
    for key, name in (
        ("fastest_wavelength", "fastest_wavelength_m"),
        ("fastest_growth_rate", "fastest_growth_rate_per_passage"),
        ("ridge_frequency", "ridge_frequency_hz"),
        ("passages_to_limit", "passages_to_limit"),
        ("months_to_limit", "months_to_limit"),
        ("limit_reached", "limit_reached"),
    ):
        assert found[key].values.tolist() == [outcome[name] for outcome in outcomes], key
    rates = [[band["growth_rate_per_passage"] for band in outcome["growth_rate_per_passage"]] for outcome in outcomes]
    assert found["growth_rate"].values.tolist() == rates


def test_ground_to_a_table_is_that_of_the_program(
    nominal: riffel.Case, tmp_path: Path, program: Callable[..., Any]
) -> None:
    table = tmp_path / "ground.toml"
    levels = {20: -9.0, 25: -9.0, 31.5: -8.0, 40: -7.0, 50: -6.0, 63: -5.0, 80: -4.0}
    bands = "".join(f'[[level]]\nwavelength = "{band} mm"\nlevel_db = {level}\n' for band, level in levels.items())
    head = "name = 'ground'\ntitle = 'after grinding'\nedition = 'own'\nsource = 'test'\n"
    table.write_text(head + bands)
    printed = program(
        "forecast", "cases/nominal.toml", "--traffic", "cases/traffic.toml", "--ground", str(table), "--months", "12", "--json",
    )  # fmt: skip
    found = nominal.forecast(traffic="cases/traffic.toml", ground=str(table), months=12.0)
    assert found["level_now"].values.tolist() == [band["level_db"] for band in printed["spectrum_now"]] == list(levels.values())
    assert found["level"][0].values.tolist() == [band["level_db"] for band in printed["spectrum_then"]]
    assert found.attrs["grinding_interval_passages"] == printed["passages_to_limit"]
    assert found["growth_rate"].values.tolist() == [band["growth_rate_per_passage"] for band in printed["bands"]]


def test_units_are_those_of_the_program(tmp_path: Path, program: Callable[..., Any]) -> None:
    # Kilometres and millimetres, of which the file says nothing.
    file = tmp_path / "bare.txt"
    rows = [(1e-6 * row, 0.02 * np.sin(2 * np.pi * row / 50)) for row in range(20_000)]
    file.write_text("".join(f"{x:.6f} {height:.9f}\n" for x, height in rows))
    printed = program("roughness", str(file), "--height-unit", "mm", "--position-unit", "km", "--json")
    read = roughness.read(file, height_unit="mm", position_unit="km").profile
    assert read is not None
    assert read["position"][-1].item() == pytest.approx(19.999, abs=1e-9)
    (rail,) = read
    levels = [band["level_db"] for band in printed["rails"][0]["spectrum"]]
    # Positions of a file are even to rounding; an array is cut at the same gaps.
    assert np.allclose(roughness.analyse(read[rail]).spectrum, levels, atol=1e-6)
    assert max(levels) == pytest.approx(10.0 * np.log10(200.0), abs=0.03)
    with pytest.raises(ValueError, match="position_unit: .*no unit of length"):
        roughness.read(file, position_unit="kN")

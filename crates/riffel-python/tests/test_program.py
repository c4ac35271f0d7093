"""Python and the program give the same bits."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from conftest import PROGRAM, ROOT

import riffel
import riffel.plot

POINTS = json.loads((ROOT / "validation/reference/points.json").read_text())["points"]


def case_of(point: dict[str, Any]) -> dict[str, Any]:
    """Overrides of the nominal case, as the validation of the program sets them."""
    values = point["case"]
    overrides = {
        "steel.youngs_modulus": values["E"],
        "steel.poisson_ratio": float(values["nu"]),
        "rail.mass_per_length": values["m_rail"],
        "rail.second_moment": float(values["I_rail"]),
        "wheel.mass": values["m_w"],
        "wheel.rolling_radius": float(values["R"]),
        "contact.friction": float(values["mu"]),
        "contact.normal_load": values["P0"],
        "contact.transverse_radius": float(values["Rr"]),
        "contact.tractive_ratio": float(values["tau"]),
        "corrugation.amplitude": float(values["Delta"]),
    }
    if values["rail"] == "moving":
        overrides["track.model"] = "moving-beam"
    if values["rail"] == "two-layer":
        overrides |= {
            "track.model": "two-layer",
            "track.support_spacing": 1,
            "track.pad.stiffness": values["kp"],
            "track.pad.damping": values["cp"],
            "track.sleeper.mass": values["ms"],
            "track.ballast.stiffness": values["kb"],
            "track.ballast.damping": values["cb"],
        }
    return overrides


def as_json(point: dict[str, float | complex]) -> dict[str, Any]:
    """A point as the program writes it; numbers of JSON read back to the same bits, and no limit is none."""
    pairs = {key: [value.real, value.imag] if isinstance(value, complex) else value for key, value in point.items()}
    tables = {key: as_json(value) if isinstance(value, dict) else value for key, value in pairs.items()}
    return {key: None if value != value else value for key, value in tables.items()}


@pytest.mark.parametrize("point", POINTS, ids=lambda point: f"{point['case']['rail']}-{point['case']['tau']}")
def test_reference_points(point: dict[str, Any]) -> None:
    """To 1e-10, the rounding that the validation of the program allows."""
    case = riffel.Case.from_toml("cases/nominal.toml", case_of(point))
    found = as_json(case.point(wavelength=point["wavelength_m"], speed=point["speed_m_per_s"]))  # type: ignore[arg-type]
    for key, expected in point["expect"].items():
        assert np.abs(np.subtract(found[key], expected)).max() <= 1e-10 * np.abs(expected).max(), key


def values(written: dict[str, Any]) -> dict[str, Any]:
    """Without sentences, which Python has in `line_growth`, and the band of the coefficient, which is none of a point."""
    return {key: value for key, value in written.items() if key not in ("reported_growth", "unlikely_wear", "wear_coefficient_band_80")}


@pytest.mark.parametrize("index", range(len(POINTS)))
def test_points_of_the_program(index: int, program: Callable[..., Any]) -> None:
    point = POINTS[index]
    overrides = case_of(point)
    sets = [word for key, value in overrides.items() for word in ("--set", f"{key}={value!r}")]
    place = {"wavelength": point["wavelength_m"], "speed": point["speed_m_per_s"]}
    arguments = [f"--{name}={value!r}" for name, value in place.items()]
    written = program("point", "cases/nominal.toml", "--json", *arguments, *sets)
    written = values(written)
    found = as_json(riffel.Case.from_toml("cases/nominal.toml", overrides).point(**place))  # type: ignore[arg-type]
    assert list(found) == list(written)
    assert found == written


@pytest.mark.parametrize(
    ("case", "overrides"),
    [
        ("cases/bhaskar-track.toml", {}),
        ("cases/nominal.toml", {"wear.law": "usfd"}),
        ("cases/nominal.toml", {"contact.creep_law": "polach", "contact.hertz": "exact"}),
        ("cases/nominal.toml", {"track.model": "two-layer-periodic", "track.preset": "br-stiff", "rail.section": "60E1"}),
    ],
)
def test_points_of_other_cases(case: str, overrides: dict[str, Any], program: Callable[..., Any]) -> None:
    sets = [word for key, value in overrides.items() for word in ("--set", f"{key}={value}")]
    written = values(program("point", case, "--json", "--wavelength", "41 mm", "--speed", "83 km/h", *sets))
    found = as_json(riffel.Case.from_toml(case, overrides).point(wavelength="41 mm", speed="83 km/h"))  # type: ignore[arg-type]
    assert found == written


def test_a_comparison_is_under_the_usual_traffic(program: Callable[..., Any]) -> None:
    printed = program("compare", "cases/metro.toml", "--with", "cases/soft-pads.toml", "--json")["outcomes"]
    found = riffel.Case.from_toml("cases/metro.toml").compare(["cases/soft-pads.toml"])
    rates = [outcome["fastest_growth_rate_per_passage"] for outcome in printed]
    assert found["fastest_growth_rate"].values.tolist() == rates


def test_many_points_are_those_one_by_one(nominal: riffel.Case) -> None:
    wavelengths, speeds = np.linspace(0.02, 0.08, 7), np.array([11.0, 31.0])
    grid = nominal.point(wavelength=wavelengths, speed=speeds)
    assert isinstance(grid, xr.Dataset)
    for speed in speeds:
        for wavelength in wavelengths:
            one = nominal.point(wavelength=float(wavelength), speed=float(speed))
            chosen = grid.sel(speed=speed, wavelength=wavelength)
            many = as_json({str(key): values.item() for key, values in chosen.data_vars.items()})
            assert many == as_json(one)  # type: ignore[arg-type]
    pairs = nominal.point(
        wavelength=xr.DataArray(wavelengths[:2], dims="section"), speed=xr.DataArray(speeds, dims="section")
    )
    assert isinstance(pairs, xr.Dataset)
    assert pairs["normal_force_n"].dims == ("section",)
    assert pairs["normal_force_n"][1] == grid["normal_force_n"][1, 1]


@pytest.mark.parametrize("case", ["nominal", "bhaskar-track"])
def test_map_of_the_program(case: str, tmp_path: Path) -> None:
    # Enough points for a table of the track.
    sets = ["--set", "map.wavelength={ min = 0.02, max = 0.08, points = 203 }"]
    path = f"cases/{case}.toml"
    subprocess.run([PROGRAM, "map", path, "-o", tmp_path / "out", *sets], check=True, cwd=ROOT, capture_output=True)
    written = xr.open_dataset(tmp_path / "out" / "map.nc", engine="scipy")
    riffel_case = riffel.Case.from_toml(path)
    found = riffel_case.growth_map(wavelength={"min": "20 mm", "max": 0.08, "points": 203})
    assert found["normalized_dissipation"].dims == ("speed", "wavelength")
    for name, values in (
        ("wavelength", found["wavelength"]),
        ("speed", found["speed"]),
        ("normalized_dissipation_re", found["normalized_dissipation"].real),
        ("normalized_dissipation_im", found["normalized_dissipation"].imag),
        ("growth_rate", found["growth_rate"]),
    ):
        assert np.array_equal(written[name].values, values.values), name
        assert written[name].dtype == values.dtype
    ridge = riffel_case.ridge(wavelength={"min": "20 mm", "max": 0.08, "points": 203})
    table = np.genfromtxt(tmp_path / "out" / "ridge.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    if case == "nominal":  # A map with a table refines the ridge on the track itself, from the same grid.
        assert np.array_equal(table["wavelength_m"], ridge["wavelength"])
        assert np.array_equal(table["growth_rate_per_passage"], ridge["growth_rate"])
    assert np.allclose(table["frequency_hz"], ridge["frequency"], rtol=1e-6)
    branches = riffel_case.ridge_branches(wavelength={"min": "20 mm", "max": 0.08, "points": 203})
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())["ridge"]
    assert [entry["frequency_hz"] for entry in summary["branches"]] == pytest.approx(branches["best_fit_frequency"], rel=1e-6)
    assert ridge.attrs["best_fit_frequency_hz"] == branches["best_fit_frequency"][0]
    assert [entry.get("mechanism", "") for entry in summary["branches"]] == branches["mechanism"].values.tolist()
    points = np.genfromtxt(tmp_path / "out" / "branches.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    for index in branches["branch"].values:
        here = branches.sel(branch=index).dropna("speed", subset=["wavelength"])
        written_here = points[points["branch"] == index]
        assert np.allclose(written_here["speed_m_per_s"], here["speed"], rtol=1e-12)
        assert np.allclose(written_here["wavelength_m"], here["wavelength"], rtol=1e-6)
        assert np.array_equal(written_here["at_edge"], here["at_edge"])


def test_receptance_of_the_program(program: Callable[..., Any]) -> None:
    written = program("receptance", "cases/bhaskar-track.toml", "--json", "--points", "600")
    found = riffel.Case.from_toml("cases/bhaskar-track.toml").receptance()
    assert written.pop("frequency_hz") == found["frequency"].values.tolist()
    resonances = written.pop("resonances")
    assert [one["resonance"] for one in resonances] == found.attrs["resonances"]
    assert [one["frequency_hz"] for one in resonances] == found.attrs["resonance_frequencies_hz"]
    assert written.pop("p2_closed_form")["frequency_hz"] == found.attrs["p2_closed_form_hz"]
    assert set(written) == set(found.data_vars)
    for key, values in written.items():
        assert [complex(*value) for value in values] == found[key].values.tolist(), key


def test_contact_of_the_program(program: Callable[..., Any]) -> None:
    coarse = {"contact.grid": 16}
    written = program(
        "contact", "cases/nominal.toml", "--json", "--set", "contact.grid=16", "--ratio", "8,20", "--creepage", "0.001"
    )
    case = riffel.Case.from_toml("cases/nominal.toml", coarse)
    assert {key: written[key] for key in case.contact()} == case.contact()
    curves = case.creep_curve(0.001)["tractive_ratio"]
    for law, values in written["creep_curve"]["tractive_ratio"].items():
        assert values == curves.sel(law=law).values.tolist()
    response = case.frequency_response([8.0, 20.0])["response"]
    for put in ("creepage", "load"):
        for output, pairs in written["frequency_response"][put].items():
            assert [complex(*pair) for pair in pairs] == response.sel(input=put, output=output).values.tolist()


def test_contact_in_any_direction_of_the_program(program: Callable[..., Any]) -> None:
    sets = {
        "contact.grid": 16,
        "contact.response": "non-steady",
        "contact.creepage": {"longitudinal": 0.0005, "lateral": 0.0003, "spin": 0.1},
    }
    table = "contact.creepage={ longitudinal = 0.0005, lateral = 0.0003, spin = 0.1 }"
    words = ["--set", "contact.grid=16", "--set", "contact.response=non-steady", "--set", table]
    written = program("contact", "cases/nominal.toml", "--json", *words, "--ratio", "8,20", "--creepage", "0.001")
    case = riffel.Case.from_toml("cases/nominal.toml", sets)
    assert case.contact()["steady"] == written["steady"]
    assert written["steady"]["spin_moment_nm"] != 0.0
    found = case.frequency_response([8.0, 20.0])
    responses = written["frequency_response"]
    assert found["input"].values.tolist() == ["longitudinal_creepage", "lateral_creepage", "spin", "load"]
    for put in found["input"].values.tolist():
        for output, pairs in responses[put].items():
            one = found.sel(input=put, output=output)
            assert [complex(*pair) for pair in pairs] == one["response"].values.tolist()
            assert responses["error"][put][output] == one["error"].values.tolist()
    with pytest.raises(ValueError, match="input by input"):
        riffel.plot.frequency_response(found)


@pytest.mark.parametrize("case", ["nominal", "discrete-supports"])
def test_branches_of_the_program(case: str, program: Callable[..., Any]) -> None:
    """On a grid that is too small for a table of the track, so that program and Python search on the same track."""
    sets = [
        "--set", "map.wavelength={ min = 0.02, max = 0.1, points = 81 }",
        "--set", "map.speed={ min = 10, max = 40, points = 31 }",
    ]  # fmt: skip
    summary = program("map", f"cases/{case}.toml", "--json", *sets)["ridge"]
    found = riffel.Case.from_toml(f"cases/{case}.toml").ridge_branches(
        wavelength={"min": 0.02, "max": 0.1, "points": 81}, speed={"min": 10.0, "max": 40.0, "points": 31}
    )
    assert found["best_fit_frequency"].values.tolist() == [branch["frequency_hz"] for branch in summary["branches"]]
    highest = [branch["highest_growth_rate_per_passage"] for branch in summary["branches"]]
    assert found["highest_growth_rate"].values.tolist() == highest == sorted(highest, reverse=True)
    assert found["mechanism"].values.tolist() == [branch.get("mechanism", "") for branch in summary["branches"]]
    for index, branch in enumerate(summary["branches"]):
        inside = found.sel(branch=index).where(~found["at_edge"].sel(branch=index)).dropna("speed", subset=["wavelength"])
        if not branch.get("only_at_edge", False):
            assert [inside["speed"].min(), inside["speed"].max()] == branch["speed_m_per_s"]
            assert [inside["wavelength"].min(), inside["wavelength"].max()] == branch["wavelength_m"]

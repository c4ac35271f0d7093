"""Diagnosis of rails: that of the program, from files, heights and spectra."""

from __future__ import annotations

import datetime
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import xarray as xr
from conftest import ROOT

import riffel

SBB = "validation/reference/sbb-track-noise/rail_roughness.csv"
CASE = "cases/discrete-supports.toml"


def heights(amplitude: float, seed: int) -> npt.NDArray[np.float64]:
    """60 m of a wave of 56 mm in noise."""
    position = 1e-3 * np.arange(60_000)
    noise = np.random.default_rng(seed).normal(scale=1e-6, size=position.size)
    return np.asarray(amplitude * np.sin(2.0 * np.pi * position / 0.056) + noise)


def written(path: Path, values: npt.NDArray[np.float64]) -> str:
    position = 1e-3 * np.arange(values.size)
    table = np.column_stack([position, values])
    np.savetxt(path, table, delimiter=",", header="position [m],left [m]", comments="", fmt="%.17g")
    return str(path)


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> tuple[str, str]:
    """A record of last year and one of today."""
    folder = tmp_path_factory.mktemp("records")
    return written(folder / "before.csv", heights(10e-6, 1)), written(folder / "now.csv", heights(20e-6, 2))


def test_spectra_of_the_program(program: Callable[..., Any]) -> None:
    printed = program(
        "diagnose", CASE, "--roughness", SBB, "--where", "laboratory=MBBM", "--speed", "136 km/h", "--json"
    )
    case = riffel.Case.from_toml(CASE)
    found = case.diagnose(SBB, where={"laboratory": "MBBM"}, speed="136 km/h")
    assert found == printed
    assert found["dominant_wavelengths"][0]["candidates"][0]["mechanism"] == "grinding mark"
    # The same spectra as arrays, chosen here.
    spectra = [one for one in riffel.roughness.read(SBB).spectra if one.attrs["laboratory"] == "MBBM"]
    assert case.diagnose(spectra, speed="136 km/h") == {**printed, "file": "rail"}
    read = case.diagnose(riffel.roughness.read(SBB), where={"laboratory": "MBBM"}, speed="136 km/h")
    assert read == {**printed, "file": "rail"}


# Long: reads two records twice, here and by the program.
def test_profiles_of_the_program(files: tuple[str, str], nominal: riffel.Case, program: Callable[..., Any]) -> None:
    before, now = files
    printed = program(
        "diagnose", "cases/nominal.toml", "--roughness", now, "--earlier", before, "--dates", "2024-05-01,2025-05-01",
        "--speed", "100 km/h..120 km/h", "--speed", "80 km/h", "--torsion", "60 Hz", "--bending", "110 Hz",
        "--from-vehicle", "--json",
    )  # fmt: skip
    modes: dict[str, Any] = {"torsion": "60 Hz", "bending": [110.0], "from_vehicle": True}
    found = nominal.diagnose(
        now,
        earlier=[before],
        dates=["2024-05-01", datetime.date(2025, 5, 1)],
        speed=[("100 km/h", "120 km/h"), "80 km/h"],
        **modes,
    )
    assert found == printed
    assert found["dominant_wavelengths"][0]["course"]["per"] == "year"
    # A file that was read, whose positions are even to rounding.
    read = nominal.diagnose(riffel.roughness.read(now), speed=30.0)["dominant_wavelengths"][0]
    assert read["level_db"] == pytest.approx(found["dominant_wavelengths"][0]["level_db"], abs=1e-6)
    arrays = nominal.diagnose(
        heights(20e-6, 2),
        spacing="1 mm",
        earlier=[heights(10e-6, 1)],
        dates=[np.datetime64("2024-05-01"), "2025-05-01"],  # type: ignore[list-item]
        speed=["100 km/h..120 km/h", 80.0 / 3.6],
        **modes,
    )
    assert arrays["file"] == "rail"
    ours, theirs = (document["dominant_wavelengths"][0] for document in (arrays, printed))
    assert ours["wavelength_m"] == pytest.approx(theirs["wavelength_m"], rel=1e-6)
    assert ours["course"]["levels_db"] == pytest.approx(theirs["course"]["levels_db"], abs=1e-6)
    assert [one["mechanism"] for one in ours["candidates"]] == [one["mechanism"] for one in theirs["candidates"]]


def test_speeds_of_traffic_and_of_the_map(
    files: tuple[str, str], nominal: riffel.Case, program: Callable[..., Any]
) -> None:
    arguments = ("diagnose", "cases/nominal.toml", "--roughness", files[1], "--json")
    printed = program(*arguments, "--traffic", "cases/traffic.toml")
    assert nominal.diagnose(files[1], traffic="cases/traffic.toml") == printed
    assert nominal.diagnose(files[1]) == program(*arguments)


def test_rails_of_a_dataset(nominal: riffel.Case) -> None:
    rails = xr.Dataset(
        {"left": ("position", heights(20e-6, 1)), "right": ("position", heights(5e-6, 2))},
        {"position": 1e-3 * np.arange(60_000)},
    )
    peak = nominal.diagnose(rails, speed=30.0)["dominant_wavelengths"][0]
    levels = {rail["name"]: rail["level_db"] for rail in peak["rails"]}
    # Amplitudes of 4 to 1.
    assert levels["left"] - levels["right"] == pytest.approx(20.0 * np.log10(4.0), abs=0.3)
    coarse = nominal.diagnose(heights(20e-6, 1)[::2], spacing="2 mm", speed=30.0)
    assert any("sampled every 2.000 mm" in warning for warning in coarse["warnings"])


def test_a_callable_that_fails(nominal: riffel.Case) -> None:
    limit = [1e9]

    def known(frequency: npt.NDArray[np.float64]) -> Any:
        if frequency.max() > limit[0]:
            raise ValueError("beyond the mesh")
        return nominal.receptance(frequency)["rail_m_per_n"].values

    given = nominal.with_track(known)
    limit[0] = 10.0
    with pytest.raises(riffel.ReceptanceError, match="beyond the mesh"):
        given.diagnose(heights(20e-6, 1), spacing=1e-3, speed=30.0)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"speed": 30.0, "traffic": "cases/traffic.toml"}, "traffic and speed exclude each other"),
        ({"speed": ("120 km/h", "80 km/h")}, "must be from the slower to the faster"),
        ({"speed": "120 km/h..80 km/h"}, "must be from the slower to the faster"),
        ({"speed": (10.0, 20.0, 30.0)}, r"a range is \(slowest, fastest\)"),
        ({"speed": []}, "speed is empty"),
        ({"speed": [30.0, "80 kg"]}, r"speed\[1\]: .*not a speed"),
        ({"speed": -3.0}, "speed is -3.0, but must be finite and greater than zero"),
        ({"speed": {"min": 3.0}}, "speed is of type dict"),
        ({"torsion": "-5 Hz"}, "torsion is -5 Hz, but must be finite and greater than zero"),
        ({"bending": [50.0, np.nan]}, r"bending\[1\] is nan"),
        ({"dates": ["2024-01-01"]}, "dates needs --earlier"),
        ({"earlier": [SBB], "dates": "2024-01-01"}, "dates is 2024-01-01, but must be 2 dates"),
        ({"earlier": SBB}, "must be a sequence of records"),
        ({"earlier": [SBB], "dates": ["2024-01-01", "yesterday"]}, 'dates: "yesterday" is no date'),
        ({"earlier": [SBB]}, "is a table of levels, but rail is a profile; both must be the same"),
        ({"where": {"rail": "left"}}, "where is rail=left, .* it is for tables of spectra, and rail is a profile"),
        ({"spacing": None}, "spacing is missing"),
        ({"traffic": {"vehicle": []}}, "vehicle"),
    ],
)
def test_bad_diagnoses(nominal: riffel.Case, arguments: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        nominal.diagnose(heights(20e-6, 1), **{"spacing": 1e-3, **arguments})


def test_bad_rails(nominal: riffel.Case, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="none.csv"):
        nominal.diagnose(tmp_path / "none.csv")
    with pytest.raises(ValueError, match="no spectrum has laboratory=NOBODY"):
        nominal.diagnose(ROOT / SBB, where={"laboratory": "NOBODY"})
    with pytest.raises(ValueError, match='no column "moon"'):
        nominal.diagnose(SBB, by="moon")
    with pytest.raises(ValueError, match="a Dataset without heights"):
        nominal.diagnose(xr.Dataset())
    with pytest.raises(ValueError, match=r"rail\['left'\] has the dimensions \('x',\)"):
        nominal.diagnose(xr.Dataset({"left": ("x", np.zeros(10)), "right": ("x", np.zeros(10))}), spacing=1e-3)
    with pytest.raises(ValueError, match=r"rail\[1\] has units \"m\""):
        one = riffel.roughness.levels([0.04], [1.0])
        nominal.diagnose([one, one.assign_attrs(units="m")])
    with pytest.raises(ValueError, match="rail: .*at least"):
        nominal.diagnose(np.zeros(50), spacing=1e-3)

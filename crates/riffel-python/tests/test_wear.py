"""The wear coefficient of two measurements: that of the program."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import riffel
from riffel import roughness

SBB = "validation/reference/sbb-track-noise/rail_roughness.csv"
TRAFFIC = "cases/traffic.toml"


def campaign(date: str) -> list[xr.DataArray]:
    """The spectra of Müller-BBM of the left rail, which leads, of one date."""
    spectra = roughness.read(SBB).spectra
    own = {"laboratory": "MBBM", "date": date, "rail": "L"}
    return [one for one in spectra if own.items() <= one.attrs.items()]


def test_the_mark_of_niederwangen(nominal: riffel.Case, program: Callable[..., Any]) -> None:
    printed = program(
        "forecast", "cases/nominal.toml", "--spectrum", SBB, "--where", "laboratory=MBBM", "--date-column", "date",
        "--traffic", TRAFFIC, "--json",
    )["wear_fit"]  # fmt: skip
    # 2014-03-01 to 2015-10-01.
    found = nominal.fit_wear(campaign("2014-03-01"), campaign("2015-10-01"), days=579, traffic=TRAFFIC)
    # Of two rails the program says which it has taken.
    assert "L alone" in printed.pop("remarks")[0] and found.pop("remarks") == []
    assert found == printed
    assert found["paired"]
    assert found["coefficient_kg_per_j"] is None
    assert any("20 mm fades" in sentence for sentence in found["sentences"])


def test_what_grows_twice_as_fast(nominal: riffel.Case, tmp_path: Path, program: Callable[..., Any]) -> None:
    now = roughness.levels([0.0315, 0.04, 0.05, 0.063], [2.0, 1.0, 0.0, -1.0])
    grown = nominal.forecast(now, traffic=TRAFFIC, passages=[8e6])["level"][0]
    later = [(grown + more).assign_attrs(units="dB") for more in (0.4, -0.1, -0.2, 0.3)]
    found = nominal.fit_wear([now] * 4, later, passages=4e6, traffic=TRAFFIC)
    assert found["verdict"] == "fitted"
    low, high = found["coefficient_interval_kg_per_j"]
    assert low < 2.0 * 2.5e-9 < high
    paths = []
    for name, spectra in (("now.csv", [now] * 4), ("later.csv", later)):
        rows = [
            f"{section},{wavelength!r},{level!r}"
            for section, one in zip("ABCD", spectra, strict=True)
            for wavelength, level in zip(one["wavelength"].values.tolist(), one.values.tolist(), strict=True)
        ]
        paths.append(str(tmp_path / name))
        Path(paths[-1]).write_text("section,wavelength_m,level_db\n" + "\n".join(rows) + "\n")
    printed = program(
        "forecast", "cases/nominal.toml", "--spectrum", paths[1], "--earlier", paths[0], "--passages-between", "4e6",
        "--traffic", TRAFFIC, "--json",
    )["wear_fit"]  # fmt: skip
    assert nominal.fit_wear(*paths, passages=4e6, traffic=TRAFFIC) == printed
    assert printed["paired"] and not found["paired"]


# Long: reads two records of 40 000 heights three times.
def test_profiles(nominal: riffel.Case, tmp_path: Path, program: Callable[..., Any]) -> None:
    position = 1e-3 * np.arange(40_000)
    noise = np.random.default_rng(1).normal(scale=1e-6, size=position.size)
    for name, amplitude in (("now.csv", 5e-6), ("later.csv", 10e-6)):
        heights = amplitude * np.sin(2.0 * np.pi * position / 0.05) + noise
        table = np.column_stack([position, heights])
        np.savetxt(tmp_path / name, table, delimiter=",", header="position [m],left [m]", comments="", fmt="%.17g")
    found = nominal.fit_wear(tmp_path / "now.csv", tmp_path / "later.csv", passages=1e6, speed=30.0)
    band = next(band for band in found["bands"] if abs(band["wavelength_m"] - 0.05) < 1e-3)
    # Twice the amplitude, at each place of 10 m.
    assert band["measured_change_db"] == pytest.approx(20.0 * np.log10(2.0), abs=0.05)
    assert found["paired"] and found["records_earlier"] == found["records_later"] == 4
    paths = [str(tmp_path / name) for name in ("now.csv", "later.csv")]
    printed = program(
        "forecast", "cases/nominal.toml", "--spectrum", paths[1], "--earlier", paths[0], "--passages-between", "1e6",
        "--traffic", TRAFFIC, "--json",
    )["wear_fit"]  # fmt: skip
    assert nominal.fit_wear(*paths, passages=1e6, traffic=TRAFFIC) == printed


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({}, "give one of passages and days"),
        ({"passages": 1e6, "days": 3.0}, "give one of passages and days"),
        ({"passages": 0.0}, "passages is 0.0, but must be finite and greater than zero"),
        ({"passages": [1e6]}, r"passages is \[1000000.0\], but must be a number"),
        ({"days": 3.0}, "days is 3, but must be given with a traffic that says under"),
        ({"passages": 1e6, "traffic": TRAFFIC, "speed": 30.0}, "traffic and speed exclude each other"),
        ({"passages": 1e6, "later": roughness.levels([1.0], [0.0])}, "later: "),
        ({"passages": 1e6, "earlier": np.zeros(3)}, "earlier is of type ndarray, but must be a DataArray over wavelength"),
        ({"passages": 1e6, "earlier": []}, "earlier is of type list"),
    ],
)
def test_bad_fits(nominal: riffel.Case, arguments: dict[str, Any], sentence: str) -> None:
    both = {"earlier": roughness.levels([0.04], [1.0]), "later": roughness.levels([0.04], [2.0])}
    with pytest.raises(ValueError, match=sentence):
        nominal.fit_wear(**{**both, **arguments})


def test_files_that_are_not_there(nominal: riffel.Case, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="none.csv"):
        nominal.fit_wear(tmp_path / "none.csv", SBB, passages=1e6)

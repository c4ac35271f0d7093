"""Rolling noise: that of the program."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

import riffel

CASE = "cases/main-line.toml"
WAVELENGTHS = [0.02, 0.025, 0.0315, 0.04, 0.05, 0.063, 0.08, 0.1]


# Long: computes the noise of eight wheels twice, here and by the program.
def test_noise_of_the_program(program: Callable[..., Any], tmp_path: Any) -> None:
    levels = [float(level) for level in range(8, 0, -1)]
    rail = riffel.roughness.levels(WAVELENGTHS, levels)
    rows = "".join(f"{1e3 * length},{level}\n" for length, level in zip(WAVELENGTHS, levels, strict=True))
    table = tmp_path / "rail.csv"
    table.write_text(f"wavelength_mm,level_db\n{rows}")
    transfer = ("cnossos-monobloc-hard-pads", "cnossos-wheel-920")
    printed = program(
        *("noise", CASE, "--roughness", str(table), "--speed", "136 km/h", "--wheels", "8"),
        *("--wheel-roughness", "cnossos-disc-brakes", "--track-transfer", transfer[0], "--vehicle-transfer", transfer[1]),
        *("--wheel-modes", "straight-web-920"),
        *("--distance", "25 m", "--height", "3.5 m", "--traffic", "cases/traffic.toml", "--months", "24", "--limit-dba", "90"),
        "--json",
    )
    found = riffel.Case.from_toml(CASE).noise(
        rail,
        speed="136 km/h",
        wheels=8,
        wheel_roughness="cnossos-disc-brakes",
        wheel_modes="straight-web-920",
        transfer=transfer,
        distance=25,
        height="3.5 m",
        traffic="cases/traffic.toml",
        months=24.0,
        limit_dba=90.0,
    )
    assert found == printed
    assert found["course"]["limit_dba"] == 90.0


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"distance": "50 cm"}, "distance is 50 cm, but must be between 760 mm and 1000 m"),
        ({"distance": 1e5}, "distance is 100000 m, but must be between 760 mm and 1000 m"),
        ({"height": "5 km"}, "height is 5 km, but must be between 0 m and 100 m"),
        ({"rail_foot": 5}, "rail_foot is 5 m, but must be between 10 mm and 500 mm"),
        ({"wheels": 1000, "train_length": 10}, "train_length is 10 m, but must be at least 500 m"),
        ({"wheels": 0}, "--wheels is 0, but must be an integer from 1 to 10000"),
        ({"wheel_roughness": "round"}, "wheel_roughness is \"round\", but must be a spectrum or one of cnossos-"),
        ({"limit_dba": 80.0}, "--limit-dba needs --traffic"),
        ({"traffic": "cases/traffic.toml", "months": -1.0}, "months is -1, but must be above zero and at most 12000"),
        ({"speed": "0.5 km/h"}, "speed is 0.5 km/h, but must be one at which"),
    ],
)
def test_what_is_not_allowed(given: dict[str, Any], sentence: str) -> None:
    rail = riffel.roughness.levels(WAVELENGTHS, [0.0] * 8)
    with pytest.raises(ValueError, match="^" + sentence):
        riffel.Case.from_toml(CASE).noise(rail, **{"speed": "136 km/h", **given})


def test_levels_that_no_rail_has_are_asked_about() -> None:
    rail = riffel.roughness.levels(WAVELENGTHS, [-115.0] * 8)
    remarks = riffel.Case.from_toml(CASE).noise(rail, speed="136 km/h")["remarks"]
    assert any("they look like dB re 1 m" in remark for remark in remarks), remarks

"""Cases from files, texts and dicts, and what is wrong with them."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import PROGRAM, ROOT

import riffel

KEYS: dict[str, Any] = {
    "wheel": {"rolling_radius": "460 mm", "mass": 350},
    "rail": {"section": "BS113A"},
    "track": {"model": "free-beam"},
    "contact": {"transverse_radius": 0.23, "normal_load": np.float64(50e3), "friction": 0.4, "tractive_ratio": 0.1},
}


def changed(table: str, **values: Any) -> dict[str, Any]:
    return {**KEYS, table: {**KEYS[table], **values}}


def test_a_dict_is_the_case_of_its_file() -> None:
    text = (
        "[wheel]\nrolling_radius = '460 mm'\nmass = 350\n[rail]\nsection = 'BS113A'\n[track]\nmodel = 'free-beam'\n"
        "[contact]\ntransverse_radius = 0.23\nnormal_load = 50e3\nfriction = 0.4\ntractive_ratio = 0.1\n"
    )
    by_dict, by_text = riffel.Case.from_dict(KEYS), riffel.Case.parse(text)
    assert by_dict.to_dict() == by_text.to_dict()
    assert by_dict.growth_map().identical(by_text.growth_map())
    again = riffel.Case.from_dict(by_dict.to_dict())
    assert again.growth_map().equals(by_dict.growth_map())


def test_a_path_is_no_case() -> None:
    with pytest.raises(TypeError, match=r"takes no str: .*Case.from_toml\(path\)"):
        riffel.Case("cases/nominal.toml")  # type: ignore[arg-type]


def test_overrides_of_every_kind(nominal: riffel.Case) -> None:
    slow = nominal.with_({"map.speed": {"min": "20 km/h", "max": 10, "points": np.int64(5)}}, title="slow")
    assert slow.title == "slow"
    assert slow.growth_map().sizes["speed"] == 5
    creep = nominal.with_(**{"contact.creepage": "0.02 %"}).to_dict()["contact"]
    assert creep["creepage"] == 0.0002
    assert "tractive_ratio" not in creep
    assert nominal.with_().growth_map().identical(nominal.growth_map())


@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        (changed("contact", frction=0.3), "`contact.frction` is not a key Riffel knows\n  did you mean friction"),
        (changed("contact", friction=-1.0), "`contact.friction` is -1"),
        (changed("contact", normal_load="50 kg"), '"50 kg" is in kg, not a force in N'),
        (changed("rail", section="BS113B"), 'no rail preset has that name'),
        ({"wheel": KEYS["wheel"]}, "`rail` is missing"),
        (changed("contact", friction=float("nan")), "finite"),
    ],
)
def test_bad_keys(keys: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError) as caught:
        riffel.Case.from_dict(keys)
    assert sentence in str(caught.value)


def test_values_that_no_case_holds() -> None:
    with pytest.raises(TypeError, match="`contact.friction` is of type object"):
        riffel.Case.from_dict(changed("contact", friction=object()))
    with pytest.raises(TypeError, match="`contact.friction` is of type NoneType"):
        riffel.Case.from_dict(changed("contact", friction=None))


def test_an_error_names_the_line(tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(Path("cases/nominal.toml").read_text().replace("friction = 0.4", "friction = 4000"))
    with pytest.raises(ValueError) as caught:
        riffel.Case.from_toml(path)
    assert "`contact.friction` is 4000, but must be between" in str(caught.value)
    assert "case.toml, line 35: friction = 4000" in str(caught.value)
    with pytest.raises(ValueError, match="`contact.tractive_ratio` is 1.5, but must be between"):
        riffel.Case.from_toml("cases/nominal.toml").with_({"contact.tractive_ratio": 1.5})
    with pytest.raises(ValueError, match="not valid TOML") as caught:
        riffel.Case.parse("[wheel]\nmass = = 3\n", name="mine.toml")
    assert "mine.toml, line 2: mass = = 3" in str(caught.value)


def test_files_that_are_not_there(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="cannot read the case file"):
        riffel.Case.from_toml(tmp_path / "none.toml")
    with pytest.raises(FileNotFoundError, match="cannot read the file"):
        riffel.roughness.read(tmp_path / "none.csv")
    with pytest.raises(FileNotFoundError, match="cannot read the traffic file"):
        levels = riffel.roughness.levels([0.04], [1.0])
        riffel.Case.from_toml("cases/nominal.toml").forecast(levels, traffic=tmp_path / "none.toml")


def test_what_does_not_converge(nominal: riffel.Case) -> None:
    """With the sentence of the program, whether a case is made or used."""
    # A slender ellipse of some micrometres, near full slip on a grid of 16.
    slender = {
        "contact.friction": 0.0325,
        "contact.normal_load": 8.71,
        "contact.transverse_radius": 0.00274,
        "wheel.rolling_radius": 1.02,
        "steel.poisson_ratio": 0.42,
        "contact.grid": 16,
    }
    with pytest.raises(riffel.ConvergenceError, match="steady rolling did not converge") as caught:
        nominal.with_(slender).creep_curve([2e-7])
    sets = [word for key, value in slender.items() for word in ("--set", f"{key}={value!r}")]
    command = [PROGRAM, "contact", "cases/nominal.toml", "--json", "--creepage", "2e-7", *sets]
    refused = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
    assert refused.returncode == 2
    words = " ".join(refused.stderr.replace("│", " ").split())
    assert str(caught.value) in words
    assert issubclass(riffel.ConvergenceError, RuntimeError)


def test_bays_and_decay_rates(nominal: riffel.Case) -> None:
    with pytest.raises(ValueError, match="needs discrete supports"):
        nominal.bay_maps()
    with pytest.raises(ValueError, match="a decay rate needs a track whose supports are known"):
        nominal.decay_rate()
    with pytest.raises(ValueError, match='direction is "up"'):
        nominal.receptance(direction="up")
    window = {"min": 0.03, "max": 0.06, "points": 5}
    periodic = nominal.with_(
        {
            "rail.section": "60E1",
            "track.model": "two-layer-periodic",
            "track.preset": "br-stiff",
            "map.wavelength": window,
            "map.speed": {"min": 20, "max": 30, "points": 3},
        }
    )
    bay = periodic.bay_maps()
    assert bay["growth_rate"].dims == ("place", "speed", "wavelength")
    over = bay["normalized_dissipation"].sel(place="over support")
    assert np.array_equal(over, periodic.with_({"track.position": 0}).growth_map()["normalized_dissipation"])
    rates = periodic.decay_rate()
    assert rates.attrs["units"] == "dB/m"
    assert bool((rates > 0.0).all())


def test_presets_have_sources() -> None:
    presets = riffel.presets()
    rail = next(preset for preset in presets if preset["name"] == "BS113A")
    assert rail["kind"] == "rail"
    assert all(entry["source"] for entry in rail["values"].values())


def test_growth_of_a_line_is_that_of_the_program() -> None:
    case = riffel.Case.from_toml("cases/metro.toml").with_({"map.speed.points": 3, "map.wavelength.points": 21})
    usual, given = case.line_growth(), case.line_growth("cases/traffic.toml")
    assert usual["usual_traffic_of"] == "metro" and given["usual_traffic_of"] is None
    assert [round(3.6 * speed) for speed in usual["speeds_m_per_s"]] == [40, 70]
    # Before it stands that rails wear more than that.
    assert "0.1 to 5" in usual["remarks"][0]
    assert usual["remarks"][1].split("; ")[0].endswith("grows fastest under the usual traffic of a metro (40–70 km/h, 6000 axles a day)")
    early, late = usual["fastest"]["doubling_months_banded"]["band_80"]
    assert early < usual["fastest"]["doubling_months"] < late
    with pytest.raises(ValueError, match="vehicle"):
        case.line_growth({"line": {"passages_per_day": 10}})

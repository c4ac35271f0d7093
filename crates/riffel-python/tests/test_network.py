"""A network of surveys."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import riffel


def survey(path: Path, rough: float, *, gap: bool = False) -> Path:
    """1 km of two rails, 1 um but for 100 m of the left one, and 100 m that are not measured."""
    rows = ["rail,from_m,to_m,rms_30_to_100_mm_um"]
    for rail in ("left", "right"):
        for start in range(0, 1000, 10):
            rms = f"{rough}" if rail == "left" and 500 <= start < 600 else "1"
            rows.append(f"{rail},{start},{start + 10},{'' if gap and start < 100 else rms}")
    path.write_text("\n".join(rows))
    return path


@pytest.fixture
def network(tmp_path: Path) -> riffel.Network:
    network = riffel.Network(tmp_path / "railway")
    network.ingest(survey(tmp_path / "before.csv", 3.5), "Main line", "2025-07-01")
    network.ingest(survey(tmp_path / "after.csv", 7.0, gap=True), "Main line", "2026-01-01")
    return network


def test_surveys_become_a_plan(network: riffel.Network, tmp_path: Path) -> None:
    again = network.ingest(tmp_path / "after.csv", "Main line", "2026-01-01")
    assert again["there_already"]
    assert network.status()["surveys"] == 2
    worst = network.worst(most=1)
    assert worst["rail"].values.tolist() == ["left"]
    assert float(worst["from"][0]) == 500.0
    assert worst["rms_over_limit"].values == pytest.approx([1.0], rel=1e-12)
    assert worst["band"].values.tolist() == [[0.03, 0.1]]
    earlier = network.worst(most=1, until="2025-12-31")
    assert earlier["rms_over_limit"].values == pytest.approx([0.5], rel=1e-12)
    growth = network.growth(most=3)
    yearly = 20 * np.log10(2) / 184 * 365.2425
    assert float(growth["growth"].max()) == pytest.approx(yearly, rel=1e-9)
    plan = network.plan(months=6, length="1 km")
    assert plan.attrs["over_limit_m"] == 100.0
    assert plan["from"].values.tolist() == [500.0]
    most = network.plan(months=6, money=600, cost_per_metre=6, most_track=True)
    assert most["to"].values.tolist() == [600.0] and most.attrs["least_left_over_limit_m"] == 0.0
    priced = network.plan(months=6, money=100, cost_per_metre=6)
    assert priced.sizes == {} and priced.attrs["left_over_limit_m"] == 100.0


def test_a_chart_is_place_by_date(network: riffel.Network) -> None:
    chart = network.chart("Main line")
    assert chart["rms_over_limit"].dims == ("date", "place")
    at = chart["rms_over_limit"].sel(place=550.0)
    assert at.values == pytest.approx([0.5, 1.0], rel=1e-12)
    assert np.isnan(chart["rms"].sel(place=50.0, date="2026-01-01").item())
    assert np.isfinite(chart["rms"].sel(place=50.0, date="2025-07-01").item())
    right = network.chart("Main line", rail="right")["rms_over_limit"]
    assert float(right.max()) == pytest.approx(1 / 7, rel=1e-12)


def test_what_cannot_be_is_refused(network: riffel.Network, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="holds no network"):
        riffel.Network(tmp_path / "elsewhere").status()
    with pytest.raises(ValueError, match="one of those in the store: Main line"):
        network.chart("Branch")
    with pytest.raises(ValueError, match="has another survey of 2026-01-01"):
        network.ingest(survey(tmp_path / "other.csv", 5.0), "Main line", "2026-01-01")
    with pytest.raises(ValueError, match="--length or --money is missing"):
        network.plan()
    with pytest.raises(ValueError, match="--money needs --cost-per-metre"):
        network.plan(money=10.0)
    with pytest.raises(ValueError, match="500.000, which may be 500000 or 500"):
        network.plan(money="500.000", cost_per_metre=12)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="at least a cell"):
        network.worst(section="1 m")
    with pytest.raises(ValueError, match="2026"):
        network.worst(until="yesterday")
    with pytest.raises(ValueError, match="most is 0"):
        network.worst(most=0)


def test_a_damaged_survey_is_an_error(network: riffel.Network, tmp_path: Path) -> None:
    chunk = sorted(tmp_path.rglob("left/c/0/0"))[-1]
    chunk.write_bytes(bytes(reversed(chunk.read_bytes())))
    for ask in (network.status, network.worst):
        with pytest.raises(ValueError, match="is damaged: .*; the survey is left out"):
            ask()


def test_what_traffic_is_expected_to_make_is_that_of_the_program(
    network: riffel.Network, nominal: riffel.Case, tmp_path: Path
) -> None:
    network.ingest(tmp_path / "before.csv", "Branch", "2026-01-01")
    growth = network.growth(case=nominal, line="Branch", most=100)
    branch = growth.sel(place=growth["line"] == "Branch")
    traffic = nominal.line_growth()
    per_year = traffic["fastest"]["growth_rate_per_passage"] * traffic["passages_per_day"] * 365.2425
    # The fastest wave between 30 and 100 mm, of those in the middle of sixteenths of a band.
    assert branch["expected_growth"].values == pytest.approx(20 / np.log(10) * per_year, rel=0.02)
    low, high = branch["expected_growth_band_80"].values[0]
    assert low < branch["expected_growth"][0] < high
    assert (growth["expected_growth"].isnull() == (growth["line"] == "Main line")).all()
    # Half of its limit is 6 dB below it.
    months = 12 * 20 * np.log10(2) / branch["expected_growth"].max()
    assert branch["months_to_limit"].min() == pytest.approx(float(months), rel=1e-3)
    with pytest.raises(ValueError, match="case"):
        network.growth(line="Branch")
    with pytest.raises(ValueError, match="one of those in the store"):
        network.plan(length="1 km", case=nominal, line="Siding")

"""Calibrations and decisions from Python."""

import csv
import json
import shutil
import subprocess
from collections.abc import Callable
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import riffel
import xarray as xr
from conftest import PROGRAM, ROOT
from distributed import Client, LocalCluster

SETS = ROOT / "validation" / "calibration"
SET = SETS / "b-three-dates"
HEAD = """case = "case.toml"
traffic = "traffic.toml"
[sampler]
chains = 2
warmup = 200
draws = 400
[[parameter]]
key = "wear.coefficient"
lognormal = { median = 2.5e-9, factor = 2.0 }
[[data]]
kind = "dated-levels"
file = "roughness.csv"
discrepancy = { kind = "band", standard_deviation = 1.0 }
"""
DECISION = """[cost]
grinding = "9000 EUR"
horizon = "30 months"
[[action]]
changes = "friction.toml"
upkeep = "2000 EUR"
"""


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    for name in ("case.toml", "traffic.toml", "friction.toml", "roughness.csv"):
        shutil.copy(SET / name, tmp_path)
    path = tmp_path / "plan.toml"
    path.write_text(HEAD)
    return path


# Long: draws the chains of a calibration.
@pytest.mark.filterwarnings("ignore::UserWarning")
def test_a_calibration_is_a_tree_and_its_decision_that_of_the_program(
    plan: Path, tmp_path: Path, program: Callable[..., Any]
) -> None:
    folder = tmp_path / "out"
    tree = riffel.calibrate(plan, folder)
    draws = tree["posterior/wear.coefficient"]
    assert draws.shape == (2, 400)
    assert draws.attrs["units"] == "kg/J"
    likelihood = tree["log_likelihood/dated-levels"]
    assert likelihood.sizes == {"chain": 2, "draw": 400, "datum": 16}
    observed = tree["observed_data/dated-levels"]
    replicas = tree["posterior_predictive/dated-levels"]
    apart = (replicas.mean(("chain", "draw")) - observed) / replicas.std(("chain", "draw"))
    # With 1 dB per 10^6 passages that the model may miss, replicas lie as far from their mean as the data.
    assert 0.2 < np.sqrt((apart**2).mean()) < 1.5
    with pytest.raises(ValueError, match="`cost` is missing"):
        riffel.decide(folder)
    plan.write_text(HEAD + DECISION)
    found = riffel.decide(folder)
    expected = program("decide", str(folder), "--json", "-q")
    assert list(found["action"].values) == ["as it is", "friction treatment"]
    for place, action in enumerate(expected["actions"]):
        assert found["mean_cost_per_year"].values[place] == action["mean_cost_per_year"]
        assert found["probability_never"].values[place] == action["months_to_limit"]["probability_never"]
    assert found.attrs["evpi_per_year"] == expected["evpi_per_year"]
    assert found["probability_cheapest"].sum() == pytest.approx(1)
    assert sorted(found["rank"].values) == [1, 2]
    assert "breaks_budget" not in found
    plan.write_text(HEAD + DECISION.replace("[cost]", '[cost]\nbudget = "1 EUR"'))
    assert list(riffel.decide(folder)["breaks_budget"].values) == [1, 1]


# Long: imports ArviZ and draws four chains.
@pytest.mark.filterwarnings("ignore")
def test_arviz_reads_the_tree_and_finds_the_same_diagnostics(plan: Path, tmp_path: Path) -> None:
    import arviz

    plan.write_text(HEAD.replace("chains = 2", "chains = 4"))
    riffel.calibrate(plan, tmp_path / "out")
    tree = xr.open_datatree(tmp_path / "out" / "posterior.zarr", engine="zarr")
    groups = {"posterior", "sample_stats", "prior", "log_likelihood", "posterior_predictive", "observed_data", "constant_data"}
    assert set(tree.children) == groups
    for group in groups - {"observed_data", "constant_data"}:
        assert list(tree[group].sizes)[:2] == ["chain", "draw"]
        assert tree[group]["draw"].dtype == np.int64
    assert tree["sample_stats/diverging"].dtype == bool
    assert tree["sample_stats/n_steps"].dtype == np.int64
    # What the model was given, row by row of the tables, and where each group comes from.
    given = tree["constant_data"]
    table = np.genfromtxt(plan.parent / "roughness.csv", delimiter=",", names=True)
    assert table.dtype.names is not None
    for name in table.dtype.names:
        assert np.array_equal(given[f"dated-levels.{name}"], table[name])
    for part in [tree, *tree.children.values()]:
        assert part.attrs["inference_library"] == "riffel"
        assert part.attrs["inference_library_version"] == riffel.__version__
        made = datetime.fromisoformat(part.attrs["created_at"])
        assert abs((datetime.now(timezone.utc) - made).total_seconds()) < 3600
    data = arviz.InferenceData.from_datatree(tree)  # type: ignore[no-untyped-call]
    found = arviz.summary(data, round_to="none")
    with (tmp_path / "out" / "summary.csv").open() as file:
        own = {row["parameter"]: row for row in csv.DictReader(file)}
    assert set(own) == set(found.index)
    for name, row in own.items():
        for key, column in (
            ("mean", "mean"),
            ("standard_deviation", "sd"),
            ("rhat", "r_hat"),
            ("ess_bulk", "ess_bulk"),
            ("ess_tail", "ess_tail"),
        ):
            assert float(row[key]) == pytest.approx(found[column][name], rel=0.01), (name, key)
    # What indexes by divergences, and what weights draws by the likelihood of each datum.
    arviz.plot_trace(data)
    assert arviz.loo(data).n_data_points == tree["observed_data"].sizes["datum"]  # type: ignore[no-untyped-call]


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_the_same_seed_gives_the_same_bits_of_all_but_the_time(plan: Path, tmp_path: Path) -> None:
    def strip(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: strip(inner) for key, inner in value.items() if key != "created_at"}
        return value

    def files(name: str) -> dict[str, Any]:
        riffel.calibrate(plan, tmp_path / name)
        root = tmp_path / name / "posterior.zarr"
        paths = [path for path in root.rglob("*") if path.is_file()]
        assert any("created_at" in path.read_text() for path in paths if path.name == "zarr.json")
        read = {
            path: strip(json.loads(path.read_text())) if path.name == "zarr.json" else path.read_bytes() for path in paths
        }
        return {str(path.relative_to(root)): content for path, content in read.items()}

    assert files("one") == files("other")


def refused(**question: Any) -> str:
    """The sentence by which the program refuses a calibration."""
    asked = json.dumps(question)
    found = subprocess.run([PROGRAM, "ask", "calibrate"], input=asked, capture_output=True, text=True)
    assert found.returncode == 2
    sentence: str = json.loads(found.stderr)["error"]["message"]
    return sentence


# Long: draws the chains of a calibration three times.
@pytest.mark.filterwarnings("ignore::UserWarning")
def test_a_case_and_its_tables_need_no_plan(tmp_path: Path, program: Callable[..., Any]) -> None:
    site = tmp_path / "site"
    site.mkdir()
    shutil.copy(SETS / "a-hammer-and-decay" / "case.toml", site)
    shutil.copy(SET / "traffic.toml", site)
    shutil.copy(SET / "roughness.csv", site)
    head, *lines = (SETS / "a-hammer-and-decay" / "hammer.csv").read_text().splitlines()
    # Every sixth line: the chains are as long as ever, but a model takes a sixth of the time.
    (site / "hammer.csv").write_text("\n".join([head, *lines[::6]]))
    case, table, traffic = site / "case.toml", site / "hammer.csv", site / "traffic.toml"
    tree = riffel.calibrate(case, tmp_path / "own", with_=table, traffic=traffic)
    assert tree.attrs["doubts"] == []
    program("calibrate", str(case), "--with", str(table), "--traffic", str(traffic), "-o", str(tmp_path / "other"), "--json", "-q")
    for name in ("plan.toml", "summary.csv"):
        assert (tmp_path / "own" / name).read_bytes() == (tmp_path / "other" / name).read_bytes(), name
    assert 'traffic = "../site/traffic.toml"' in (tmp_path / "own" / "plan.toml").read_text()
    # The plan that was written runs by itself.
    again = riffel.calibrate(tmp_path / "own" / "plan.toml", tmp_path / "again")
    assert again.children["posterior"].equals(tree.children["posterior"])
    with pytest.raises(ValueError, match="traffic is given without with_"):
        riffel.calibrate(tmp_path / "own" / "plan.toml", tmp_path / "own", traffic=traffic)
    for wrong in (site / "roughness.csv", case):
        with pytest.raises(ValueError) as error:
            riffel.calibrate(case, tmp_path / "none", with_=[table, wrong])
        asked = {"plan": str(case), "with": [str(table), str(wrong)], "output": str(tmp_path / "none")}
        assert refused(**asked) in str(error.value)
    assert not (tmp_path / "none").exists()


# Long: draws the chains of sites on a cluster.
@pytest.mark.filterwarnings("ignore")
def test_sites_are_calibrated_on_a_cluster(plan: Path, tmp_path: Path) -> None:
    def calibrate(site: Path) -> list[str]:
        doubts: list[str] = riffel.calibrate(site / "plan.toml", site / "posterior", restart=True).attrs["doubts"]
        return doubts

    sites = [tmp_path / name for name in ("here", "there")]
    for seed, site in enumerate(sites):
        shutil.copytree(plan.parent, site, ignore=lambda *_: ["here", "there"])
        few = "draws = 50" if seed else "draws = 1000"
        (site / "plan.toml").write_text(HEAD.replace("draws = 400", f"{few}\nseed = {seed}"))
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", silence_logs="CRITICAL") as cluster,
        Client(cluster) as client,
    ):
        told = client.gather(client.map(calibrate, sites, pure=False))
    # Of 2 × 50 draws fewer than 400 count.
    assert told[0] == []
    assert "effective draws, but must have 400" in told[1][-1]
    for site in sites:
        riffel.calibrate(site / "plan.toml", site / "alone")
        summaries = [(site / folder / "summary.csv").read_bytes() for folder in ("posterior", "alone")]
        assert summaries[0] == summaries[1]


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_models_are_compared_date_by_date(plan: Path, tmp_path: Path) -> None:
    compare = '[[compare]]\ntitle = "less friction"\nset = { "contact.friction" = 0.3 }\n'
    plan.write_text(HEAD.replace("draws = 400", "draws = 50").replace("[[parameter]]", compare + "[[parameter]]"))
    own, other = riffel.calibrate(plan, tmp_path / "out").attrs["models"]
    assert [own["title"], other["title"]] == [None, "less friction"]
    assert [score["held_out"] for score in own["scores"]] == [{"date": 0}, {"date": 1.5e6}, {"date": 3.5e6}]
    assert own["log_density"] == pytest.approx(sum(score["log_density"] for score in own["scores"]))
    assert min(own["behind"], other["behind"]) == 0


def test_what_is_not_there_is_said(plan: Path, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="holds no calibration"):
        riffel.decide(tmp_path)
    plan.write_text(HEAD.replace("2.5e-9", '"2 kg"'))
    with pytest.raises(ValueError, match="2 kg"):
        riffel.calibrate(plan, tmp_path / "out")


# Long: draws chains and computes growth for each of 200 draws twice.
@pytest.mark.filterwarnings("ignore::UserWarning")
def test_cases_of_draws_answer_as_the_program_does_over_the_posterior(
    plan: Path, tmp_path: Path, program: Callable[..., Any]
) -> None:
    folder = tmp_path / "out"
    tree = riffel.calibrate(plan, folder)
    drawn = riffel.draws(folder)
    assert len(drawn) == 200
    fastest = [case.line_growth(traffic)["fastest"] for case, traffic in drawn]
    months = np.array([growth["doubling_months"] for growth in fastest])
    found = program("map", str(plan.parent / "case.toml"), "--posterior", str(folder), "--json", "-q")
    assert "under_traffic" not in found
    over = {number["name"]: number for number in found["over_posterior"]["numbers"]}
    banded = over["under_traffic.fastest.doubling_months"]
    assert banded["median"] == pytest.approx(np.quantile(months, 0.5), rel=1e-12)
    assert banded["band_90"] == pytest.approx(np.quantile(months, [0.05, 0.95]), rel=1e-12)
    # The wear coefficient alone is drawn, and growth goes with it.
    coefficient = np.asarray(tree["posterior/wear.coefficient"].values, dtype=float)
    assert np.std(np.log(months)) == pytest.approx(np.std(np.log(coefficient)), rel=0.15)
    with pytest.raises(FileNotFoundError, match="holds no calibration"):
        riffel.draws(tmp_path)


def test_the_density_of_a_plan_is_that_of_its_sampler(plan: Path) -> None:
    posterior = riffel.LogPosterior(plan)
    assert (posterior.names, posterior.units) == (["wear.coefficient"], ["kg/J"])
    middle = posterior.prior_quantile(0.5)
    assert middle == pytest.approx([2.5e-9])
    place = posterior.place(middle)
    assert posterior.values(place) == pytest.approx(middle)
    likelihood = sum(posterior.log_likelihood(middle).values())
    prior = -0.5 * np.log(2.0 * np.pi) - np.log(np.log(2.0))
    assert posterior(place) == pytest.approx(likelihood + prior, abs=1e-9)
    step = 1e-4
    slope = (posterior(place + step) - posterior(place - step)) / (2.0 * step)
    assert posterior.gradient(place) == pytest.approx([slope], rel=1e-4)
    assert posterior([1e3]) == -np.inf
    with pytest.raises(ValueError, match="2 numbers are given, but the plan has 1 parameters"):
        posterior([0.0, 0.0])

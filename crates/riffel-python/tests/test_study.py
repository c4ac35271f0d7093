"""Studies in one process, in shards, and on a cluster whose workers fail."""

from __future__ import annotations

import os
import resource
import shutil
import signal
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from conftest import PROGRAM, ROOT
from distributed import Client, LocalCluster
from SALib.analyze import sobol
from SALib.test_functions import Ishigami
from scipy.stats import qmc

import riffel
from riffel import _cluster

# distributed and zarr use what Python and NumPy are about to change.
pytestmark = [
    pytest.mark.filterwarnings("ignore::DeprecationWarning"),
    pytest.mark.filterwarnings("ignore::FutureWarning"),
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
    pytest.mark.filterwarnings("ignore:Consolidated metadata"),
    pytest.mark.filterwarnings("ignore:The data type"),
]

PLAN = """
title = "Friction and wheel"
case = "{case}"
[set]
map.wavelength = {{ min = "20 mm", max = "80 mm", points = 121 }}
map.speed = {{ min = "5 m/s", max = "60 m/s", points = 40 }}
[design]
method = "{method}"
samples = {samples}
seed = 3
[[parameter]]
key = "contact.friction"
uniform = {{ min = 0.2, max = 0.5 }}
[[parameter]]
key = "wheel.mass"
normal = {{ mean = "350 kg", standard_deviation = "40 kg", min = "200 kg", max = "500 kg" }}
[outputs]
ridge = true
growth_by_wavelength = true
[results]
samples_per_chunk = {chunk}
"""


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """A plan of 32 chunks of some tens of milliseconds."""
    return written(tmp_path)


def written(folder: Path, *, method: str = "latin-hypercube", samples: int = 640, chunk: int = 20) -> Path:
    path = folder / "plan.toml"
    case = ROOT / "cases" / "nominal.toml"
    path.write_text(PLAN.format(case=case, method=method, samples=samples, chunk=chunk))
    return path


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> xr.Dataset:
    """The results of the plan in one process."""
    folder = tmp_path_factory.mktemp("plan")
    return riffel.Study.from_toml(written(folder)).run(folder / "alone").load()


def same(one: xr.Dataset, other: xr.Dataset) -> None:
    """The same variables with the same bits."""
    assert set(one.variables) == set(other.variables)
    for name in one.variables:
        assert one[name].values.tobytes() == other[name].values.tobytes(), name


@contextmanager
def workers(count: int) -> Iterator[Client]:
    """A cluster of processes of one thread each."""
    with (
        LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=":0", silence_logs="CRITICAL") as cluster,
        Client(cluster) as client,
    ):
        yield client


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    with workers(3) as client:
        yield client


# Long: computes a study three times, and starts workers.
def test_program_shards_and_python_give_the_same_numbers(plan: Path, tmp_path: Path, alone: xr.Dataset) -> None:
    study = riffel.Study.from_toml(plan)
    assert not np.isnan(alone["ridge_frequency"].values).any()
    assert alone["mean_growth_rate"].sizes == {"sample": 640, "wavelength": 121}
    subprocess.run([PROGRAM, "study", str(plan), "-o", str(tmp_path / "program")], check=True, capture_output=True)
    same(alone, riffel.open_results(tmp_path / "program"))
    shards = [tmp_path / f"shard{index}" for index in range(1, 8)]
    for index, shard in enumerate(shards, 1):
        study.run(shard, shard=f"{index}/7")
    assert np.isnan(riffel.open_results(shards[0])["ridge_frequency"].values).sum() == 640 - 5 * 20
    assert riffel.merge_studies(tmp_path / "merged", shards) == []
    same(alone, riffel.open_results(tmp_path / "merged"))
    assert riffel.study_summary(tmp_path / "merged")["samples_finished"] == 640


# Long: computes a study on a cluster of processes.
def test_a_cluster_gives_the_same_numbers(client: Client, plan: Path, tmp_path: Path, alone: xr.Dataset) -> None:
    study = riffel.Study.from_toml(plan)
    told: list[tuple[int, int]] = []
    results = study.run(tmp_path / "cluster", client, progress=lambda *now: told.append(now))
    same(alone, results)
    assert told[-1] == (640, 640)
    assert [done for done, _ in told] == sorted(done for done, _ in told)
    # Nothing is left behind with the scheduler.
    assert not any(client.processing().values())


# Long: starts three workers and computes a study twice.
def test_a_killed_worker_costs_nothing(tmp_path: Path) -> None:
    study = riffel.Study.from_toml(written(tmp_path, samples=1280))
    with workers(3) as client:
        pids = list(client.run(os.getpid).values())

        def kill(done: int, _: int) -> None:
            if done > 200 and pids:
                os.kill(pids.pop(), signal.SIGKILL)
                pids.clear()

        results = study.run(tmp_path / "cluster", client, progress=kill)
    assert not pids
    same(study.run(tmp_path / "alone"), results)


# Long: starts three workers and waits until one is given up.
def test_a_worker_that_never_answers_is_given_up(tmp_path: Path) -> None:
    study = riffel.Study.from_toml(written(tmp_path, samples=1280))
    with workers(3) as client:
        pid = client.run(os.getpid).popitem()[1]
        stopped: list[int] = []

        def stop(done: int, _: int) -> None:
            if done > 100 and not stopped:
                stopped.append(pid)
                os.kill(pid, signal.SIGSTOP)

        try:
            results = study.run(tmp_path / "cluster", client, progress=stop, patience=4.0)
        finally:
            # Its nanny may have ended it by then.
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGCONT)
    assert stopped
    same(study.run(tmp_path / "alone"), results)


def limit_files(size: int) -> None:
    """No file larger than this: what a full disk does to a write."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))


def test_workers_are_asked_of_the_scheduler(client: Client, monkeypatch: pytest.MonkeyPatch) -> None:
    """What the client keeps of them is without any of them for moments."""
    monkeypatch.setattr(client, "scheduler_info", lambda *_, **__: {"workers": {}})
    assert sorted(_cluster._threads(client).values()) == [1, 1, 1]


# Long: waits until a study has done without one of its workers.
def test_a_full_disk_on_one_worker_costs_nothing(
    client: Client, plan: Path, tmp_path: Path, alone: xr.Dataset
) -> None:
    study = riffel.Study.from_toml(plan)
    worker = next(iter(_cluster._threads(client)))
    client.run(limit_files, 100, workers=[worker])
    try:
        results = study.run(tmp_path / "cluster", client)
    finally:
        client.run(limit_files, resource.RLIM_INFINITY, workers=[worker])
    same(alone, results)


# Long: waits until a study gives up on its workers.
def test_full_disks_everywhere_stop_it_with_a_sentence(
    client: Client, plan: Path, tmp_path: Path, alone: xr.Dataset
) -> None:
    study = riffel.Study.from_toml(plan)
    client.run(limit_files, 100)
    try:
        with pytest.raises((OSError, RuntimeError), match="Finished chunks are kept"):
            study.run(tmp_path / "cluster", client, patience=5.0)
    finally:
        client.run(limit_files, resource.RLIM_INFINITY)
    same(alone, study.run(tmp_path / "cluster", client))


@contextmanager
def elsewhere(client: Client, folder: Path, workers: list[str] | None = None) -> Iterator[None]:
    """Workers that work in another folder than the client; the others in its own."""
    client.run(os.chdir, Path.cwd())
    client.run(os.chdir, folder, workers=workers)
    try:
        yield
    finally:
        # A task that was cancelled may still write: not into the repository.
        client.run(os.chdir, Path.cwd().parent)


# A folder of this name is another one in every process that works elsewhere: as /scratch is on every machine.
OWN_FOLDER = Path("/proc/self/cwd/study")
each_has_its_own = pytest.mark.skipif(not OWN_FOLDER.parent.exists(), reason="needs the /proc of Linux")


# Long: waits until a study gives up on a folder.
@each_has_its_own
def test_a_folder_that_workers_do_not_see(
    client: Client, plan: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, alone: xr.Dataset
) -> None:
    study = riffel.Study.from_toml(plan)
    (here := tmp_path / "here").mkdir()
    (there := tmp_path / "there").mkdir()
    monkeypatch.chdir(here)
    study.run(OWN_FOLDER, shard="1/8")
    finished = riffel.study_summary(here / "study")["chunks_finished"]
    shared = f"does not see {OWN_FOLDER}: it must be a folder that all machines of the cluster share"
    with elsewhere(client, there), pytest.raises(RuntimeError, match=shared) as caught:
        study.run(OWN_FOLDER, client, patience=5.0)
    assert "Finished chunks are kept" in str(caught.value)
    assert riffel.study_summary(here / "study")["chunks_finished"] == finished
    assert list(there.iterdir()) == []
    # In a place that they see it goes on.
    same(alone, study.run(here / "study", client))


@each_has_its_own
def test_a_folder_of_which_each_worker_has_its_own(
    client: Client, plan: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, alone: xr.Dataset
) -> None:
    study = riffel.Study.from_toml(plan)
    (here := tmp_path / "here").mkdir()
    monkeypatch.chdir(here)
    study.run(OWN_FOLDER, shard="1/8")
    there = Path(shutil.copytree(here, tmp_path / "there"))
    finished = riffel.study_summary(here / "study")["chunks_finished"]
    with elsewhere(client, there), pytest.raises(RuntimeError, match=f"not in {OWN_FOLDER} here: it must be a folder"):
        study.run(OWN_FOLDER, client)
    # What was here is here, and what the workers did can be taken along.
    assert riffel.study_summary(here / "study")["chunks_finished"] == finished
    assert riffel.study_summary(there / "study")["chunks_finished"] > finished
    riffel.merge_studies(tmp_path / "merged", [here / "study", there / "study"])
    same(alone, study.run(tmp_path / "merged"))


# Long: waits until a study has done without one of its workers.
@each_has_its_own
def test_one_worker_that_does_not_see_the_folder_costs_nothing(
    client: Client, plan: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, alone: xr.Dataset
) -> None:
    study = riffel.Study.from_toml(plan)
    (here := tmp_path / "here").mkdir()
    (there := tmp_path / "there").mkdir()
    monkeypatch.chdir(here)
    with elsewhere(client, there, [next(iter(_cluster._threads(client)))]):
        results = study.run(OWN_FOLDER, client)
    assert list(there.iterdir()) == []
    same(alone, results)


def test_an_interrupted_study_goes_on(plan: Path, tmp_path: Path, alone: xr.Dataset) -> None:
    study = riffel.Study.from_toml(plan)

    def interrupt(done: int, _: int) -> None:
        if done > 50:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        study.run(tmp_path / "study", progress=interrupt)
    summary = riffel.study_summary(tmp_path / "study")
    assert 0 < summary["chunks_finished"] < 32
    kept = {path: path.stat().st_mtime_ns for path in (tmp_path / "study" / "finished").iterdir()}
    results = study.run(tmp_path / "study")
    assert {path: path.stat().st_mtime_ns for path in kept} == kept
    same(alone, results)


# Long: computes a study of 3000 samples on a cluster.
def test_tasks_are_few_and_long(client: Client, tmp_path: Path) -> None:
    """Chunks of a millisecond go to the cluster many at a time, and never more than a few tasks at once."""
    study = riffel.Study.from_toml(written(tmp_path, samples=3000, chunk=4))
    tasks: list[int] = []

    def count(*_: int) -> None:
        tasks.append(sum(len(keys) for keys in client.processing().values()))

    study.run(tmp_path / "cluster", client, progress=count)
    assert max(tasks) <= _cluster.QUEUE * 3
    assert len(tasks) < 750 / 4


def test_designs_are_those_of_their_names(tmp_path: Path) -> None:
    def unit(study: riffel.Study) -> np.ndarray[Any, np.dtype[np.float64]]:
        friction = (study.design()["contact.friction"].values - 0.2) / 0.3
        return np.column_stack([friction, np.argsort(np.argsort(study.design()["wheel.mass"].values)) / study.samples])

    hypercube = unit(riffel.Study.from_toml(written(tmp_path, samples=256)))[:, 0]
    assert (np.sort((256 * hypercube).astype(int)) == np.arange(256)).all()
    found = unit(riffel.Study.from_toml(written(tmp_path, method="sobol", samples=256)))
    # A net: one point in each interval of a 256th, and as even as the sequence of SciPy.
    assert (np.sort((256 * found[:, 0]).astype(int)) == np.arange(256)).all()
    own = [qmc.discrepancy(unit(riffel.Study.from_toml(written(tmp_path, method="sobol", samples=256))))]
    scipy = [qmc.discrepancy(qmc.Sobol(2, seed=seed).random(256)) for seed in range(8)]
    assert own[0] < 1.5 * max(scipy)
    random = unit(riffel.Study.from_toml(written(tmp_path, method="random", samples=256)))
    assert qmc.discrepancy(random) > 3.0 * own[0]


def test_sobol_indices_are_those_of_salib(tmp_path: Path) -> None:
    """The Ishigami function (a = 7, b = 0.1) on a Saltelli design: known indices, and the estimates of SALib."""
    study = riffel.Study.from_dict(
        {
            "design": {"method": "saltelli", "samples": 4096, "seed": 1},
            "parameter": [
                {"key": key, "uniform": {"min": low, "max": high}}
                for key, low, high in (
                    ("contact.friction", 0.2, 0.5),
                    ("wheel.mass", 300.0, 400.0),
                    ("contact.normal_load", 40e3, 60e3),
                )
            ],
            "outputs": {"ridge": True},
        },
        case=ROOT / "cases" / "nominal.toml",
    )
    design = study.design()
    shares = [
        (design[key].values - low) / (high - low)
        for key, low, high in (
            ("contact.friction", 0.2, 0.5),
            ("wheel.mass", 300.0, 400.0),
            ("contact.normal_load", 40e3, 60e3),
        )
    ]
    values = Ishigami.evaluate(np.pi * (2.0 * np.column_stack(shares) - 1.0))
    indices = study.sobol_indices(xr.DataArray(values, dims="sample", name="ishigami"))
    peer = sobol.analyze(study.salib_problem(), values, calc_second_order=False, seed=1)
    # SALib standardises with the variance of all rows of A and B as well; its estimators are the same but for the mean.
    assert np.abs(indices["first"].values - peer["S1"]).max() < 0.01
    assert np.abs(indices["total"].values - peer["ST"]).max() < 0.01
    for name, known in (("first", [0.3139, 0.4424, 0.0]), ("total", [0.5576, 0.4424, 0.2437])):
        # The bootstrap takes the rows as independent; a Sobol sequence is better.
        assert (indices[f"{name}_low"].values <= np.array(known) + 1e-3).all()
        assert (indices[f"{name}_high"].values >= np.array(known) - 1e-3).all()


def test_sobol_indices_of_an_output_by_its_name(tmp_path: Path) -> None:
    study = riffel.Study.from_toml(written(tmp_path, method="saltelli", samples=16))
    with pytest.raises(ValueError, match="has no results to take highest_growth_rate from: run it"):
        study.sobol_indices("highest_growth_rate")
    study.run(tmp_path / "part", shard="1/2")
    with pytest.raises(ValueError, match="part is not finished: .* chunks are missing"):
        study.sobol_indices("highest_growth_rate")
    results = study.run(tmp_path / "results")
    by_array = study.sobol_indices(results["highest_growth_rate"])
    assert study.sobol_indices("highest_growth_rate").identical(by_array)
    assert riffel.Study.open(tmp_path / "results").sobol_indices("highest_growth_rate").identical(by_array)
    with pytest.raises(ValueError, match="has no output growth, but .*highest_growth_rate"):
        study.sobol_indices("growth")
    with pytest.raises(ValueError, match="must be one number for each"):
        study.sobol_indices("mean_growth_rate")


def test_tornado(plan: Path) -> None:
    tornado = riffel.Study.from_toml(plan).tornado("highest_growth_rate")
    assert tornado["parameter"].values.tolist()[0] == "contact.friction"
    assert (tornado["low"] != tornado["high"]).all()
    with pytest.raises(ValueError, match="has no output nonsense, but ridge_frequency"):
        riffel.Study.from_toml(plan).tornado("nonsense")
    with pytest.raises(ValueError, match="no single number"):
        riffel.Study.from_toml(plan).tornado("mean_growth_rate")
    with pytest.raises(ValueError, match="must rise between 0 and 1"):
        riffel.Study.from_toml(plan).tornado("highest_growth_rate", (0.9, 0.1))


def test_wrong_plans_and_folders(plan: Path, tmp_path: Path) -> None:
    study = riffel.Study.from_toml(plan)
    with pytest.raises(FileNotFoundError, match="nowhere"):
        riffel.Study.from_toml(tmp_path / "nowhere.toml")
    with pytest.raises(FileNotFoundError, match="holds no study"):
        riffel.Study.open(tmp_path)
    with pytest.raises(FileNotFoundError, match="holds no study"):
        riffel.open_results(tmp_path)
    # A file of the same name, but not of this study.
    mine = tmp_path / "mine"
    mine.mkdir()
    (mine / "case.toml").write_text("mine")
    with pytest.raises(ValueError, match="is not empty and holds no study"):
        study.run(mine)
    assert [(path.name, path.read_text()) for path in mine.iterdir()] == [("case.toml", "mine")]
    with pytest.raises(ValueError, match='shard is "9/8"'):
        study.run(tmp_path / "study", shard="9/8")
    with pytest.raises(ValueError, match=r"design\.samples"):
        riffel.Study.from_toml(written(tmp_path, samples=10**12))
    other = riffel.Study.from_toml(written(tmp_path, samples=641))
    study.run(tmp_path / "study", shard="1/8")
    with pytest.raises(ValueError, match="another plan"):
        other.run(tmp_path / "study")
    with pytest.raises(ValueError, match="design: method"):
        study.sobol_indices(xr.DataArray(np.zeros(640), dims="sample"))
    with pytest.raises(ValueError, match="not among the 640"):
        study.design(0, 641)


def test_a_cluster_without_workers(plan: Path, tmp_path: Path) -> None:
    with workers(0) as client:
        with pytest.raises(RuntimeError, match="no workers"):
            riffel.Study.from_toml(plan).run(tmp_path / "study", client)
    assert not (tmp_path / "study").exists()


def test_a_line_tells_how_far_it_is(plan: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    riffel.Study.from_toml(plan).run(tmp_path / "study", progress=True)
    assert "640/640 samples" in capfd.readouterr().err

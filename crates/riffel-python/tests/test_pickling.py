"""Cases that go to another process."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import xarray as xr
from conftest import ROOT

import riffel

WINDOW = {"wavelength": {"min": 0.02, "max": 0.08, "points": 61}, "speed": [20.0, 30.0, 41.0]}


def winkler(frequency: npt.NDArray[np.float64]) -> npt.NDArray[np.complex128]:
    """A rail of 56 kg/m on an elastic foundation with loss."""
    bending, mass, foundation = 207e9 * 2.35e-5, 56.0, 50e6 * (1.0 + 0.2j)
    decay = ((foundation - mass * (2.0 * np.pi * frequency) ** 2) / (4.0 * bending)) ** 0.25
    return np.asarray(1.0 / (8.0 * bending * decay**3))


def rigid_mass(frequency: npt.NDArray[np.float64]) -> npt.NDArray[np.complex128]:
    return (-1.0 / (350.0 * (2.0 * np.pi * frequency) ** 2)).astype(np.complex128)


def growth(case: riffel.Case) -> bytes:
    return case.growth_map(**WINDOW)["normalized_dissipation"].values.tobytes()  # type: ignore[arg-type]


def again(case: riffel.Case) -> riffel.Case:
    found: riffel.Case = pickle.loads(pickle.dumps(case))
    return found


def same(one: riffel.Case, other: riffel.Case) -> None:
    assert growth(one) == growth(other)
    assert one.to_dict() == other.to_dict()
    assert (one.title, one.remarks) == (other.title, other.remarks)


@pytest.mark.parametrize("name", ["nominal", "bhaskar-track", "discrete-supports"])
def test_the_same_bits(name: str) -> None:
    case = riffel.Case.from_toml(f"cases/{name}.toml", {"contact.friction": 0.1 + 0.2})
    found = again(case)
    same(case, found)
    # It goes on as the other: overrides replace, and errors show the line of the file.
    same(case.with_({"contact.creepage": "0.05 %"}), found.with_({"contact.creepage": "0.05 %"}))
    for wrong in ({"contact.friction": -1.0}, {"wheel.weight": 3.0}, {"contact.tractive_ratio": 2.0}):
        with pytest.raises(ValueError) as expected:
            case.with_(wrong)
        with pytest.raises(ValueError) as caught:
            found.with_(wrong)
        assert str(caught.value) == str(expected.value)
    assert pickle.dumps(found) == pickle.dumps(case)


def test_cases_from_dicts_and_texts(nominal: riffel.Case) -> None:
    text = (ROOT / "cases/nominal.toml").read_text()
    for case in (riffel.Case.from_dict(nominal.to_dict()), riffel.Case.parse(text)):
        same(case, again(case))


# Long: starts a process that imports all anew.
def test_other_processes(nominal: riffel.Case) -> None:
    cases = [nominal, nominal.with_track(winkler).with_wheel(rigid_mass)]
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        assert list(pool.map(growth, cases)) == [growth(case) for case in cases]


def test_given_receptances(nominal: riffel.Case) -> None:
    frequency = np.geomspace(50.0, 4000.0, 500)
    table = xr.DataArray(winkler(frequency), {"frequency": frequency}, ("frequency",))
    dataset = {
        "type": 58, "func_type": 4, "id1": "rail head", "load_case_id": 0, "rsp_dir": 3, "ref_dir": 3,
        "abscissa_spec_data_type": 18, "ordinate_spec_data_type": 8, "orddenom_spec_data_type": 13,
        "x": frequency, "data": winkler(frequency),
    }  # fmt: skip
    for given in (winkler, (frequency, winkler(frequency)), table, dataset, riffel.receptance_from_uff(dataset)):
        case = nominal.with_track(given).with_({"contact.friction": 0.3})
        found = again(case)
        same(case, found)
        assert growth(found) != growth(nominal.with_({"contact.friction": 0.3}))
        same(case.with_wheel(rigid_mass), again(found.with_wheel(rigid_mass)))


def test_arrays_go_by_value(nominal: riffel.Case) -> None:
    frequency = np.geomspace(50.0, 4000.0, 500)
    values = winkler(frequency)
    case = nominal.with_track((frequency, values))
    expected = growth(case)
    values[:] = 1.0
    frequency[:] = 1.0
    assert growth(case) == growth(again(case)) == expected


def test_a_callable_that_python_does_not_pickle(nominal: riffel.Case) -> None:
    case = nominal.with_track(lambda frequency: winkler(frequency))
    with pytest.raises((pickle.PicklingError, AttributeError), match="<lambda>"):
        pickle.dumps(case)
    # Dask takes it along.
    cloudpickle: Any = pytest.importorskip("cloudpickle")
    same(case, pickle.loads(cloudpickle.dumps(case)))


def fails_elsewhere(frequency: npt.NDArray[np.float64]) -> npt.NDArray[np.complex128]:
    if LIMIT and frequency.max() > LIMIT[0]:
        raise KeyError("no such node")
    return winkler(frequency)


LIMIT: list[float] = []


def test_a_callable_that_fails_where_it_arrives(nominal: riffel.Case) -> None:
    pickled = pickle.dumps(nominal.with_track(fails_elsewhere))
    case: riffel.Case = pickle.loads(pickled)
    LIMIT.append(0.0)
    try:
        with pytest.raises(riffel.ReceptanceError, match="raised KeyError"):
            pickle.loads(pickled)
        with pytest.raises(riffel.ReceptanceError, match="raised KeyError"):
            case.growth_map()
    finally:
        LIMIT.clear()


# Long: starts a process that imports all anew.
def test_measured_files_are_found_from_any_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    frequency = np.geomspace(50.0, 4000.0, 500)
    values = winkler(frequency)
    rows = "\n".join(f"{f!r},{z.real!r},{z.imag!r}" for f, z in zip(frequency.tolist(), values.tolist(), strict=True))
    (tmp_path / "track.csv").write_text(f"f,re,im\n{rows}\n")
    (tmp_path / "case.toml").write_text((ROOT / "cases/nominal.toml").read_text())
    monkeypatch.chdir(tmp_path)
    measurement = {"file": "track.csv", "frequency": "f", "real": "re", "imaginary": "im"}
    case = riffel.Case.from_toml("case.toml", {"track.model": "measured", "track.measurement": measurement})
    pickled = pickle.dumps(case)
    (tmp_path / "case.pickle").write_bytes(pickled)
    program = (
        "import pickle, sys; case = pickle.load(open(sys.argv[1], 'rb'));"
        "map = case.growth_map(wavelength=[0.03, 0.05], speed=[30.0]);"
        "print(map['normalized_dissipation'].values.tobytes().hex())"
    )
    command = [sys.executable, "-c", program, str(tmp_path / "case.pickle")]
    found = subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT)
    expected = case.growth_map(wavelength=[0.03, 0.05], speed=[30.0])["normalized_dissipation"]
    assert found.stdout.strip() == expected.values.tobytes().hex()
    (tmp_path / "track.csv").unlink()
    with pytest.raises(ValueError, match="`track.measurement.file`: cannot read .*track.csv"):
        pickle.loads(pickled)


def test_copies_are_the_case_itself(nominal: riffel.Case) -> None:
    case = nominal.with_track(lambda frequency: winkler(frequency))
    assert copy.copy(case) is case
    assert copy.deepcopy({"case": case})["case"] is case

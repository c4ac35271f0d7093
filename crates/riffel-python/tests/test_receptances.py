"""Tracks and wheels that users give."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import xarray as xr

import riffel


def free_beam(frequency: npt.NDArray[np.float64]) -> Any:
    """Equation (23) of Afferrante & Ciavarella (2009) for the rail of the nominal case."""
    omega = 2.0 * np.pi * frequency
    root = (56.0**3 * 207e9 * 2.35e-5) ** 0.25
    return np.exp(-0.75j * np.pi) / (2.0 * np.sqrt(2.0) * root * omega**1.5)


def rigid_mass(frequency: npt.NDArray[np.float64]) -> npt.NDArray[np.complex128]:
    return (-1.0 / (350.0 * (2.0 * np.pi * frequency) ** 2)).astype(np.complex128)


# Long: asks Python for every receptance of a map and of a ridge.
def test_a_callable_is_the_track_that_it_computes(nominal: riffel.Case) -> None:
    """To rounding, and to the 1e-9 of the table where a map is large."""
    given = nominal.with_track(free_beam).with_wheel(rigid_mass)
    for window in (5, 241):
        axis = {"min": 0.02, "max": 0.08, "points": window}
        expected = nominal.growth_map(wavelength=axis)["normalized_dissipation"]
        found = given.growth_map(wavelength=axis)["normalized_dissipation"]
        assert abs(found / expected - 1.0).max() < (1e-12 if window == 5 else 5e-9)
    a, b = given.point(wavelength=0.055, speed=30.0), nominal.point(wavelength=0.055, speed=30.0)
    assert all(np.isclose(a[key], b[key], rtol=1e-12) for key in b)  # type: ignore[index]
    assert np.allclose(given.ridge()["wavelength"], nominal.ridge()["wavelength"], rtol=1e-6)
    assert np.allclose(given.receptance()["total_m_per_n"], nominal.receptance()["total_m_per_n"], rtol=1e-12)
    # It stays with the case, and takes part under traffic.
    again = given.with_({"contact.friction": 0.3})
    levels = riffel.roughness.levels([0.04, 0.05], [1.0, 1.0])
    later = nominal.with_({"contact.friction": 0.3}).forecast(levels, speed=30.0, passages=1e6)
    assert np.allclose(again.forecast(levels, speed=30.0, passages=1e6)["level"], later["level"], rtol=1e-9)


# Long: searches a ridge by a receptance that Python asks for.
def test_a_callable_may_ask_another_case(nominal: riffel.Case) -> None:
    """Its threads must not wait for each other, however few there are."""
    given = nominal.with_track(lambda frequency: nominal.receptance(frequency)["rail_m_per_n"].values)
    assert np.allclose(given.ridge()["wavelength"], nominal.ridge()["wavelength"], rtol=1e-6)
    found = given.growth_map(wavelength=[0.03, 0.05], speed=[20.0, 30.0])
    expected = nominal.growth_map(wavelength=[0.03, 0.05], speed=[20.0, 30.0])
    assert np.allclose(found["growth_rate"], expected["growth_rate"], rtol=1e-12)


def test_tables_are_interpolated_and_not_extrapolated(nominal: riffel.Case) -> None:
    frequency = np.geomspace(60.0, 3100.0, 20_000)
    table = nominal.with_track((frequency, free_beam(frequency)))
    array = xr.DataArray(free_beam(frequency), {"frequency": frequency}, ("frequency",))
    # Linear between points 0.02 % apart, of a power law: (Δ ln f)²/8 · (3/2)².
    assert abs(table.growth_map() / nominal.growth_map() - 1.0)["normalized_dissipation"].max() < 1e-6
    assert table.growth_map().identical(nominal.with_track(array).growth_map())
    with pytest.raises(ValueError, match="is known from 60.0000 to 3100.0000 Hz and is not extrapolated"):
        table.point(wavelength=0.01, speed=60.0)
    with pytest.raises(ValueError, match="receptance given for the track is vertical only"):
        table.receptance(direction="lateral")
    for change, says in (
        (np.conj, "it is conjugated"),
        (np.negative, "it is turned in sign"),
        (lambda h: -h.conj(), "conjugated, as with .*, and turned in sign"),
    ):
        with pytest.raises(ValueError, match=says):
            nominal.with_track((frequency, change(free_beam(frequency))))
        with pytest.raises(ValueError, match=says):
            nominal.with_wheel((frequency, change(free_beam(frequency))))
    late = free_beam(frequency) * np.exp(-2j * np.pi * frequency * 0.5e-3)
    assert any("0.50 ms between the channels" in remark for remark in nominal.with_track((frequency, late)).remarks)


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        (([100.0, 200.0], [1e-9]), r"receptance\[1\] has the shape \(1,\), but there are 2 frequencies"),
        (([200.0, 100.0], [1e-9, 1e-9]), "frequencies must rise"),
        (([100.0, 200.0], [1e-9, np.nan]), "a receptance must be finite"),
        (([100.0, 200.0], ["a", "b"]), "dtype <U1, but must be complex numbers"),
        (([], []), r"receptance\[0\] is empty"),
        ((1.0, 2.0, 3.0), "is a tuple of 3"),
        (xr.DataArray([1e-9], dims="f"), r"has the dimensions \('f',\)"),
        (xr.DataArray([1e-9], dims="frequency"), "has no coordinate frequency"),
        (
            xr.DataArray([1e-9], {"frequency": [1.0]}, ("frequency",), attrs={"units": "m/s/N"}),
            'has units "m/s/N", but must be in m/N',
        ),
    ],
)
def test_bad_tables(nominal: riffel.Case, given: Any, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        nominal.with_track(given)


def test_a_callable_that_fails(nominal: riffel.Case) -> None:
    def raises(frequency: npt.NDArray[np.float64]) -> npt.ArrayLike:
        raise KeyError("no such node")

    with pytest.raises(riffel.ReceptanceError, match="the receptance of the track raised KeyError") as caught:
        nominal.with_track(raises)
    assert isinstance(caught.value.__cause__, KeyError)
    wrong: list[tuple[Any, str]] = [
        (lambda f: f * np.nan, "is NaN"),
        (lambda f: 1e-9, r"returned an array of shape \[\]"),
        (lambda f: np.ones((f.size, 2)), r"returned an array of shape \[1, 2\]"),
        (lambda f: ["soft"] * f.size, "must return complex numbers"),
        (lambda f: {"H": f}, "must return complex numbers"),
    ]
    for returns, sentence in wrong:
        with pytest.raises(riffel.ReceptanceError, match=sentence):
            nominal.with_wheel(returns)
    with pytest.raises(TypeError, match="receptance is of type int"):
        nominal.with_track(3)  # type: ignore[arg-type]


def test_a_callable_that_fails_later_recovers(nominal: riffel.Case) -> None:
    limit = [1e9]

    def known(frequency: npt.NDArray[np.float64]) -> Any:
        if frequency.max() > limit[0]:
            raise ValueError("beyond the mesh")
        return free_beam(frequency)

    case = nominal.with_track(known)
    expected = case.growth_map()
    limit[0] = 1000.0
    for computation in (case.growth_map, case.ridge, case.receptance):
        with pytest.raises(riffel.ReceptanceError, match="beyond the mesh"):
            computation()
    limit[0] = 1e9
    assert case.growth_map().identical(expected)


def test_a_function_of_pyuff(nominal: riffel.Case, tmp_path: Path) -> None:
    import pyuff

    frequency = np.arange(0.0, 3201.0, 1.0)
    omega = 2.0 * np.pi * np.maximum(frequency, 1.0)
    accelerance = free_beam(np.maximum(frequency, 1.0)) * (1j * omega) ** 2
    written = {
        "type": 58, "binary": 0, "func_type": 4, "rsp_node": 1, "rsp_dir": 3, "ref_node": 1, "ref_dir": 3,
        "data": accelerance, "x": frequency, "id1": "rail head", "rsp_ent_name": "rail", "ref_ent_name": "rail",
        "abscissa_spacing": 1, "abscissa_spec_data_type": 18, "ordinate_spec_data_type": 12,
        "orddenom_spec_data_type": 13, "ordinate_axis_units_lab": "m/s2", "orddenom_axis_units_lab": "N",
    }  # fmt: skip
    path = str(tmp_path / "frf.uff")
    pyuff.UFF(path).write_sets(written, mode="add")
    dataset = pyuff.UFF(path).read_sets(0)
    by_dict = nominal.with_track(dataset)
    assert "the measured value at 0 Hz is left out" in by_dict.remarks
    # The file holds six digits and a line each hertz.
    asked = np.linspace(100.0, 3000.0, 30)
    found = by_dict.receptance(asked)["rail_m_per_n"].values
    assert np.abs(found / free_beam(asked) - 1.0).max() < 1e-4
    # The program reads the same file to the same receptance.
    by_file = nominal.with_(
        {"track.model": "measured", "track.measurement": {"file": path}}
    ).receptance(asked)["rail_m_per_n"].values
    assert np.abs(found / by_file - 1.0).max() < 1e-12
    for key, value, sentence in (
        ("type", 55, "of type 55, but must be 58"),
        ("func_type", 1, "is not a complex frequency response"),
        ("orddenom_axis_units_lab", "kg", "is labelled with a unit that does not fit"),
        ("data", accelerance.real, "the data of the dataset are real"),
    ):
        with pytest.raises(ValueError, match=sentence):
            nominal.with_track({**dataset, key: value})

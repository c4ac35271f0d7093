"""Arrays and quantities of every kind, good and bad."""

from __future__ import annotations

import threading
import time
from typing import Any

import numpy as np
import pytest
import xarray as xr

import riffel


@pytest.mark.parametrize(
    ("wavelength", "sentence"),
    [
        ([], "wavelength is empty"),
        (np.ones((2, 2)), "wavelength has 2 dimensions, but must have one dimension"),
        (np.array([0.03 + 0j]), "wavelength has the dtype complex128"),
        (np.array([True]), "wavelength has the dtype bool"),
        (np.array(["3 cm"], dtype=object), "wavelength has the dtype object"),
        (np.array([0.03, np.nan]), r"wavelength\[1\] is nan"),
        ([0.03, -0.03], r"wavelength\[1\] is -0.03, but must be finite and greater than zero"),
        (["30 mm", "30 kg"], r'wavelength\[1\]: "30 kg" is in kg, not a length in m'),
        ("30 furlongs", 'wavelength: unknown unit "furlongs"'),
        (xr.DataArray([30.0], dims="x", attrs={"units": "km/h"}), 'wavelength has units "km/h"'),
        ({"min": 0.02, "max": 0.08}, "must have min, max and points"),
        ({"min": 0.08, "max": 0.02, "points": 3}, "upper end of an axis is 0.02"),
        ({"min": 0.02, "max": 0.08, "points": 2.5}, "wavelength.points is 2.5"),
        (True, "wavelength is True"),
    ],
)
def test_bad_arrays(nominal: riffel.Case, wavelength: Any, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        nominal.growth_map(wavelength=wavelength, speed=30.0)


def test_arrays_of_every_good_kind(nominal: riffel.Case) -> None:
    metres = np.linspace(0.02, 0.08, 13)
    expected = nominal.growth_map(wavelength=metres, speed=[30.0])
    strided = np.repeat(metres, 2)[::2]
    assert not strided.flags.c_contiguous
    millimetres = xr.DataArray(1e3 * metres, dims="wavelength", attrs={"units": "mm"})
    for kind in (strided, list(metres), metres[::-1][::-1], xr.DataArray(metres, dims="x", attrs={"units": "m"})):
        assert nominal.growth_map(wavelength=kind, speed="108 km/h").equals(expected)
    # A millimetre is not a power of two of a metre.
    xr.testing.assert_allclose(nominal.growth_map(wavelength=millimetres, speed=30.0), expected, rtol=1e-12)
    single = nominal.growth_map(wavelength=metres.astype(np.float32), speed=np.array([30], dtype=np.int32))
    assert single["normalized_dissipation"].dtype == np.complex128


def test_a_map_takes_any_values_in_any_order(nominal: riffel.Case) -> None:
    wavelengths, speeds = np.array([0.07, 0.021, 0.04]), np.array([50.0, 6.0])
    growth = nominal.growth_map(wavelength=wavelengths, speed=speeds)
    for speed in speeds:
        for wavelength in wavelengths:
            one = nominal.point(wavelength=float(wavelength), speed=float(speed))
            found = growth["normalized_dissipation"].sel(speed=speed, wavelength=wavelength).item()
            # A row is evaluated in another order of operations than a point.
            assert abs(found - one["normalized_dissipation"]) < 1e-12


def test_growth_rates_are_read_lazily_and_right(nominal: riffel.Case) -> None:
    growth = nominal.growth_map()
    rate = growth["growth_rate"]
    assert np.array_equal(rate.isel(speed=3).values, rate.values[3])
    assert np.array_equal(rate[5:9, ::7].values, rate.values[5:9, ::7])
    assert np.array_equal(rate.isel(speed=[4, 2], wavelength=xr.DataArray([1, 3])).values, rate.values[[4, 2]][:, [1, 3]])
    assert rate[7, 11].item() == rate.values[7, 11]
    assert rate.load().identical(nominal.growth_map()["growth_rate"].load())
    assert growth.attrs["title"] == nominal.title
    assert rate.attrs == {"units": "1", "long_name": "growth rate of the amplitude per passage of a wheel"}


def test_maps_of_one_case_are_apart(nominal: riffel.Case) -> None:
    first, second = nominal.growth_map(), nominal.growth_map()
    first["growth_rate"].attrs["note"] = first.attrs["note"] = first["speed"].attrs["note"] = "mine"
    first["normalized_dissipation"][0, 0] = 0.0
    assert second.identical(nominal.growth_map())
    assert second.identical(riffel.Case.from_toml("cases/nominal.toml").growth_map())


def test_a_ridge_needs_equal_steps(nominal: riffel.Case) -> None:
    with pytest.raises(ValueError, match="wavelength must rise in equal steps"):
        nominal.ridge(wavelength=[0.02, 0.03, 0.05])
    with pytest.raises(ValueError, match="wavelength has one value"):
        nominal.ridge(wavelength="30 mm")
    every = nominal.ridge(wavelength=np.linspace(0.02, 0.08, 241))
    some = nominal.ridge(speed=every["speed"][10:13])
    assert np.allclose(some["frequency"], every["frequency"][10:13], rtol=1e-6)


def test_other_threads_run_while_a_map_is_computed(nominal: riffel.Case) -> None:
    """With the lock held, the counter would stand still for all of a map."""
    case = nominal.with_({"track.model": "two-layer", "track.preset": "br-stiff", "rail.beam": "timoshenko"})
    wavelength, speed = np.linspace(0.02, 0.08, 1500), np.linspace(5.0, 60.0, 1500)
    counted, begun, ended = [0], threading.Event(), threading.Event()

    def count() -> None:
        begun.set()
        while not ended.is_set():
            counted[0] += 1
            time.sleep(1e-4)

    thread = threading.Thread(target=count)
    thread.start()
    begun.wait()
    before = counted[0]
    case.growth_map(wavelength=wavelength, speed=speed)
    during = counted[0] - before
    ended.set()
    thread.join()
    assert during > 10


def test_two_threads_at_once_agree(nominal: riffel.Case) -> None:
    expected = nominal.growth_map()
    results: list[xr.Dataset] = []
    threads = [threading.Thread(target=lambda: results.append(nominal.growth_map())) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 4
    assert all(result.identical(expected) for result in results)

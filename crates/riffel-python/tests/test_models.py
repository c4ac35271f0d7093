"""A case by the models of the field."""

from __future__ import annotations

import numpy as np
import pytest

import riffel


def test_seed_is_the_case(nominal: riffel.Case) -> None:
    growth = riffel.compare_models(nominal, ["afferrante-ciavarella-2009"], speed="108 km/h")
    own = nominal.growth_map(wavelength=growth["wavelength"].values, speed=30.0)["growth_rate"]
    np.testing.assert_allclose(growth["growth_rate"].values[0], own.values.ravel(), rtol=1e-12)
    assert growth["fastest_frequency"].values[0] == pytest.approx(538, abs=3)
    (described,) = growth.attrs["models"]
    assert described["joints"]["track"] == "free Euler–Bernoulli beam"


def test_what_is_not_on_the_case_has_no_growth(nominal: riffel.Case) -> None:
    short = nominal.with_({"map.wavelength": {"min": "40 mm", "max": "60 mm", "points": 5}})
    growth = riffel.compare_models(short, speed="108 km/h")
    # As many as its lines of growth need, over the window of the case.
    assert growth.sizes["model"] == 13
    assert growth["wavelength"].values[[0, -1]] == pytest.approx([0.04, 0.06], rel=1e-12)
    applies = growth["applies"].values
    assert np.isnan(growth["growth_rate"].values[~applies]).all()
    assert np.isfinite(growth["growth_rate"].values[applies]).all()
    assert all(bool(text) != known for text, known in zip(growth["not_on_this_case"].values, applies))


def test_wrong_names_are_told(nominal: riffel.Case) -> None:
    with pytest.raises(ValueError, match='no model has the name "nobody"; models: carson-johnson-1971'):
        riffel.compare_models(nominal, ["nobody"])
    with pytest.raises(ValueError, match="frederick-1987 is not on this case: needs supports"):
        riffel.compare_models(nominal, ["frederick-1987"])
    with pytest.raises(ValueError, match="must be a sequence of names"):
        riffel.compare_models(nominal, "riffel")

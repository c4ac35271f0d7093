"""Figures and the gallery."""

from __future__ import annotations

import runpy
from pathlib import Path

import matplotlib.pyplot as plt
import pytest
import scipy.io
from conftest import ROOT

import riffel
import riffel.plot

GALLERY = sorted((ROOT / "docs" / "gallery").glob("*.py"))


def test_there_is_a_gallery() -> None:
    assert len(GALLERY) >= 4


# Long: draws every figure.
@pytest.mark.parametrize("script", GALLERY, ids=lambda script: script.stem)
def test_gallery(script: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RIFFEL_GALLERY", str(tmp_path))
    runpy.run_path(str(script), run_name="__main__")
    picture = tmp_path / f"{script.stem}.png"
    assert picture.stat().st_size > 10_000


def test_axes_are_those_given(nominal: riffel.Case) -> None:
    figure, axes = plt.subplots(1, 2)
    assert riffel.plot.growth_map(nominal.growth_map(), axes[0]) is axes[0]
    assert riffel.plot.ridge(nominal.ridge(), axes[0]) is axes[0]
    assert riffel.plot.ridge_branches(nominal.ridge_branches(), axes[0]) is axes[0]
    legend = axes[0].get_legend()
    assert legend is not None
    assert "537 Hz" in [text.get_text() for text in legend.get_texts()]
    assert riffel.plot.receptance(nominal.receptance(), axes[1], phase=True) is axes[1]
    assert len(figure.axes) == 3  # with the scale of colours
    made = riffel.plot.growth_map(nominal.growth_map(), colorbar=False)
    assert made.get_title(loc="left") == nominal.title


def test_a_map_without_growth_is_drawn(nominal: riffel.Case) -> None:
    fast = nominal.growth_map(wavelength=[0.02, 0.021], speed=[59.0, 60.0])
    assert float(fast["growth_rate"].max()) < 0.0
    low, high = riffel.plot.growth_map(fast).collections[0].get_clim()
    assert low == -high == float(fast["growth_rate"].min())


def test_matlab(nominal: riffel.Case, tmp_path: Path) -> None:
    growth = nominal.growth_map(wavelength=[0.02, 0.03, 0.05], speed=[20.0, 30.0])
    path = tmp_path / "map.mat"
    riffel.to_matlab(growth, path)
    found = scipy.io.loadmat(path)
    assert (found["normalized_dissipation"] == growth["normalized_dissipation"].values).all()
    assert (found["growth_rate"] == growth["growth_rate"].values).all()
    assert found["wavelength"].ravel().tolist() == growth["wavelength"].values.tolist()
    assert found["units"]["speed"].item().item() == "m/s"
    with pytest.raises(FileNotFoundError):
        riffel.to_matlab(growth, tmp_path / "none" / "map.mat")
    assert sorted(file.name for file in tmp_path.iterdir()) == ["map.mat"]

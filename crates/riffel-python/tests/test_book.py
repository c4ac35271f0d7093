"""The listings of the book run, one after the other."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import pytest
from conftest import ROOT


# Long: runs every listing of the page of the book.
def test_listings_of_the_page_on_python(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # What a listing writes does not stay in the repository.
    for folder in ("cases", "validation"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    monkeypatch.chdir(tmp_path)
    page = (ROOT / "docs" / "src" / "python.md").read_text(encoding="utf-8")
    listings = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    assert len(listings) >= 6
    names: dict[str, object] = {}
    for listing in listings:
        exec(compile(listing, "docs/src/python.md", "exec"), names)
    growth = names["growth"]
    assert growth.sizes == {"speed": 221, "wavelength": 241}  # type: ignore[attr-defined]


def test_waves_on_a_half_plane_need_nothing_of_the_package() -> None:
    script = runpy.run_path(str(ROOT / "docs" / "src" / "wave_on_half_plane.py"))
    for wavelength, theory in [(0.0557, 0.9449), (0.02, 0.6658)]:
        # The grid leaves 2e-4, the amplitude 3e-4.
        assert abs(script["weight"](wavelength, places=32) - theory) < 1e-3


def test_rolling_circles_need_nothing_of_the_package() -> None:
    script = runpy.run_path(str(ROOT / "docs" / "src" / "wave_geometry.py"))
    curvature = script["KAPPA"]
    assert abs(script["sliding_point"]()[0] / curvature - 1) < 5e-3
    force, _ = script["carter"](constant_force=True)
    speed, slope = script["carter"](constant_force=False)
    assert abs(force / curvature - 0.5) < 5e-3
    assert abs(speed / curvature - 1 - slope / 2) < 5e-3

"""The listings of the book run, one after the other."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import ROOT


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

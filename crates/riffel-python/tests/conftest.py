"""What every test and doctest may use."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import pytest

import riffel

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("RIFFEL_PROGRAM", str(ROOT / "target" / "debug" / "riffel"))
"""The program that Python is held against, built from the same sources."""


@pytest.fixture(autouse=True)
def _in_the_repository(monkeypatch: pytest.MonkeyPatch) -> None:
    """Examples name files of the repository."""
    monkeypatch.chdir(ROOT)


@pytest.fixture(autouse=True)
def _no_figures_left() -> Iterator[None]:
    yield
    plt.close("all")


@pytest.fixture
def nominal() -> riffel.Case:
    return riffel.Case.from_toml("cases/nominal.toml")


@pytest.fixture
def program() -> Callable[..., Any]:
    """The program, with its JSON document as the result."""
    def run(*arguments: str) -> Any:
        found = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True, cwd=ROOT)
        return json.loads(found.stdout)

    return run

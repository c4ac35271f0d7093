"""What every test and doctest may use."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")

import json

import numpy as np
import pytest

import riffel
import riffel.plot

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(autouse=True)
def _in_the_repository(monkeypatch: pytest.MonkeyPatch) -> None:
    """Examples name files of the repository."""
    monkeypatch.chdir(ROOT)


@pytest.fixture(autouse=True)
def _doctest_names(
    doctest_namespace: dict[str, Any], tmp_path: Path, _in_the_repository: None
) -> Iterator[None]:
    import matplotlib.pyplot as plt

    doctest_namespace.update(riffel=riffel, np=np, folder=tmp_path, case=riffel.Case.from_toml("cases/nominal.toml"))
    yield
    plt.close("all")


@pytest.fixture
def nominal() -> riffel.Case:
    return riffel.Case.from_toml("cases/nominal.toml")


@pytest.fixture
def program() -> Callable[..., Any]:
    """The program, with its JSON document as the result."""
    binary = os.environ.get("RIFFEL_PROGRAM", str(ROOT / "target" / "debug" / "riffel"))

    def run(*arguments: str) -> Any:
        found = subprocess.run([binary, *arguments], capture_output=True, text=True, check=True, cwd=ROOT)
        return json.loads(found.stdout)

    return run

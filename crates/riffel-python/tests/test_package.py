"""The names of the package, which load their modules when they are first asked for."""

from __future__ import annotations

import subprocess
import sys

import pytest

import riffel


@pytest.mark.parametrize("name", riffel.__all__)
def test_a_name_is_there_in_a_fresh_interpreter(name: str) -> None:
    """Each alone, so that none is there because of another."""
    program = f"import riffel; assert {name!r} in dir(riffel); riffel.{name}; from riffel import {name}"
    found = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert found.returncode == 0, found.stderr


def test_a_wrong_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="module 'riffel' has no attribute 'Cases'"):
        riffel.Cases  # type: ignore[attr-defined]
    with pytest.raises(ImportError, match="cannot import name 'Cases'"):
        from riffel import Cases  # type: ignore[attr-defined]  # noqa: F401

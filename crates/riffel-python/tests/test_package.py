"""The names of the package, which load their modules when they are first asked for."""

from __future__ import annotations

import ast
import subprocess
import sys

import pytest
from conftest import ROOT

import riffel
from riffel import _riffel


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


def test_the_stub_has_the_names_of_the_extension() -> None:
    stub = ast.parse((ROOT / "crates/riffel-python/python/riffel/_riffel.pyi").read_text())
    defined = {one.name for one in stub.body if isinstance(one, (ast.ClassDef, ast.FunctionDef))}
    values = {one.target.id for one in stub.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name)}
    names = {name for name in vars(_riffel) if not name.startswith("_")}
    assert defined | {name for name in values if not name.startswith("_")} == names

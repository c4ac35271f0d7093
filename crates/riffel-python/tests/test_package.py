"""The names of the package, which load their modules when they are first asked for."""

from __future__ import annotations

import ast
import subprocess
import sys

import pytest
from conftest import ROOT

import riffel
from riffel import _riffel


# Every name from a package that has loaded none of its modules yet, but for the extension, which is loaded once in a process.
EACH_ALONE = """
import importlib, sys
names = importlib.import_module("riffel").__all__
for name in names:
    for module in [module for module in sys.modules if module.split(".")[0] == "riffel"]:
        if module != "riffel._riffel":
            del sys.modules[module]
    riffel = importlib.import_module("riffel")
    assert name in dir(riffel), name
    getattr(riffel, name)
    exec(f"from riffel import {name}")
print(len(names))
"""


# Long: imports every name in a process of its own.
def test_every_name_is_there_in_a_fresh_interpreter() -> None:
    """Each alone, so that none is there because of another."""
    found = subprocess.run([sys.executable, "-c", EACH_ALONE], capture_output=True, text=True, check=False)
    assert (found.returncode, found.stdout.strip()) == (0, str(len(riffel.__all__))), found.stderr


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

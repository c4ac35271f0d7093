"""Examples of docstrings print what they say."""

from __future__ import annotations

import doctest
import importlib
import pkgutil
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import riffel
import riffel.plot

MODULES = [
    riffel,
    *(
        importlib.import_module(module.name)
        for module in pkgutil.walk_packages(riffel.__path__, "riffel.")
        if module.name != "riffel._riffel"
    ),
]


# Long: runs every example of the package.
@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_examples(module: ModuleType, nominal: riffel.Case, tmp_path: Path) -> None:
    names = {"riffel": riffel, "np": np, "case": nominal, "folder": tmp_path}
    found = doctest.testmod(
        module, extraglobs=names, optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS, report=True
    )
    assert found.failed == 0


def test_public_names_have_docstrings() -> None:
    for module in MODULES:
        assert module.__doc__, module
        for name in getattr(module, "__all__", []):
            assert getattr(module, name).__doc__, f"{module.__name__}.{name}"
    for name in dir(riffel.Case):
        if not name.startswith("_") or name == "with_":
            assert getattr(riffel.Case, name).__doc__, name

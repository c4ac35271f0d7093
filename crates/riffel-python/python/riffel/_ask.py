"""Questions by their names, as the program answers them."""

from __future__ import annotations

import datetime
import math
import os
import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from riffel import _riffel
from riffel._spectra import levels_of


IN_MEMORY = (_riffel.AxleBoxRun, _riffel.Case, _riffel.CurvingCase, _riffel.Record, _riffel.Traffic)
"""What stands in a question in place of a file."""


def ask(name: str, question: Mapping[str, Any]) -> Any:
    """The answer to a question of the program, by its keys.

    Parameters
    ----------
    name : str
        Name of the question, as of the command of the program: ``"point"``, ``"network worst"``.
    question : mapping
        Its keys, which ``riffel schema --question NAME`` tells: quantities as numbers in SI or strings with their unit. A
        `Case` may stand for a case file, a `DataArray` for a table of levels, and a dict of its keys or its columns for any
        file. What is None is left out.

    Returns
    -------
    dict or list
        What ``riffel NAME --json`` prints. No files are written.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        For a key or a value that is not allowed.
    ConvergenceError
        If an iteration does not reach its tolerance.

    Warns
    -----
    UserWarning
        Of a value or a file that is unusual.

    Examples
    --------
    >>> state = riffel.ask("point", {"case": "cases/nominal.toml", "wavelength": "55 mm", "speed": 30.0})
    >>> state["growth_rate_per_passage"] > 0.0
    True
    """
    found, remarks, _ = answer(name, question)
    for _, remark in remarks:
        warnings.warn(remark, stacklevel=2)
    return found


def answer(name: str, question: Mapping[str, Any]) -> tuple[Any, list[tuple[str, str]], list[str]]:
    """The answer to a question, ids and sentences of what is unusual about the question, and remarks of the answer."""
    return _riffel.ask(name, keys_of(question))


def keys_of(question: Mapping[str, Any]) -> dict[str, Any]:
    """The keys of a question that are given, in the types of JSON or as what stands in memory."""
    return {key: plain(value, key) for key, value in question.items() if value is not None}


def plain(value: Any, name: str) -> Any:
    """What a user gave under a key, in the types of JSON, or a case."""
    value = getattr(value, "_case", value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return {key: plain(one, f"{name}.{key}") for key, one in value.items()}
    if isinstance(value, xr.DataArray):
        return _riffel.Record(name, [([], levels_of(value, name))])
    if isinstance(value, (list, tuple)):
        return [plain(one, f"{name}[{index}]") for index, one in enumerate(value)]
    if isinstance(value, np.datetime64):
        return str(value.astype("datetime64[D]"))
    if isinstance(value, (np.generic, np.ndarray)):
        return plain(value.tolist(), name)
    if isinstance(value, datetime.date):
        return value.strftime("%Y-%m-%d")
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{name} is {value}, but must be finite")
    if value is None or isinstance(value, (str, int, float, *IN_MEMORY)):
        return value
    kind = type(value).__name__
    raise TypeError(f"`{name}` is of type {kind}, but must be a number, a string, a bool, a list or a dict")

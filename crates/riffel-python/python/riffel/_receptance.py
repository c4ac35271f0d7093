"""Receptances that users give in the place of the models of a case."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel import _riffel
from riffel._quantities import OR_ZERO, Complexes, Floats, array, checked, real

GivenReceptance: TypeAlias = (
    "Callable[[npt.NDArray[np.float64]], npt.ArrayLike] | tuple[npt.ArrayLike, npt.ArrayLike] | xr.DataArray"
    " | Mapping[str, Any] | _riffel.Universal"
)
"""A callable of frequencies, a pair of arrays, an array over ``frequency``, or a function of a universal file."""


def checked_receptance(given: Any, name: str) -> Any:
    """What the extension takes: a callable, a pair of arrays or a function of a universal file."""
    if isinstance(given, xr.DataArray):
        return _of_data_array(given, name)
    if isinstance(given, Mapping):
        return receptance_from_uff(given)
    if isinstance(given, tuple):
        if len(given) != 2:
            raise ValueError(f"{name} is a tuple of {len(given)}, but must be (frequency, receptance)")
        frequency = array(given[0], f"{name}[0]", "frequency")
        return _table(frequency, given[1], f"{name}[1]")
    if callable(given) or isinstance(given, _riffel.Universal):
        return given
    raise TypeError(
        f"{name} is of type {type(given).__name__}, but must be a callable, a pair (frequency, receptance), a"
        " DataArray or a dataset 58 of pyuff"
    )


def _of_data_array(given: xr.DataArray, name: str) -> tuple[Floats, Complexes]:
    if given.dims != ("frequency",):
        raise ValueError(f"{name} has the dimensions {given.dims}, but must have the one dimension frequency")
    if "frequency" not in given.coords:
        raise ValueError(f"{name} has no coordinate frequency")
    units = given.attrs.get("units", "m/N")
    if units != "m/N":
        raise ValueError(f"{name} has units \"{units}\", but must be in m/N")
    frequency = array(given.coords["frequency"], f"{name}.frequency", "frequency")
    return _table(frequency, given.values, name)


def _table(frequency: Floats, receptance: Any, name: str) -> tuple[Floats, Complexes]:
    values = np.asarray(receptance)
    if values.dtype == bool or not np.issubdtype(values.dtype, np.number):
        raise ValueError(f"{name} has the dtype {values.dtype}, but must be complex numbers")
    if values.shape != frequency.shape:
        raise ValueError(f"{name} has the shape {values.shape}, but there are {frequency.size} frequencies")
    # Copies: a case is pickled with them, and does not change when the user's arrays do.
    return np.array(frequency), np.array(values, dtype=np.complex128, order="C")


def receptance_from_uff(dataset: Mapping[str, Any], vertical_axis: str = "z") -> _riffel.Universal:
    """The receptance in a function of a universal file that `pyuff` has read.

    Parameters
    ----------
    dataset : mapping
        A dataset 58 as ``pyuff.UFF(path).read_sets(n)`` returns it: a complex frequency response of displacement,
        velocity or acceleration per force, with time factor exp(+i omega t). Units are those of its labels, SI where
        it has none. A value at 0 Hz is left out.
    vertical_axis : {"z", "x", "y"}
        The axis that is vertical in the test: response and force must lie along it.

    Returns
    -------
    Universal
        For `Case.with_track` and `Case.with_wheel`.

    Raises
    ------
    ValueError
        If it is another dataset or function, is not vertical, has a unit that does not fit, or leaves out an octave or more.

    Examples
    --------
    >>> import numpy as np
    >>> frequency = np.linspace(0.0, 4000.0, 401)
    >>> dataset = {
    ...     "type": 58, "func_type": 4, "id1": "rail head", "load_case_id": 0, "rsp_dir": 3, "ref_dir": 3,
    ...     "abscissa_spec_data_type": 18, "ordinate_spec_data_type": 8, "orddenom_spec_data_type": 13,
    ...     "x": frequency, "data": 1e-9 / (1.0 + 1e-3j * frequency),
    ... }
    >>> case = riffel.Case.from_toml("cases/nominal.toml").with_track(riffel.receptance_from_uff(dataset))
    >>> case.remarks[-2]
    'the measured value at 0 Hz is left out'
    """
    kind = dataset.get("type")
    if kind != 58:
        raise ValueError(f"the dataset is of type {kind}, but must be 58, a function at nodal degrees of freedom")
    missing = [key for key in ("func_type", "x", "data") if key not in dataset]
    if missing:
        raise ValueError(f"the dataset has no \"{missing[0]}\"")
    values = np.asarray(dataset["data"])
    if not np.iscomplexobj(values):
        raise ValueError("the data of the dataset are real, but a frequency response is complex")
    frequency = real(dataset["x"], "x of the dataset")
    checked(frequency, "x of the dataset", OR_ZERO)
    frequency, values = _table(frequency, values, "data of the dataset")

    def axis(name: str) -> tuple[int, str]:
        return int(dataset.get(f"{name}_spec_data_type", 0)), str(dataset.get(f"{name}_axis_units_lab", ""))

    return _riffel.Universal(
        str(dataset.get("id1", "")).strip(),
        int(dataset["func_type"]),
        int(dataset.get("load_case_id", 0)),
        (int(dataset.get("rsp_dir", 0)), int(dataset.get("ref_dir", 0))),
        vertical_axis,
        int(dataset.get("abscissa_spec_data_type", 0)),
        axis("ordinate"),
        axis("orddenom"),
        frequency,
        values,
    )

"""Results as files of MATLAB."""

from __future__ import annotations

import os

import numpy as np
import xarray as xr


def to_matlab(dataset: xr.Dataset, path: str | os.PathLike[str]) -> None:
    """Write a result as a MATLAB file of version 5, which ``load`` of MATLAB and Octave reads.

    Every variable and coordinate becomes an array of its name, those of two dimensions with a row for each value of the
    first. Units and long names are in the struct ``units`` and ``long_name``.

    Parameters
    ----------
    dataset : xarray.Dataset
        A map, a ridge or any other result.
    path : path-like
        File to write; an old one is replaced once the new one is complete.

    Examples
    --------
    >>> import scipy.io
    >>> riffel.to_matlab(case.growth_map(), folder / "map.mat")
    >>> scipy.io.loadmat(folder / "map.mat")["growth_rate"].shape
    (221, 241)
    """
    import scipy.io

    names = {str(name): values for name, values in dataset.variables.items()}
    content: dict[str, object] = {
        name: np.asarray([str(text) for text in values.values], dtype=object)
        if values.dtype.kind in "OUT"
        else np.asarray(values.values)
        for name, values in names.items()
    }
    for attribute in ("units", "long_name"):
        content[attribute] = {name: str(values.attrs.get(attribute, "")) for name, values in names.items()}
    path = os.fspath(path)
    partial = f"{path}.part"
    try:
        scipy.io.savemat(partial, content, appendmat=False, oned_as="row")
        os.replace(partial, path)
    finally:
        if os.path.exists(partial):
            os.remove(partial)

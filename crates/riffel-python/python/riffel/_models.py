"""A case by the models of the field."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import xarray as xr

from riffel import _datasets
from riffel._ask import ask
from riffel._case import Case
from riffel._quantities import Quantity


def compare_models(case: Case, models: Sequence[str] | None = None, *, speed: Quantity | None = None) -> xr.Dataset:
    """The same case by the models of the field, side by side.

    Parameters
    ----------
    case : Case
        The case. What a model fixes takes the place of its keys.
    models : sequence of str, optional
        Names of models; by default all, those that cannot be read from the case without growth.
    speed : quantity, optional
        Speed of the vehicle; by default growth is the mean over the speeds of the usual traffic of the line.

    Returns
    -------
    xarray.Dataset
        Over ``model``: ``growth_rate`` by ``wavelength``, NaN where the model is not on the case; ``fastest_wavelength``,
        ``fastest_growth_rate`` and ``fastest_frequency``, NaN where nothing grows; ``title``, ``source``, ``applies``,
        ``not_on_this_case`` (what the case lacks) and ``differs_by`` (the joint that moves growth most towards the exact
        contact). Attribute ``models``: all that ``riffel compare --models --json`` says of each.

    Raises
    ------
    ValueError
        For a name that no model has, or a model named that cannot be read from the case.

    Examples
    --------
    >>> named = ["grassie-johnson-1985", "afferrante-ciavarella-2009"]
    >>> growth = riffel.compare_models(case, named, speed="30 m/s")
    >>> growth["fastest_frequency"].round(-1).values.tolist()
    [380.0, 540.0]
    """
    if isinstance(models, str):
        raise ValueError(f"models is {models!r}, but must be a sequence of names")
    found = ask("compare", {"case": case, "models": ",".join(models or ["all"]), "speed": speed})
    described = found["models"]
    wavelengths = found["wavelength_m"]

    fastest = partial(_datasets.column, "model", [model["highest"] or {} for model in described])
    texts = partial(_datasets.texts, "model", described)
    differs = [model["differs_by"][0]["joint"] if model["differs_by"] else "" for model in described]
    return xr.Dataset(
        {
            "growth_rate": (("model", "wavelength"), _datasets.rates(described, wavelengths), _datasets.GROWTH_RATE),
            "fastest_wavelength": fastest("wavelength_m", "m", "wavelength that grows fastest"),
            "fastest_growth_rate": fastest("growth_rate_per_passage", "1", "its growth rate per passage"),
            "fastest_frequency": fastest("frequency_hz", "Hz", "its frequency"),
            "title": texts("title", "authors and year"),
            "source": texts("source", "where it was published"),
            "applies": ("model", [model["applies"] for model in described], {"long_name": "whether it is on the case"}),
            "not_on_this_case": texts("not_on_this_case", "what the case lacks"),
            "differs_by": ("model", differs, {"long_name": "joint that moves growth most towards the exact contact"}),
        },
        {
            "model": ("model", [model["name"] for model in described], {"long_name": "model of the field"}),
            "wavelength": ("wavelength", wavelengths, _datasets.WAVELENGTH),
            "speed": ((), found["speed_m_per_s"], _datasets.SPEED),
        },
        {**_datasets.attributes(case.title), "models": described},
    )

"""What measurements say of a case, and what to do."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from riffel import _riffel
from riffel._ask import ask
from riffel._case import Case

Folder = str | os.PathLike[str]

# Numbers of an action in the document, with their long names.
OF_ACTIONS = {
    "fixed_cost_per_year": "investment and upkeep of a year",
    "mean_cost_per_year": "cost of a year in the mean",
    "probability_longer": "probability that the interval is longer than as it is",
    "probability_cheapest": "probability that it is the cheapest",
    "expected_regret_per_year": "cost of a year beyond the cheapest in the mean",
    "rank": "place by mean cost, behind all that hold to what is asked",
}
# What an action may have to hold to, with long names.
ASKED = {
    "budget": "probability that it costs more than the budget",
    "noise_limit": "probability that a band is louder than the limit of noise when grinding comes",
    "possession_hours": "probability that it closes the line for more hours than there are",
}
SHARES = [0.05, 0.25, 0.5, 0.75, 0.95]


def calibrate(
    plan: Folder,
    folder: Folder,
    *,
    with_: Folder | Sequence[Folder] = (),
    traffic: Folder | None = None,
    restart: bool = False,
) -> xr.DataTree:
    """Draw from the posterior of the uncertain values of a case, as ``riffel calibrate`` does.

    Parameters
    ----------
    plan : path
        The plan: priors, data, sampler; beside ``with_`` the case file.
    folder : path
        Where the chains and ``posterior.zarr`` go; made if need be.
    with_ : path or sequence of path
        Tables of measurements, whose columns say of what kind they are: all that they tell of the case is uncertain, with the
        usual priors, and ``plan.toml`` in the folder is the plan.
    traffic : path, optional
        Traffic file that made dated levels grow, beside ``with_``; a plan names its own.
    restart : bool
        Keep finished parts of chains that were stopped, and go on from there; put chains of this plan in the place of those of
        another, which are refused otherwise.

    Returns
    -------
    xarray.DataTree
        ``posterior.zarr``, with the groups of ArviZ: ``posterior``, ``sample_stats``, ``prior``, ``observed_data``,
        ``log_likelihood`` and ``posterior_predictive``, over ``chain`` and ``draw``, and ``constant_data``, the columns of the tables
        that the model was given. The sampler ``smc`` tells the attribute ``log_evidence``, one for each chain. The attribute
        ``doubts`` lists why the chains allow no conclusion, and is empty where they do. Where the plan compares models, the attribute
        ``models`` says how well each predicts what was left out: the list of ``models.json``.

    Warns
    -----
    UserWarning
        Where the chains allow no conclusion, with the reason.

    Raises
    ------
    ValueError
        For a key, a value or data that cannot be used; for a folder with chains of another plan, or where another run draws.
    """
    tables = [with_] if isinstance(with_, str | os.PathLike) else with_
    if traffic is not None and not tables:
        raise ValueError("traffic is given without with_: a plan names its own traffic")
    remarks, doubts, models = _riffel.calibrate(
        os.fspath(plan),
        os.fspath(folder),
        [os.fspath(table) for table in tables],
        None if traffic is None else os.fspath(traffic),
        restart,
    )
    for sentence in [*remarks, *doubts]:
        warnings.warn(sentence, stacklevel=2)
    tree = xr.open_datatree(Path(folder) / "posterior.zarr", engine="zarr")
    tree.attrs["doubts"] = doubts
    if models is not None:
        tree.attrs["models"] = models["models"]
    return tree


def decide(folder: Folder, *, plan: Folder | None = None) -> xr.Dataset:
    """Rank the actions of a plan over its finished calibration, as ``riffel decide`` does.

    Parameters
    ----------
    folder : path
        Folder of the calibration.
    plan : path, optional
        The plan; left out, the one that the chains were drawn for.

    Returns
    -------
    xarray.Dataset
        Over ``action``, to leave all as it is first, and ``quantile``: ``months_to_limit``, NaN beyond the horizon, with
        ``probability_never``; ``cost_per_year`` and ``saving_per_year``; ``mean_cost_per_year``, ``expected_regret_per_year``,
        ``probability_cheapest``, ``probability_longer`` and ``rank``; where the plan asks for them ``breaks_budget``,
        ``breaks_noise_limit`` and ``breaks_possession_hours``, probabilities. Attributes: ``currency``, ``evpi_per_year``, ``evppi_per_year``,
        ``measurements``.

    Raises
    ------
    FileNotFoundError
        If the folder holds no calibration.
    ValueError
        For a key of the plan that cannot be used, or chains of another plan.
    """
    found = ask("decide", {"dir": folder, "plan": plan})
    actions = found["actions"]
    numbers = {
        name: ("action", [action[name] for action in actions], {"long_name": words})
        for name, words in OF_ACTIONS.items()
    }
    for name, words in ASKED.items():
        breaks = [action["breaks"][name] for action in actions]
        if None not in breaks:
            numbers[f"breaks_{name}"] = ("action", breaks, {"long_name": words})
    over = ("action", "quantile")
    months = [action["months_to_limit"] for action in actions]
    nothing = float("nan")
    quantiles = [[nothing if it is None else it for it in of["quantiles"]] for of in months]
    return xr.Dataset(
        {
            "months_to_limit": (over, quantiles, {"long_name": "months from grinding to the limit"}),
            "probability_never": ("action", [of["probability_never"] for of in months]),
            "cost_per_year": (over, [action["cost_per_year"] for action in actions]),
            "saving_per_year": (over, [action["saving_per_year"] for action in actions]),
            **numbers,
        },
        coords={"action": [action["title"] for action in actions], "quantile": SHARES},
        attrs={
            name: found[name]
            for name in ("currency", "rise_db", "horizon_months", "draws", "evpi_per_year", "evppi_per_year", "measurements")
        },
    )


def draws(folder: Folder, count: int = 200) -> list[tuple[Case, dict[str, Any] | None]]:
    """Cases with the values of draws of a finished calibration: whatever a case is asked, it can be asked of each.

    Parameters
    ----------
    folder : path
        Folder of the calibration.
    count : int
        So many draws, which lie evenly in the chains; all of them where there are fewer.

    Returns
    -------
    list of (Case, dict or None)
        The case as the dated levels of the plan see it, and the keys of its traffic, none where the plan names no traffic.

    Raises
    ------
    FileNotFoundError
        If the folder holds no calibration.
    ValueError
        Where the case refuses the values of a draw.

    Examples
    --------
    >>> months = [case.line_growth(traffic)["fastest"]["doubling_months"] for case, traffic in riffel.draws("posterior")]  # doctest: +SKIP
    """
    return [(Case(case), traffic) for case, traffic in _riffel.draws(os.fspath(folder), count)]


class LogPosterior:
    """How likely values are after the data of a plan: a density for samplers, or for likelihoods of one's own.

    Places are on the whole line: the logarithm of what is lognormal, deviations of what is normal, the logit of what is uniform.

    Parameters
    ----------
    plan : path
        The plan: priors and data.

    Attributes
    ----------
    names, units : list of str
        Of the parameters, in the order of all arrays here; units are SI.

    Examples
    --------
    >>> posterior = riffel.LogPosterior("plan.toml")  # doctest: +SKIP
    >>> sampler = emcee.EnsembleSampler(40, len(posterior.names), lambda z: posterior(z) + own(posterior.values(z)))  # doctest: +SKIP
    """

    def __init__(self, plan: Folder) -> None:
        self._posterior = _riffel.LogPosterior(os.fspath(plan))
        self.names = [name for name, _ in self._posterior.parameters]
        self.units = [unit for _, unit in self._posterior.parameters]

    def __call__(self, place: ArrayLike) -> float:
        """Natural logarithm of prior times likelihood at a place, up to a constant; minus infinity where the case refuses it."""
        return self._posterior.log_density(_numbers(place))

    def gradient(self, place: ArrayLike) -> NDArray[np.float64] | None:
        """Derivatives by the place, of forward differences of the predictions; none where the case refuses it."""
        gradient = self._posterior.gradient(_numbers(place))
        return None if gradient is None else np.array(gradient)

    def log_likelihood(self, values: ArrayLike) -> dict[str, float]:
        """Natural logarithm of the likelihood of each set of data for values in SI."""
        return dict(self._posterior.log_likelihood(_numbers(values)))

    def values(self, place: ArrayLike) -> NDArray[np.float64]:
        """Values in SI of a place."""
        return np.array(self._posterior.values(_numbers(place)))

    def place(self, values: ArrayLike) -> NDArray[np.float64]:
        """Place of values in SI."""
        return np.array(self._posterior.place(_numbers(values)))

    def prior_quantile(self, share: float) -> NDArray[np.float64]:
        """Values in SI below which a share of each prior lies."""
        return np.array(self._posterior.prior_quantile(share))


def _numbers(numbers: ArrayLike) -> list[float]:
    return np.asarray(numbers, dtype=float).ravel().tolist()

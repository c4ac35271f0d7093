"""Surveys of many lines and dates."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from riffel._ask import answer
from riffel._case import Case
from riffel._quantities import Quantity, scalar
from riffel._traffic import Traffic

_UNITS = {
    "from_m": ("from", "m", "first place of the section"),
    "to_m": ("to", "m", "last place of the section"),
    "rms_m": ("rms", "m", "RMS of roughness in the band that is farthest over its limit"),
    "rms_over_limit": ("rms_over_limit", "1", "RMS over limit"),
    "growth_db_per_year": ("growth", "dB/year", "growth of the level"),
    "growth_error_db_per_year": ("growth_error", "dB/year", "half of the interval of 95 % of the growth"),
    "expected_growth": ("expected_growth", "dB/year", "growth of the level that the traffic is expected to make"),
    "expected_growth_band_80": ("expected_growth_band_80", "dB/year", "80 % of what it may be"),
    "lasting_over_limit": ("lasting_over_limit", "1", "RMS over limit without single places"),
    "months_to_limit": ("months_to_limit", "month", "months until the limit is reached; NaN where it never is"),
    "months_to_limit_band_80": ("months_to_limit_band_80", "month", "80 % of what they may be; infinite where it may never be reached"),
    "cost": ("cost", "1", "cost"),
}


class Network:
    """A store of surveys of many lines and dates, as `riffel network` keeps them.

    Parameters
    ----------
    folder : str or path-like
        Folder of the store. The first survey makes it.
    resolution : quantity, optional
        Length of a cell of a new store; by default that of the first block.

    Examples
    --------
    >>> blocks = folder / "blocks.csv"
    >>> _ = blocks.write_text("rail,from_m,to_m,rms_30_to_100_mm_um\\nleft,0,100,5\\nleft,100,200,9\\n")
    >>> network = riffel.Network(folder / "railway")
    >>> network.ingest(blocks, "Main line", "2026-01-31")["there_already"]
    False
    >>> network.worst(most=1)["rms_over_limit"].round(3).values.tolist()
    [1.286]
    >>> network.chart("Main line")["rms_over_limit"].sizes
    Frozen({'date': 1, 'place': 2})
    """

    def __init__(self, folder: str | os.PathLike[str], *, resolution: Quantity | None = None) -> None:
        self._folder = os.fspath(folder)
        self._resolution = resolution

    def __repr__(self) -> str:
        return f"Network({self._folder!r})"

    def ingest(
        self,
        file: str | os.PathLike[str],
        line: str,
        date: str,
        *,
        replace: bool = False,
        rename: dict[str, str] | None = None,
    ) -> dict[str, Any]:
        """Add a survey: blocks along the rails of a line, as `riffel axlebox` and `riffel roughness` write them.

        Parameters
        ----------
        file : str or path-like
            The blocks: ``rail``, ``from_m``, ``to_m`` and ``rms_30_to_100_mm_m`` for each band.
        line : str
            The line.
        date : str
            The day, as in ``"2026-01-31"``.
        replace : bool, default False
            Put it in the place of another survey of the line on that day.
        rename : dict, optional
            Other names for rails of the file. ``"links"``, ``"L"`` or ``"gauche"`` is the rail that the line calls left without it.

        Returns
        -------
        dict
            ``line``, ``date``, ``there_already``, ``measured``, the cells of each rail, ``goes_back``, the long kilometres, ``renamed``,
            the rails that have other names in the file, and ``new_rails``, those that the line has not had. Surveys are there whole or not at all;
            the same one again changes nothing. Of several processes that add at once, as under Dask, all but one raise `OSError`.
        """
        names = [f"{old}={new}" for old, new in (rename or {}).items()]
        survey = {"csv": file, "line": line, "date": date, "replace": replace, "rename": names}
        found: dict[str, Any] = self._ask("ingest", {**survey, "resolution": self._resolution})
        return found

    def status(self) -> dict[str, Any]:
        """Lines, dates, kilometres and RMS of the latest surveys: what ``riffel network status --json`` prints."""
        found: dict[str, Any] = self._ask("status", {})
        return found

    def worst(
        self,
        *,
        section: Quantity = "100 m",
        limit: str | os.PathLike[str] = "grassie-1999",
        until: str | None = None,
        most: int = 20,
    ) -> xr.Dataset:
        """Sections that are farthest over their limit.

        Parameters
        ----------
        section : quantity, default "100 m"
            Length of a section.
        limit : str or path-like, default "grassie-1999"
            Limit of the RMS in bands of wavelength, by name or as a TOML file.
        until : str, optional
            The state of this day; by default that of the latest surveys.
        most : int, default 20
            So many sections.

        Returns
        -------
        xarray.Dataset
            Over ``place``, the worst first: ``line``, ``date``, ``rail``, ``from``, ``to``, ``band`` (over ``end``), ``rms``,
            ``rms_over_limit``, ``kind`` (``"corrugation"``, ``"joint"``, ``"weld"``, ``"unknown"``; within the
            limit ``"ground"`` or empty) and ``growth``.
        """
        return _table(self._ask("worst", {"section": section, "limit": limit, "until": until, "most": most}), "place")

    def growth(
        self,
        *,
        section: Quantity = "100 m",
        limit: str | os.PathLike[str] = "grassie-1999",
        between: tuple[str, str] | None = None,
        most: int = 20,
        case: Case | None = None,
        traffic: Traffic | None = None,
        line: str | None = None,
    ) -> xr.Dataset:
        """How sections grew over their surveys, the soonest at their limit first.

        Parameters
        ----------
        section, limit, most
            As of `worst`.
        between : tuple of str, optional
            Two days: from the latest survey up to the one to the latest up to the other; by default all surveys.
        case, traffic, line : optional
            The track of a line, or of all, and its traffic, by default the usual one of such a line: the growth that it is expected
            to make stands beside that of the surveys, and in its place where a line has one survey or was ground.

        Returns
        -------
        xarray.Dataset
            As of `worst`, with ``growth`` and ``growth_error`` (half of its interval of 95 %), ``surveys``, ``lasting_over_limit`` (without
            single places), ``months_to_limit`` with ``months_to_limit_band_80``, ``ground``, and both ``dates`` and ``rms`` over ``survey``; ``expected_growth`` and
            ``expected_growth_band_80`` where a case was given.
        """
        start, end = between or (None, None)
        judged = {"section": section, "limit": limit, "from": start, "to": end, "most": most}
        found = self._ask("growth", {**judged, "case": case, "traffic": traffic, "line": line})
        for place in found:
            months = place["months_to_limit_band_80"]
            place["months_to_limit_band_80"] = [np.nan, np.nan] if months is None else [np.inf if end is None else end for end in months]
            growth = place.pop("expected_growth_db_per_year")
            if case is not None:
                place["expected_growth"] = None if growth is None else growth["median"]
                place["expected_growth_band_80"] = [np.nan, np.nan] if growth is None else growth["band_80"]
        return _table(found, "place")

    def plan(
        self,
        *,
        months: float = 12.0,
        length: Quantity | None = None,
        money: float | None = None,
        cost_per_metre: float | None = None,
        cost_per_site: float = 0.0,
        most_track: bool = False,
        section: Quantity = "100 m",
        limit: str | os.PathLike[str] = "grassie-1999",
        case: Case | None = None,
        traffic: Traffic | None = None,
        line: str | None = None,
    ) -> xr.Dataset:
        """What to grind with a budget.

        Parameters
        ----------
        months : float, default 12
            For the state in so many months.
        length : quantity, optional
            Length of track that can be ground; or else
        money, cost_per_metre, cost_per_site : float, optional
            money, what a metre of track costs, and each site besides.
        most_track : bool, default False
            Choose the sites that bring the most track below its limit, not the worst sections first.
        section, limit
            As of `worst`.
        case, traffic, line : optional
            As of `growth`.

        Returns
        -------
        xarray.Dataset
            Over ``site``: ``line``, ``from``, ``to``, ``rms_over_limit`` and ``cost``. Attributes: ``length_m``, ``cost``,
            ``over_limit_m``, ``single_places_m``, ``left_over_limit_m``, ``least_left_over_limit_m`` (no plan for this budget leaves less)
            and ``remarks``.
        """
        question = {
            "months": months,
            "length": length,
            "money": money,
            "cost_per_metre": cost_per_metre,
            "cost_per_site": None if money is None else cost_per_site,
            "most_track": most_track,
            "section": section,
            "limit": limit,
            "case": case,
            "traffic": traffic,
            "line": line,
        }
        found = self._ask("plan", question)
        sites = _table(found.pop("sites"), "site")
        return sites.assign_attrs(found)

    def chart(
        self,
        line: str,
        *,
        rail: str | None = None,
        section: Quantity = "100 m",
        limit: str | os.PathLike[str] = "grassie-1999",
    ) -> xr.Dataset:
        """Every survey of a line, place by date.

        Parameters
        ----------
        line : str
            The line.
        rail : str, optional
            This rail alone; by default the worst of all at each place.
        section, limit
            As of `worst`.

        Returns
        -------
        xarray.Dataset
            ``rms_over_limit`` and ``rms`` over ``date`` and ``place`` (the middle of a section), NaN where nothing is measured; ready
            for ``chart["rms_over_limit"].plot()``.
        """
        question = {"line": line, "rail": rail, "section": section, "limit": limit}
        surveys = self._ask("chart", question)["lines"][0]["surveys"]
        length = scalar(section, "section", "length")
        sections = [section["from_m"] for survey in surveys for section in survey["sections"]]
        first, last = (round(end / length) for end in (min(sections), max(sections)))
        values = np.full((2, len(surveys), last - first + 1), np.nan)
        for row, survey in enumerate(surveys):
            for found in survey["sections"]:
                place = round(found["from_m"] / length) - first
                values[:, row, place] = found["rms_over_limit"], found["rms_m"]
        dates = np.array([survey["date"] for survey in surveys], dtype="datetime64[ns]")
        places = (np.arange(first, last + 1) + 0.5) * length
        return xr.Dataset(
            {
                "rms_over_limit": (("date", "place"), values[0], {"units": "1", "long_name": "RMS over limit"}),
                "rms": (("date", "place"), values[1], {"units": "m", "long_name": "RMS of roughness"}),
            },
            coords={
                "date": dates,
                "place": ("place", places, {"units": "m", "long_name": "place along the line"}),
            },
            attrs={"title": line, "limit": os.fspath(limit)},
        )

    def _ask(self, name: str, question: dict[str, Any]) -> Any:
        found, remarks, _ = answer(f"network {name}", {"store": self._folder, **question})
        for kind, remark in remarks:
            if kind == "survey-is-left-out":
                raise ValueError(remark)
            warnings.warn(remark, stacklevel=3)
        return found


def _table(rows: Sequence[dict[str, Any]], dimension: str) -> xr.Dataset:
    """Rows of a document over a dimension."""
    variables: dict[str, Any] = {}
    for key in rows[0] if rows else ():
        # A name that is not known is empty, and a number NaN.
        missing = "" if key == "kind" else np.nan
        column = [missing if row[key] is None else row[key] for row in rows]
        name, units, meaning = _UNITS.get(key, (key.removesuffix("_m"), "m" if key.endswith("_m") else "", ""))
        values = np.array(column)
        inner = "end" if key == "band_m" or key.endswith("_band_80") else "survey"
        dimensions = (dimension,) if values.ndim == 1 else (dimension, inner)
        described = {"units": units, "long_name": meaning}
        variables[name] = (dimensions, values, {name: text for name, text in described.items() if text})
    return xr.Dataset(variables)

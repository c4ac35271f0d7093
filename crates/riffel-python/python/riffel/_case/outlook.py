"""What becomes of a rail under traffic, and what would help."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

import xarray as xr

from riffel import _forecast, _riffel
from riffel._ask import ask, keys_of
from riffel._case.keys import KeysOfCase
from riffel._quantities import Quantity, scalar
from riffel._records import Date, Levels, levels_in_question
from riffel._traffic import Traffic, file_or_keys, traffic_or_speed


class OutlookOfCase(KeysOfCase):
    """What lies ahead of a rail under traffic."""

    __slots__ = ()

    def forecast(
        self,
        spectrum: xr.DataArray | None = None,
        *,
        earlier: Sequence[xr.DataArray] = (),
        dates: Sequence[Date] = (),
        traffic: Traffic | None = None,
        speed: Quantity | None = None,
        speed_deviation: Quantity | None = None,
        passages: Any = None,
        mgt: Any = None,
        months: Any = None,
        ground: str | None = None,
        from_limit: str | float | None = None,
        limit: str = "iso-3095-2013",
    ) -> xr.Dataset:
        """What becomes of a measured spectrum, or of that of a ground rail, under traffic.

        Parameters
        ----------
        spectrum : DataArray, optional
            One-third-octave levels in dB re 1 µm over ``wavelength``, as `riffel.roughness.spectrum` gives them.
        earlier : sequence of DataArray, optional
            Levels of the same rail before, the oldest first, by which it goes on growing where the amount of traffic is known.
        dates : sequence of date or str, optional
            Dates of `earlier` and, last, of `spectrum`.
        traffic : path or mapping, optional
            A traffic file or its keys; without it, the wheel of the case at `speed`, or else at the usual speeds of its line,
            whose amount of traffic is not assumed.
        speed, speed_deviation : quantity, optional
            Mean and standard deviation of the speed of the wheel of the case.
        passages, mgt, months : number or array, optional
            How far to look ahead, in one of the three.
        ground : str, optional
            Begin with the levels of a limit table that grinding meets, by name or file, in place of `spectrum`; with `earlier` the
            rail goes on growing as it was measured.
        from_limit : str or float, optional
            Begin so many decibels below the limit, as in ``"-6 dB"``, in place of `spectrum`.
        limit : str
            Limit of the levels by name or as a TOML file.

        Returns
        -------
        xarray.Dataset
            Over ``passages`` and ``wavelength``: ``level``; over ``wavelength``: ``level_now``, ``growth_rate``, ``limit`` and
            ``passages_to_limit``, infinite where it is never reached. Attributes: ``grinding_interval_passages``,
            ``limit_reached`` ("after", "beyond-linear-range" or "never") and ``linear_range_passages``, where the wheel
            leaves the rail and the forecast ends: what lies beyond is NaN. Where flow hardens, also ``runaway_number`` and
            ``hardened_wave_ratio``; with fatigue among the laws, over ``phase`` too, ``fatigue_index``, ``damage_per_passage``,
            ``wear_per_passage``, ``crack_growth_per_passage`` and ``crack_length`` after the most passages; ``findings`` says
            what they mean.

        Raises
        ------
        ValueError
            For a spectrum without a band in the window of the case, or a value that is not allowed.

        Examples
        --------
        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> now = riffel.roughness.levels([0.0315, 0.04, 0.05, 0.063], [2.0, 1.0, 0.0, -1.0])
        >>> later = case.forecast(now, speed="100 km/h", passages=[0.0, 1e6])
        >>> later["level"].dims
        ('passages', 'wavelength')
        >>> bool((later["level"][0] == later["level_now"]).all())
        True

        A rail that will be ground to 6 dB below the limit, and one that will be ground to the limit itself:

        >>> ground = case.forecast(from_limit="-6 dB", traffic="cases/traffic.toml", months=12.0)
        >>> ground.attrs["limit_reached"], ground.attrs["grinding_interval_passages"] > 1e6
        ('after', True)
        >>> met = case.forecast(ground="iso-3095-2013", traffic="cases/traffic.toml", months=12.0)
        >>> met.attrs["grinding_interval_passages"]
        0.0
        """
        measure, values = _forecast.horizon(passages, mgt, months, traffic is not None)
        if len(earlier) > 0 and len(dates) == 0:
            raise ValueError("dates is empty, but must be the dates of the earlier spectra and of spectrum, the oldest first")
        question = {
            "case": self,
            "spectrum": spectrum,
            "earlier": earlier,
            "dates": dates,
            "traffic": _riffel.Traffic(self._case, traffic_or_speed(traffic, speed, speed_deviation)),
            "ground": ground,
            "from_limit": from_limit,
            "limit": limit,
            # Of no account: levels are asked for at the values of the measure, which may be zero.
            "passages": 1.0,
        }
        found = _riffel.forecast(keys_of(question), measure, values)
        return _forecast.forecast(found, limit, self.title)

    def line_growth(self, traffic: Traffic | None = None) -> dict[str, Any]:
        """What grows fastest under the traffic of the line, and in what time.

        Parameters
        ----------
        traffic : path or mapping, optional
            A traffic file or its keys; without it, the usual traffic of a line of this kind, which the case tells by its curve, its
            vehicle, or else its wheel and load.

        Returns
        -------
        dict
            ``under_traffic`` of ``riffel map --json``: ``usual_traffic_of``, ``speeds_m_per_s``, ``passages_per_day``, ``fastest``,
            None where nothing grows, with the band of the wear coefficient, ``cause``, the resonance that it follows with the evidence,
            and ``remarks``, the answer in sentences first.

        Examples
        --------
        >>> growth = riffel.Case.from_toml("cases/metro.toml").line_growth()
        >>> growth["usual_traffic_of"], [round(3.6 * speed) for speed in growth["speeds_m_per_s"]]
        ('metro', [40, 70])
        """
        given = None if traffic is None else _riffel.Traffic(self._case, file_or_keys(traffic))
        return _riffel.line_growth(self._case, given)

    def remedies(self, traffic: Traffic | None = None, *, costs: Mapping[str, float] | None = None) -> dict[str, Any]:
        """What would slow growth under the traffic of the line, the remedy that helps most first.

        Parameters
        ----------
        traffic : path or mapping, optional
            As of `line_growth`.
        costs : mapping, optional
            What remedies cost by their ids, in one currency for all; what gains most months of grinding interval for it then
            comes first.

        Returns
        -------
        dict
            What ``riffel compare --remedies --json`` prints: ``under_traffic``, ``grinding_interval``, ``remedies``, each with ``id``,
            ``title``, ``changes``, ``change_of_fastest_growth``, ``fastest``, ``grinding_interval`` and ``months_gained``, and
            ``left_out`` with the reasons.

        Raises
        ------
        ValueError
            For a cost that is not above zero, or of what no remedy is called.

        Examples
        --------
        >>> metro = riffel.Case.from_toml("cases/metro.toml")
        >>> best = metro.remedies()["remedies"][0]
        >>> best["id"], round(100 * best["change_of_fastest_growth"])
        ('softer-pads', -52)
        >>> metro.remedies(costs={"slower-trains": 1.0})["remedies"][0]["id"]
        'slower-trains'
        """
        cost = [f"{remedy}={cost}" for remedy, cost in (costs or {}).items()]
        found: dict[str, Any] = ask("compare", {"case": self, "remedies": True, "traffic": traffic, "cost": cost})
        return found

    def compare(
        self,
        variants: Sequence[str | os.PathLike[str] | Mapping[str, Any]],
        *,
        traffic: Traffic | None = None,
        speed: Quantity | None = None,
        speed_deviation: Quantity | None = None,
        spectrum: xr.DataArray | None = None,
        earlier: Sequence[xr.DataArray] = (),
        dates: Sequence[Date] = (),
        ground: str | None = None,
        from_limit: str | float | None = None,
        hold: str | None = None,
        limit: str = "iso-3095-2013",
    ) -> xr.Dataset:
        """What would help: growth on the case and on variants of it, side by side.

        Parameters
        ----------
        variants : sequence of paths or mappings
            Files of changes or their keys: ``{"title": ..., "track": {...}, "speed": {"factor": 0.8}}``.
        traffic, speed, speed_deviation, earlier, dates, ground, from_limit, limit
            As of `forecast`; without a traffic and a speed under all of the usual traffic of the line, with its axles a day.
        spectrum : DataArray, optional
            Measured levels, to say when each variant reaches the limit.
        hold : {"force", "ratio", "creepage"}, optional
            What variants of friction or load hold; by default what the case or the vehicle gives, the tractive ratio or
            the creepage.

        Returns
        -------
        xarray.Dataset
            Over ``variant``, "as it is" first: ``growth_rate`` by ``wavelength``, ``fastest_wavelength``,
            ``fastest_growth_rate``, ``ridge_frequency``, ``passages_to_limit``, ``months_to_limit``, ``limit_reached``
            (empty without a spectrum), ``hold`` (empty where friction and load stay) and ``acts``; attribute ``no_effect``:
            sentences on variants of which a part or all has no effect.

        Examples
        --------
        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> both = case.compare([{"title": "less friction", "contact": {"friction": 0.2}}], speed="100 km/h")
        >>> both["variant"].values.tolist()
        ['as it is', 'less friction']

        With less friction the wheel pulls less, unless the force is held:

        >>> less = [{"title": "less friction", "contact": {"friction": 0.25}}]
        >>> for hold in (None, "force"):
        ...     held = case.compare(less, traffic="cases/traffic.toml", from_limit="-6 dB", hold=hold)
        ...     months = held["months_to_limit"].values
        ...     print(held["hold"].values[1], "longer" if months[1] > months[0] else "shorter")
        ratio longer
        force shorter
        """
        question = {
            "case": self,
            "with": variants,
            "speed": speed,
            "speed_deviation": speed_deviation,
            "traffic": traffic,
            "spectrum": spectrum,
            "earlier": earlier,
            "dates": dates,
            "ground": ground,
            "from_limit": from_limit,
            "hold": hold,
            "limit": limit,
        }
        return _forecast.comparison(ask("compare", question)["outcomes"], self.title)

    def fit_wear(
        self,
        earlier: Levels,
        later: Levels,
        *,
        passages: float | None = None,
        days: float | None = None,
        traffic: Traffic | None = None,
        speed: Quantity | None = None,
        speed_deviation: Quantity | None = None,
        limit: str = "iso-3095-2013",
    ) -> dict[str, Any]:
        """The wear coefficient with which this case grows as a rail has grown between two measurements.

        Parameters
        ----------
        earlier, later : DataArray, sequence of DataArray or path
            One-third-octave spectra, or a file of spectra or of a profile: of several rails the fit is of that which leads. Three records or more of each
            date give an interval. Records are paired by the texts among their attributes that are the same in both; those of
            two profiles are every 10 m of rail that is in both.
        passages : number, optional
            Axle passages between the two.
        days : number, optional
            Days between the two, in place of `passages`, for traffic that says how much of it there is.
        traffic, speed, speed_deviation, limit
            As of `forecast`.

        Returns
        -------
        dict
            What ``riffel forecast --json`` has under ``wear_fit``: ``verdict``, ``coefficient_kg_per_j`` with its 95 %
            interval, None where no fit is claimed, ``bands`` with measured, predicted and fitted changes, and
            ``sentences`` that say what to make of it.

        Raises
        ------
        ValueError
            For measurements without a common band in the window of the case, or a value that is not allowed.

        Examples
        --------
        What grows by twice its forecast has twice the coefficient:

        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> before = riffel.roughness.levels([0.04, 0.05, 0.063], [1.0, 1.0, 1.0])
        >>> grown = case.forecast(before, speed="100 km/h", passages=[2e5])["level"][0]
        >>> fit = case.fit_wear(before, grown, passages=1e5, speed="100 km/h")
        >>> fit["verdict"], round(fit["best_factor"], 6)
        ('without-interval', 2.0)
        """
        between = {"passages": passages, "days": days}
        given = {name: scalar(value, name, "ratio") for name, value in between.items() if value is not None}
        if len(given) != 1:
            raise ValueError("give one of passages and days: how much traffic there was between the measurements")
        question = {
            "case": self,
            "spectrum": levels_in_question(later, "later"),
            "earlier": [levels_in_question(earlier, "earlier")],
            "passages_between": given.get("passages"),
            "traffic": _riffel.Traffic(self._case, traffic_or_speed(traffic, speed, speed_deviation)),
            "limit": limit,
        }
        return _riffel.fit_wear(keys_of(question), given.get("days"))

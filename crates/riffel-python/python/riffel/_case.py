"""Cases."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel import _contact, _datasets, _diagnosis, _forecast, _growth, _passage, _points, _riffel, _track
from riffel._axlebox import AxleBoxRun, checked_place, checked_run
from riffel._quantities import Floats, Quantities, Quantity, array, is_scalar, scalar, spaced
from riffel._receptance import GivenReceptance, checked_receptance
from riffel._records import Date, Levels, RailRecord, checked_levels
from riffel._spectra import levels_of
from riffel._speeds import Speeds
from riffel._traffic import Traffic, file_or_keys, plain_keys, traffic_or_speed

Overrides: TypeAlias = "Mapping[str, Any]"
"""Values by dotted key, as in ``{"contact.friction": 0.3}``."""


class Case:
    """One wheel on one track, checked and complete. It does not change; `with_` makes another one.

    Make one with `from_toml`, `from_dict` or `parse`.
    """

    __slots__ = ("_case", "_given", "_window_map")

    def __init__(self, case: _riffel.Case, given: Mapping[str, Any] | None = None) -> None:
        if not isinstance(case, _riffel.Case):
            raise TypeError(
                f"Case takes no {type(case).__name__}: make a case with Case.from_toml(path), "
                "Case.from_dict(keys) or Case.parse(text)"
            )
        self._case = case
        # Receptances of track and wheel that were given, to take along when it is pickled.
        self._given = dict(given or {})
        # A map over the window of the case but for its values: to make one costs a tenth of a million points.
        self._window_map: xr.Dataset | None = None

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str], overrides: Overrides | None = None) -> Case:
        """Read a case file.

        Parameters
        ----------
        path : path-like
            The file. Files that it names are relative to its folder.
        overrides : mapping, optional
            Values by dotted key that replace those of the file, as ``--set`` of the program.

        Raises
        ------
        FileNotFoundError
            If there is no such file.
        ValueError
            For a key or a value that is not allowed, with the line of the file.
        ConvergenceError
            If a contact does not converge with the values of the case.

        Examples
        --------
        >>> case = riffel.Case.from_toml("cases/nominal.toml", {"wheel.mass": "600 kg"})
        >>> case.title
        'BR main line, tangent track'
        """
        return cls(_riffel.Case.read(os.fspath(path), dict(overrides or {})))

    @classmethod
    def parse(cls, text: str, overrides: Overrides | None = None, *, name: str = "case") -> Case:
        """Read a case from TOML; `name` is shown in errors. Otherwise as `from_toml`."""
        return cls(_riffel.Case.parse(text, name, dict(overrides or {})))

    @classmethod
    def from_dict(cls, keys: Mapping[str, Any]) -> Case:
        """A case from nested dicts with the keys of the case file.

        Parameters
        ----------
        keys : mapping
            Tables as dicts; quantities as numbers in SI or strings with their unit.

        Raises
        ------
        ValueError
            For a key or a value that is not allowed.
        TypeError
            For a value that no case file holds.

        Examples
        --------
        >>> case = riffel.Case.from_dict({
        ...     "wheel": {"rolling_radius": "460 mm", "mass": 350},
        ...     "rail": {"section": "BS113A"},
        ...     "track": {"model": "free-beam"},
        ...     "contact": {"transverse_radius": "230 mm", "normal_load": "50 kN", "friction": 0.4, "tractive_ratio": 0.1},
        ... })
        >>> case.to_dict()["wheel"]["mass"]
        '350 kg'
        """
        return cls(_riffel.Case.from_dict(plain_keys(keys)))

    def with_(self, overrides: Overrides | None = None, /, **more: Any) -> Case:
        """The case with other values.

        Parameters
        ----------
        overrides : mapping, optional
            Values by dotted key. One of two keys that exclude each other replaces the other.
        **more
            The same, as in ``case.with_(**{"contact.friction": 0.3})``.

        Examples
        --------
        >>> riffel.Case.from_toml("cases/nominal.toml").with_({"contact.friction": 0.3}).to_dict()["contact"]["friction"]
        0.3
        """
        return Case(self._case.with_overrides({**(overrides or {}), **more}), self._given)

    def with_track(self, receptance: GivenReceptance) -> Case:
        """The case on a track of the receptance given: a finite-element track, say, or a measured one.

        It takes part in points, maps, ridges, receptances, forecasts and comparisons, and stays with the case in
        `with_`. It stands for one place of the rail, so that nothing is averaged over a bay.

        Parameters
        ----------
        receptance : callable, tuple, DataArray or dataset of pyuff
            Vertical receptance of the rail at the contact in m/N, displacement and force both downward, for the time
            factor exp(+i omega t): a passive track has an imaginary part of zero or less. A callable takes an array of
            frequencies in Hz and returns as many complex numbers; it is called from several threads in turn, with one
            frequency or with 64. For a map of 20 000 points or more it is tabulated to 1e-9. A pair
            ``(frequency, receptance)`` or a `DataArray` over ``frequency`` is interpolated linearly in the logarithm of
            frequency and not extrapolated.

        Raises
        ------
        ReceptanceError
            If the callable raises, which is the cause of the error, or does not return one finite number for each
            frequency. Raised here or by the computation that met it.
        ValueError
            For arrays that are no receptance.

        Examples
        --------
        A rail of 56 kg/m on an elastic foundation with loss:

        >>> def winkler(frequency):
        ...     omega = 2.0 * np.pi * frequency
        ...     bending, mass, foundation = 207e9 * 2.35e-5, 56.0, 50e6 * (1.0 + 0.2j)
        ...     decay = ((foundation - mass * omega**2) / (4.0 * bending)) ** 0.25
        ...     return 1.0 / (8.0 * bending * decay**3)
        >>> case = riffel.Case.from_toml("cases/nominal.toml").with_track(winkler)
        >>> bool((case.receptance([500.0, 1000.0])["rail_m_per_n"] == winkler(np.array([500.0, 1000.0]))).all())
        True
        """
        track = checked_receptance(receptance, "receptance")
        return Case(self._case.with_track(track), {**self._given, "track": track})

    def with_wheel(self, receptance: GivenReceptance) -> Case:
        """The case under a wheel of the receptance given; its rotation stays that of the case.

        Otherwise as `with_track`.
        """
        wheel = checked_receptance(receptance, "receptance")
        return Case(self._case.with_wheel(wheel), {**self._given, "wheel": wheel})

    def to_dict(self) -> dict[str, Any]:
        """All keys with their values, presets and defaults filled in; `from_dict` reads them back."""
        return self._case.to_dict()

    @property
    def title(self) -> str | None:
        """What the case is."""
        return self._case.title

    @property
    def remarks(self) -> list[str]:
        """What to know about the validity of the models in the window of the map."""
        return self._case.remarks

    def __reduce__(self) -> tuple[Any, ...]:
        # Keys and not results: it is built anew where it arrives. A callable goes as Python pickles it.
        return _restored, (self._case.portable(), self._given)

    def __copy__(self) -> Case:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Case:
        # It does not change.
        return self

    def __repr__(self) -> str:
        return f"<riffel.Case {self.title or 'without title'!r}>"

    def point(self, *, wavelength: Quantities, speed: Quantities) -> dict[str, float | complex] | xr.Dataset:
        """The whole loop at one wavelength and speed, or at many.

        Parameters
        ----------
        wavelength, speed : quantity or array
            Plain arrays make a grid; `DataArray` s are broadcast by their dimensions.

        Returns
        -------
        dict or xarray.Dataset
            For two scalars a dict with the keys of ``riffel point --json``; for arrays the same keys as variables, those of
            laws of damage as ``damage.growth_by_law.flow``.
            Complex quantities are amplitudes for exp(+i omega t).

        Examples
        --------
        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> state = case.point(wavelength="55 mm", speed=30.0)
        >>> state["growth_rate_per_passage"] > 0.0
        True
        >>> case.point(wavelength=[0.03, 0.05, 0.08], speed="30 m/s")["normal_force_n"].dims
        ('wavelength',)
        """
        if is_scalar(wavelength) and is_scalar(speed):
            pair = np.array([scalar(wavelength, "wavelength", "length")]), np.array([scalar(speed, "speed", "speed")])
            return _points.one(self._case.points(*pair))
        speeds, wavelengths = xr.broadcast(
            _points.as_data_array(speed, "speed", "speed", _datasets.SPEED),
            _points.as_data_array(wavelength, "wavelength", "length", _datasets.WAVELENGTH),
        )
        flat = [np.ascontiguousarray(values.values.ravel()) for values in (wavelengths, speeds)]
        return _points.many(self._case.points(*flat), speeds, wavelengths, self.title)

    def sensitivity(self, *, wavelength: Quantity, speed: Quantity) -> xr.Dataset:
        """What the growth rate at one wavelength and speed answers to.

        Parameters
        ----------
        wavelength, speed : quantity
            Numbers in SI or strings with their unit.

        Returns
        -------
        xarray.Dataset
            Over ``key``, the quantities of the case that move the growth rate, and ``wavelength`` and ``speed``, the
            strongest first: ``derivative`` of the growth rate per passage by the quantity in SI, ``elasticity``
            (relative change over relative change), ``error`` of the elasticity, ``value`` and ``unit``. All
            other quantities hold their values, those that presets and defaults fill in among them.

        Examples
        --------
        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> strongest = case.sensitivity(wavelength="55 mm", speed="30 m/s")
        >>> round(float(strongest["elasticity"].sel(key="wear.coefficient")), 9)
        1.0
        """
        point = scalar(wavelength, "wavelength", "length"), scalar(speed, "speed", "speed")
        return _points.sensitivity(self._case.sensitivities(*point), self.title)

    def growth_on_irregular_supports(
        self,
        *,
        wavelength: Quantity,
        speed: Quantity,
        spacing_deviation: Quantity,
        supports: int = 60,
        seed: int = 1,
    ) -> xr.Dataset:
        """Growth along a stretch of discrete supports at drawn distances, as if the wheel stayed at each place.

        Parameters
        ----------
        wavelength, speed : quantity
            Numbers in SI or strings with their unit.
        spacing_deviation : quantity
            Standard deviation of the distances, which are normal about that of the case; at most a quarter of it.
        supports : int
            Supports of the stretch, 8 to 200; the outer two bays at either end are left out.
        seed : int
            Of the draw.

        Returns
        -------
        xarray.Dataset
            ``growth_rate`` over ``position`` from where the first support would stand, ``even_growth_rate`` over ``place_in_bay`` of
            equal supports, and ``support_position`` over ``support``.

        Examples
        --------
        >>> flat = {"contact.wave_geometry": False}
        >>> case = riffel.Case.from_toml("cases/discrete-supports.toml").with_(flat)
        >>> along = case.growth_on_irregular_supports(wavelength="60 mm", speed=30.0, spacing_deviation="3 cm")
        >>> bool(along["growth_rate"].max() > 0 > along["even_growth_rate"].max())
        True
        """
        point = scalar(wavelength, "wavelength", "length"), scalar(speed, "speed", "speed")
        deviation = scalar(spacing_deviation, "spacing_deviation", "length")
        found = self._case.growth_on_irregular_supports(point, deviation, supports, seed)
        return _growth.on_irregular_supports(found, self.title)

    def growth_map(self, *, wavelength: Quantities | None = None, speed: Quantities | None = None) -> xr.Dataset:
        """Growth over wavelength and speed.

        Parameters
        ----------
        wavelength, speed : array or window, optional
            Any values, or ``{"min": ..., "max": ..., "points": ...}`` as in a case file; those of the case by default.

        Returns
        -------
        xarray.Dataset
            Dimensions ``speed`` and ``wavelength``; ``normalized_dissipation``, complex, and ``growth_rate``, which is
            computed from it when it is read.

        Examples
        --------
        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> growth = case.growth_map(wavelength={"min": "20 mm", "max": "80 mm", "points": 61}, speed=[20.0, 30.0])
        >>> growth["growth_rate"].idxmax("wavelength").values.round(3)
        array([0.037, 0.056])
        """
        wavelengths = self._window("wavelength", wavelength)
        speeds = self._window("speed", speed)
        own = wavelength is None and speed is None
        # Memory of NumPy, which asks the system for large pages; they are touched while the map is computed.
        padded = -(-wavelengths.size // _riffel.TILE) * _riffel.TILE
        values = np.empty((speeds.size, padded), dtype=np.complex128)
        normalized = values[:, : wavelengths.size]

        def dataset(factor: float) -> xr.Dataset:
            if not own or self._window_map is None:
                return _growth.growth_map(wavelengths, speeds, normalized, factor, self.title)
            rate = _growth.growth_rate(normalized, factor)
            return self._window_map.copy(data={"normalized_dissipation": normalized, "growth_rate": rate})

        growth = self._case.growth_map(wavelengths, speeds, values, dataset)
        if own and self._window_map is None:
            nothing = np.broadcast_to(np.complex128(0.0), normalized.shape)
            self._window_map = growth.copy(data={"normalized_dissipation": nothing, "growth_rate": nothing.real})
        return growth

    def bay_maps(self) -> xr.Dataset:
        """Growth over a sleeper bay on discrete supports, over the window of the case.

        Returns
        -------
        xarray.Dataset
            As `growth_map`, with the dimension ``place``: over a support, in mid-span and mean over the bay.

        Raises
        ------
        ValueError
            On a track that is the same everywhere along the rail.
        """
        maps, rate = self._case.bay_maps()
        return _growth.bay_maps(maps, rate, self._case.wavelengths(), self._case.speeds(), self.title)

    def ridge(self, *, wavelength: Quantities | None = None, speed: Quantities | None = None) -> xr.Dataset:
        """The wavelength of highest growth at each speed.

        Parameters
        ----------
        wavelength : array or window, optional
            Equally spaced wavelengths between which the ridge is searched, refined to 1e-7 of their range.
        speed : array or window, optional
            Any speeds.

        Returns
        -------
        xarray.Dataset
            Over ``speed``. The attribute ``best_fit_frequency_hz`` is that of the strongest branch, NaN where nothing
            grows or no crest of it lies in the window; `ridge_branches` gives them all.

        Examples
        --------
        >>> ridge = riffel.Case.from_toml("cases/nominal.toml").ridge(speed=["72 km/h", "108 km/h"])
        >>> ridge["frequency"].values.round()
        array([537., 539.])
        """
        axis, speeds = self._ridge_window(wavelength, speed)
        return _growth.ridge(self._case.ridge(axis, speeds), speeds, self.title)

    def ridge_branches(self, *, wavelength: Quantities | None = None, speed: Quantities | None = None) -> xr.Dataset:
        """The branches of the ridge: lines of growth whose frequency is continuous over speed, the strongest first.

        A branch may be hidden at some speeds, or at all, under a stronger one at another wavelength.

        Parameters
        ----------
        wavelength, speed : array or window, optional
            As for `ridge`. Near speeds tell the branches apart best.

        Returns
        -------
        xarray.Dataset
            Over ``branch`` and ``speed``, NaN where a branch does not grow in the window. Over ``branch`` alone:
            ``best_fit_frequency``, ``highest_growth_rate``, and ``mechanism``, the resonance of the case within 10 % of
            that frequency, empty where there is none.

        Examples
        --------
        >>> branches = riffel.Case.from_toml("cases/discrete-supports.toml").ridge_branches()
        >>> branches["best_fit_frequency"].values.round(-1)
        array([220.,  60.])
        """
        axis, speeds = self._ridge_window(wavelength, speed)
        return _growth.ridge_branches(self._case.ridge_branches(axis, speeds), speeds, self.title)

    def _ridge_window(
        self, wavelength: Quantities | None, speed: Quantities | None
    ) -> tuple[tuple[float, float, int], Floats]:
        """Ends and number of the wavelengths between which a ridge is searched, and its speeds."""
        speeds = self._window("speed", speed)
        if wavelength is not None:
            return spaced(wavelength, "wavelength", "length"), speeds
        values = self._case.wavelengths()
        return (float(values[0]), float(values[-1]), int(values.size)), speeds

    def receptance(
        self, frequency: Quantities | None = None, *, speed: Quantity | None = None, direction: str = "vertical"
    ) -> xr.Dataset:
        """Receptances of rail, wheel and contact, and their sum.

        Parameters
        ----------
        frequency : array or window, optional
            By default 600 from 20 Hz to 5 kHz, equally spaced in their logarithm, or those that were measured.
        speed : quantity, optional
            Speed of the load; by default the highest of the map.
        direction : {"vertical", "lateral", "longitudinal"}
            Of force and displacement; wheel and contact are vertical only.

        Returns
        -------
        xarray.Dataset
            Complex receptances in m/N over ``frequency``, named as by ``riffel receptance --json``; on discrete
            supports those over a support and in mid-span as well. The attributes ``resonances`` and
            ``resonance_frequencies_hz`` name what stands out vertically, ``p2_closed_form_hz`` is P2 of masses and springs.

        Examples
        --------
        >>> track = riffel.Case.from_toml("cases/bhaskar-track.toml").receptance(["100 Hz", "1 kHz"])
        >>> sorted(track.data_vars)
        ['contact_m_per_n', 'rail_m_per_n', 'total_m_per_n', 'wheel_m_per_n']
        >>> track.attrs["resonances"]
        ['P2', 'full-track', 'rail on pad']
        """
        asked = None if frequency is None else array(frequency, "frequency", "frequency")
        load = None if speed is None else scalar(speed, "speed", "speed")
        frequencies, joints = self._case.receptance(asked, load, direction)
        found = _track.receptance(
            frequencies, joints, self._case.resonances() if direction == "vertical" else None, self.title
        )
        if direction == "vertical" and (closed := self._case.p2_closed_form()) is not None:
            found.attrs["p2_closed_form_hz"] = closed
        return found

    def decay_rate(self, *, direction: str = "vertical") -> xr.DataArray:
        """Track decay rate in one-third octaves of EN 15461, in dB/m over nominal ``frequency``.

        The coordinate ``upper_bound`` is true where the rate is not known better.

        Raises
        ------
        ValueError
            For a track whose supports the case does not know.
        """
        return _track.decay_rate(self._case.decay_rate(direction))

    def contact(self) -> dict[str, Any]:
        """The contact patch and steady rolling by the law of the case: the scalars of ``riffel contact --json``.

        A case that only spins closes no loop and is no `Case`; the program answers it.
        """
        return self._case.contact()

    def creep_curve(self, creepage: Quantities | None = None) -> xr.Dataset:
        """Tractive ratio against creepage by every law.

        Parameters
        ----------
        creepage : array, optional
            Creepages as ratios or strings with %; by default 40, to 1.2 times that of full slip.

        Returns
        -------
        xarray.Dataset
            ``tractive_ratio`` over ``law`` and ``creepage``, and the same for Kalker's exact theory, ``half-space``.

        Raises
        ------
        ConvergenceError
            If the exact theory does not converge.

        Examples
        --------
        >>> curves = riffel.Case.from_toml("cases/nominal.toml", {"contact.grid": 16}).creep_curve(["0.05 %", "0.1 %"])
        >>> curves["tractive_ratio"].sel(law="carter-3d").values.round(3)
        array([0.198, 0.369])
        """
        asked = None if creepage is None else array(creepage, "creepage", "ratio")
        creepages, laws = self._case.creep_curve(asked)
        return _contact.creep_curve(creepages, laws, self.title)

    def frequency_response(self, wavelength_over_semi_axis: Quantities | None = None) -> xr.Dataset:
        """Responses of the exact contact to small oscillations about its mean state.

        Parameters
        ----------
        wavelength_over_semi_axis : array, optional
            Wavelengths in longitudinal semi-axes; by default 61 from 2 to 100.

        Returns
        -------
        xarray.Dataset
            Complex ``response`` and what the grid may miss of it, ``error``, over ``input``, ``output`` and
            ``wavelength_over_semi_axis``. Where the case gives a tractive ratio or a number for its creepage, the inputs are
            creepage and load, the outputs force, dissipation and rail_dissipation, each over its quasi-static value. About
            a table of creepages the inputs are longitudinal_creepage, lateral_creepage, spin and load, the outputs
            longitudinal_force, lateral_force, dissipation and rail_dissipation, in SI per unit of the input.

        Raises
        ------
        ConvergenceError
            If the exact theory does not converge.
        ValueError
            Near full slip, or for a wavelength that the grid of the contact does not resolve.
        """
        name = "wavelength_over_semi_axis"
        asked = None if wavelength_over_semi_axis is None else array(wavelength_over_semi_axis, name, "ratio")
        ratios, responses, normalized = self._case.frequency_response(asked)
        return _contact.frequency_response(ratios, responses, self.title, normalized=normalized)

    def forecast(
        self,
        spectrum: xr.DataArray | None = None,
        *,
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
        traffic : path or mapping, optional
            A traffic file or its keys; without it, the wheel of the case at `speed`, or else at the usual speeds of its line,
            whose amount of traffic is not assumed.
        speed, speed_deviation : quantity, optional
            Mean and standard deviation of the speed of the wheel of the case.
        passages, mgt, months : number or array, optional
            How far to look ahead, in one of the three.
        ground : str, optional
            Begin with the levels of a limit table that grinding meets, by name or file, in place of `spectrum`.
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
        horizon = _forecast.horizon(passages, mgt, months, traffic is not None)
        found = _riffel.forecast(
            self._case,
            None if spectrum is None else levels_of(spectrum, "spectrum"),
            _forecast.ground_in_words(ground, from_limit),
            traffic_or_speed(traffic, speed, speed_deviation),
            horizon.get("passages"),
            horizon.get("mgt"),
            horizon.get("months"),
            limit,
        )
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
        return _riffel.line_growth(self._case, None if traffic is None else file_or_keys(traffic))

    def compare(
        self,
        variants: Sequence[str | os.PathLike[str] | Mapping[str, Any]],
        *,
        traffic: Traffic | None = None,
        speed: Quantity | None = None,
        speed_deviation: Quantity | None = None,
        spectrum: xr.DataArray | None = None,
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
        traffic, speed, speed_deviation, ground, from_limit, limit
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
        measured = None if spectrum is None else levels_of(spectrum, "spectrum")
        changes = [file_or_keys(variant) for variant in variants]
        wavelengths, nominal, outcomes = _riffel.compare(
            self._case,
            changes,
            traffic_or_speed(traffic, speed, speed_deviation),
            measured,
            _forecast.ground_in_words(ground, from_limit),
            hold,
            limit,
        )
        return _forecast.comparison(wavelengths, nominal, outcomes, self.title)

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
    ) -> dict[str, Any]:
        """The wear coefficient with which this case grows as a rail has grown between two measurements.

        Parameters
        ----------
        earlier, later : DataArray, sequence of DataArray or path
            One-third-octave spectra of the same rail, or a file of spectra or of a profile. Three records or more of each
            date give an interval. Records are paired by the texts among their attributes that are the same in both; those of
            two profiles are every 10 m of rail that is in both.
        passages : number, optional
            Axle passages between the two.
        days : number, optional
            Days between the two, in place of `passages`, for traffic that says how much of it there is.
        traffic, speed, speed_deviation
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
        return _riffel.fit_wear(
            self._case,
            checked_levels(earlier, "earlier"),
            checked_levels(later, "later"),
            given.get("passages"),
            given.get("days"),
            traffic_or_speed(traffic, speed, speed_deviation),
        )

    def diagnose(
        self,
        rail: RailRecord,
        *,
        spacing: Quantity | None = None,
        earlier: Sequence[RailRecord] = (),
        dates: Sequence[Date] = (),
        traffic: Traffic | None = None,
        speed: Speeds | None = None,
        torsion: Quantities = (),
        bending: Quantities = (),
        where: Mapping[str, str] | None = None,
        by: str | None = None,
        format: str | os.PathLike[str] | None = None,
        height_unit: str | None = None,
        position_unit: str | None = None,
        from_vehicle: bool = False,
        keep_defects: bool = False,
    ) -> dict[str, Any]:
        """What may have made the wavelengths that stand out of a rail, held against this case.

        Parameters
        ----------
        rail : array, Dataset, DataArray, sequence of DataArray or path
            Heights of a rail in m as in `riffel.roughness.analyse`, or a `Dataset` of those of several; one-third-octave
            spectra of the same rail; a file of either, or what `riffel.roughness.read` made of it. Texts among the attributes
            of a spectrum are its labels.
        spacing : quantity, optional
            Step between heights without positions.
        earlier : sequence
            Earlier records of the same rail, the oldest first, each of the kind of `rail`.
        dates : sequence of date or str, optional
            Dates of all records, the oldest first and that of `rail` last.
        traffic : path or mapping, optional
            A traffic file or its keys, for the speeds of its vehicles.
        speed : quantity, tuple or list, optional
            Speed of the traffic in place of `traffic`; a range as a pair or as "60 km/h..90 km/h"; several as a list. By
            default all speeds of the map of the case.
        torsion, bending : quantity or array, optional
            Frequencies of torsional and of bending modes of the wheelset.
        where : mapping, optional
            Keep the spectra whose label of this name has this value.
        by : str, optional
            Label that tells the spectra of one table apart in time; ``date`` by default, if there is one.
        format : path-like, optional
            Reader profile of files.
        height_unit, position_unit : str, optional
            Units of heights and positions in files, as "mm", whatever these say.
        from_vehicle : bool
            Whether the record was taken from a vehicle, whose wheels are in it, and not with a trolley.
        keep_defects : bool
            Whether welds, joints and squats stay in the spectra of heights; else they are listed and left out.

        Returns
        -------
        dict
            With the keys of ``riffel diagnose --json``: ``dominant_wavelengths``, each with its ``candidates``, the
            likeliest first, ``defects`` and ``warnings``. A share compares the candidates of one list, each taken to be equally
            likely beforehand; it is no probability that a finding is right.

        Raises
        ------
        FileNotFoundError
            If there is no such file.
        ValueError
            For a record or a value that is not allowed, or records of different kinds.

        Examples
        --------
        Corrugation of 56 mm under trains at 108 km/h, on noise:

        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> position = 1e-3 * np.arange(60_000)
        >>> noise = np.random.default_rng(1).normal(scale=1e-6, size=position.size)
        >>> found = case.diagnose(20e-6 * np.sin(2 * np.pi * position / 0.056) + noise, spacing="1 mm", speed="108 km/h")
        >>> peak = found["dominant_wavelengths"][0]
        >>> round(peak["wavelength_m"], 3), peak["candidates"][0]["mechanism"]
        (0.056, 'growth ridge')

        With a record of a year before, it has a course:

        >>> now = {"rail": 20e-6 * np.sin(2 * np.pi * position / 0.056) + noise}
        >>> before = [10e-6 * np.sin(2 * np.pi * position / 0.056) + noise[::-1]]
        >>> dates = ["01.05.2024", "2025-05-01"]
        >>> found = case.diagnose(**now, earlier=before, dates=dates, spacing="1 mm", speed="108 km/h")
        >>> course = found["dominant_wavelengths"][0]["course"]
        >>> course["records"], course["per"], round(course["slope_db"], 1)
        (['2024-05-01', '2025-05-01'], 'year', 6.0)
        """
        return _diagnosis.diagnose(
            self._case,
            rail,
            spacing=spacing,
            earlier=earlier,
            dates=dates,
            traffic=None if traffic is None else file_or_keys(traffic),
            speed=speed,
            torsion=torsion,
            bending=bending,
            where=where,
            by=by,
            format=format,
            height_unit=height_unit,
            position_unit=position_unit,
            from_vehicle=from_vehicle,
            keep_defects=keep_defects,
        )

    def curve(self, overrides: Overrides | None = None, *, radius: Quantities | None = None) -> xr.Dataset:
        """The bogie of the case in its curve; see `riffel.curve`, which also takes files of the tables of curving alone.

        Parameters
        ----------
        overrides : mapping, optional
            Values by dotted key.
        radius : quantities, optional
            Radii of curves, above zero to the right; by default that of the case alone.

        Raises
        ------
        ValueError
            For a case without the tables of curving, and for a value that is not allowed.
        ConvergenceError
            Where no equilibrium is found at the radius of the case.
        """
        from riffel._curving import curve  # noqa: PLC0415  # it takes cases

        return curve(self, overrides, radius=radius)

    def simulate(
        self,
        profile: npt.ArrayLike | xr.DataArray | None = None,
        *,
        speed: Quantity,
        spacing: Quantity | None = None,
        sinusoid: Sequence[Quantity] | None = None,
        step: Quantity | None = None,
        contact_filter: bool = False,
        transient: bool = False,
    ) -> xr.Dataset:
        """The wheel along a rail in time, with loss of contact: once along a profile, or over a sinusoid until it is settled.

        Parameters
        ----------
        profile : array-like or DataArray, optional
            Heights in m, positive upward, without gaps. A `DataArray` over ``position`` needs no `spacing`.
        speed : quantity
            Speed of the wheel.
        spacing : quantity, optional
            Step between two heights.
        sinusoid : pair of quantity, optional
            Amplitude and wavelength, in place of a profile.
        step : quantity, optional
            Largest step in time, as a length; by default 0.5 mm, or 1/256 of the wavelength.
        contact_filter : bool
            The wheel feels the mean of the profile over the patch in the place of its height.
        transient : bool
            Over a sinusoid: follow the contact of the half-space element by element, in the place of the creep law of the case.

        Returns
        -------
        Dataset
            ``height``, ``normal_force``, ``tangential_force``, ``creepage``, ``dissipation`` and ``approach`` over
            ``position``; of a sinusoid one wave, and ``normal_force_harmonics`` and the like over ``harmonic``, complex and relative
            to the profile; of a transient contact ``energy_at_rail_harmonics`` too, what a place of the rail receives. A loop on all axes has ``lateral_force`` and ``lateral_creepage`` too; where it has several
            contacts, all lie over ``contact`` as well, as they are when the first wheel is at ``position``. ``contact_loss_fraction``, ``minimum_normal_force`` and ``maximum_normal_force`` are attributes.

        Raises
        ------
        ValueError
            For a case that is not followed through time, and a profile that is too short or too coarse.

        Examples
        --------
        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> wave = case.simulate(sinusoid=("60 um", "55 mm"), speed="108 km/h")
        >>> round(1e-3 * wave.attrs["maximum_normal_force"], 1), wave.sizes["harmonic"]
        (95.6, 6)
        """
        return _passage.simulate(
            self._case,
            _passage.checked_surface(profile, spacing, sinusoid),
            scalar(speed, "speed", "speed"),
            None if step is None else scalar(step, "step", "length"),
            contact_filter,
            transient,
            self.title,
        )

    def on_smooth_rail(self, speed: Quantity, step: Quantity | None = None) -> xr.Dataset:
        """What becomes of a push on a smooth rail: rest, or the limit cycle of an unstable loop, as squeal and stick and slip.

        Parameters
        ----------
        speed : quantity
            Speed of the wheels.
        step : quantity, optional
            Largest step in time, as a length; by default 10 µs of rolling, which is also the largest.

        Returns
        -------
        Dataset
            Forces, creepages and dissipation over ``contact`` and ``position``, three periods at the end; their least and
            largest value over the last half second, as ``lateral_force_range``, over ``bound``; ``stick_fraction`` and
            ``mean_dissipation``. Attributes: ``outcome`` (``"at-rest"``, ``"limit-cycle"``, ``"runs-away"`` or ``"irregular"``), ``frequency`` in Hz,
            ``linear_unstable_roots`` and ``linear_frequency`` of the linear loop.

        Raises
        ------
        ValueError
            For a case that is not followed through time, and for one wheel with longitudinal creepage alone.

        Examples
        --------
        >>> creepage = {"longitudinal": 0.001, "lateral": 0.002}
        >>> case = riffel.Case.from_toml("cases/nominal.toml", {"contact.creepage": creepage})
        >>> case.on_smooth_rail(speed=20).attrs["outcome"]
        'at-rest'
        """
        return _passage.on_smooth_rail(
            self._case,
            scalar(speed, "speed", "speed"),
            None if step is None else scalar(step, "step", "length"),
            self.title,
        )

    def evolve(
        self,
        profile: npt.ArrayLike | xr.DataArray | None = None,
        *,
        passages: int,
        speed: Quantity | None = None,
        speed_deviation: Quantity | None = None,
        traffic: Traffic | None = None,
        spacing: Quantity | None = None,
        sinusoid: Sequence[Quantity] | None = None,
        periodic: bool = False,
        step: Quantity | None = None,
        contact_filter: bool = False,
    ) -> xr.Dataset:
        """A rail that wears under many wheels, beside the linear loop.

        Parameters
        ----------
        profile : array-like or DataArray, optional
            Heights in m before any wheel, positive upward, without gaps. Its ends are joined, unless it is `periodic`.
        passages : int
            How many wheels.
        speed : quantity
            Speed of the wheels; for a traffic, `traffic`.
        speed_deviation : quantity, optional
            Standard deviation of the speed.
        traffic : path or mapping, optional
            A traffic file or its keys, in place of a speed: every vehicle at the speeds of its distribution, as often as its
            share says.
        spacing : quantity, optional
            Step between two heights.
        sinusoid : pair of quantity, optional
            Amplitude and wavelength, in place of a profile.
        periodic : bool
            The profile goes on where it ends.
        step : quantity, optional
            Largest step in time, as a length; by default 0.5 mm, or 1/256 of the wavelength of a sinusoid.
        contact_filter : bool
            The wheels feel the mean of the profile over the patch in the place of its height.

        Returns
        -------
        Dataset
            ``level``, ``linear_level`` and ``shift`` over ``passages`` and ``wavelength``; growth, drift and
            ``saturation_level`` over ``wavelength``, NaN where there is none; ``mean_depth``, loss of contact and forces over
            ``passages``; ``height`` over ``profile_passages`` and ``position``. On discrete supports ``support_pattern_level`` as
            well, the level of the waves that fit between two of them.

        Raises
        ------
        ValueError
            For a case that is not followed through time, and a profile that is too short or too coarse.
        KeyboardInterrupt
            After Ctrl-C.

        Examples
        --------
        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> worn = case.evolve(sinusoid=("0.1 um", "55 mm"), speed="108 km/h", passages=1_000_000)
        >>> grown = worn.sel(wavelength=0.05, method="nearest")
        >>> rate, linear = float(grown.first_growth_rate), float(grown.linear_growth_rate)
        >>> abs(rate / linear - 1) < 0.01
        True
        """
        if isinstance(passages, bool) or not isinstance(passages, (int, np.integer)) or passages < 1:
            raise ValueError(f"passages is {passages!r}, but must be a whole number of at least 1")
        if periodic and sinusoid is not None:
            raise ValueError("periodic is for a profile: a sinusoid is periodic anyway")
        if traffic is None and speed is None:
            raise ValueError("give speed or traffic")
        return _passage.evolve(
            self._case,
            _passage.checked_surface(profile, spacing, sinusoid),
            periodic,
            traffic_or_speed(traffic, speed, speed_deviation),
            int(passages),
            None if step is None else scalar(step, "step", "length"),
            contact_filter,
            self.title,
        )

    def axlebox(
        self,
        run: AxleBoxRun,
        *,
        rate: Quantity | None = None,
        speed: Quantities | None = None,
        odometer: Quantities | None = None,
        channels: Sequence[str] = (),
        shortest: Quantity = 0.01,
        longest: Quantity = 0.4,
        slowest: Quantity = "20 km/h",
        contact_filter: bool = False,
        keep_defects: bool = False,
        limit: str | Sequence[str] = (),
        block: Quantity = 10.0,
    ) -> dict[str, Any]:
        """Roughness of the rails from the acceleration of axle boxes on a train in service.

        Parameters
        ----------
        run : path, paths, mapping or array
            Files as of ``riffel axlebox``: text in columns, WAV, universal files. Or accelerations in m/s² at even times, of
            one channel or of several by name, as `scipy.io.loadmat` gives them of a file of MATLAB.
        rate : quantity, optional
            Samples per second: needed of arrays, and of files without times.
        speed : quantity or array, optional
            Speed of the train: one, or for arrays one for each sample.
        odometer : array, optional
            Reading of the odometer in m for each sample, in place of `speed`.
        channels : sequence of str, optional
            Channels of a WAV file in their order, each with its value at full scale: ``"acceleration_left_g=50"``.
        shortest, longest : quantity
            Wavelengths.
        slowest : quantity
            Lowest speed at which the train is listened to.
        contact_filter : bool
            Give back what the contact patch does not let through.
        keep_defects : bool
            Keep welds, joints and squats in the levels; else they are listed and left out of them.
        limit : str or sequence of str, optional
            Limit tables, by name or as TOML files; by default all.
        block : quantity
            Length of a block.

        Returns
        -------
        dict
            With the keys of ``riffel axlebox --json``: ``rails`` with their ``spectrum``, ``bands``, ``verdicts``,
            ``defects`` and ``grind``, and ``remarks``.

        Raises
        ------
        ValueError
            For signals that are clipped, in another unit or shorter than the others, a speed or an odometer that falls, and
            for a value that is not allowed.

        Examples
        --------
        A wave of 3 µm and 100 mm at 20 m/s, under a wheel that follows it; by hand, 3 µm are 6.5 dB re 1 µm:

        >>> case = riffel.Case.from_toml("cases/nominal.toml")
        >>> time = np.arange(30_000) / 1000.0
        >>> follows = 3e-6 * (2 * np.pi * 200.0) ** 2 * np.sin(2 * np.pi * 200.0 * time)
        >>> found = case.axlebox({"left": follows}, rate=1000.0, speed=20.0)
        >>> [rail["name"] for rail in found["rails"]]
        ['left']
        """
        given = checked_run(run)
        rate_hz, place = checked_place(given, rate, speed, odometer)
        within = (
            scalar(shortest, "shortest", "length"),
            scalar(longest, "longest", "length"),
            scalar(slowest, "slowest", "speed"),
            scalar(block, "block", "length"),
        )
        if within[1] < 2.0 * within[0]:
            raise ValueError(f"longest is {longest}, but must be at least twice shortest")
        limits = [limit] if isinstance(limit, str) else list(limit)
        return _riffel.axlebox(
            self._case,
            given,
            rate_hz,
            place,
            list(channels),
            within,
            bool(contact_filter),
            bool(keep_defects),
            limits,
        )

    def noise(
        self,
        spectrum: xr.DataArray,
        *,
        speed: Quantity,
        wheels: int = 4,
        train_length: Quantity | None = None,
        wheel_roughness: str | xr.DataArray | None = None,
        wheel_modes: str | os.PathLike[str] | None = None,
        decay_rate: str | os.PathLike[str] | None = None,
        transfer: tuple[str | os.PathLike[str], str | os.PathLike[str]] | None = None,
        distance: Quantity = 7.5,
        height: Quantity = 1.2,
        rail_foot: Quantity = 0.15,
        sleeper_area: Quantity = 0.33,
        limit: str = "iso-3095-2013",
        traffic: Traffic | None = None,
        months: float = 12.0,
        limit_dba: float | None = None,
    ) -> dict[str, Any]:
        """Rolling noise of a train on a rail of some roughness, what makes it, and what would lower it.

        Parameters
        ----------
        spectrum : DataArray
            One-third-octave levels of the rail in dB re 1 µm over ``wavelength``, as `riffel.roughness.spectrum` gives them.
        speed : quantity
            Speed of the train.
        wheels : int
            Wheels of the train on one rail.
        train_length : quantity, optional
            Length of the train; by default 6.6 m for each wheel.
        wheel_roughness : str or DataArray, optional
            Roughness of the wheels: a table by name, such as ``"cnossos-disc-brakes"``, or levels; by default smooth.
        wheel_modes : str or path, optional
            Modes of the web and tyre of the wheels: ``"straight-web-920"``, or a TOML file; by default rigid wheels.
        decay_rate : path, optional
            Measured decay rates of the track, in place of those of the case.
        transfer : pair of str or path, optional
            Transfer functions of track and vehicle, for the level by the directive as well.
        distance, height : quantity
            Of the receiver from the middle of the track and above the rail.
        rail_foot, sleeper_area : quantity
            Breadth of the rail foot, and the face of a sleeper that belongs to one rail.
        limit : str
            Limit of the levels of roughness to which the rail may be ground, by name or as a TOML file.
        traffic : path or mapping, optional
            A traffic file or its keys, for the level in months to come.
        months : float
            How far to look ahead under `traffic`.
        limit_dba : float, optional
            Highest level allowed, to say in how many months it is reached under `traffic`.

        Returns
        -------
        dict
            With the keys of ``riffel noise --json``: ``frequency_hz``, ``level`` of rail, sleepers, wheel and all of it,
            ``measures``, ``course`` under traffic and ``remarks``.

        Raises
        ------
        ValueError
            For a value that is not allowed, or a spectrum that fills no band between 100 Hz and 5 kHz at the speed.

        Examples
        --------
        >>> case = riffel.Case.from_toml("cases/main-line.toml")
        >>> wavelengths = [0.02, 0.025, 0.0315, 0.04, 0.05, 0.063, 0.08, 0.1]
        >>> rough = riffel.roughness.levels(wavelengths, [10.0] * 8)
        >>> smooth = riffel.roughness.levels(wavelengths, [0.0] * 8)
        >>> loud, quiet = (case.noise(rail, speed="136 km/h")["level"] for rail in (rough, smooth))
        >>> round(loud["total_dba"] - quiet["total_dba"], 6)
        10.0
        """
        rails = (scalar(rail_foot, "rail_foot", "length"), scalar(sleeper_area, "sleeper_area", "area"))
        least = -np.finfo(np.float64).tiny
        train = (
            wheels,
            None if train_length is None else scalar(train_length, "train_length", "length"),
            scalar(distance, "distance", "length"),
            scalar(height, "height", "length", least=least),
        )
        if isinstance(wheels, bool) or not isinstance(wheels, (int, np.integer)) or wheels < 1:
            raise ValueError(f"wheels is {wheels!r}, but must be a whole number of at least 1")
        if limit_dba is not None and traffic is None:
            raise ValueError("limit_dba needs traffic, under which the level changes")
        return _riffel.noise(
            self._case,
            levels_of(spectrum, "spectrum"),
            scalar(speed, "speed", "speed"),
            train,
            levels_of(wheel_roughness, "wheel_roughness")
            if isinstance(wheel_roughness, xr.DataArray)
            else wheel_roughness,
            None if wheel_modes is None else os.fspath(wheel_modes),
            None if decay_rate is None else os.fspath(decay_rate),
            None if transfer is None else (os.fspath(transfer[0]), os.fspath(transfer[1])),
            rails,
            limit,
            None if traffic is None else file_or_keys(traffic),
            (months, limit_dba),
        )

    def _window(self, name: str, value: Quantities | None) -> Floats:
        if name == "wavelength":
            return self._case.wavelengths() if value is None else array(value, name, "length")
        return self._case.speeds() if value is None else array(value, name, "speed")


def _restored(portable: _riffel.PortableCase, given: dict[str, Any]) -> Case:
    """A pickled case."""
    return Case(_riffel.Case.restore(portable, given.get("track"), given.get("wheel")), given)

"""How a case grows: points, maps and ridges."""

from __future__ import annotations

import numpy as np
import xarray as xr

from riffel import _datasets, _growth, _points, _riffel
from riffel._case.keys import KeysOfCase
from riffel._quantities import Floats, Quantities, Quantity, array, is_scalar, scalar, spaced


class GrowthOfCase(KeysOfCase):
    """Growth over wavelength and speed."""

    __slots__ = ()

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

    def _window(self, name: str, value: Quantities | None) -> Floats:
        if name == "wavelength":
            return self._case.wavelengths() if value is None else array(value, name, "length")
        return self._case.speeds() if value is None else array(value, name, "speed")

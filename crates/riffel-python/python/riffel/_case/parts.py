"""What a loop is made of: track, wheel, contact and its curve."""

from __future__ import annotations

from typing import Any

import xarray as xr

from riffel import _contact, _riffel, _track, _vehicle_in_curve
from riffel._case.keys import KeysOfCase, Overrides
from riffel._quantities import Quantities, Quantity, array, scalar, signed


class PartsOfCase(KeysOfCase):
    """Track, wheel, contact and curve."""

    __slots__ = ()

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
        radii = None if radius is None else signed(radius, "radius", "length")
        return _vehicle_in_curve.curve(_riffel.CurvingCase(self._case, dict(overrides or {})), radii)

"""Wheels of a case that are followed through time."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import xarray as xr

from riffel import _passage, _riffel
from riffel._case.keys import KeysOfCase
from riffel._quantities import Quantity, scalar
from riffel._traffic import Traffic, traffic_or_speed


class CaseInTime(KeysOfCase):
    """Motion and wear in time."""

    __slots__ = ()

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
            _riffel.Traffic(self._case, traffic_or_speed(traffic, speed, speed_deviation)),
            int(passages),
            None if step is None else scalar(step, "step", "length"),
            contact_filter,
            self.title,
        )

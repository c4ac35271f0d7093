"""The keys of a case: read, changed and taken along."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

import xarray as xr

from riffel import _riffel
from riffel._receptance import GivenReceptance, checked_receptance
from riffel._traffic import plain_keys

if TYPE_CHECKING:
    from typing_extensions import Self

Overrides: TypeAlias = "Mapping[str, Any]"
"""Values by dotted key, as in ``{"contact.friction": 0.3}``."""


class KeysOfCase:
    """A case by its keys, checked and complete."""

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
    def from_toml(cls, path: str | os.PathLike[str], overrides: Overrides | None = None) -> Self:
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
    def parse(cls, text: str, overrides: Overrides | None = None, *, name: str = "case") -> Self:
        """Read a case from TOML; `name` is shown in errors. Otherwise as `from_toml`."""
        return cls(_riffel.Case.parse(text, name, dict(overrides or {})))

    @classmethod
    def from_dict(cls, keys: Mapping[str, Any]) -> Self:
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

    def with_(self, overrides: Overrides | None = None, /, **more: Any) -> Self:
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
        return type(self)(self._case.with_overrides({**(overrides or {}), **more}), self._given)

    def with_track(self, receptance: GivenReceptance) -> Self:
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
        return type(self)(self._case.with_track(track), {**self._given, "track": track})

    def with_wheel(self, receptance: GivenReceptance) -> Self:
        """The case under a wheel of the receptance given; its rotation stays that of the case.

        Otherwise as `with_track`.
        """
        wheel = checked_receptance(receptance, "receptance")
        return type(self)(self._case.with_wheel(wheel), {**self._given, "wheel": wheel})

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
        return _restored, (type(self), self._case.portable(), self._given)

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        # It does not change.
        return self

    def __repr__(self) -> str:
        return f"<riffel.Case {self.title or 'without title'!r}>"


def _restored(kind: type[KeysOfCase], portable: _riffel.PortableCase, given: dict[str, Any]) -> KeysOfCase:
    """A pickled case."""
    return kind(_riffel.Case.restore(portable, given.get("track"), given.get("wheel")), given)

"""What was measured on a line, held against its case."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr

from riffel._ask import ask
from riffel._axlebox import AxleBoxRun, run_in_question
from riffel._case.keys import KeysOfCase
from riffel._quantities import Quantities, Quantity, array
from riffel._records import Date, RailRecord, record_in_question
from riffel._speeds import Speeds, ranges
from riffel._traffic import Traffic


class MeasuredOnCase(KeysOfCase):
    """Records of a line, held against its case."""

    __slots__ = ()

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
            default those of the usual traffic of the line.
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
        if traffic is not None and speed is not None:
            raise ValueError("traffic and speed exclude each other: give one of the two")
        if isinstance(earlier, (str, os.PathLike)):
            raise ValueError(f"earlier is {os.fspath(earlier)!r}, but must be a sequence of records, the oldest first")
        records = [record_in_question(record, f"earlier[{index}]", spacing) for index, record in enumerate(earlier)]
        question = {
            "case": self,
            "roughness": record_in_question(rail, "rail", spacing),
            "earlier": records,
            "dates": dates,
            "traffic": traffic,
            "speed": None if speed is None else ranges(speed),
            "torsion": _modes(torsion, "torsion"),
            "bending": _modes(bending, "bending"),
            "where": [f"{column}={value}" for column, value in (where or {}).items()],
            "by": by,
            "spacing": spacing,
            "format": format,
            "height_unit": height_unit,
            "position_unit": position_unit,
            "from_vehicle": from_vehicle,
            "keep_defects": keep_defects,
        }
        found: dict[str, Any] = ask("diagnose", question)
        return found

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
            ``defects`` and ``grind``, ``wheels`` that are not round, and ``remarks``.

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
        given = run_in_question(run, rate, speed, odometer)
        of_files = {"rate": rate, "speed": speed} if isinstance(given, list) else {}
        question = {
            "file": given,
            "case": self,
            "channels": channels,
            "shortest": shortest,
            "longest": longest,
            "slowest": slowest,
            "contact_filter": bool(contact_filter),
            "keep_defects": bool(keep_defects),
            "limit": limit,
            "block": block,
            **of_files,
        }
        found: dict[str, Any] = ask("axlebox", question)
        return found

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
        earlier: Sequence[xr.DataArray] = (),
        dates: Sequence[Date] = (),
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
        earlier : sequence of DataArray, optional
            Levels of the same rail before, the oldest first, by which it goes on growing under `traffic`.
        dates : sequence of date or str, optional
            Dates of `earlier` and, last, of `spectrum`.
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
        track_transfer, vehicle_transfer = transfer or (None, None)
        question = {
            "case": self,
            "roughness": spectrum,
            "speed": speed,
            "wheels": wheels,
            "train_length": train_length,
            "wheel_roughness": wheel_roughness,
            "wheel_modes": wheel_modes,
            "decay_rate": decay_rate,
            "track_transfer": track_transfer,
            "vehicle_transfer": vehicle_transfer,
            "distance": distance,
            "height": height,
            "rail_foot": rail_foot,
            "sleeper_area": sleeper_area,
            "limit": limit,
            "earlier": earlier,
            "dates": dates,
            "traffic": traffic,
            "months": months if traffic is not None else None,
            "limit_dba": limit_dba,
        }
        found: dict[str, Any] = ask("noise", question)
        return found


def _modes(frequencies: Quantities, name: str) -> list[float]:
    if isinstance(frequencies, (Sequence, np.ndarray)) and len(frequencies) == 0:
        return []
    modes: list[float] = array(frequencies, name, "frequency").tolist()
    return modes

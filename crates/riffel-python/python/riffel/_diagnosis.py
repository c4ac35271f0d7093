"""What may have made the wavelengths that stand out of a rail."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from riffel import _riffel
from riffel._layout import layout
from riffel._quantities import Quantities, Quantity, array
from riffel._records import Date, RailRecord, checked_dates, checked_record
from riffel._speeds import Speeds, ranges


def diagnose(
    case: _riffel.Case,
    rail: RailRecord,
    *,
    spacing: Quantity | None,
    earlier: Sequence[RailRecord],
    dates: Sequence[Date],
    traffic: str | dict[str, Any] | None,
    speed: Speeds | None,
    torsion: Quantities,
    bending: Quantities,
    where: Mapping[str, str] | None,
    by: str | None,
    format: str | os.PathLike[str] | None,
    height_unit: str | None,
    position_unit: str | None,
    from_vehicle: bool,
    keep_defects: bool,
) -> dict[str, Any]:
    """Check what a user gave and ask the extension; see `Case.diagnose`."""
    if traffic is not None and speed is not None:
        raise ValueError("traffic and speed exclude each other: give one of the two")
    if isinstance(earlier, (str, os.PathLike)):
        raise ValueError(f"earlier is {os.fspath(earlier)!r}, but must be a sequence of records, the oldest first")
    dated = checked_dates(dates, len(earlier) + 1)
    records = [
        *(checked_record(record, f"earlier[{index}]", spacing) for index, record in enumerate(earlier)),
        checked_record(rail, "rail", spacing),
    ]
    *before, present = [(name, date, given) for (name, given), date in zip(records, dated, strict=True)]
    found = _riffel.diagnose(
        case,
        present,
        before,
        layout(format, spacing, height_unit, position_unit),
        traffic if speed is None else ranges(speed),
        _modes(torsion, "torsion"),
        _modes(bending, "bending"),
        [f"{column}={value}" for column, value in (where or {}).items()],
        by,
        from_vehicle,
        keep_defects,
    )
    return found


def _modes(frequencies: Quantities, name: str) -> list[float]:
    if isinstance(frequencies, (Sequence, np.ndarray)) and len(frequencies) == 0:
        return []
    modes: list[float] = array(frequencies, name, "frequency").tolist()
    return modes

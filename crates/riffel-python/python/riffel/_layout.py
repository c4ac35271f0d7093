"""How files of roughness are laid out."""

from __future__ import annotations

import os
from typing import TypeAlias

from riffel._quantities import Quantity, scalar

Layout: TypeAlias = tuple[str | None, float | None, str | None, str | None]
"""Reader profile, step in m, units of heights and positions."""


def layout(
    format: str | os.PathLike[str] | None,
    spacing: Quantity | None,
    height_unit: str | None,
    position_unit: str | None,
) -> Layout:
    """What a user says of the layout, as the extension takes it."""
    step = None if spacing is None else scalar(spacing, "spacing", "length")
    return None if format is None else os.fspath(format), step, height_unit, position_unit

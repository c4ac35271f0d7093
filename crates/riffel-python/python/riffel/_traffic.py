"""Traffic, as users give it: a file, its keys, or speeds of the wheel of a case."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, TypeAlias


from riffel._quantities import OR_ZERO, Quantity, scalar

Traffic: TypeAlias = "str | os.PathLike[str] | Mapping[str, Any]"
"""A traffic file, or its keys."""


def traffic_or_speed(
    traffic: Traffic | None, speed: Quantity | None, deviation: Quantity | None
) -> str | dict[str, Any] | tuple[float, float] | None:
    """The traffic, or mean and standard deviation of the speed; nothing where neither is given."""
    if traffic is not None:
        if speed is not None or deviation is not None:
            raise ValueError("traffic and speed exclude each other: give one of the two")
        return file_or_keys(traffic)
    if speed is None:
        if deviation is not None:
            raise ValueError("speed_deviation needs speed, about which speeds scatter")
        return None
    scatter = 0.0 if deviation is None else scalar(deviation, "speed_deviation", "speed", least=OR_ZERO)
    return scalar(speed, "speed", "speed"), scatter


def file_or_keys(given: str | os.PathLike[str] | Mapping[str, Any]) -> str | dict[str, Any]:
    """The name of a file, or its keys in its place."""
    return plain_keys(given) if isinstance(given, Mapping) else os.fspath(given)


def plain_keys(keys: Mapping[str, Any]) -> dict[str, Any]:
    """Mappings of any kind as dicts, all the way down."""
    return {key: plain_keys(value) if isinstance(value, Mapping) else value for key, value in keys.items()}

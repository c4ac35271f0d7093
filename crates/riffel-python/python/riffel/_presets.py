"""Presets with their sources."""

from __future__ import annotations

from typing import Any

from riffel._ask import ask


def presets() -> list[dict[str, Any]]:
    """Every preset: kind, name, title, and its values as written and in SI, with their sources."""
    found: list[dict[str, Any]] = ask("presets", {})
    return found

"""Riffel predicts rail corrugation: which wavelengths grow on a track under traffic, how fast, and why.

A `Case` is one wheel on one track. Its methods return `xarray` objects in SI, with units and long names in
their attributes. Quantities are numbers in SI or strings with their unit, as in the case file.

>>> import riffel
>>> case = riffel.Case.from_toml("cases/nominal.toml")
>>> growth = case.growth_map()
>>> growth.sizes
Frozen({'speed': 221, 'wavelength': 241})
>>> case.with_({"contact.friction": 0.3}).point(wavelength="55 mm", speed="108 km/h")["frequency_hz"]
545.4545454545455

Conventions: time factor exp(+i omega t); receptances in m/N, positive downward; braking positive; corrugation grows
where the real part of the normalised dissipation is negative, and where the growth rate is positive.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from riffel import roughness
    from riffel._ask import ask
    from riffel._calibration import LogPosterior, calibrate, decide, draws
    from riffel._case import Case
    from riffel._curving import contact_geometry, contact_under_load, curve
    from riffel._matlab import to_matlab
    from riffel._models import compare_models
    from riffel._network import Network
    from riffel._profile import profile, profile_wear
    from riffel._presets import presets
    from riffel._receptance import receptance_from_uff
    from riffel._riffel import VERSION as __version__
    from riffel._riffel import ConvergenceError, ReceptanceError
    from riffel._study import Study, merge_studies, open_results, study_summary
    from riffel._wheels import wheels_of_curve

__all__ = [
    "Case",
    "ConvergenceError",
    "LogPosterior",
    "Network",
    "ReceptanceError",
    "Study",
    "__version__",
    "ask",
    "calibrate",
    "compare_models",
    "contact_geometry",
    "contact_under_load",
    "curve",
    "decide",
    "draws",
    "merge_studies",
    "open_results",
    "presets",
    "profile",
    "profile_wear",
    "receptance_from_uff",
    "roughness",
    "study_summary",
    "to_matlab",
    "wheels_of_curve",
]

# Where a name is, which loads its module when it is first asked for: the program is imported with this package and
# must not wait for NumPy and xarray.
_HOMES = {
    "Case": "riffel._case",
    "ConvergenceError": "riffel._riffel",
    "LogPosterior": "riffel._calibration",
    "Network": "riffel._network",
    "ReceptanceError": "riffel._riffel",
    "Study": "riffel._study",
    "ask": "riffel._ask",
    "calibrate": "riffel._calibration",
    "compare_models": "riffel._models",
    "contact_geometry": "riffel._curving",
    "contact_under_load": "riffel._curving",
    "curve": "riffel._curving",
    "decide": "riffel._calibration",
    "draws": "riffel._calibration",
    "merge_studies": "riffel._study",
    "open_results": "riffel._study",
    "presets": "riffel._presets",
    "profile": "riffel._profile",
    "profile_wear": "riffel._profile",
    "receptance_from_uff": "riffel._receptance",
    "study_summary": "riffel._study",
    "to_matlab": "riffel._matlab",
    "wheels_of_curve": "riffel._wheels",
}

if not TYPE_CHECKING:  # a type checker shall see wrong names

    def __getattr__(name: str) -> object:
        if name == "roughness":
            return importlib.import_module("riffel.roughness")
        if name == "__version__":
            return importlib.import_module("riffel._riffel").VERSION
        if name in _HOMES:
            return getattr(importlib.import_module(_HOMES[name]), name)
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})

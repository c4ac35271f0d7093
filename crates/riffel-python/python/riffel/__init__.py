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

from riffel import roughness
from riffel._case import Case
from riffel._matlab import to_matlab
from riffel._receptance import receptance_from_uff
from riffel._riffel import VERSION as __version__
from riffel._riffel import ConvergenceError, ReceptanceError, presets
from riffel._study import Study, merge_studies, open_results, study_summary

__all__ = [
    "Case",
    "ConvergenceError",
    "ReceptanceError",
    "Study",
    "__version__",
    "merge_studies",
    "open_results",
    "presets",
    "receptance_from_uff",
    "roughness",
    "study_summary",
    "to_matlab",
]

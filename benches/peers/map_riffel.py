"""The growth map of Riffel from Python: the same core behind `riffel.Case.growth_map`.

Reads lines "map TRACK N" from standard input, computes the N x N map of the nominal case and answers each with the seconds
it took and the sum of Re W1/(mu P0 V xi0).
"""

import pathlib
import sys
import time

import riffel

nominal = riffel.Case.from_toml(pathlib.Path(__file__).parents[2] / "cases" / "nominal.toml")
cases = {}

for line in sys.stdin:
    points = int(line.split()[-1])
    if points not in cases:
        wavelength = {"min": "20 mm", "max": "80 mm", "points": points}
        cases[points] = nominal.with_({"map.wavelength": wavelength, "map.speed": {"min": 5, "max": 60, "points": points}})
    begun = time.perf_counter()
    growth = cases[points].growth_map()
    seconds = time.perf_counter() - begun
    print(seconds, float(growth["normalized_dissipation"].values.real.sum()), flush=True)
    del growth

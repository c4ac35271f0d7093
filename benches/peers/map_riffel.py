"""The growth map of Riffel from Python: the same core behind `riffel.Case.growth_map`.

Reads lines "map TRACK N" from standard input, computes the N x N map of the nominal case and answers each with the seconds
it took and the sum of Re W1/(mu P0 V xi0).
"""

import pathlib
import sys
import time

import numpy as np

import riffel

case = riffel.Case.from_toml(pathlib.Path(__file__).parents[2] / "cases" / "nominal.toml")

for line in sys.stdin:
    points = int(line.split()[-1])
    wavelength, speed = np.linspace(0.020, 0.080, points), np.linspace(5.0, 60.0, points)
    begun = time.perf_counter()
    growth = case.growth_map(wavelength=wavelength, speed=speed)
    seconds = time.perf_counter() - begun
    print(seconds, float(growth["normalized_dissipation"].values.real.sum()), flush=True)
    del growth

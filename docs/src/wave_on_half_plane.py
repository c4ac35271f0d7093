"""A wheel that slides over a wavy rail wears crests more than troughs, though load and slip speed are constant.

A cylinder of radius R on an elastic half-plane is pressed by a constant force onto r(x) = D cos kx. At each place of the wheel the
pressure is solved for the true gap (X - x)^2/2R - r(X). A point of the rail that slides receives the energy mu s p dt: a metre of it
mu (s/V) times the integral of p over the places of the wheel. No formula of the theory goes in; it is printed beside the result,
e1/e0 = R k^2 Phi D with Phi = 2 (J0^2 + J1^2) - 2 J0 J1/z of a half-plane, z = ka. Needs numpy and scipy.
"""

import numpy as np
from scipy.special import j0, j1

RADIUS, HALF_WIDTH = 0.46, 6e-3  # wheel, flat contact [m]
ELEMENTS = 160  # over 2.4 half-widths
STEP = 2.4 * HALF_WIDTH / ELEMENTS
PLACES = (np.arange(ELEMENTS) - (ELEMENTS - 1) / 2) * STEP


def displacement():
    """Displacement of each element by the pressure 2 p/(pi E*) on another, -ln|x| over its length, to a constant."""

    def integral(x):
        return x * np.log(np.abs(x))

    apart = np.subtract.outer(PLACES, PLACES)
    return integral(apart - STEP / 2) - integral(apart + STEP / 2)


def pressure(gap, matrix, load):
    """Pressure of a given sum that closes the gap wherever it presses: what pulls is taken out, until nothing does."""
    inside = np.ones(len(gap), bool)
    while True:
        size = inside.sum()
        system = np.zeros((size + 1, size + 1))
        system[:size, :size] = matrix[np.ix_(inside, inside)]
        system[:size, size], system[size, :size] = -1.0, STEP
        solved = np.linalg.solve(system, np.append(-gap[inside], load))[:size]
        if (solved >= 0).all():
            result = np.zeros(len(gap))
            result[inside] = solved
            return result
        inside[inside] = solved > 0


def weight(wavelength, curvature=0.05, places=96):
    """e1/(e0 kappa), relative to cos kx, of a wave with R k^2 D = kappa."""
    k = 2 * np.pi / wavelength
    amplitude = curvature / (RADIUS * k * k)
    matrix = displacement()
    load = HALF_WIDTH**2 / (2 * RADIUS)  # of 2 p/(pi E*): the flat contact has the half-width
    first, total = 0.0, 0.0
    for x in wavelength / places * np.arange(places):
        rail = x - RADIUS * amplitude * k * np.sin(k * x) + PLACES  # elements around where the wheel touches
        gap = (rail - x) ** 2 / (2 * RADIUS) - amplitude * np.cos(k * rail)
        p = pressure(gap, matrix, load)
        first += (p * np.exp(-1j * k * rail)).sum()
        total += p.sum()
    return 2 * first / total / curvature


if __name__ == "__main__":
    for millimetres in (20, 30, 40, 55.7, 80, 120):
        z = 2 * np.pi / (1e-3 * millimetres) * HALF_WIDTH
        theory = 2 * (j0(z) ** 2 + j1(z) ** 2) - 2 * j0(z) * j1(z) / z
        found = weight(1e-3 * millimetres)
        print(f"{millimetres:5} mm: {found.real:.4f} {found.imag:+.4f}i, theory {theory:.4f}")

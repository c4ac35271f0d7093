"""The equations of the loop on all axes in vectorised NumPy: a peer of the benchmark.

Reads lines "VARIANT N" from standard input, solves the loop of one wheel or of eight on N x N wavelengths and speeds, all
points in one batch, receptances at hand, and answers each with the seconds it took and the sum of Re W1/(mu P0 V |xi0|),
by which both sides are compared.
"""

import sys
import time

import numpy as np

STIFFNESS, AMPLITUDE, FULL_SLIP = 1e9, 1e-5, 0.4 * 50e3 * np.hypot(1e-3, 5e-4)
FORCE_BY_LOAD = np.array([0.08, 0.04])
FORCE_BY_CREEPAGE = np.array([[4e6, -5e5], [-5e5, 5e6]])
ENERGY_BY_LOAD, ENERGY_BY_CREEPAGE = 1e-4, np.array([9e3, 5e3])


def solved(wheels, n):
    """Unknowns Q_x, Q_y, P of each wheel; rows as in the theory."""
    size = 3 * wheels
    wavelength, speed = (axis.ravel() for axis in np.meshgrid(np.linspace(0.020, 0.080, n), np.linspace(5.0, 60.0, n)))
    wavenumber = 2 * np.pi / wavelength
    distance = np.abs(np.subtract.outer(np.arange(size), np.arange(size)))
    at_hand = np.where(distance == 0, 2e-9 - 0.5e-9j, (0.3e-9 - 0.06e-9j) / (1 + distance))
    receptance = at_hand * (3000.0 / (wavenumber * speed))[:, None, None]
    tangential = np.arange(size).reshape(wheels, 3)[:, :2]
    normal = np.arange(2, size, 3)
    creepage = -1j * wavenumber[:, None, None, None] * receptance[:, tangential]
    matrix = np.empty_like(receptance)
    matrix[:, tangential] = -(FORCE_BY_CREEPAGE @ creepage)
    matrix[:, normal] = receptance[:, normal]
    matrix[:, tangential, tangential] += 1
    matrix[:, tangential, normal[:, None]] -= FORCE_BY_LOAD
    matrix[:, normal, normal] += 1 / STIFFNESS
    phase = np.exp(-1j * wavenumber[:, None] * 2.5 * np.arange(wheels))
    right = np.zeros((wavelength.size, size, 1), complex)
    right[:, normal, 0] = AMPLITUDE * phase
    force = np.linalg.solve(matrix, right)
    energy = ENERGY_BY_LOAD * force[:, normal, 0] + (creepage @ force[:, None])[..., 0] @ ENERGY_BY_CREEPAGE
    return (energy / phase).mean(axis=1) / FULL_SLIP


WHEELS = {"one-wheel": 1, "eight-wheels": 8}

for line in sys.stdin:
    variant, n = line.split()
    begun = time.perf_counter()
    values = solved(WHEELS[variant], int(n))
    elapsed = time.perf_counter() - begun
    print(elapsed, values.real.sum(), flush=True)

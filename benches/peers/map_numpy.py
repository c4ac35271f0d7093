"""The growth map of Riffel's nominal case in vectorised NumPy: the peer of the benchmark.

Reads lines "VARIANT N" from standard input, computes the N x N map (free beam, rigid wheel, paper's creep law, phase
lag) and answers each with the seconds it took and the sum of Re W1/(mu P0 V xi0), by which both sides are compared.
"""

import sys
import time

import numpy as np

E, NU = 207e9, 0.3
R, R_R, M_W = 0.46, 0.23, 350.0
M_RAIL, I_RAIL = 56.0, 2.35e-5
P0, MU, TAU, DELTA = 50e3, 0.4, 0.1, 31.5e-6

G = E / (2 * (1 + NU))
I_W = 0.75 * M_W * R**2 / 2
R_E = np.sqrt(R * R_R)
A0 = (3 * (1 - NU) * R * R_E * P0 / (4 * G * R_R)) ** (1 / 3)
K_H = (6 * G**2 * P0 * R_E / (1 - NU) ** 2) ** (1 / 3)
C00 = 2.84 + 1.2 * (R / R_R) ** (2 / 3)
XI_MAX = 3 * MU / C00 * (16 * P0 / (9 * (1 - NU) ** 2 * R_E**2 * G)) ** (1 / 3)
XI0 = XI_MAX * (1 - (1 - TAU) ** (1 / 3))
X = XI0 / XI_MAX


def as_written(n):
    """The equations as the paper prints them, on the full grid."""
    wavelength, speed = np.meshgrid(np.linspace(0.020, 0.080, n), np.linspace(5.0, 60.0, n))
    omega = 2 * np.pi * speed / wavelength
    h_rail = np.exp(-0.75j * np.pi) / (2 * np.sqrt(2) * (M_RAIL**3 * E * I_RAIL) ** 0.25 * omega**1.5)  # (23)
    h_wheel = -1 / (M_W * omega**2)  # (25)
    p1 = DELTA / (h_rail + h_wheel + 1 / K_H)  # (24)
    q_p = 2 * MU * X * (1 - X / 2)  # (9)
    q_omega = -3 * MU * R * P0 / (speed * XI_MAX) * (1 - X) ** 2  # (10)
    w_omega = -6 * MU * P0 * R * X * (1 - 1.5 * X * (1 - 4 / 9 * X))  # (12)
    w1 = q_p * (speed * XI0 + w_omega / (1j * omega * I_W / R - q_omega)) * p1  # (19)
    theta = 2 * np.pi * A0 / wavelength * (1 - TAU / 2)
    return w1 * np.exp(-1j * theta) / (MU * P0 * speed * XI0)  # (20)


def tuned(n):
    """The same with what depends on one axis kept one-dimensional, and square roots for powers."""
    wavelength = np.linspace(0.020, 0.080, n)
    speed = np.linspace(5.0, 60.0, n)[:, None]
    omega = 2 * np.pi * speed / wavelength
    h_rail = np.exp(-0.75j * np.pi) / (2 * np.sqrt(2) * (M_RAIL**3 * E * I_RAIL) ** 0.25 * (omega * np.sqrt(omega)))
    p1 = DELTA / (h_rail - 1 / (M_W * omega**2) + 1 / K_H)
    q_p = 2 * MU * X * (1 - X / 2)
    q_omega = -3 * MU * R * P0 / (speed * XI_MAX) * (1 - X) ** 2
    w_omega = -6 * MU * P0 * R * X * (1 - 1.5 * X * (1 - 4 / 9 * X))
    w1 = q_p * (speed * XI0 + w_omega / (1j * omega * I_W / R - q_omega)) * p1
    lag = np.exp(-1j * (2 * np.pi * A0 / wavelength) * (1 - TAU / 2))
    return w1 * lag / (MU * P0 * speed * XI0)


VARIANTS = {"as-written": as_written, "tuned": tuned}

for line in sys.stdin:
    variant, n = line.split()
    begun = time.perf_counter()
    values = VARIANTS[variant](int(n))
    elapsed = time.perf_counter() - begun
    print(elapsed, values.real.sum(), flush=True)

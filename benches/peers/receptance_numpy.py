"""The receptance of a rail on discrete two-layer supports in vectorised NumPy: a peer of the benchmark.

Reads lines "VARIANT N" from standard input, computes the receptance at mid-span at N frequencies spaced evenly in
logarithm from 20 Hz to 3000 Hz (infinite Timoshenko beam, motion like exp(+i omega t)) and answers each with the mean
of the seconds it took and the sum of |H|, by which both sides are compared.
"""

import sys
import time

import numpy as np

REPEATS = 5

# UIC 60 on stiff pads: validation/reference/receptance/uic60_stiff_pad.json
E, G, ETA = 210e9, 80.769e9, 0.02
AREA, INERTIA, KAPPA = 7.67e-3, 3.037e-5, 0.393
MASS, DENSITY = 60.2, 7850.0
SPACING = 0.6
K_PAD, C_PAD = 800e6, 30e3
M_SLEEPER = 162.0
K_BALLAST, C_BALLAST = 100e6, 60e3

BENDING = E * (1 + 1j * ETA) * INERTIA
SHEARING = KAPPA * G * (1 + 1j * ETA) * AREA
UNIT = BENDING / SPACING**3  # stiffness in which forces are counted; lengths are counted in bays
SHEAR = BENDING / (SHEARING * SPACING**2)


def inertias(omega):
    """Translational and rotary inertia of a bay, without dimension."""
    square = omega**2
    return MASS * SPACING / UNIT * square, DENSITY * INERTIA / (UNIT * SPACING) * square


def support(omega):
    """Dynamic stiffness of a support: the pad in series with sleeper and ballast."""
    pad = K_PAD + 1j * omega * C_PAD
    below_pad = K_BALLAST + 1j * omega * C_BALLAST - omega**2 * M_SLEEPER
    return pad * below_pad / (pad + below_pad) / UNIT


def as_written(frequency):
    """Matrices of half a bay, a support, half a bay for (w, phi, M, Q); Floquet waves by eig, load by solve."""
    omega = 2 * np.pi * frequency
    inertia, rotary = inertias(omega)
    a = np.zeros((omega.size, 4, 4), complex)  # y' = A y
    a[:, 0, 1], a[:, 0, 3] = 1, SHEAR
    a[:, 1, 2] = 1
    a[:, 2, 1], a[:, 2, 3] = -rotary, -1
    a[:, 3, 0] = -inertia
    # exp(A/2) = c0 + c1 A + c2 A^2 + c3 A^3 by Cayley and Hamilton
    mean = -(rotary + inertia * SHEAR) / 2
    root = np.sqrt(((rotary - inertia * SHEAR) / 2) ** 2 + inertia)
    first, second = mean + root, mean - root
    p, q = np.sqrt(first), np.sqrt(second)
    cosh_p, cosh_q = np.cosh(p / 2), np.cosh(q / 2)
    sinh_p, sinh_q = np.sinh(p / 2) / p, np.sinh(q / 2) / q
    c2, c3 = (cosh_p - cosh_q) / (2 * root), (sinh_p - sinh_q) / (2 * root)
    c0, c1 = cosh_p - c2 * first, sinh_p - c3 * first
    c0, c1, c2, c3 = (c[:, None, None] for c in (c0, c1, c2, c3))
    square = a @ a
    half = c0 * np.eye(4) + c1 * a + c2 * square + c3 * (square @ a)
    across = np.tile(np.eye(4, dtype=complex), (omega.size, 1, 1))
    across[:, 3, 0] = support(omega)
    multipliers, waves = np.linalg.eig(half @ across @ half)  # from mid-span to mid-span
    order = np.argsort(np.abs(multipliers), axis=1)
    waves = np.take_along_axis(waves, order[:, None, :], axis=2)
    waves[:, :, 2:] *= -1  # the two that decay to the right less the two that decay to the left
    load = np.zeros((omega.size, 4, 1), complex)
    load[:, 3] = -1
    amplitudes = np.linalg.solve(waves, load)[:, :, 0]
    return (waves[:, 0, :2] * amplitudes[:, :2]).sum(axis=1) / UNIT


def tuned(frequency):
    """The same without matrices: the bay is symmetric, which leaves two roots for the Floquet waves.

    The block of the bay's matrix that takes the even (w, M) to themselves has the cosines (mu + 1/mu)/2 as eigenvalues;
    the state at the load is a function of that 2 x 2 block, hence a polynomial of degree one.
    """
    omega = 2 * np.pi * frequency
    inertia, rotary = inertias(omega)
    stiffness = support(omega)
    shear_inertia = SHEAR * inertia
    mean = (rotary + shear_inertia) / -2
    half_difference = (rotary - shear_inertia) / 2
    root = np.sqrt(half_difference * half_difference + inertia)
    first, double_root = mean + root, 2 * root
    p, q = np.sqrt(first), np.sqrt(mean - root)
    # Half a bay by exponentials, the whole bay by the double angle
    exp_p, exp_q = np.exp(p / 2), np.exp(q / 2)
    inverse_p, inverse_q = 1 / exp_p, 1 / exp_q
    cosh_p, cosh_q = (exp_p + inverse_p) / 2, (exp_q + inverse_q) / 2
    sinh_p, sinh_q = (exp_p - inverse_p) / (2 * p), (exp_q - inverse_q) / (2 * q)
    h2, h3 = (cosh_p - cosh_q) / double_root, (sinh_p - sinh_q) / double_root
    h0, h1 = cosh_p - h2 * first, sinh_p - h3 * first
    sinh_p, sinh_q = 2 * sinh_p * cosh_p, 2 * sinh_q * cosh_q
    cosh_p, cosh_q = 2 * cosh_p * cosh_p - 1, 2 * cosh_q * cosh_q - 1
    c2, c3 = (cosh_p - cosh_q) / double_root, (sinh_p - sinh_q) / double_root
    c0, c1 = cosh_p - c2 * first, sinh_p - c3 * first
    # Entries of A^3 from Q to w and M; half a bay from Q to w and M, and from w and M to w
    q_w, q_m = -SHEAR * shear_inertia - 1, shear_inertia + rotary
    to_w, to_m = SHEAR * h1 + q_w * h3, q_m * h3 - h1
    from_w = h0 - shear_inertia * h2
    push_w, push_m = stiffness * to_w, stiffness * to_m
    ww, wm = c0 - shear_inertia * c2 + push_w * from_w, c2 + push_w * h2
    mw, mm = inertia * c2 + push_m * from_w, c0 - rotary * c2 + push_m * h2
    load_w = (SHEAR * c1 + q_w * c3 + push_w * to_w) / -2
    load_m = (q_m * c3 - c1 + push_m * to_w) / -2
    mean = (ww + mm) / 2
    half_difference = (ww - mm) / 2
    root = np.sqrt(half_difference * half_difference + wm * mw)
    one, two = mean + root, mean - root
    inverse_one, inverse_two = inverse_sine(one), inverse_sine(two)
    slope = (inverse_one - inverse_two) / (2 * root)
    return ((inverse_one - slope * one + slope * ww) * load_w + slope * wm * load_m) / UNIT


def inverse_sine(cosine):
    """2/(mu - 1/mu) for the multiplier of modulus below one that has this cosine."""
    sine = np.sqrt(cosine - 1) * np.sqrt(cosine + 1)
    return np.where(np.abs(cosine + sine) < 1, 1, -1) / sine


VARIANTS = {"as-written": as_written, "tuned": tuned}

for line in sys.stdin:
    variant, n = line.split()
    frequency = np.geomspace(20.0, 3000.0, int(n))
    begun = time.perf_counter()
    for _ in range(REPEATS):
        values = VARIANTS[variant](frequency)
    elapsed = (time.perf_counter() - begun) / REPEATS
    print(elapsed, np.abs(values).sum(), flush=True)

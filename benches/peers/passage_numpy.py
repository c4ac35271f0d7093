"""A wheel over discrete supports by modes of finite elements in NumPy and SciPy: a peer of the benchmark.

The argument is the number of bays of the track. Reads lines "march BAYS" from standard input, rolls a wheel over so many of
them in steps of 0.5 mm, and answers each with the
seconds it took and the root mean square of P - P0 over the last six bays.
"""

import sys
import time

import numpy as np
import scipy.linalg
import scipy.sparse
import scipy.sparse.linalg

BAYS, SPACING, ELEMENTS, FINE, HIGHEST = int(sys.argv[1]), 0.6, 6, 240, 2 * np.pi * 6e3
SPEED, STEP, COUNTED, STEPS_TO_BAY, FIRST = 30.0, 5e-4, 6, 1200, BAYS // 4
BENDING, MASS, SHEAR, ROTARY, DAMPING = 207e9 * 3.04e-5, 60.2, 0.4 * 7.67e-3 * 79.6e9, 7850 * 3.04e-5, 5e4
PAD, SLEEPER, BALLAST = (300e6, 40e3), 150.0, (80e6, 80e3)
LOAD, WHEEL, RADIUS, INERTIA, FRICTION = 50e3, 350.0, 0.46, 0.375 * 350.0 * 0.46**2, 0.35
SHEAR_MODULUS, POISSON, EQUIVALENT = 207e9 / 2.6, 0.3, (0.46 * 0.3) ** 0.5
# Equations (26), (7) and (6) of the paper.
STIFFNESS = (6 * (SHEAR_MODULUS / (1 - POISSON)) ** 2 * LOAD * EQUIVALENT) ** (1 / 3)
CREEP = 2.84 + 1.2 * (0.46 / 0.3) ** (2 / 3)
SATURATION = 3 * FRICTION / CREEP * (16 / 9 * LOAD / ((1 - POISSON) ** 2 * EQUIVALENT**2 * SHEAR_MODULUS)) ** (1 / 3)


def element(length):
    """Timoshenko's beam with cubic shapes (Przemieniecki 1968, chapters 5.6 and 11.3): mass, stiffness, and mass
    of one kilogramme a metre."""
    phi = 12 * BENDING / (SHEAR * length**2)
    l = length
    k = BENDING / (1 + phi) / l**3 * np.array([
        [12, 6 * l, -12, 6 * l], [6 * l, (4 + phi) * l**2, -6 * l, (2 - phi) * l**2],
        [-12, -6 * l, 12, -6 * l], [6 * l, (2 - phi) * l**2, -6 * l, (4 + phi) * l**2]])
    points, weights = np.polynomial.legendre.leggauss(5)
    along = np.zeros((4, 4))
    rotary = np.zeros((4, 4))
    for s, weight in zip((points + 1) / 2, weights / 2):
        w = shapes(s, l, phi)
        turn = turns(s, l, phi)
        along += weight * l * np.outer(w, w)
        rotary += weight * l * np.outer(turn, turn)
    return MASS * along + ROTARY * rotary, k, along


def shapes(s, l, phi):
    return np.array([
        1 - 3 * s**2 + 2 * s**3 + phi * (1 - s), l * (s - 2 * s**2 + s**3 + phi * (s - s**2) / 2),
        3 * s**2 - 2 * s**3 + phi * s, l * (s**3 - s**2 + phi * (s**2 - s) / 2)]) / (1 + phi)


def turns(s, l, phi):
    return np.array([
        6 * (s**2 - s) / l, 1 - 4 * s + 3 * s**2 + phi * (1 - s),
        6 * (s - s**2) / l, 3 * s**2 - 2 * s + phi * s]) / (1 + phi)


def assembled(elements, bays):
    """Mass, stiffness and damping of so many bays."""
    length = SPACING / elements
    nodes = bays * elements + 1
    size = 2 * nodes + bays + 1
    me, ke, along = element(length)
    parts = {"m": [], "k": [], "c": []}
    for index in range(nodes - 1):
        here = range(2 * index, 2 * index + 4)
        for name, values in (("m", me), ("k", ke), ("c", DAMPING * along)):
            parts[name] += [(i, j, values[a, b]) for a, i in enumerate(here) for b, j in enumerate(here)]
    for support in range(bays + 1):
        rail, sleeper = 2 * elements * support, 2 * nodes + support
        parts["m"].append((sleeper, sleeper, SLEEPER))
        for name, pad, ballast in (("k", PAD[0], BALLAST[0]), ("c", PAD[1], BALLAST[1])):
            parts[name] += [(rail, rail, pad), (rail, sleeper, -pad), (sleeper, rail, -pad), (sleeper, sleeper, pad + ballast)]
    rows_columns_values = (zip(*parts[name]) for name in "mkc")
    return [scipy.sparse.coo_array((v, (i, j)), (size, size)).tocsc() for i, j, v in rows_columns_values]


def static(elements, bays):
    """What the track gives way under the force, at so many places of a bay, its end included [m/N]."""
    _, k, _ = assembled(elements, bays)
    solved = scipy.sparse.linalg.splu(k)
    values = []
    for node in range(bays // 2 * elements, (bays // 2 + 1) * elements + 1):
        force = np.zeros(k.shape[0])
        force[2 * node] = 1
        values.append(solved.solve(force)[2 * node])
    return np.array(values)


def track():
    """Poles, modes and their scales, and what the modes leave out over a bay [m/N].

    The flexibility of the modes cut off, and that within an element: without it a wheel feels every node.
    """
    length = SPACING / ELEMENTS
    m, k, c = (matrix.toarray() for matrix in assembled(ELEMENTS, BAYS))
    size = len(m)
    zero = np.zeros((size, size))
    first = np.block([[c, m], [m, zero]])
    second = np.block([[k, zero], [zero, -m]])
    poles, modes = scipy.linalg.eig(-second, first)
    norm = np.einsum("ij,ij->j", modes, first @ modes)
    kept = (poles.imag >= 0) & (abs(poles) < HIGHEST)
    poles, modes, norm = poles[kept], modes[:size, kept], norm[kept]
    scale = np.where(poles.imag > 0, 2.0, 1.0) / norm
    fine = static(FINE, BAYS)
    rest = []
    for step in range(STEPS_TO_BAY):
        by_modes = -(scale * at(modes, BAYS // 2 * SPACING + step * STEP, length) ** 2 / poles).sum().real
        rest.append(np.interp(step / STEPS_TO_BAY * FINE, np.arange(FINE + 1), fine) - by_modes)
    return poles, modes, scale, length, rest


def at(modes, x, length):
    phi = 12 * BENDING / (SHEAR * length**2)
    index = min(int(x / length), BAYS * ELEMENTS - 1)
    return shapes(x / length - index, length, phi) @ modes[2 * index:2 * index + 4]


def height(x):
    return 5e-6 * np.cos(2 * np.pi * x / 0.047) + 8e-6 * np.sin(2 * np.pi * x / 0.083)


def prepared():
    poles, modes, scale, length, rest = track()
    h = STEP / SPEED
    z = poles * h
    decay = np.exp(z)
    old = h * ((z - 1) * decay + 1) / z**2
    new = h * (decay - 1 - z) / z**2
    places = np.array([at(modes, index * STEP, length) for index in range(int(BAYS * SPACING / STEP) + 1)])
    return poles, scale, decay, old, new, places, rest


POLES, SCALE, DECAY, OLD, NEW, PLACES, REST = prepared()


def march(bays):
    h = STEP / SPEED
    begin = round(FIRST * SPACING / STEP)
    approach = 1.5 * LOAD / STIFFNESS
    constant = LOAD / approach**1.5
    here = PLACES[begin]
    states = -SCALE * here * LOAD / POLES
    rest = (here @ states).real + REST[0] * LOAD
    force, wheel, speed = LOAD, 0.0, 0.0
    mean = 0.3 * FRICTION * LOAD
    creepage = SATURATION * (1 - 0.7 ** (1 / 3))
    tangential = mean
    c = RADIUS**2 * h / (2 * INERTIA * SPEED)
    squares = 0.0
    steps = bays * STEPS_TO_BAY
    for step in range(1, steps + 1):
        there = PLACES[begin + step]
        weight = SCALE * NEW * there
        states = DECAY * states + (SCALE * OLD * force) * here
        rail = (there @ states).real - rest
        by_new = (there @ weight).real + REST[step % STEPS_TO_BAY]
        by_wheel = h * h / (6 * WHEEL)
        predicted = wheel + h * speed - h * h / (3 * WHEEL) * (force - LOAD)
        gap = approach + predicted - rail + height(step * STEP) + by_wheel * LOAD
        give = by_new + by_wheel
        now = force
        for _ in range(20):
            root = max(gap - give * now, 0.0) ** 0.5
            change = (constant * root**3 - now) / (1 + 1.5 * constant * root * give)
            now += change
            if abs(change) < 1e-9 * LOAD:
                break
        now = max(now, 0.0)
        states = states + now * weight
        wheel = predicted - by_wheel * (now - LOAD)
        speed -= 0.5 * h / WHEEL * (force - LOAD + now - LOAD)
        goal = creepage - c * (tangential - 2 * mean)
        for _ in range(20):
            stick = max(1 - creepage / (SATURATION * (now / LOAD) ** (1 / 3)), 0.0) if now > 0 else 0.0
            tangential = FRICTION * now * (1 - stick**3)
            slope = 3 * FRICTION * now * stick**2 / (SATURATION * (now / LOAD) ** (1 / 3)) if now > 0 else 0.0
            change = (goal - creepage - c * tangential) / (1 + c * slope)
            creepage += change
            if abs(change) < 1e-12:
                break
        force, here = now, there
        if step > steps - COUNTED * STEPS_TO_BAY:
            squares += (force - LOAD) ** 2
    return (squares / (COUNTED * STEPS_TO_BAY)) ** 0.5


for line in sys.stdin:
    _, count = line.split()
    begun = time.perf_counter()
    value = march(int(count))
    print(time.perf_counter() - begun, value, flush=True)

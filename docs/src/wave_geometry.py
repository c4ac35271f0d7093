"""What the shape of a wave does to wear, without Riffel: a circle rolls over it in small steps.

The contact is where the circle comes nearest to the rail, found on a fine grid; the patch there is a brush (a Winkler bed of bristles
along the rail) under a constant load. Energy goes to the point of the rail that each bristle touches. Only numpy is needed.
Constant slip speed in full sliding: theory says e1/(e0 R k^2 Delta) = 3 (1 - sinc^2 z)/z^2 of a brush, z = ka, and 1 of a point.
A point contact at constant creep force or slip speed with Carter's law in two dimensions: 1/2 and 1 + g/2.
"""

import numpy as np

RADIUS, HALF_LENGTH, WAVELENGTH = 0.46, 6e-3, 55.7e-3  # m
WAVENUMBER = 2 * np.pi / WAVELENGTH
KAPPA = 0.02  # R k^2 Delta
AMPLITUDE = KAPPA / (RADIUS * WAVENUMBER**2)


def first_harmonic(places, values):
    """Mean and first harmonic over one wave, relative to cos kx."""
    mean = np.trapezoid(values, places) / WAVELENGTH
    first = 2 * np.trapezoid(values * np.exp(-1j * WAVENUMBER * places), places) / WAVELENGTH
    return first / mean


def rolling_point(centre):
    """Where a circle touches the wave: the place at which rail minus circle is highest, refined by a parabola."""
    offsets = np.linspace(-2e-3, 2e-3, 801)
    gap = AMPLITUDE * np.cos(WAVENUMBER * (centre + offsets)) - offsets**2 / (2 * RADIUS)
    best = int(np.argmax(gap))
    below, here, above = gap[best - 1 : best + 2]
    step = offsets[1] - offsets[0]
    return centre + offsets[best] + step * 0.5 * (below - above) / (below - 2 * here + above)


def sliding_point():
    """Full sliding of a point at constant load and slip speed: energy per time is constant, per metre it is not."""
    centres = np.linspace(0, WAVELENGTH, 4001)
    places = np.array([rolling_point(centre) for centre in centres])
    speed = np.gradient(places, centres)  # dx/dx_c
    return first_harmonic(places, 1 / speed), speed, places


def carter(constant_force, ratio=0.1):
    """Carter: Q = 1 - (1 - xi/xi_max)^2 of full slip, xi_max ~ sqrt(1/R_x), on the place and the curvature found above."""
    _, speed, places = sliding_point()
    saturation = np.sqrt(1 + RADIUS * AMPLITUDE * WAVENUMBER**2 * np.cos(WAVENUMBER * places))
    share = 1 - np.sqrt(1 - ratio)
    creepage = share * saturation if constant_force else share / speed
    force = 1 - (1 - creepage / saturation) ** 2
    return first_harmonic(places, force * creepage), 2 * share * (1 - share) / ratio


def sliding_brush():
    """Full sliding of a patch of bristles under a constant load, each leaving its pressure on the rail under it."""
    steps, margin = 2400, 1200
    rail = WAVELENGTH / steps * np.arange(-margin, steps + margin + 1)
    energy = np.zeros_like(rail)
    offsets = np.linspace(-1.5, 1.5, 601) * HALF_LENGTH
    for centre in rail[margin // 2 : -margin // 2]:
        shape = AMPLITUDE * np.cos(WAVENUMBER * (centre + offsets)) - offsets**2 / (2 * RADIUS)
        low, high = shape.min(), shape.max()
        load = 2 * HALF_LENGTH**3 / (3 * RADIUS)
        for _ in range(50):
            level = 0.5 * (low + high)
            pressed = np.trapezoid(np.maximum(shape - level, 0), offsets)
            low, high = (level, high) if pressed > load else (low, level)
        pressure = np.maximum(shape - level, 0)
        energy += np.interp(rail - centre, offsets, pressure, 0, 0)
    wave = slice(margin, margin + steps + 1)
    return first_harmonic(rail[wave], energy[wave])


if __name__ == "__main__":
    z = WAVENUMBER * HALF_LENGTH
    brush = 3 * (1 - (np.sin(z) / z) ** 2) / z**2
    print(f"full sliding, point:   {sliding_point()[0].real / KAPPA:.4f}  theory 1")
    print(f"full sliding, brush:   {sliding_brush().real / KAPPA:.4f}  theory {brush:.4f}")
    for constant_force in (True, False):
        found, g = carter(constant_force)
        name, theory = ("force", 0.5) if constant_force else ("slip speed", 1 + g / 2)
        print(f"Carter, constant {name}: {found.real / KAPPA:.4f}  theory {theory:.4f}")

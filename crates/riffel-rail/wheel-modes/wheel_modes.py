"""Natural modes of a railway wheel from its section, as `riffel noise --wheel-modes` reads them.

A solid of revolution, held at its bore: displacements U cos nθ, V sin nθ, W cos nθ over the section (r, z), in biquadratic
elements. For another wheel change the lengths of the section and `NAME`, `TITLE`. Needs NumPy and SciPy:

    python wheel_modes.py > straight-web-920.toml
    python wheel_modes.py --check
"""

import sys

import numpy as np
from scipy.linalg import eigh

YOUNGS_MODULUS, POISSON_RATIO, DENSITY = 207e9, 0.3, 7850.0
HIGHEST = 5700.0  # Hz
GAUSS = np.polynomial.legendre.leggauss(3)
# Damping ratio by number of nodal diameters, of the wheel on its axle without the rail (Thompson 2009).
DAMPING_RATIO = {0: 1e-3, 1: 1e-2}
DAMPING_RATIO_OF_MORE = 1e-4
# Below this the modes with no and with one nodal diameter are motions of the axle as well, which is held here [Hz].
LOWEST_WITH_AXLE = 500.0
FINENESS = 2  # of the mesh: frequencies change by less than 1 % with twice as many elements


def shape(place):
    """Lagrange's quadratic polynomials at -1, 0, 1 and their slopes."""
    x = place
    return np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2]), np.array([x - 0.5, -2 * x, x + 0.5])


class Section:
    """A section out of four-sided blocks, whose sides fit each other."""

    def __init__(self, blocks):
        self.nodes, self.elements, self.index = [], [], {}
        for corners, (along_r, along_z) in blocks:
            corners = np.array(corners, float)  # (r, z) at inner low, outer low, outer high, inner high
            for i in range(along_r):
                for j in range(along_z):
                    self.elements.append([
                        self.node(corners, (i + a / 2) / along_r, (j + b / 2) / along_z)
                        for a in range(3) for b in range(3)
                    ])
        self.nodes = np.array(self.nodes)

    def node(self, corners, s, t):
        weights = np.array([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t])
        place = weights @ corners
        key = tuple(np.round(place, 7))
        if key not in self.index:
            self.index[key] = len(self.nodes)
            self.nodes.append(place)
        return self.index[key]

    def at(self, r, z):
        return self.index[tuple(np.round((r, z), 7))]

    def matrices(self, n):
        """Stiffness and mass of the motion with n nodal diameters; displacements U, V, W node by node."""
        size = 3 * len(self.nodes)
        stiffness, mass = np.zeros((size, size)), np.zeros((size, size))
        lame = YOUNGS_MODULUS / (1 + POISSON_RATIO)
        elastic = np.zeros((6, 6))
        elastic[:3, :3] = lame * POISSON_RATIO / (1 - 2 * POISSON_RATIO)
        elastic += np.diag([lame, lame, lame, lame / 2, lame / 2, lame / 2])
        around = 2 * np.pi if n == 0 else np.pi
        for element in self.elements:
            places = self.nodes[element]
            k, m = np.zeros((27, 27)), np.zeros((27, 27))
            for a, wa in zip(*GAUSS):
                for b, wb in zip(*GAUSS):
                    (fa, da), (fb, db) = shape(a), shape(b)
                    value = np.outer(fa, fb).ravel()
                    slopes = np.array([np.outer(da, fb).ravel(), np.outer(fa, db).ravel()])
                    jacobian = slopes @ places
                    slope_r, slope_z = np.linalg.solve(jacobian, slopes)
                    r = value @ places[:, 0]
                    strain = np.zeros((6, 27))
                    strain[0, 0::3] = slope_r
                    strain[1, 0::3], strain[1, 1::3] = value / r, n * value / r
                    strain[2, 2::3] = slope_z
                    strain[3, 0::3], strain[3, 2::3] = slope_z, slope_r
                    strain[4, 1::3], strain[4, 0::3] = slope_r - value / r, -n * value / r
                    strain[5, 1::3], strain[5, 2::3] = slope_z, -n * value / r
                    weight = wa * wb * abs(np.linalg.det(jacobian)) * r * around
                    k += weight * strain.T @ elastic @ strain
                    move = np.kron(value, np.eye(3))
                    m += weight * DENSITY * move.T @ move
            rows = (3 * np.array(element)[:, None] + np.arange(3)).ravel()
            stiffness[np.ix_(rows, rows)] += k
            mass[np.ix_(rows, rows)] += m
        return stiffness, mass

    def modes(self, n, held=None, highest=HIGHEST):
        """Angular frequencies and mass-normalised displacements [mode, node, 3]."""
        stiffness, mass = self.matrices(n)
        free = np.ones(len(stiffness), bool)
        if held is not None:
            free[(3 * held[:, None] + np.arange(3)).ravel()] = False
        if n == 0:
            free[1::3] = False  # no torsion
        squares, vectors = eigh(stiffness[np.ix_(free, free)], mass[np.ix_(free, free)],
                                subset_by_value=(-np.inf, (2 * np.pi * highest) ** 2))
        shapes = np.zeros((len(squares), len(stiffness)))
        shapes[:, free] = vectors.T
        return np.sqrt(np.abs(squares)), shapes.reshape(len(squares), len(stiffness) // 3, 3)


NAME = "straight-web-920"
TITLE = "Wheel of 920 mm with a straight web that leans by 27 mm"
# The section [m]: r from the axis, z from the back of the flange towards the field side.
BORE, HUB, RIM, TREAD, FLANGE = 0.090, 0.135, 0.395, 0.460, 0.488
WIDTH, CONTACT = 0.135, 0.070
WEB_AT_HUB, WEB_AT_RIM = (0.040, 0.070), (0.070, 0.095)
HUB_ENDS = (-0.035, 0.145)


def wheel(fineness=1):
    f = fineness
    low, high = WEB_AT_HUB
    blocks = [
        ([(BORE, HUB_ENDS[0]), (HUB, HUB_ENDS[0]), (HUB, low), (BORE, low)], (2 * f, 3 * f)),
        ([(BORE, low), (HUB, low), (HUB, high), (BORE, high)], (2 * f, f)),
        ([(BORE, high), (HUB, high), (HUB, HUB_ENDS[1]), (BORE, HUB_ENDS[1])], (2 * f, 3 * f)),
        ([(HUB, low), (RIM, WEB_AT_RIM[0]), (RIM, WEB_AT_RIM[1]), (HUB, high)], (8 * f, f)),
    ]
    cuts = [0.0, 0.032, WEB_AT_RIM[0], WEB_AT_RIM[1], WIDTH]
    for begin, end in zip(cuts, cuts[1:]):
        blocks.append(([(RIM, begin), (TREAD, begin), (TREAD, end), (RIM, end)], (2 * f, f)))
    blocks.append(([(TREAD, 0.0), (FLANGE, 0.0), (FLANGE, 0.032), (TREAD, 0.032)], (f, f)))
    return Section(blocks)


def middle(section):
    """Every second node of the middle surface from the hub to the tread."""
    line = [(HUB, 0.5 * sum(WEB_AT_HUB)), (RIM, 0.5 * sum(WEB_AT_RIM)), (TREAD, 0.5 * sum(WEB_AT_RIM))]
    found = []
    for index, (r, z) in enumerate(section.nodes):
        for (r0, z0), (r1, z1) in zip(line, line[1:]):
            if r0 <= r <= r1 and abs(z - z0 - (z1 - z0) * (r - r0) / (r1 - r0)) < 1e-9:
                found.append((r, index))
                break
    return [index for _, index in sorted(set(found))][::2]


def table(fineness=FINENESS):
    section = wheel(fineness)
    held = np.flatnonzero(section.nodes[:, 0] < BORE + 1e-9)
    axial = middle(section)
    tread = np.flatnonzero((np.abs(section.nodes[:, 0] - TREAD) < 1e-9) & (section.nodes[:, 1] >= 0.032 - 1e-9))
    contact = section.at(TREAD, CONTACT)
    rows = []
    for n in range(0, 12):
        frequencies, shapes = section.modes(n, held)
        for w, mode in zip(frequencies, shapes):
            if n < 2 and w < 2 * np.pi * LOWEST_WITH_AXLE:
                continue
            along = mode[axial, 2]
            sign = np.sign(along[np.argmax(np.abs(along))])
            rows.append({
                "n": n, "frequency": w / (2 * np.pi), "radial": sign * mode[contact, 0], "axial": sign * mode[contact, 2],
                "tread": np.sqrt(np.mean(mode[tread, 0] ** 2)), "along": sign * along,
            })
    return section.nodes[axial, 0], sorted(rows, key=lambda row: row["frequency"])


def check():
    # A slender free ring, bending in its plane: ω² = EI n²(n² − 1)²/(ρA R⁴ (n² + 1)).
    radius, height = 0.5, 0.01
    ring = Section([([(radius - height / 2, 0), (radius + height / 2, 0), (radius + height / 2, height),
                      (radius - height / 2, height)], (1, 1))])
    for n in (2, 3, 4):
        w2 = YOUNGS_MODULUS * height**2 / 12 * n**2 * (n**2 - 1) ** 2 / (DENSITY * radius**4 * (n**2 + 1))
        found = ring.modes(n)[0]
        print("ring", n, min(found, key=lambda w: abs(w - w2**0.5)) / w2**0.5 - 1)
    # A thin free disc: ω = λ²/a² √(D/ρh), λ² = 5.262 and 12.23 for n = 2, 3 without circle, 9.084 for n = 0 with one (Leissa 1969, of 0.33).
    radius, height = 0.5, 0.01
    disc = Section([([(1e-6, 0), (radius, 0), (radius, height), (1e-6, height)], (12, 1))])
    rigidity = YOUNGS_MODULUS * height**2 / 12 / (1 - POISSON_RATIO**2) / DENSITY
    for n in (2, 3, 0):
        print("disc", n, [float(w * radius**2 / rigidity**0.5) for w in disc.modes(n, highest=600)[0]])
    coarse, fine = table()[1], table(2 * FINENESS)[1]
    print("mesh", max(abs(a["frequency"] / b["frequency"] - 1) for a, b in zip(coarse, fine)), len(coarse), len(fine))


def written():
    radii, rows = table()

    def number(value):
        return f"{value:.4g}"

    def numbers(values):
        return "[" + ", ".join(number(value) for value in values) + "]"

    millimetres = ", ".join(f'"{1e3 * radius:.5g} mm"' for radius in radii)
    lines = [
        f'name = "{NAME}"',
        f'title = "{TITLE}"',
        'source = "Computed by wheel_modes.py beside this file from a section that is chosen, not that of any wheel built: hub '
        'of 270 mm, web of 30 to 25 mm, tyre 65 mm thick, steel of 207 GPa, held at the bore of 180 mm. Modes without '
        'and with one nodal diameter are left out below 500 Hz, where the axle moves. Damping ratios: '
        'D. J. Thompson, Railway Noise and Vibration (2009), 1e-3 without nodal diameter, 1e-2 with one, 1e-4 with more"',
        f'rolling_radius = "{1e3 * TREAD:g} mm"',
        f'tread_width = "{1e3 * WIDTH:g} mm"',
        f"radius = [{millimetres}]",
    ]
    for row in rows:
        damping = DAMPING_RATIO.get(row["n"], DAMPING_RATIO_OF_MORE)
        lines += [
            "",
            "[[mode]]",
            f'nodal_diameters = {row["n"]}',
            f'frequency = "{row["frequency"]:.5g} Hz"',
            f"damping_ratio = {damping:g}",
            f'radial_at_contact = {number(row["radial"])}',
            f'radial_of_tread = {number(row["tread"])}',
            f'axial = {numbers(row["along"])}',
        ]
    return "\n".join(lines)


if __name__ == "__main__":
    check() if "--check" in sys.argv else print(written())

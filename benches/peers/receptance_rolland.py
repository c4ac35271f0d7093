"""The receptance of a rail on discrete two-layer supports with rolland's TSBDiscr2L: a peer of the benchmark.

Reads lines "rolland N" from standard input, computes the receptance at mid-span at N frequencies spaced evenly in
logarithm from 20 Hz to 3000 Hz (infinite Timoshenko rail on a finite number of supports, motion like exp(+i omega t))
and answers each with the seconds it took and the sum of |H|, by which both sides are compared.
"""

import dataclasses
import sys
import time

import numpy as np
from rolland.components import Ballast, DiscrPad, Sleeper
from rolland.database.rail.db_rail import UIC60
from rolland.methods import TSBDiscr2L
from rolland.track import SimplePeriodicBallastedSingleRailTrack

# As many on either side of the bay in the middle, where the load is
SUPPORTS = 122
# Rolland holds SUPPORTS^2 complex numbers for each frequency of a call; this many take no longer and less memory
BATCH = 100

# UIC 60 on stiff pads: validation/reference/receptance/uic60_stiff_pad.json. What vertical motion does not depend on
# (lateral and torsional stiffness, widths, heights) must be given and may be anything.
SPACING = 0.6
RAIL = dataclasses.replace(
    UIC60, E=210e9, G=80.769e9, Iyr=3.037e-5, Ar=7.67e-3, mr=60.2, rho=7850.0, kapz=0.393, etar=0.02
)
PAD = DiscrPad(sp_z=800e6, sp_y=1e6, sp_x=1e6, dp_z=30e3, dp_y=1.0, dp_x=1.0, dp_xr=1.0, wdthp=0.15)
SLEEPER = Sleeper(
    ms=162.0,
    equi_sm=False,  # the mass as given, not that of an equivalent sleeper
    Is_z=1.0,
    Is_y=1.0,
    Is_x=1.0,
    rhos=2500.0,
    lengs=2.6,
    wdths=0.25,
    heights=0.2,
    z_st=0.1,
    z_sb=0.1,
)
BALLAST = Ballast(
    sb_z=100e6, sb_y=1e6, sb_x=1e6, db_z=60e3, db_y=1.0, db_x=1.0, db_xr=1.0, db_yr=1.0, db_zr=1.0
)


def receptance(frequency):
    """From the track, which takes next to no time, to the receptance."""
    track = SimplePeriodicBallastedSingleRailTrack(
        rail=RAIL, pad=PAD, sleeper=SLEEPER, ballast=BALLAST, distance=SPACING, num_mount=SUPPORTS, z_f=0.076, y_f=0.0
    )
    middle = (SUPPORTS - 1) / 2 * SPACING
    batches = np.array_split(frequency, -(-frequency.size // BATCH))
    return np.concatenate(
        [TSBDiscr2L(track=track, f=batch, x_excit=middle, damp_type="viscous").receptance for batch in batches]
    )


VARIANTS = {"rolland": receptance}

for line in sys.stdin:
    variant, n = line.split()
    frequency = np.geomspace(20.0, 3000.0, int(n))
    begun = time.perf_counter()
    values = VARIANTS[variant](frequency)
    elapsed = time.perf_counter() - begun
    print(elapsed, np.abs(values).sum(), flush=True)

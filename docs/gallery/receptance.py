"""A track of one's own: a receptance from Python beside the models of Riffel."""

# %%
# The track of the case, two layers on evenly spread supports, and the wheel on it.

import os
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt

import riffel
import riffel.plot

case = riffel.Case.from_toml("cases/bhaskar-track.toml")
receptances = case.receptance()
print(dict(zip(receptances.attrs["resonances"], receptances.attrs["resonance_frequencies_hz"], strict=True)))

# %%
# A callable of frequency in Hz that returns m/N for exp(+i omega t), downward: here a rail on a foundation with loss, in
# its place a finite-element model could stand. It takes part in everything the case computes.


def winkler(frequency: npt.NDArray[np.float64]) -> npt.NDArray[np.complexfloating]:
    """Euler-Bernoulli beam on an elastic foundation, under the load."""
    bending, mass, foundation = 207e9 * 2.35e-5, 56.0, 60e6 * (1.0 + 0.25j)
    # The fourth root in the first quadrant decays to both sides.
    decay = ((foundation - mass * (2.0 * np.pi * frequency) ** 2) / (4.0 * bending)) ** 0.25
    return 1.0 / (8.0 * bending * decay**3)


own = case.with_track(winkler)
print(own.remarks)

# %%

figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
riffel.plot.receptance(receptances, axes[0])
axes[0].plot(
    receptances["frequency"],
    abs(winkler(receptances["frequency"].values)),
    color=riffel.plot.OKABE_ITO[4],
    label="rail on a foundation",
)
axes[0].legend()
speed = 30.0
for each, label, color in ((case, "two layers", 0), (own, "foundation", 4)):
    row = each.growth_map(wavelength=np.linspace(0.02, 0.15, 400), speed=speed)["growth_rate"].isel(speed=0)
    axes[1].plot(1e3 * row["wavelength"], row, color=riffel.plot.OKABE_ITO[color], label=label)
axes[1].axhline(0.0, color="#787878", linewidth=0.8)
axes[1].set(xlabel="wavelength λ [mm]", ylabel="growth rate per passage [-]", title=f"at {3.6 * speed:.0f} km/h")
axes[1].legend()

# %%

folder = Path(os.environ.get("RIFFEL_GALLERY", "out"))
folder.mkdir(exist_ok=True)
figure.savefig(folder / "receptance.png", dpi=120)

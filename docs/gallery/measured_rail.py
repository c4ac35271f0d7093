"""A measured rail: its levels, the limit, and what becomes of it under traffic."""

# %%
# A profile as an array. Here it is made; `riffel.roughness.read` reads the file of a trolley.

import os
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import riffel
import riffel.plot

made = riffel.roughness.synthesise()
name = str(next(iter(made)))
rail = riffel.roughness.analyse(made[name], limit="grassie-1999")
print(f"{rail.spikes} spikes and {rail.pits} pits removed; {rail.grind.sizes['section']} lengths to grind")
print(riffel.roughness.dominant_wavelengths(made[name]))

# %%
# The spectrum under a mix of vehicles, a quarter of a year apart.

case = riffel.Case.from_toml("cases/nominal.toml")
later = case.forecast(rail.spectrum, traffic="cases/traffic.toml", months=[0.0, 3.0, 6.0, 9.0, 12.0])
print(f"grinding interval: {later.attrs['grinding_interval_passages']:.2g} axle passages")

# %%
# What would help?

variants = [
    {"title": "friction 0.3", "contact": {"friction": 0.3}},
    {"title": "20 % slower", "speed": {"factor": 0.8}},
]
compared = case.compare(variants, traffic="cases/traffic.toml")

# %%

figure, axes = plt.subplots(1, 3, figsize=(15, 4.5), layout="constrained")
riffel.plot.spectrum(rail.spectrum, axes[0], limit=riffel.roughness.limits()["iso-3095-2013"], label=name)  # type: ignore[arg-type]
axes[0].set_ylim(bottom=float(np.floor(rail.spectrum.min() / 10.0) * 10.0))
riffel.plot.forecast(later, axes[1])
riffel.plot.comparison(compared, axes[2])

# %%

folder = Path(os.environ.get("RIFFEL_GALLERY", "out"))
folder.mkdir(exist_ok=True)
figure.savefig(folder / "measured_rail.png", dpi=120)

"""Where corrugation grows: a map, its ridge, and what friction does to it."""

# %%
# A case is one wheel on one track.

import os
from pathlib import Path

import matplotlib.pyplot as plt

import riffel
import riffel.plot

case = riffel.Case.from_toml("cases/nominal.toml")
for remark in case.remarks:
    print("note:", remark)

# %%
# The map is an `xarray.Dataset` over speed and wavelength. The ridge is the wavelength of highest growth at each speed.

growth, ridge = case.growth_map(), case.ridge()
print(growth)
print(f"the strongest branch grows at {ridge.attrs['best_fit_frequency_hz']:.0f} Hz")

# %%
# Axes come in and go out: two cases side by side.

figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), sharey=True, layout="constrained")
riffel.plot.growth_map(growth, axes[0])
riffel.plot.ridge(ridge, axes[0])
dry = case.with_({"contact.tractive_ratio": 0.5, "title": "The same with half of adhesion in use"})
riffel.plot.growth_map(dry.growth_map(), axes[1])
riffel.plot.ridge(dry.ridge(), axes[1])
axes[1].set_ylabel("")

# %%

folder = Path(os.environ.get("RIFFEL_GALLERY", "out"))
folder.mkdir(exist_ok=True)
figure.savefig(folder / "growth_map.png", dpi=120)

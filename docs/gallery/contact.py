"""Rolling contact: creep curves of all laws and the frequency response of the exact one."""

# %%
# A coarse grid of the contact is enough for a picture.

import os
from pathlib import Path

import matplotlib.pyplot as plt

import riffel
import riffel.plot

case = riffel.Case.from_toml("cases/nominal.toml", {"contact.grid": 16})
print(case.contact())

# %%

figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
riffel.plot.creep_curve(case.creep_curve(), axes[0])
riffel.plot.frequency_response(case.frequency_response([4, 5, 6, 8, 10, 14, 20, 30, 50, 100]), axes[1])
axes[1].set_title("")

# %%

folder = Path(os.environ.get("RIFFEL_GALLERY", "out"))
folder.mkdir(exist_ok=True)
figure.savefig(folder / "contact.png", dpi=120)

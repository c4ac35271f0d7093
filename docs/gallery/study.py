"""What matters: Sobol indices, tornado and bands of growth of a study."""

# %% A study of 1792 samples: friction, traction, wheel, wear
import os
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import riffel
import riffel.plot

study = riffel.Study.from_dict(
    {
        "title": "What matters on a main line",
        "set": {"map": {"speed": {"min": "80 km/h", "max": "140 km/h", "points": 31}}},
        "design": {"method": "saltelli", "samples": 256, "seed": 1},
        "parameter": [
            {"key": "contact.friction", "uniform": {"min": 0.2, "max": 0.5}},
            {"key": "contact.tractive_ratio", "triangular": {"min": 0.02, "mode": 0.1, "max": 0.4}},
            {"key": "wheel.mass", "normal": {"mean": 350.0, "standard_deviation": 40.0, "min": 200.0, "max": 500.0}},
            {"key": "contact.normal_load", "normal": {"mean": "50 kN", "standard_deviation": "5 kN", "min": "30 kN"}},
            {"key": "wheel.rolling_radius", "uniform": {"min": "420 mm", "max": "460 mm"}},
        ],
        "outputs": {"ridge": True, "growth_by_wavelength": True},
    },
    case="cases/nominal.toml",
)
with tempfile.TemporaryDirectory() as folder:
    results = study.run(Path(folder) / "study").load()

# %% Which parameters matter, together and alone, and how sure growth is
figure, axes = plt.subplots(3, 1, figsize=(7.0, 10.0), layout="constrained")
riffel.plot.sobol_indices(study.sobol_indices(results["highest_growth_rate"]), axes[0])
riffel.plot.tornado(study.tornado("highest_growth_rate"), axes[1])
riffel.plot.bands(results["mean_growth_rate"], axes[2])
figure.savefig(Path(os.environ.get("RIFFEL_GALLERY", ".")) / "study.png", dpi=150)

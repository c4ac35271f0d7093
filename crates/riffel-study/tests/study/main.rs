//! Plans and their errors; results that survive whatever happens to them.

mod folder;
mod plan;
mod values;

use std::fs;
use std::path::Path;

use riffel_study::{Study, StudyError};
use tempfile::TempDir;

/// A small plan on the nominal case.
const PLAN: &str = r#"
case = "nominal.toml"
set.map.speed = { min = "20 m/s", max = "40 m/s", points = 5 }
set.map.wavelength = { min = "20 mm", max = "80 mm", points = 31 }

[design]
method = "latin-hypercube"
samples = 23
seed = 4

[[parameter]]
key = "contact.friction"
uniform = { min = 0.2, max = 0.5 }

[[parameter]]
key = "wheel.mass"
normal = { mean = "350 kg", standard_deviation = "40 kg", min = "200 kg" }

[[parameter]]
key = "rail.section"
values = ["60E1", "BS113A", "54E1"]

[outputs]
ridge = true
ridge_over_speed = true
growth_by_wavelength = true
growth_by_band = "grinding"
map = ["growth_rate", "normalized_dissipation"]

[[outputs.point]]
wavelength = "55 mm"
speed = "108 km/h"
quantities = ["normal_force_n", "growth_rate_per_passage"]

[results]
samples_per_chunk = 4
"#;

/// A folder with a plan and the nominal case.
fn folder_with(plan: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("study.toml"), plan).unwrap();
    fs::write(folder.path().join("nominal.toml"), riffel_case::NOMINAL_CASE).unwrap();
    folder
}

fn read(folder: &Path) -> Result<Study, StudyError> {
    Study::read(&folder.join("study.toml"))
}

/// The study of a plan on the nominal case.
fn study_of(plan: &str) -> Study {
    read(folder_with(plan).path()).unwrap_or_else(|error| panic!("{error}"))
}

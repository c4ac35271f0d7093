//! Case files as users write them.

mod capture;
mod case_file;
mod closed_forms;
mod contact;
mod damage;
mod damage_in_loop;
mod damage_stress;
mod fixtures;
mod full_sliding;
mod general_loop;
mod measured_resonances;
mod measured_wear;
mod measurement;
mod models;
mod p2;
mod remarks;
mod track;
mod traffic;
mod traffic_wheels;
mod wave_geometry;
mod waves_in_time;
mod wheelset_cases;
mod wheelset_files;
mod wheelset_presets;

use fixtures::{case, parsed, trailer};
use riffel_case::{Case, NOMINAL_CASE};

/// The paper's case with overrides.
fn nominal(overrides: &[&str]) -> Case {
    case(NOMINAL_CASE, overrides)
}

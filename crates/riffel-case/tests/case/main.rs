//! Case files as users write them.

mod case_file;
mod closed_forms;
mod contact;
mod damage;
mod damage_in_loop;
mod damage_stress;
mod general_loop;
mod measured_resonances;
mod measured_tables;
mod measurement;
mod models;
mod p2;
mod remarks;
mod track;
mod traffic;
mod traffic_wheels;
mod wave_geometry;
mod wheelset_cases;
mod wheelset_files;
mod wheelset_presets;

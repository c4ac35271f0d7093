//! Identities and limits over random physical cases.

mod all_axes_in_time;
mod closed_forms;
mod contact;
mod fixtures;
mod forecast;
mod general_loop;
mod geometric_creepage;
mod growth;
mod load_wear;
mod measured_growth;
mod moving_contact;
mod normal_direction;
mod paper;
mod passage;
mod passing_supports;
mod spatial_track;
mod supports_on_all_axes;
mod track;
mod wave_geometry;
mod wheelset;
mod work;

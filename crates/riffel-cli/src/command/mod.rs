//! One file for each command.

pub(crate) mod axlebox;
pub(crate) mod compare;
pub(crate) mod completions;
pub(crate) mod contact;
pub(crate) mod curve;
pub(crate) mod diagnose;
pub(crate) mod figures;
pub(crate) mod forecast;
pub(crate) mod init;
pub(crate) mod man;
pub(crate) mod map;
mod models;
pub(crate) mod network;
pub(crate) mod noise;
pub(crate) mod point;
pub(crate) mod presets;
pub(crate) mod profile;
pub(crate) mod receptance;
pub(crate) mod report;
pub(crate) mod roughness;
pub(crate) mod schema;
pub(crate) mod serve;
pub(crate) mod simulate;
pub(crate) mod study;
pub(crate) mod validate;
mod wheels;
pub(crate) mod wheelset;

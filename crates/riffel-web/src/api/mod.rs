//! What the page can ask for besides [`riffel_answers::page::QUESTIONS`], one file for each.

pub(crate) mod along;
pub(crate) mod calibration;
pub(crate) mod curve;
pub(crate) mod decision;
pub(crate) mod earlier;
pub(crate) mod export;
mod file_headers;
pub(crate) mod kept;
pub(crate) mod noise;
mod numbered;
pub(crate) mod progress;
pub(crate) mod questions;
mod reading;
pub(crate) mod report;
pub(crate) mod roughness;
pub(crate) mod wheels;

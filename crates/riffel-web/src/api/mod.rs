//! What the page can ask for besides [`riffel_answers::page::QUESTIONS`], one file for each.

pub(crate) mod ask;
pub(crate) mod calibration;
pub(crate) mod curve;
pub(crate) mod decision;
pub(crate) mod export;
pub(crate) mod progress;
pub(crate) mod questions;
pub(crate) mod upload;
pub(crate) mod wheels;

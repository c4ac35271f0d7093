//! Measured roughness held to limits.

mod document;
pub(crate) mod figure;
mod profile;
mod spectra;
mod tables;
mod verdict;
mod words;

pub(crate) use document::levels;
pub use document::{Level, Removed, RoughnessDocument};
pub use profile::{ProfileAnswer, ProfileRequest, RailAnswer};
pub use spectra::{MeanSpectra, SpectraAnswer};
pub use verdict::Verdict;
pub(crate) use verdict::rail_in_words;
pub use words::{band_row, counted, grind_row};

//! Measured roughness held to limits.

mod document;
pub(crate) mod figure;
mod profile;
mod section_verdict;
mod spectra;
pub(crate) mod tables;
mod verdict;
mod words;

pub(crate) use document::levels;
pub(crate) use document::{Band, bands};
pub use document::{Level, Removed, RoughnessDocument};
pub use profile::{ProfileAnswer, ProfileRequest, RailAnswer};
pub(crate) use profile::{limit_levels, rms_limit};
pub use section_verdict::SectionVerdict;
pub use spectra::{MeanSpectra, SpectraAnswer};
pub use verdict::Verdict;
pub(crate) use verdict::{Judged, worst_first};
pub use words::{band_row, grind_row};

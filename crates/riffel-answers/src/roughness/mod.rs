//! Measured roughness held to limits.

mod band;
pub(crate) mod figure;
mod grind;
mod level;
mod profile;
mod question;
mod rail;
mod section_verdict;
mod spectra;
mod synthesised;
pub(crate) mod tables;
mod verdict;
mod words;

pub(crate) use grind::GroundSection;
pub use level::Level;
pub(crate) use level::levels;
pub use profile::{ProfileAnswer, ProfileRequest};
pub(crate) use profile::{limit_levels, rms_limit};
pub(crate) use question::MeasuredAnswer;
pub use question::RoughnessQuestion;
pub use rail::{RailAnswer, Removed};
pub use section_verdict::SectionVerdict;
pub use spectra::{MeanSpectra, SpectraAnswer};
pub use verdict::Verdict;
pub(crate) use verdict::{Judged, worst_first};

//! # The Riffel case file
//!
//! TOML with units in strings, presets with sources and overrides in; a checked [`Case`] with its
//! [`riffel::FeedbackLoop`] out. Anything wrong is a [`CaseError`] that names the key, shows the line
//! and says what is allowed.
//!
//! ```
//! use riffel_case::{Case, STARTER_CASE};
//!
//! let overrides = ["contact.tractive_ratio=0.5".to_owned()];
//! let case = Case::parse("starter", STARTER_CASE, &overrides)?;
//! let state = case.feedback.at(0.055, 30.0);
//! assert!(state.growth_rate > 0.0);
//! # Ok::<(), riffel_case::CaseError>(())
//! ```

mod case;
mod error;
pub mod file;
mod preset;
pub mod quantity;
mod source;
mod unit;
mod validity;

pub use case::Case;
pub use error::CaseError;
pub use preset::{
    Badge, Preset, PresetRow, PresetValues, RailPreset, Sourced, TrackPreset, preset, presets,
};

/// The commented case file that `riffel init` writes.
pub const STARTER_CASE: &str = include_str!("../../../cases/nominal.toml");

/// JSON schema of the case file.
pub fn json_schema() -> schemars::Schema {
    schemars::schema_for!(file::CaseFile)
}

//! # The Riffel case file
//!
//! TOML with units in strings, presets with sources and overrides in; a checked [`Case`] with its
//! [`riffel::Loop`] out. Anything wrong is a [`CaseError`](riffel_keys::CaseError) that names the key, shows the line
//! and says what is allowed.
//!
//! ```
//! use riffel_case::{Case, NOMINAL_CASE};
//!
//! let overrides = ["contact.tractive_ratio=0.5".to_owned()];
//! let case = Case::parse("nominal", NOMINAL_CASE, &overrides)?;
//! let state = case.feedback.at(0.055, 30.0);
//! assert!(state.growth_rate > 0.0);
//! # Ok::<(), riffel_keys::CaseError>(())
//! ```

#[cfg(test)]
extern crate self as riffel_case;

pub mod ask;
mod build;
mod case;
mod curve;
pub mod file;
#[cfg(test)]
#[path = "../tests/case/fixtures.rs"]
mod fixtures;
mod keys;
pub mod model;
mod parts;
mod text;
pub mod traffic;

pub use ask::contact::{CaseContact, SteadyContact};
pub use ask::contact_name::ContactName;
pub use ask::damage_point::{ByLaw, DamagePoint};
pub use ask::discrete_supports::DrawnSupports;
pub use ask::numbers::LoopOnTrack;
pub use ask::point::{AllAxes, ContactPoint, Point, PointQuantity, PointValue, WaveCreepage, WavePoint};
pub use ask::rolling_noise::TrackRadiator;
pub use ask::sensitivity::Sensitivity;
pub use ask::wheelset_modes::WheelsetMode;
pub use build::CreepLaws;
pub use case::Case;
pub use case::edit::Changes;
pub use case::hold::Hold;
pub use case::idle_key::idle_because;
pub use case::measured_wear::wear_spread;
pub use case::on_curve::{keys_of_curve, keys_that_give_way, on_curve};
pub use case::own_values::{OwnValue, own_values};
pub use case::portable_case::PortableCase;
pub use case::variant::{SpeedChange, Variant};
pub use case::wheels_of_curve::{WheelOfCurve, WheelsOfCurve, wheels_of_curve};
pub use curve::CurvingCase;
pub use file::key::CaseKey;
pub use file::setting::{Setting, settings};
pub use keys::substitutes::{CaseStructure, SubstituteReceptance};
pub use parts::track::{Origin, Track};
pub use parts::wheelset::CaseWheelset;
pub use text::case_text::case_keys;
pub use text::description::descriptions;
pub use text::preset::{Badge, Preset, PresetKind, PresetValue, preset, presets};

/// `cases/nominal.toml`, commented: the nominal case of Afferrante & Ciavarella (2009), and the file
/// that `riffel init` writes.
pub const NOMINAL_CASE: &str = include_str!("../cases/nominal.toml");

/// `cases/metro.toml`, commented: a metro on a slab, and the file that `riffel init --metro` writes.
pub const METRO_CASE: &str = include_str!("../cases/metro.toml");

/// `cases/main-line.toml`, commented: a passenger train on ballast, and the file that `riffel init --main-line`
/// writes.
pub const MAIN_LINE_CASE: &str = include_str!("../cases/main-line.toml");

/// `cases/tram.toml`, commented: a tram on a slab, and the file that `riffel init --tram` writes.
pub const TRAM_CASE: &str = include_str!("../cases/tram.toml");

/// `cases/freight.toml`, commented: laden wagons on ballast, and the file that `riffel init --freight` writes.
pub const FREIGHT_CASE: &str = include_str!("../cases/freight.toml");

/// `cases/bhaskar-track.toml`: the nominal wheel on the track of Bhaskar et al., values inferred.
pub const BHASKAR_TRACK_CASE: &str = include_str!("../cases/bhaskar-track.toml");

/// `cases/metro-curve.toml`, commented: a metro bogie in a curve of 180 m.
pub const METRO_CURVE_CASE: &str = include_str!("../cases/metro-curve.toml");

/// `cases/traffic.toml`, commented: a mix of three kinds of vehicle, and the file that
/// `riffel init --traffic` writes.
pub const TRAFFIC: &str = include_str!("../cases/traffic.toml");

/// JSON schema of the case file.
pub fn json_schema() -> schemars::Schema {
    let mut schema = schemars::schema_for!(file::CaseFile);
    let keys = CaseKey::all().iter().chain(CaseKey::in_lists());
    let keys = keys.filter(|key| key.quantity.is_some());
    riffel_keys::bound(&mut schema, keys.map(|key| (key.key.as_str(), key.pointer.as_str())));
    schema
}

/// JSON schema of the traffic file.
pub fn traffic_schema() -> schemars::Schema {
    let mut schema = schemars::schema_for!(traffic::TrafficFile);
    riffel_keys::bound(&mut schema, traffic::POINTERS);
    schema
}

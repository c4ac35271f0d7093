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

mod build;
mod case;
mod case_text;
mod checked_keys;
mod contact;
mod contact_name;
mod curving;
mod damage_of_case;
mod damage_point;
mod description;
mod discrete_supports;
mod edit;
pub mod file;
mod fill_in;
mod from_curve;
mod from_profiles;
mod general_keys;
mod growth_window;
mod hold;
mod idle_key;
mod kept_state;
mod key;
mod measured_wear;
mod measurement;
mod mechanisms;
pub mod model;
mod numbers;
mod on_curve;
mod own_values;
mod passage;
mod point;
mod portable_case;
mod preset;
mod resonances;
mod rolling_noise;
mod sensitivity;
mod setting;
mod shared;
mod short_waves;
mod stability;
mod substitutes;
mod track;
pub mod traffic;
mod variant;
mod wheels_of_curve;
mod wheelset;
mod wheelset_modes;
mod window;

pub use build::CreepLaws;
pub use case::Case;
pub use case_text::case_keys;
pub use contact::{CaseContact, SteadyContact};
pub use contact_name::ContactName;
pub use curving::{CurvingCase, ProfileOfName, ProfileReading, profile_of, read_profile};
pub use damage_point::{ByLaw, DamagePoint};
pub use description::descriptions;
pub use discrete_supports::DrawnSupports;
pub use hold::Hold;
pub use key::CaseKey;
pub use measurement::{UniversalFunction, doubts_about_rail};
pub use numbers::LoopOnTrack;
pub use own_values::OwnValue;
pub use point::{AllAxes, ContactPoint, Point, PointQuantity, PointValue, WaveCreepage, WavePoint};
pub use portable_case::PortableCase;
pub use preset::{Badge, Preset, PresetKind, PresetValue, preset, presets};
pub use rolling_noise::TrackRadiator;
pub use sensitivity::Sensitivity;
pub use setting::{Setting, settings};
pub use substitutes::GivenReceptance;
pub use track::{Origin, Track};
pub use variant::{SpeedChange, Variant};
pub use wheels_of_curve::{WheelOfCurve, WheelsOfCurve};
pub use wheelset::CaseWheelset;
pub use wheelset_modes::WheelsetMode;

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

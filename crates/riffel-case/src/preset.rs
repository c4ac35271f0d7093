//! Presets: data files under `presets/`, each value with its source.

use std::fmt;

use serde::Deserialize;

use crate::CaseError;
use crate::quantity::{
    Damping, Dimension, Length, Mass, MassPerLength, Quantity, QuantityError, SecondMoment,
    Stiffness,
};

/// The data files, built into the program.
const FILES: [&str; 5] = [
    include_str!("../../../presets/rails/bs113a.toml"),
    include_str!("../../../presets/rails/uic60.toml"),
    include_str!("../../../presets/tracks/bhaskar-inferred.toml"),
    include_str!("../../../presets/tracks/br-stiff.toml"),
    include_str!("../../../presets/tracks/br-soft-ballast.toml"),
];

/// How well a value is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Badge {
    /// Measured on the thing itself.
    Measured,
    /// Published as representative.
    Typical,
    /// Chosen or inferred by us.
    Assumed,
}

impl fmt::Display for Badge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Measured => "measured",
            Self::Typical => "typical",
            Self::Assumed => "assumed",
        })
    }
}

/// One value of a preset with its source.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(try_from = "Written", bound = "")]
pub struct Sourced<D: Dimension> {
    /// The value.
    pub quantity: Quantity<D>,
    /// The value as written, in engineers' units.
    pub written: String,
    /// How well it is known.
    pub badge: Badge,
    /// Where it comes from.
    pub source: String,
}

/// [`Sourced`] as it stands in the file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    value: String,
    badge: Badge,
    source: String,
}

impl<D: Dimension> TryFrom<Written> for Sourced<D> {
    type Error = QuantityError;

    fn try_from(written: Written) -> Result<Self, QuantityError> {
        Ok(Self {
            quantity: written.value.parse()?,
            written: written.value,
            badge: written.badge,
            source: written.source,
        })
    }
}

/// A rail section.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RailPreset {
    /// Mass per length.
    pub mass_per_length: Sourced<MassPerLength>,
    /// Second moment of area for vertical bending.
    pub second_moment: Sourced<SecondMoment>,
}

/// Supports of a two-layer track.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TrackPreset {
    /// Distance of supports.
    pub support_spacing: Sourced<Length>,
    /// Pad stiffness per support.
    pub pad_stiffness: Sourced<Stiffness>,
    /// Pad damping per support.
    pub pad_damping: Sourced<Damping>,
    /// Sleeper mass per support and rail.
    pub sleeper_mass: Sourced<Mass>,
    /// Ballast stiffness per support.
    pub ballast_stiffness: Sourced<Stiffness>,
    /// Ballast damping per support.
    pub ballast_damping: Sourced<Damping>,
}

/// A preset of any kind.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Preset {
    /// The name used in a case file.
    pub name: String,
    /// What it is.
    pub title: String,
    /// Its values.
    #[serde(flatten)]
    pub values: PresetValues,
}

/// Values of a preset, by kind.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PresetValues {
    /// For `rail.section`.
    Rail(RailPreset),
    /// For `track.preset`.
    Track(Box<TrackPreset>),
}

impl PresetValues {
    /// The kind, as a word.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Rail(_) => "rail",
            Self::Track(_) => "track",
        }
    }

    /// The key of a case file that takes the name.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Rail(_) => "rail.section",
            Self::Track(_) => "track.preset",
        }
    }

    /// One row for each value.
    pub fn rows(&self) -> Vec<PresetRow<'_>> {
        match self {
            Self::Rail(rail) => vec![
                PresetRow::new("rail.mass_per_length", &rail.mass_per_length),
                PresetRow::new("rail.second_moment", &rail.second_moment),
            ],
            Self::Track(track) => vec![
                PresetRow::new("track.support_spacing", &track.support_spacing),
                PresetRow::new("track.pad.stiffness", &track.pad_stiffness),
                PresetRow::new("track.pad.damping", &track.pad_damping),
                PresetRow::new("track.sleeper.mass", &track.sleeper_mass),
                PresetRow::new("track.ballast.stiffness", &track.ballast_stiffness),
                PresetRow::new("track.ballast.damping", &track.ballast_damping),
            ],
        }
    }
}

/// A value of a preset as text, for tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PresetRow<'a> {
    /// The key of a case file it stands for.
    pub key: &'static str,
    /// The value as written.
    pub value: &'a str,
    /// How well it is known.
    pub badge: Badge,
    /// Where it comes from.
    pub source: &'a str,
}

impl<'a> PresetRow<'a> {
    fn new<D: Dimension>(key: &'static str, sourced: &'a Sourced<D>) -> Self {
        Self {
            key,
            value: &sourced.written,
            badge: sourced.badge,
            source: &sourced.source,
        }
    }
}

/// All presets, in the order of their files.
pub fn presets() -> Vec<Preset> {
    FILES
        .iter()
        .filter_map(|text| toml::from_str(text).ok())
        .collect()
}

/// The preset of the given name, upper or lower case.
///
/// # Errors
/// [`CaseError::UnknownPreset`] with the names there are.
pub fn preset(name: &str) -> Result<Preset, CaseError> {
    let presets = presets();
    presets
        .iter()
        .find(|preset| preset.name.eq_ignore_ascii_case(name))
        .cloned()
        .ok_or_else(|| CaseError::UnknownPreset {
            name: name.to_owned(),
            known: presets
                .iter()
                .map(|preset| preset.name.as_str())
                .collect::<Vec<_>>()
                .join(", "),
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_reads_and_says_where_its_values_come_from() {
        let presets = presets();
        assert_eq!(presets.len(), FILES.len());
        for row in presets.iter().flat_map(|preset| preset.values.rows()) {
            assert!(row.source.len() > 20, "{row:?}");
        }
    }
}

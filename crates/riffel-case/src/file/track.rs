//! The keys of the track.

use riffel_keys::quantity::{Damping, DampingPerLength, Length, Mass, Quantity, Ratio, Stiffness};
use riffel_rail::response::Measurement;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What the rail lies on. Values are per support and per rail; a model takes those it needs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Track {
    /// The model.
    pub model: TrackModel,
    /// Name of a track preset, for its supports.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Distance of supports.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub support_spacing: Option<Quantity<Length>>,
    /// Rail pad.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pad: Option<Support>,
    /// Sleeper.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sleeper: Option<Sleeper>,
    /// Ballast.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ballast: Option<Support>,
    /// Viscous damping of the rail per length; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rail_damping: Option<Quantity<DampingPerLength>>,
    /// Place of the wheel on discrete supports, from one of them; left out, over a support.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<Quantity<Length>>,
    /// Where a measured receptance is found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measurement: Option<Measurement>,
}

/// Model of the track.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TrackModel {
    /// Infinite rail without support under a stationary load.
    FreeBeam,
    /// Infinite rail under a moving load; on pads if `pad` is given, on pads, sleepers and ballast if
    /// `ballast` is given, spread evenly.
    MovingBeam,
    /// Rail on pads, spread evenly; needs `support_spacing` and `pad`.
    OneLayer,
    /// Rail on pads, sleepers and ballast, spread evenly; needs `preset`, or `support_spacing`,
    /// `pad`, `sleeper` and `ballast`.
    TwoLayer,
    /// Rail on pads at every `support_spacing`.
    OneLayerPeriodic,
    /// Rail on pads, sleepers and ballast at every `support_spacing`.
    TwoLayerPeriodic,
    /// A receptance from a file; needs `measurement`.
    Measured,
}

impl TrackModel {
    /// The name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Self::FreeBeam => "free-beam",
            Self::MovingBeam => "moving-beam",
            Self::OneLayer => "one-layer",
            Self::TwoLayer => "two-layer",
            Self::OneLayerPeriodic => "one-layer-periodic",
            Self::TwoLayerPeriodic => "two-layer-periodic",
            Self::Measured => "measured",
        }
    }

    /// True for supports at discrete places.
    pub fn is_periodic(self) -> bool {
        matches!(self, Self::OneLayerPeriodic | Self::TwoLayerPeriodic)
    }
}

/// A spring with viscous and hysteretic damping.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Name of a pad or ballast preset.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Vertical stiffness per support.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<Quantity<Stiffness>>,
    /// Viscous damping per support; with `loss_factor`, both act.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub damping: Option<Quantity<Damping>>,
    /// Loss factor η: the stiffness becomes k(1 + iη).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_factor: Option<Quantity<Ratio>>,
    /// Lateral stiffness per support; its damping is in proportion to the vertical one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral_stiffness: Option<Quantity<Stiffness>>,
    /// Stiffness along the rail per support; its damping is in proportion to the vertical one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub longitudinal_stiffness: Option<Quantity<Stiffness>>,
}

/// A sleeper.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sleeper {
    /// Name of a sleeper preset.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Mass per support and rail: half of a sleeper under two rails.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<Quantity<Mass>>,
}

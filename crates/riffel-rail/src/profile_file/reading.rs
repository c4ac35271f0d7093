//! How a file of a profile is read.

use riffel::Rail;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a file of a profile is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfileReading {
    /// Wheel or rail, where it is known beforehand.
    pub kind: Option<ProfileKind>,
    /// Which side is taken of a file that has both.
    pub side: Rail,
    /// How the coordinates stand; none for what the format says.
    pub orientation: Option<ProfileOrientation>,
    /// Standard deviation of the points across their curve \[m\], which is then a smooth one.
    pub scatter: Option<f64>,
    /// Where the flange back of a wheel is taken to lie \[m\], from its datum circle.
    pub flange_back: f64,
}

impl Default for ProfileReading {
    fn default() -> Self {
        Self { kind: None, side: Rail::Right, orientation: None, scatter: None, flange_back: -0.07 }
    }
}

/// How the coordinates of a file of a profile stand; Riffel's x is positive to the field side, its y upward.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ProfileOrientation {
    /// Orientation found from the shape: flange inside and below, crown above; the gauge side of a rail is that of x below zero.
    Found,
    /// x to the field side, y upward.
    AsWritten,
    /// x to the gauge side.
    Mirrored,
    /// y downward.
    UpsideDown,
    /// x to the gauge side, y downward.
    Turned,
}

impl ProfileOrientation {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Found => "found",
            Self::AsWritten => "as-written",
            Self::Mirrored => "mirrored",
            Self::UpsideDown => "upside-down",
            Self::Turned => "turned",
        }
    }
}

/// What a profile is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProfileKind {
    /// A wheel.
    Wheel,
    /// A rail.
    Rail,
}

impl ProfileKind {
    /// "wheel" or "rail".
    pub fn name(self) -> &'static str {
        match self {
            Self::Wheel => "wheel",
            Self::Rail => "rail",
        }
    }
}

//! The keys of a measured receptance.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A frequency response in a file.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Measurement {
    /// The file: a table (CSV), or a universal file with dataset 58 if its name ends in .uff, .unv
    /// or .u58. Relative to the case file.
    pub file: String,
    /// What was measured; left out, what the unit of a table tells, else a receptance. A universal
    /// file mostly says so itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quantity: Option<Response>,
    /// Unit of the values, such as "mm/s/kN", "g/N" or, of a modulus, "dB re 1 m/N"; left out, the one
    /// in the header of a table, else m/N, m/(s N) or m/(s² N), or that of a universal file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// Column of the frequency; left out, like those of the values, the one that the header tells.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frequency: Option<String>,
    /// Unit of the frequency; left out, the one in the file, else Hz.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frequency_unit: Option<String>,
    /// Column of the real part; with `imaginary`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub real: Option<String>,
    /// Column of the imaginary part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub imaginary: Option<String>,
    /// Column of the modulus; with `phase`, instead of `real` and `imaginary`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub modulus: Option<String>,
    /// Column of the phase.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phase: Option<String>,
    /// Unit of the phase; left out, the one in the header, else degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phase_unit: Option<AngleUnit>,
    /// Column of the coherence γ². Where it is below 0.8 the lines around are averaged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coherence: Option<String>,
    /// Number of the function in a universal file with several, from one; one without directions is then
    /// taken as vertical.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub function: Option<u32>,
    /// Vertical axis of a universal file: its function must respond along it to a force along it.
    #[serde(default, skip_serializing_if = "VerticalAxis::is_z")]
    pub vertical_axis: VerticalAxis,
    /// True for values that follow exp(−iωt): their imaginary parts change sign.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub conjugate: bool,
    /// True for values of a sensor that points against the force: they change sign.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub negate: bool,
}

/// An axis of a tested structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum VerticalAxis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    #[default]
    Z,
}

impl VerticalAxis {
    /// Its letter.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        }
    }

    // Asked by serde, which has a reference.
    fn is_z(&self) -> bool {
        *self == Self::Z
    }
}

/// What a frequency response is of, per force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Response {
    /// Displacement.
    #[default]
    Receptance,
    /// Velocity.
    Mobility,
    /// Acceleration.
    Accelerance,
}

/// Unit of an angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum AngleUnit {
    /// Degrees.
    #[default]
    Degrees,
    /// Radians.
    Radians,
}

//! The keys that take the mean state from a vehicle in a curve.

use riffel::Rail;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use toml::Value;

use super::setting::Setting;

/// One contact of a vehicle in its curve, as `riffel curve` finds it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FromCurve {
    /// Case file of `riffel curve`, relative to this one; left out, the tables `[curve]`, `[bogie]`, `[body]` and `[profiles]` of this one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<String>,
    /// Wheelset: 1, which leads, 2, or 3 and 4 of the trailing bogie of a vehicle.
    #[schemars(range(min = 1, max = 4))]
    pub wheelset: u8,
    /// Rail under study.
    pub rail: CurveRail,
    /// Which point of a wheel that stands on two; left out, that on the tread.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<ContactOfWheel>,
    /// Which patch the loop takes; left out, the ellipse of Hertz.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub patch: Option<Patch>,
}

impl FromCurve {
    /// What names the wheel in a case.
    pub(crate) fn settings(&self) -> Vec<Setting> {
        let wheelset = Value::Integer(self.wheelset.into());
        let named = [("wheelset", wheelset), ("rail", self.rail.name().into())];
        let contact = self.contact.map(|contact| ("contact", contact.name().into()));
        let named = named.into_iter().chain(contact);
        named.map(|(name, value)| (format!("contact.from.{name}"), value)).collect()
    }
}

/// The patch of a contact whose profiles are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Patch {
    /// The ellipse of the curvatures where the profiles first touch.
    #[default]
    Hertz,
    /// That of the profiles themselves under load, exact on elements: its stiffness, place and angle, and an ellipse like it for
    /// the laws of creep.
    NonElliptic,
    /// Contact on the rail's own surface, which is curved across, in the place of the contact plane.
    Conformal,
}

/// A rail of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CurveRail {
    /// The inner one.
    Low,
    /// The outer one.
    High,
    /// The left one, whichever that is.
    Left,
    /// The right one.
    Right,
}

impl CurveRail {
    /// Which one it is in a curve of a radius \[m\], above zero to the right.
    pub fn in_curve(self, radius: f64) -> Rail {
        let inner = if radius > 0.0 { Rail::Right } else { Rail::Left };
        match self {
            Self::Low => inner,
            Self::High => inner.opposite(),
            Self::Left => Rail::Left,
            Self::Right => Rail::Right,
        }
    }

    /// Name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Low => "low",
            Self::High => "high",
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// A point of a wheel that stands on two.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ContactOfWheel {
    /// That of the smaller contact angle.
    #[default]
    Tread,
    /// That of the larger contact angle.
    Flange,
}

impl ContactOfWheel {
    /// The word of the case file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tread => "tread",
            Self::Flange => "flange",
        }
    }
}

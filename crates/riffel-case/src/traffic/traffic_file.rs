//! The keys of a traffic file, as written.

use riffel_keys::quantity::{Force, Length, Mass, Quantity, Ratio, Speed};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use super::Spread;
use crate::file::Creepage;

/// Riffel traffic: the vehicles that run on a line, in shares of the axle passages.
///
/// Every quantity is a bare number in SI or a string with its unit. What a vehicle does not say is that of
/// the case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Riffel traffic file")]
pub struct TrafficFile {
    /// What the traffic is, for titles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// How much of it there is.
    #[serde(default)]
    pub line: Line,
    /// The vehicles.
    pub vehicle: Vec<Vehicle>,
}

/// How much traffic there is; needed for months and dates.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// Axles a day, each a passage of one wheel over each rail.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub passages_per_day: Option<f64>,
    /// Million gross tonnes a year.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mgt_per_year: Option<f64>,
    /// The line across the rail whose growth is asked for, as a trolley measures it: from the axis of the rail's profile, positive to
    /// the field side. Contacts of vehicles with a `curve` that run beside it leave it as it is; left out, all run on it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measured_line: Option<Quantity<Length>>,
    /// Friction over the days of a year, under every vehicle that says none of its own: growth is averaged over it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction_days: Option<FrictionDays>,
}

/// Friction over days, lognormal.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct FrictionDays {
    /// Its middle, of which as many days lie above as below; where it is left out, the friction of each rail of a curve that has
    /// one for each, and 0.4 elsewhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean: Option<Quantity<Ratio>>,
    /// Two days of three lie between mean / factor and mean · factor; 1.4 where it is left out.
    pub factor: Quantity<Ratio>,
}

/// Days of a dry rail that is not cleaned: 80 % of them from 0.26 to 0.61. No number of a metro's rail is published; dry and clean ones
/// have 0.5 to 0.6, those with a friction modifier 0.25 to 0.35, wet ones 0.2 to 0.3.
impl Default for FrictionDays {
    fn default() -> Self {
        Self { mean: None, factor: Quantity::new(1.4) }
    }
}

impl FrictionDays {
    /// Its middle \[-\] on both rails.
    pub(super) fn middle(&self) -> f64 {
        self.mean.map_or(0.4, |mean| mean.si())
    }
}

/// One kind of vehicle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Vehicle {
    /// Its name.
    pub name: String,
    /// Its share of the axle passages; the shares sum to one.
    pub share: Quantity<Ratio>,
    /// Mass on an axle, two wheels.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axle_load: Option<Quantity<Mass>>,
    /// Normal load of a wheel P₀, in place of the axle load.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wheel_load: Option<Quantity<Force>>,
    /// Unsprung mass per wheel; its rotational inertia follows unless `set` gives it. Not for a wheelset: that is
    /// `set.wheelset`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wheel_mass: Option<Quantity<Mass>>,
    /// Rolling radius of the wheel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rolling_radius: Option<Quantity<Length>>,
    /// Its speed as a normal distribution, cut off at four standard deviations.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<NormalSpeed>,
    /// Its speeds one by one, in place of the distribution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speeds: Option<Vec<SpeedShare>>,
    /// Tractive ratio τ = Q₀/μP₀ in the mean.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tractive_ratio: Option<Quantity<Ratio>>,
    /// Creepage ξ₀, in place of the tractive ratio: a number, or a table of `longitudinal`, `lateral` and `spin`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub creepage: Option<Creepage>,
    /// Share of its axles under this traction, from 0 to 1, in the mean over the trains; the others roll free and
    /// let nothing grow. Left out, all of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub traction_share: Option<Quantity<Ratio>>,
    /// The curve that it runs through: a case file of `riffel curve`, relative to this file, or `true` for the curve of the
    /// case. Every wheel of the vehicle on the rail under study then has its own mean state, at each of its speeds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<CurveOfVehicle>,
    /// Where its contacts run across the rail, from the line under study; left out, all of them on it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral_position: Option<Spread<Length>>,
    /// Rolling radii of its wheels, new to worn, in place of one radius.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wheel_radius: Option<Spread<Length>>,
    /// Loads of its wheels, tare to laden, in place of one load.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<Spread<Force>>,
    /// Friction under its wheels, over days and places.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<Spread<Ratio>>,
    /// Other keys of the case with a spread, as `"track.pad.stiffness"` along the track, each as `friction`.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    #[schemars(schema_with = "any_table")]
    pub spread: toml::Table,
    /// Any other keys of the case that are different for this vehicle, as tables of the case file. A `wheelset` takes
    /// the place of the wheel of the case.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    #[schemars(schema_with = "any_table")]
    pub set: toml::Table,
}

impl Vehicle {
    /// All axle passages by the wheel of the case.
    pub fn named(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            share: Quantity::new(1.0),
            axle_load: None,
            wheel_load: None,
            wheel_mass: None,
            rolling_radius: None,
            speed: None,
            speeds: None,
            tractive_ratio: None,
            creepage: None,
            traction_share: None,
            curve: None,
            lateral_position: None,
            wheel_radius: None,
            load: None,
            friction: None,
            spread: toml::Table::new(),
            set: toml::Table::new(),
        }
    }

    /// Whether it runs through a curve with all its wheels.
    pub(crate) fn brings_curve(&self) -> bool {
        !matches!(self.curve, None | Some(CurveOfVehicle::OfCase(false)))
    }

    /// Traffic at speeds spread evenly over a range \[m/s\]: a normal distribution of their mean and standard deviation, or one
    /// by one where that would reach below standstill.
    #[must_use]
    pub fn at_even_speeds(mut self, [slowest, fastest]: [f64; 2]) -> Self {
        /// Where the standard deviation reaches this share of the mean, no normal distribution stands for the speeds.
        const WIDEST_NORMAL: f64 = 0.25;
        /// Speeds that stand for a wide range, each in the middle of an equal part of it.
        const COUNT: usize = 16;
        let mean = slowest.midpoint(fastest);
        // Of an even distribution.
        let deviation = (fastest - slowest) / 12f64.sqrt();
        if deviation < WIDEST_NORMAL * mean {
            let standard_deviation = (deviation > 0.0).then(|| Quantity::new(deviation));
            self.speed = Some(NormalSpeed { mean: Quantity::new(mean), standard_deviation });
            return self;
        }
        let share = Quantity::new(1.0 / COUNT as f64);
        let places = (0..COUNT).map(|place| (place as f64 + 0.5) / COUNT as f64);
        let speeds =
            places.map(|place| SpeedShare { speed: Quantity::new(slowest + (fastest - slowest) * place), share });
        self.speeds = Some(speeds.collect());
        self
    }
}

/// The curve of a vehicle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum CurveOfVehicle {
    /// `true`: that of the case.
    OfCase(bool),
    /// A case file of `riffel curve`.
    File(String),
}

/// A normal distribution of the speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NormalSpeed {
    /// Mean.
    pub mean: Quantity<Speed>,
    /// Standard deviation, less than a quarter of the mean; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub standard_deviation: Option<Quantity<Speed>>,
}

/// One speed of several.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpeedShare {
    /// The speed.
    pub speed: Quantity<Speed>,
    /// Its share of the passages of the vehicle.
    pub share: Quantity<Ratio>,
}

fn any_table(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "object" })
}

//! What is spread over the wheels of a vehicle besides its speed, and what each spread does to growth.

use riffel::forecast::Distribution;
use riffel_keys::{CaseError, KeyFile};
use toml::Value;

use super::Vehicle;
use super::spread::Values;
use crate::setting::Setting;

/// What is spread over the wheels of a vehicle besides its speed; none where all have one value.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Spreads {
    /// Of the contacts across the rail, from the line under study \[m\].
    pub(super) lateral_position: Option<Distribution>,
    /// Rolling radii \[m\].
    pub(super) wheel_radius: Option<Distribution>,
    /// Loads of a wheel \[N\].
    pub(super) load: Option<Distribution>,
    /// Coefficients of friction \[-\].
    pub(super) friction: Option<Distribution>,
}

/// What a spread does to the growth under a vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct SpreadEffect {
    /// Name of the vehicle.
    pub vehicle: String,
    /// The key that is spread: `speed`, `wheel_radius`, `load`, `friction` or `lateral_position`.
    pub what: &'static str,
    /// The fastest growth without this spread, every wheel at its mean, over that with it; none where nothing grows with it.
    pub reduction: Option<f64>,
}

/// The values of one part of the wheels; none for that of the case.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Values3 {
    pub(super) wheel_radius: Option<f64>,
    pub(super) load: Option<f64>,
    pub(super) friction: Option<f64>,
}

impl Values3 {
    /// What they give a case.
    pub(super) fn settings(self) -> Vec<Setting> {
        let keys = [
            ("wheel.rolling_radius", self.wheel_radius),
            ("contact.normal_load", self.load),
            ("contact.friction", self.friction),
        ];
        let given = keys.into_iter();
        given
            .filter_map(|(key, value)| Some((key.to_owned(), Value::Float(value?))))
            .collect()
    }
}

impl Spreads {
    /// Of a vehicle of a traffic file.
    pub(super) fn of(source: &KeyFile, index: usize, vehicle: &Vehicle) -> Result<Self, CaseError> {
        let key = |name: &str| format!("vehicle[{index}].{name}");
        let taken = [
            (
                "load",
                "axle_load",
                vehicle.load.is_some() && vehicle.axle_load.is_some(),
            ),
            (
                "load",
                "wheel_load",
                vehicle.load.is_some() && vehicle.wheel_load.is_some(),
            ),
            (
                "wheel_radius",
                "rolling_radius",
                vehicle.wheel_radius.is_some() && vehicle.rolling_radius.is_some(),
            ),
        ];
        if let Some((own, other, _)) = taken.into_iter().find(|(_, _, both)| *both) {
            let rule = format!("and `{}` exclude each other", key(other));
            return Err(source.invalid(&key(own), &rule, "give one of the two"));
        }
        Ok(Self {
            lateral_position: (vehicle.lateral_position.as_ref())
                .map(|it| it.distribution(source, &key("lateral_position"), Values::Any))
                .transpose()?,
            wheel_radius: (vehicle.wheel_radius.as_ref())
                .map(|it| it.distribution(source, &key("wheel_radius"), Values::Positive))
                .transpose()?,
            load: (vehicle.load.as_ref())
                .map(|it| it.distribution(source, &key("load"), Values::Positive))
                .transpose()?,
            friction: (vehicle.friction.as_ref())
                .map(|it| it.distribution(source, &key("friction"), Values::Positive))
                .transpose()?,
        })
    }

    /// Of three values, each spread or none.
    fn of_values(&self) -> [&Option<Distribution>; 3] {
        [&self.wheel_radius, &self.load, &self.friction]
    }

    /// One of the values, by its place in [`VALUES`](Self::VALUES).
    pub(super) fn value(&self, place: usize) -> Option<&Distribution> {
        self.of_values()[place].as_ref()
    }

    /// The names of what is spread, but the place across the rail.
    pub(super) const VALUES: [&'static str; 3] = ["wheel_radius", "load", "friction"];

    /// Which of the values are spread, by their places in [`VALUES`](Self::VALUES).
    pub(super) fn spread_values(&self) -> Vec<usize> {
        let of_values = self.of_values().into_iter().enumerate();
        let spread = of_values.filter(|(_, it)| it.as_ref().is_some_and(|it| !it.is_single()));
        spread.map(|(place, _)| place).collect()
    }

    /// The values of all parts with their shares: every combination of the nodes of each, by the rule of each; none for the
    /// mean alone.
    pub(super) fn parts(&self, rules: [Option<usize>; 3]) -> Vec<(f64, Values3)> {
        let nodes: Vec<Vec<(Option<f64>, f64)>> = self
            .of_values()
            .into_iter()
            .zip(rules)
            .map(|(distribution, rule)| match (distribution, rule) {
                (None, _) => vec![(None, 1.0)],
                (Some(it), None) => vec![(Some(it.mean()), 1.0)],
                (Some(it), Some(rule)) => {
                    let nodes = it.nodes(rule).into_iter();
                    nodes.map(|(value, share)| (Some(value), share)).collect()
                }
            })
            .collect();
        let mut parts = Vec::new();
        for &(wheel_radius, of_radius) in &nodes[0] {
            for &(load, of_load) in &nodes[1] {
                for &(friction, of_friction) in &nodes[2] {
                    let values = Values3 {
                        wheel_radius,
                        load,
                        friction,
                    };
                    parts.push((of_radius * of_load * of_friction, values));
                }
            }
        }
        parts
    }

    /// The share of passages whose contact, of a semi-axis across the rail \[m\], covers the line under study; none where all run
    /// on it.
    pub(super) fn covering(&self, semi_axis: f64) -> Option<f64> {
        let position = self.lateral_position.as_ref()?;
        Some(position.share_within(-semi_axis, semi_axis))
    }
}

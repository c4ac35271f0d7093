//! What is spread over the wheels of a vehicle besides its speed, and what each spread does to growth.

use riffel::forecast::WheelValues;
use riffel_keys::{CaseError, KeyFile, say};
use toml::Value;

use super::spread::{Values, names_of_key, of_key};
use super::{FrictionDays, Vehicle};
use crate::CaseKey;
use crate::file::setting::{Setting, settings, settings_until};
use crate::text::case_text::is_within;

/// What is spread over the wheels of a vehicle besides its speed.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Spreads {
    /// Of the contacts across the rail, from the line under study \[m\]; `None` if all run on it.
    pub(super) lateral_position: Option<WheelValues>,
    /// Of keys of the case.
    pub(super) of_keys: Vec<SpreadOfKey>,
}

/// The values of a key of the case over the wheels of a vehicle.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SpreadOfKey {
    /// The key of the vehicle, `friction` or `spread.track.pad.stiffness`.
    pub(super) own: String,
    /// The key of the case.
    pub(super) key: String,
    values: ValuesOfKey,
}

/// What a key has over the wheels of a vehicle.
#[derive(Debug, Clone, PartialEq)]
enum ValuesOfKey {
    /// Of a quantity.
    Numbers(WheelValues),
    /// Of a key that takes a name, as that of a profile, each with its share.
    Names(Vec<(String, f64)>),
}

impl ValuesOfKey {
    fn is_single(&self) -> bool {
        match self {
            Self::Numbers(values) => values.is_single(),
            Self::Names(names) => names.len() == 1,
        }
    }

    /// The mean, or the name that is met most.
    fn middle(&self) -> Value {
        match self {
            Self::Numbers(values) => Value::Float(values.mean()),
            Self::Names(names) => {
                let most = names.iter().max_by(|one, other| one.1.total_cmp(&other.1));
                Value::String(most.map_or(String::new(), |it| it.0.clone()))
            }
        }
    }

    /// Values with their shares, by a rule of quadrature where there is no list of them.
    fn nodes(&self, rule: usize) -> Vec<(Value, f64)> {
        match self {
            Self::Numbers(values) => {
                let nodes = values.nodes(rule).into_iter();
                nodes.map(|(value, share)| (Value::Float(value), share)).collect()
            }
            Self::Names(names) => {
                let names = names.iter();
                names.map(|(name, share)| (Value::String(name.clone()), *share)).collect()
            }
        }
    }
}

impl SpreadOfKey {
    /// Whether its values are listed one by one, which takes no rule of quadrature.
    pub(super) fn is_listed(&self) -> bool {
        matches!(self.values, ValuesOfKey::Names(_) | ValuesOfKey::Numbers(WheelValues::Shares(_)))
    }

    /// `friction`, or a key of the case.
    pub(super) fn name(&self) -> &str {
        match self.own.as_str() {
            FRICTION_DAYS => "friction",
            own => own.strip_prefix("spread.").unwrap_or(own),
        }
    }
}

/// What a spread does to the growth under a vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct SpreadEffect {
    /// Name of the vehicle.
    pub vehicle: String,
    /// What is spread: `speed`, `wheel_radius`, `load`, `friction`, `lateral_position` or a key of the case.
    pub what: String,
    /// The fastest growth without this spread, every wheel at its mean, over that with it; `None` if nothing grows with it.
    pub reduction: Option<f64>,
}

/// The rule of quadrature of each spread; none for its mean alone.
pub(super) type Rules = Vec<Option<usize>>;

/// The values that one part of the wheels gives keys of the case, each with the key of the vehicle that it comes from.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct PartValues(Vec<(String, Setting)>);

/// Shorthands of a vehicle for keys of the case.
pub(super) const LOAD: &str = "contact.normal_load";
pub(super) const FRICTION: &str = "contact.friction";
pub(super) const WHEEL_RADIUS: &str = "wheel.rolling_radius";

/// Key of the line for vehicles that say no friction.
pub(super) const FRICTION_DAYS: &str = "line.friction_days";

/// Where the key of a vehicle, or of its line, stands in the traffic file.
pub(super) fn place_of(index: usize, own: &str) -> String {
    match own {
        FRICTION_DAYS => own.to_owned(),
        own => format!("vehicle[{index}].{own}"),
    }
}

impl PartValues {
    /// What they give a case, each with the key of the vehicle.
    pub(super) fn settings(&self) -> impl Iterator<Item = (String, Setting)> {
        self.0.iter().cloned()
    }

    /// The values with those of some keys of a vehicle.
    pub(super) fn with(&self, own: impl Iterator<Item = (String, Setting)>) -> Self {
        Self(self.0.iter().cloned().chain(own).collect())
    }

    /// The values without friction.
    pub(super) fn without_friction(&self) -> Self {
        Self(self.0.iter().filter(|(_, (key, _))| key != FRICTION).cloned().collect())
    }

    /// The values where each rail has friction of its own, left and right: days without a mean scale both.
    ///
    /// # Errors
    /// The key of the vehicle or of its line that gives one friction to both.
    pub(super) fn on_rails(&self, rails: [f64; 2], days: Option<FrictionDays>) -> Result<Self, String> {
        let mut values = self.clone();
        for (own, (_, value)) in values.0.iter_mut().filter(|(_, (key, _))| key == FRICTION) {
            let days = days.filter(|days| own == FRICTION_DAYS && days.mean.is_none());
            let (Some(days), Some(of_day)) = (days, value.as_float()) else {
                return Err(own.clone());
            };
            let of_rails = rails.map(|friction| Value::Float(friction * of_day / days.middle()));
            let of_rails = ["left", "right"].map(str::to_owned).into_iter().zip(of_rails);
            *value = Value::Table(of_rails.collect());
        }
        Ok(values)
    }

    /// The value of a key of the case, if it is spread.
    pub(super) fn of(&self, key: &str) -> Option<f64> {
        let found = self.0.iter().find(|(_, (own, _))| own == key);
        found.and_then(|(_, (_, value))| value.as_float())
    }
}

impl Spreads {
    /// Of a vehicle of a traffic file, under the friction that its line has over the days.
    pub(super) fn of(
        source: &KeyFile,
        days: Option<FrictionDays>,
        index: usize,
        vehicle: &Vehicle,
    ) -> Result<Self, CaseError> {
        let at = |name: &str| place_of(index, name);
        let mut of_keys = Vec::new();
        let mut shorthand = |own: &str, key: &str, values: WheelValues| {
            of_keys.push(SpreadOfKey {
                own: own.to_owned(),
                key: key.to_owned(),
                values: ValuesOfKey::Numbers(values),
            });
        };
        if let Some(radius) = &vehicle.wheel_radius {
            let at = at("wheel_radius");
            shorthand("wheel_radius", WHEEL_RADIUS, radius.values(source, &at, Values::Positive)?);
        }
        if let Some(load) = &vehicle.load {
            shorthand("load", LOAD, load.values(source, &at("load"), Values::Positive)?);
        }
        if let Some(friction) = &vehicle.friction {
            let at = at("friction");
            shorthand("friction", FRICTION, friction.values(source, &at, Values::Positive)?);
        }
        let given = settings(&vehicle.set);
        let spread = settings(&vehicle.spread);
        let says = |(key, _): &Setting| is_within(key, FRICTION);
        let says_friction = vehicle.friction.is_some() || given.iter().chain(&spread).any(says);
        if let Some(days) = days.filter(|_| !says_friction) {
            let values = WheelValues::log_normal(days.middle(), days.factor.si());
            let values = values.map_err(|error| source.invalid(FRICTION_DAYS, &error, ""))?;
            shorthand(FRICTION_DAYS, FRICTION, values);
        }
        for (key, value) in settings_until(&vehicle.spread, |key| CaseKey::find(key).is_some()) {
            let own = format!("spread.{key}");
            let Some(known) = CaseKey::find(&key) else {
                let help = say!(the_nearest_key_is, key = CaseKey::nearest(&key));
                return Err(source.invalid(&at(&own), say!(is_no_key_of_a_case), &help));
            };
            let values = match known.quantity {
                Some(kind) => ValuesOfKey::Numbers(of_key(source, &at(&own), kind, &value)?),
                None => ValuesOfKey::Names(names_of_key(source, &at(&own), &value)?),
            };
            of_keys.push(SpreadOfKey { own, key, values });
        }
        Ok(Self {
            lateral_position: (vehicle.lateral_position.as_ref())
                .map(|it| it.values(source, &at("lateral_position"), Values::Any))
                .transpose()?,
            of_keys,
        })
    }

    /// What is spread of a key of the case.
    pub(super) fn of_case(&self, key: &str) -> Option<&SpreadOfKey> {
        self.of_keys.iter().find(|it| it.key == key)
    }

    /// Which of the keys have more than one value, by their places.
    pub(super) fn spread_values(&self) -> Vec<usize> {
        let of_keys = self.of_keys.iter().enumerate();
        let spread = of_keys.filter(|(_, it)| !it.values.is_single());
        spread.map(|(place, _)| place).collect()
    }

    /// Every key at its mean.
    pub(super) fn means(&self) -> Rules {
        vec![None; self.of_keys.len()]
    }

    /// The values of all parts with their shares: every combination of the nodes of each key, by the rule of each.
    pub(super) fn parts(&self, rules: &[Option<usize>]) -> Vec<(f64, PartValues)> {
        let mut parts = vec![(1.0, PartValues::default())];
        for (it, rule) in self.of_keys.iter().zip(rules) {
            let nodes = match rule {
                None => vec![(it.values.middle(), 1.0)],
                Some(rule) => it.values.nodes(*rule),
            };
            let with_each = |(share, values): &(f64, PartValues)| {
                let with = |(value, of_value): &(Value, f64)| {
                    let mut values = values.clone();
                    let setting = (it.key.clone(), value.clone());
                    values.0.push((it.own.clone(), setting));
                    (share * of_value, values)
                };
                nodes.iter().map(with).collect::<Vec<_>>()
            };
            parts = parts.iter().flat_map(with_each).collect();
        }
        parts
    }

    /// The share of passages whose contact, of half a width across the rail \[m\], covers a line that is so far from where the contact
    /// runs in the mean \[m\].
    pub(super) fn covering(&self, half_width: f64, line: f64) -> f64 {
        match &self.lateral_position {
            Some(position) => position.share_within(line - half_width, line + half_width),
            None => f64::from(line.abs() <= half_width),
        }
    }
}

//! What a plan says of an uncertain value.

use riffel_case::CaseKey;
use riffel_keys::quantity::{Quantity, Ratio};
use riffel_keys::{CaseError, PhysicalRange, quantity};

use super::{Reading, excludes, name_of};
use crate::file::{DataFile, UncertainFile};
use crate::model::{Parameter, Role, Vehicle, VehicleKey};
use crate::prior::Prior;

impl Reading<'_> {
    pub(super) fn parameter(
        &self,
        index: usize,
        written: &UncertainFile,
    ) -> Result<Parameter, CaseError> {
        let at = format!("parameter[{index}]");
        let place = |key: &str| format!("{at}.{key}");
        for (number, name) in written.in_data.iter().flatten().enumerate() {
            let known = |data: &DataFile| name_of(data) == name;
            if !self.file.data.iter().any(known) {
                let rule = format!("is \"{name}\", but no [[data]] has this name or kind");
                let key = place(&format!("in_data[{number}]"));
                return Err(self.source.invalid(&key, &rule, ""));
            }
        }
        let (key, role, name) = self.role(&at, written)?;
        let of_key = match &role {
            Role::Vehicle(_, VehicleKey::OfCase(of, _)) if key.starts_with("vehicle.set.") => of,
            _ => key,
        };
        let which = match written.key {
            Some(_) => "key",
            None => "multiplies",
        };
        let quantity = quantity_of(key, of_key)
            .map_err(|(rule, help)| self.source.invalid(&place(which), &rule, &help))?;
        let multiplies = matches!(role, Role::Multiplies(_));
        let kind = match multiplies {
            true => quantity::Kind::of::<Ratio>(),
            false => quantity,
        };
        let distribution = riffel_study::distribution(self.source, &at, kind, &written.prior())?;
        let distribution = distribution.ok_or_else(|| {
            let help = "give one of lognormal, normal, uniform and triangular";
            self.source.missing(&place("lognormal"), help)
        })?;
        let ends = match (&role, PhysicalRange::of(of_key)) {
            (Role::Multiplies(_), _) => [0.0, f64::INFINITY],
            (Role::Vehicle(_, VehicleKey::TractionShare), _) => [0.0, 1.0],
            (_, Some(range)) => range.hard,
            (_, None) => [f64::NEG_INFINITY, f64::INFINITY],
        };
        let prior = Prior::within(distribution, ends).ok_or_else(|| {
            let rule = format!(
                "leaves nothing of the range that can be computed, {} to {}",
                ends[0], ends[1]
            );
            self.source.invalid(&at, &rule, "")
        })?;
        self.check_own_value(&at, key, &role, &prior)?;
        Ok(Parameter {
            name,
            unit: kind.unit.to_owned(),
            prior,
            ends,
            role,
            in_data: written.in_data.clone(),
        })
    }

    /// The key of the case or of a vehicle, what the value does to it, and its name.
    fn role<'w>(
        &self,
        at: &str,
        written: &'w UncertainFile,
    ) -> Result<(&'w String, Role, String), CaseError> {
        let vehicles = self.vehicles;
        let place = |key: &str| format!("{at}.{key}");
        let wrong =
            |key: &str, rule: &str, help: &str| self.source.invalid(&place(key), rule, help);
        Ok(match (&written.key, &written.multiplies) {
            (Some(_), Some(_)) => {
                let rule = format!("and `{}` exclude each other", place("key"));
                return Err(wrong("multiplies", &rule, "give one of the two"));
            }
            (None, None) => {
                let help = "give the key of the case, or multiplies = \"…\" with a name";
                return Err(self.source.missing(&place("key"), help));
            }
            (None, Some(key)) => {
                let name = written.name.clone().ok_or_else(|| {
                    self.source.missing(
                        &place("name"),
                        "name the factor, as in \"preload_stiffening\"",
                    )
                })?;
                (key, Role::Multiplies(key.clone()), name)
            }
            (Some(key), None) => match key.strip_prefix("vehicle.") {
                Some(rest) => {
                    let vehicle = self.vehicle(at, written)?;
                    let of = VehicleKey::of(rest).ok_or_else(|| {
                        let rule = format!("is \"{key}\", which a vehicle does not have or which cannot be uncertain");
                        wrong("key", &rule, "take speed.mean, speed.standard_deviation, traction_share, tractive_ratio, creepage, wheel_load, axle_load, wheel_mass, rolling_radius or set.… after vehicle.")
                    })?;
                    let several = vehicles.len() > 1;
                    let name = match several {
                        true => format!("{key} ({})", vehicles[vehicle].name),
                        false => key.clone(),
                    };
                    (key, Role::Vehicle(vehicle, of), name)
                }
                None => (
                    key,
                    Role::Key(key.clone()),
                    written.name.clone().unwrap_or_else(|| key.clone()),
                ),
            },
        })
    }

    /// Refuse a prior that excludes the value of the case.
    fn check_own_value(
        &self,
        at: &str,
        key: &str,
        role: &Role,
        prior: &Prior,
    ) -> Result<(), CaseError> {
        let own = match role {
            Role::Multiplies(_) => None,
            Role::Vehicle(vehicle, of) => self.vehicles[*vehicle].number(of),
            _ => self.case.number(key),
        };
        if let Some(own) = own
            && excludes(prior, own)
        {
            let rule = format!(
                "excludes {}, the value of the case for `{key}`: it lies beyond the ends or four standard deviations of the prior",
                Quantity::<Ratio>::new(own)
            );
            return Err(self
                .source
                .invalid(at, &rule, "widen the prior, or correct the case"));
        }
        Ok(())
    }

    /// The vehicle that a parameter is of.
    fn vehicle(&self, at: &str, written: &UncertainFile) -> Result<usize, CaseError> {
        let vehicles = self.vehicles;
        let key = format!("{at}.key");
        if vehicles.is_empty() {
            let rule = "is a key of a vehicle, but the plan names no traffic";
            return Err(self
                .source
                .invalid(&key, rule, "give traffic = \"traffic.toml\""));
        }
        match &written.name {
            None if vehicles.len() == 1 => Ok(0),
            None => {
                let names: Vec<&str> = vehicles.iter().map(|vehicle| &*vehicle.name).collect();
                let help = format!("the traffic has several vehicles: {}", names.join(", "));
                Err(self.source.missing(&format!("{at}.name"), &help))
            }
            Some(name) => vehicles
                .iter()
                .position(|vehicle| vehicle.name == *name)
                .ok_or_else(|| {
                    let rule =
                        format!("is \"{name}\", but no vehicle of the traffic has this name");
                    self.source.invalid(&format!("{at}.name"), &rule, "")
                }),
        }
    }
}

/// The quantity of a key, where that of the case is `of_key`; or the rule that it breaks, and help.
pub(super) fn quantity_of(key: &str, of_key: &str) -> Result<quantity::Kind, (String, String)> {
    let quantity = match (key.strip_prefix("vehicle."), PhysicalRange::of(of_key)) {
        (Some(_), Some(range)) => Some(range.kind),
        (Some("traction_share"), None) => Some(quantity::Kind::of::<Ratio>()),
        _ => match CaseKey::find_with_curving(of_key) {
            Some(known) => known.quantity,
            None => {
                let rule = format!("is \"{key}\", but the case file has no such key");
                let help = format!("did you mean {}?", CaseKey::nearest(of_key));
                return Err((rule, help));
            }
        },
    };
    quantity.ok_or_else(|| {
        let rule = format!("is \"{key}\", which takes a choice, a name or a whole number");
        (rule, "only quantities can be uncertain".to_owned())
    })
}

impl Vehicle {
    /// The number that a vehicle has for one of its keys, in SI.
    pub(super) fn number(&self, key: &VehicleKey) -> Option<f64> {
        use crate::model::Speeds;
        match (key, &self.speeds) {
            (VehicleKey::TractionShare, _) => Some(self.traction_share),
            (VehicleKey::MeanSpeed, Speeds::Normal { mean, .. }) => Some(*mean),
            (VehicleKey::SpeedDeviation, Speeds::Normal { deviation, .. }) => Some(*deviation),
            (VehicleKey::OfCase(key, factor), _) => {
                let own = self.settings.iter().find(|setting| setting.0 == *key)?;
                Some(own.1.as_float()? / factor)
            }
            _ => None,
        }
    }
}

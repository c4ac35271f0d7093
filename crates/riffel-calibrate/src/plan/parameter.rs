//! What a plan says of an uncertain value.

use riffel_case::CaseKey;
use riffel_keys::quantity::{Quantity, Ratio};
use riffel_keys::{CaseError, Message, PhysicalRange, quantity, say};

use super::{Reading, excludes, name_of};
use crate::file::{DataFile, UncertainFile};
use crate::model::{Parameter, Role, Vehicle, VehicleKey};
use crate::prior::Prior;

impl Reading<'_> {
    pub(super) fn parameter(&self, index: usize, written: &UncertainFile) -> Result<Parameter, CaseError> {
        let at = format!("parameter[{index}]");
        let place = |key: &str| format!("{at}.{key}");
        for (number, name) in written.in_data.iter().flatten().enumerate() {
            let known = |data: &DataFile| name_of(data) == name;
            if !self.file.data.iter().any(known) {
                let rule = say!(is_name_of_no_data, name);
                let key = place(&format!("in_data[{number}]"));
                return Err(self.source.invalid(&key, rule, ""));
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
        let quantity =
            quantity_of(key, of_key).map_err(|(rule, help)| self.source.invalid(&place(which), rule, help))?;
        let multiplies = matches!(role, Role::Multiplies(_));
        let kind = match multiplies {
            true => quantity::Kind::of::<Ratio>(),
            false => quantity,
        };
        let distribution = riffel_study::distribution(self.source, &at, kind, &written.prior())?;
        let distribution = distribution.ok_or_else(|| {
            let help = say!(give_a_prior);
            self.source.missing(&place("lognormal"), help)
        })?;
        let ends = match (&role, PhysicalRange::of(of_key)) {
            (Role::Multiplies(_), _) => [0.0, f64::INFINITY],
            (Role::Vehicle(_, VehicleKey::TractionShare), _) => [0.0, 1.0],
            (_, Some(range)) => range.hard,
            (_, None) => [f64::NEG_INFINITY, f64::INFINITY],
        };
        let prior = Prior::within(distribution, ends).ok_or_else(|| {
            let rule = say!(leaves_nothing, low = ends[0], high = ends[1]);
            self.source.invalid(&at, rule, "")
        })?;
        self.check_own_value(&at, key, &role, &prior)?;
        Ok(Parameter { name, unit: kind.unit.to_owned(), prior, ends, role, in_data: written.in_data.clone() })
    }

    /// The key of the case or of a vehicle, what the value does to it, and its name.
    fn role<'w>(&self, at: &str, written: &'w UncertainFile) -> Result<(&'w String, Role, String), CaseError> {
        let vehicles = self.vehicles;
        let place = |key: &str| format!("{at}.{key}");
        let wrong = |key: &str, rule: Message, help: Message| self.source.invalid(&place(key), rule, help);
        Ok(match (&written.key, &written.multiplies) {
            (Some(_), Some(_)) => {
                let rule = say!(and_exclude_each_other, other = place("key"));
                return Err(wrong("multiplies", rule, say!(give_one_of_the_two)));
            }
            (None, None) => {
                let help = say!(give_key_or_factor);
                return Err(self.source.missing(&place("key"), help));
            }
            (None, Some(key)) => {
                let name =
                    written.name.clone().ok_or_else(|| self.source.missing(&place("name"), say!(name_the_factor)))?;
                (key, Role::Multiplies(key.clone()), name)
            }
            (Some(key), None) => match key.strip_prefix("vehicle.") {
                Some(rest) => {
                    let vehicle = self.vehicle(at, written)?;
                    let of = VehicleKey::of(rest).ok_or_else(|| {
                        wrong("key", say!(is_no_key_of_a_vehicle, name = key), say!(keys_of_a_vehicle))
                    })?;
                    let several = vehicles.len() > 1;
                    let name = match several {
                        true => format!("{key} ({})", vehicles[vehicle].name),
                        false => key.clone(),
                    };
                    (key, Role::Vehicle(vehicle, of), name)
                }
                None => (key, Role::Key(key.clone()), written.name.clone().unwrap_or_else(|| key.clone())),
            },
        })
    }

    /// Refuse a prior that excludes the value of the case.
    fn check_own_value(&self, at: &str, key: &str, role: &Role, prior: &Prior) -> Result<(), CaseError> {
        let own = match role {
            Role::Multiplies(_) => None,
            Role::Vehicle(vehicle, of) => self.vehicles[*vehicle].number(of),
            _ => self.case.number(key),
        };
        if let Some(own) = own
            && excludes(prior, own)
        {
            let own = Quantity::<Ratio>::new(own).to_string();
            let rule = say!(excludes_value_of_the_case, value = own, key);
            return Err(self.source.invalid(at, rule, say!(widen_the_prior)));
        }
        Ok(())
    }

    /// The vehicle that a parameter is of.
    fn vehicle(&self, at: &str, written: &UncertainFile) -> Result<usize, CaseError> {
        let vehicles = self.vehicles;
        let key = format!("{at}.key");
        if vehicles.is_empty() {
            let rule = say!(is_key_of_a_vehicle_without_traffic);
            return Err(self.source.invalid(&key, rule, say!(give_traffic)));
        }
        match &written.name {
            None if vehicles.len() == 1 => Ok(0),
            None => {
                let names: Vec<&str> = vehicles.iter().map(|vehicle| &*vehicle.name).collect();
                let help = say!(traffic_has_several_vehicles, names = names.join(", "));
                Err(self.source.missing(&format!("{at}.name"), help))
            }
            Some(name) => vehicles.iter().position(|vehicle| vehicle.name == *name).ok_or_else(|| {
                let rule = say!(is_name_of_no_vehicle, name);
                self.source.invalid(&format!("{at}.name"), rule, "")
            }),
        }
    }
}

/// The quantity of a key, where that of the case is `of_key`; or the rule that it breaks, and help.
pub(super) fn quantity_of(key: &str, of_key: &str) -> Result<quantity::Kind, (Message, Message)> {
    let quantity = match (key.strip_prefix("vehicle."), PhysicalRange::of(of_key)) {
        (Some(_), Some(range)) => Some(range.kind),
        (Some("traction_share"), None) => Some(quantity::Kind::of::<Ratio>()),
        _ => match CaseKey::find_with_curving(of_key) {
            Some(known) => known.quantity,
            None => {
                let nearest = CaseKey::nearest(of_key);
                return Err((say!(is_no_key_of_the_case, name = key), say!(the_nearest_key_is, key = nearest)));
            }
        },
    };
    quantity.ok_or_else(|| {
        let rule = say!(is_key_of_no_quantity, name = key);
        (rule, say!(only_quantities_are_uncertain))
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

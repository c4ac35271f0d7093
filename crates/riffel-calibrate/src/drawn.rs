//! A case and its traffic with the values of draws.

use rayon::prelude::*;
use riffel_case::Case;
use riffel_case::file::Creepage;
use riffel_case::traffic::{Traffic, Vehicle};
use riffel_keys::CaseError;
use riffel_keys::quantity::Quantity;
use toml::{Table, Value};

use crate::chains::Chains;
use crate::error::CalibrationError;
use crate::model::{Role, VehicleKey};
use crate::plan::Plan;

/// A case and its traffic with the values of one draw.
pub struct Drawn {
    /// The case as trains meet it.
    pub case: Case,
    /// The traffic of the plan, if it names one.
    pub traffic: Option<Traffic>,
}

impl Plan {
    /// The case with the values of draws that lie evenly in the chains, `most` at most.
    ///
    /// It is the case that the dated levels of the plan see, with what it sets for them; without such data the case of the plan
    /// with the values that act in all data.
    ///
    /// # Errors
    /// [`CalibrationError::Refused`] where the case or the traffic refuses the values of a draw.
    pub fn drawn(&self, chains: &Chains, most: usize) -> Result<Vec<Drawn>, CalibrationError> {
        let drawn = chains.evenly(most).into_par_iter().map(|draw| {
            let values = self.posterior.values(&draw.place);
            self.with_values(&values).map_err(|error| CalibrationError::Refused(error.to_string()))
        });
        drawn.collect()
    }

    /// The case and its traffic with values of all parameters in SI.
    ///
    /// # Errors
    /// [`CaseError`] where they refuse a value.
    pub fn with_values(&self, values: &[f64]) -> Result<Drawn, CaseError> {
        let model = &self.posterior.model;
        let view = &model.views[self.trains];
        let numbers = model.trial(values).numbers(self.trains);
        let numbers = numbers.into_iter();
        let settings: Vec<_> = numbers.map(|(key, value)| (key.to_owned(), Value::Float(value))).collect();
        let edited = self.traffic.as_ref().map(|traffic| {
            traffic.edit(|file| {
                for &index in &view.acting {
                    if let Role::Vehicle(vehicle, key) = &model.parameters[index].role {
                        write(&mut file.vehicle[*vehicle], key, values[index]);
                    }
                }
            })
        });
        Ok(Drawn { case: view.case.with(&settings[..])?, traffic: edited.transpose()? })
    }

    /// What the plan sets for trains beside its case, as `track.model = "two-layer"`.
    pub fn set_for_trains(&self) -> Vec<String> {
        let levels = self.file.data.iter();
        let set = levels.filter(|data| data.kind == crate::file::Kind::DatedLevels);
        let settings = set.flat_map(|data| riffel_case::settings(&data.set));
        settings.map(|(key, value)| format!("{key} = {value}")).collect()
    }
}

/// Give a key of a vehicle its value.
fn write(vehicle: &mut Vehicle, key: &VehicleKey, value: f64) {
    match key {
        VehicleKey::MeanSpeed => {
            if let Some(speed) = &mut vehicle.speed {
                speed.mean = Quantity::new(value);
            }
        }
        VehicleKey::SpeedDeviation => {
            if let Some(speed) = &mut vehicle.speed {
                speed.standard_deviation = Some(Quantity::new(value));
            }
        }
        VehicleKey::TractionShare => vehicle.traction_share = Some(Quantity::new(value)),
        VehicleKey::OfCase(key, factor) => {
            let value = factor * value;
            match key.as_str() {
                "contact.normal_load" => {
                    vehicle.axle_load = None;
                    vehicle.wheel_load = Some(Quantity::new(value));
                }
                "contact.tractive_ratio" => vehicle.tractive_ratio = Some(Quantity::new(value)),
                "contact.creepage" => {
                    vehicle.creepage = Some(Creepage::Longitudinal(Quantity::new(value)));
                }
                "wheel.mass" => vehicle.wheel_mass = Some(Quantity::new(value)),
                "wheel.rolling_radius" => vehicle.rolling_radius = Some(Quantity::new(value)),
                key => insert(&mut vehicle.set, key, value),
            }
        }
    }
}

/// Write a number under a key with dots.
fn insert(table: &mut Table, key: &str, value: f64) {
    match key.split_once('.') {
        None => {
            table.insert(key.to_owned(), Value::Float(value));
        }
        Some((first, rest)) => {
            let inner = table.entry(first).or_insert_with(|| Value::Table(Table::new()));
            if let Value::Table(inner) = inner {
                insert(inner, rest, value);
            }
        }
    }
}

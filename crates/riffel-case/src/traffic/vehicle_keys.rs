//! What the keys of a vehicle say of the case: each thing once, and nothing without effect.

use riffel::STANDARD_GRAVITY;
use riffel_keys::{CaseError, KeyFile, say};
use toml::{Table, Value};

use super::spreads::{FRICTION, LOAD, Spreads, WHEEL_RADIUS, place_of};
use super::{Traffic, Vehicle};
use crate::Case;
use crate::file::setting::{Setting, settings};
use crate::text::case_text::is_within;

const CREEPAGE: &str = "contact.creepage";
const TRACTIVE_RATIO: &str = "contact.tractive_ratio";

/// What a vehicle gives the case, each with the key of the vehicle that it comes from.
pub(super) fn settings_of(vehicle: &Vehicle) -> Vec<(String, Setting)> {
    let wheel = |mass: f64| 0.5 * mass * STANDARD_GRAVITY;
    let load = vehicle.axle_load.map(|mass| wheel(mass.si()));
    let numbers = [
        ("axle_load", LOAD, load),
        ("wheel_load", LOAD, vehicle.wheel_load.map(|force| force.si())),
        ("wheel_mass", "wheel.mass", vehicle.wheel_mass.map(|mass| mass.si())),
        ("rolling_radius", WHEEL_RADIUS, vehicle.rolling_radius.map(|radius| radius.si())),
        ("tractive_ratio", TRACTIVE_RATIO, vehicle.tractive_ratio.map(|ratio| ratio.si())),
    ];
    let creepage = vehicle.creepage.map(|creepage| ("creepage".to_owned(), creepage.setting()));
    let numbers = numbers
        .into_iter()
        .filter_map(|(own, key, value)| Some((own.to_owned(), (key.to_owned(), Value::Float(value?)))));
    let others = settings(&vehicle.set).into_iter();
    let others = others.map(|setting| (format!("set.{}", setting.0), setting));
    creepage.into_iter().chain(numbers).chain(others).collect()
}

/// The keys of a vehicle, each with the key of the case that it says. A tractive ratio says the creepage.
fn said_keys(vehicle: &Vehicle, spreads: &Spreads) -> Vec<(String, String)> {
    let given = settings_of(vehicle).into_iter().flat_map(|(own, setting)| {
        let keys = settings(&Table::from_iter([setting])).into_iter();
        keys.map(move |(key, _)| (own.clone(), key))
    });
    let spread = spreads.of_keys.iter().map(|it| (it.own.clone(), it.key.clone()));
    let keys = given.chain(spread);
    keys.map(|(own, key)| if key == TRACTIVE_RATIO { (own, CREEPAGE.to_owned()) } else { (own, key) }).collect()
}

/// `Ok` unless two keys of a vehicle say one key of the case.
pub(super) fn said_once(source: &KeyFile, index: usize, vehicle: &Vehicle, spreads: &Spreads) -> Result<(), CaseError> {
    let said = said_keys(vehicle, spreads);
    for (place, (own, key)) in said.iter().enumerate() {
        let says_it = |(_, said): &&(String, String)| is_within(key, said) || is_within(said, key);
        if let Some((other, _)) = said[..place].iter().find(says_it) {
            let rule = say!(and_exclude_each_other, other = place_of(index, other));
            return Err(source.invalid(&place_of(index, own), rule, say!(give_one_of_the_two)));
        }
    }
    Ok(())
}

impl Traffic {
    /// `Ok` unless a key of a vehicle has no effect on a case, or says what only a curve says there.
    pub(super) fn check_keys_on(&self, index: usize, case: &Case) -> Result<(), CaseError> {
        let vehicle = &self.file.vehicle[index];
        let in_curve = vehicle.brings_curve();
        for (own, key) in said_keys(vehicle, &self.spreads[index]) {
            let at = place_of(index, &own);
            let within = |tables: &[&str]| tables.iter().any(|table| is_within(&key, table));
            let is_set = own.starts_with("set.");
            let refused = if within(&["map", "title"]) {
                say!(key_of_vehicle_without_effect, key = &at)
            } else if in_curve && within(&["contact.from.wheelset"]) {
                say!(wheelset_of_vehicle_in_curve, key = &at)
            } else if in_curve && within(&["curve.speed"]) && case.unfilled.keys.has("curve.speed") {
                say!(speed_of_vehicle_in_curve, key = &at)
            } else if in_curve && !is_set && within(&[CREEPAGE]) {
                say!(creepage_of_vehicle_in_curve, key = &at)
            } else if !in_curve && case.is_in_curve() && !is_set && within(&[CREEPAGE, FRICTION, LOAD, WHEEL_RADIUS]) {
                say!(key_of_vehicle_beside_curve_of_case, key = &at)
            } else {
                continue;
            };
            return Err(self.source.refuse(&at, &refused));
        }
        Ok(())
    }
}

//! All wheels of a vehicle in its curve, each with its own mean state at each speed.

use riffel::STANDARD_GRAVITY;
use riffel_curving::VehicleInCurve;
use riffel_keys::{CaseError, say};

use super::spreads::{FRICTION, LOAD, PartValues, WHEEL_RADIUS, place_of};
use super::vehicle_keys::settings_of;
use super::{CurveOfVehicle, Traffic};
use crate::curve::CurvingCase;
use crate::curve::Equilibrium;
use crate::file::setting::Setting;
use crate::file::{FromCurve, RailFriction};
use crate::keys::written_keys::WrittenKeys;
use crate::text::case_text::{CaseText, is_within};
use crate::{Case, Variant};

/// Keys of a case that the equilibrium of a vehicle gives in their place, where the case takes its own mean state from no curve.
const MEAN_STATE: [&str; 9] = [
    "contact.creepage",
    "contact.tractive_ratio",
    "contact.normal_load",
    "contact.contact_angle",
    "contact.lateral_offset",
    "contact.longitudinal_radius",
    "contact.transverse_radius",
    "contact.friction",
    "opposite_contact",
];

/// Tables that belong to a vehicle in its curve.
const OF_VEHICLE: [&str; 4] = ["curve.", "bogie.", "body.", "profiles."];

/// True for a key of a table that belongs to a vehicle in its curve.
pub(super) fn is_of_vehicle(key: &str) -> bool {
    OF_VEHICLE.iter().any(|table| key.starts_with(table))
}

/// A vehicle in its curve, before it is balanced.
pub(super) struct ThroughCurve {
    curving: CurvingCase,
    vehicle: VehicleInCurve,
    /// What its wheels have of their own.
    pub(super) values: PartValues,
}

impl Traffic {
    /// The curve of a vehicle with values of some of its wheels; `None` if it brings no curve.
    pub(super) fn through_curve(
        &self,
        index: usize,
        case: &Case,
        variant: &Variant,
        values: &PartValues,
    ) -> Result<Option<ThroughCurve>, CaseError> {
        let vehicle = &self.file.vehicle[index];
        let mut curving = match &vehicle.curve {
            None | Some(CurveOfVehicle::OfCase(false)) => return Ok(None),
            Some(CurveOfVehicle::OfCase(true)) => {
                let sets = [&crate::file::setting::settings(&vehicle.set)[..], &variant.settings];
                let mut text = case.text_with(&sets)?;
                let from = text.keys.has("contact.from").then(|| text.asks_for());
                match from.transpose()?.and_then(|from| from.curve) {
                    Some(_) => {
                        text.fill_in()?;
                        text.curving_case(&text.asks_for()?, &text, case.keys.folder.as_deref())?
                    }
                    None if !text.keys.has("curve") => {
                        let key = place_of(index, "curve");
                        return Err(self.source.refuse(&key, say!(curve_of_vehicle_without_curve_of_case, key = &key)));
                    }
                    None => CurvingCase::of_tables(text, case.keys.folder.as_deref())?,
                }
            }
            Some(CurveOfVehicle::File(file)) => {
                let own = crate::file::setting::settings(&vehicle.set);
                let of_vehicle = own.iter().chain(&variant.settings);
                let of_vehicle = of_vehicle.filter(|(key, _)| is_of_vehicle(key) || is_within(key, FRICTION));
                let overrides: Vec<String> = of_vehicle.map(|(key, value)| format!("{key}={value}")).collect();
                CurvingCase::read(&self.folder.join(file), &overrides)?
            }
        };
        // A variant goes before the vehicle.
        let values = match variant.keys().any(|key| key == FRICTION) {
            true => &values.without_friction(),
            false => values,
        };
        let into_bogie = |(own, _): &(String, Setting)| ["axle_load", "wheel_load", "rolling_radius"].contains(&&**own);
        let mut values = values.with(settings_of(vehicle).into_iter().filter(into_bogie));
        if let Some(RailFriction::Each(rails)) = curving.file.contact.as_ref().map(|contact| contact.friction) {
            values =
                values.on_rails(RailFriction::Each(rails).of_rails(), self.file.line.friction_days).map_err(|own| {
                    let key = place_of(index, &own);
                    let message = say!(friction_of_both_rails, key = &key, left = rails.left, right = rails.right);
                    self.source.refuse(&key, &message)
                })?;
        }
        let mut overrides = Vec::new();
        if let (Some(load), Some(bogie)) = (values.of(LOAD), &curving.file.bogie) {
            let mass = 2.0 * load / STANDARD_GRAVITY;
            let more = mass - bogie.mass_per_axle.si();
            let body = curving.file.body.as_ref().map(|body| body.mass.si() + 4.0 * more);
            overrides.push(format!("bogie.mass_per_axle={mass:?}"));
            overrides.extend(body.map(|body| format!("body.mass={body:?}")));
        }
        let of_curve = |key: &str| is_of_vehicle(key) || [FRICTION, WHEEL_RADIUS].contains(&key);
        let of_part = values.settings().filter(|(_, (key, _))| of_curve(key));
        overrides.extend(of_part.map(|(_, (key, value))| format!("{key}={value}")));
        if !overrides.is_empty() {
            curving = curving.with(&overrides)?;
        }
        curving.shared = case.keys.given.profiles.or_kept();
        let vehicle = curving.vehicle_in_curve()?;
        Ok(Some(ThroughCurve { curving, vehicle, values }))
    }
}

impl ThroughCurve {
    /// Its wheelsets.
    pub(super) fn wheelsets(&self) -> usize {
        self.vehicle.running_gear.wheelsets()
    }

    /// The vehicle balanced at a speed \[m/s\].
    pub(super) fn at(&self, speed: f64) -> Result<Equilibrium, CaseError> {
        let mut vehicle = self.vehicle.clone();
        vehicle.curve.speed = speed;
        let state = self.curving.equilibrium(&vehicle)?;
        Ok(Equilibrium::new(self.curving.clone(), vehicle, vec![state]))
    }
}

/// The keys of the case with settings, before a wheel of a vehicle in its curve gives them their mean state.
pub(crate) fn before_a_wheel(case: &Case, sets: &[&[Setting]]) -> Result<(WrittenKeys, FromCurve), CaseError> {
    let mut text = case.text_with(sets)?;
    if !text.keys.has("contact.from") {
        text.asks_for_low_rail();
    }
    let written = WrittenKeys::read(text, case.keys.folder.as_deref())?;
    let Some(from) = written.from.clone() else {
        unreachable!("the text asks for a wheel");
    };
    Ok((written, from))
}

impl CaseText {
    /// Take the mean state of a case without a curve from a wheel on its rail: that of the wheelset, or else the low one.
    fn asks_for_low_rail(&mut self) {
        for key in MEAN_STATE {
            self.keys.remove(key);
        }
        let rail = self.keys.text_of("wheelset.rail").unwrap_or("low").to_owned();
        self.keys.put("contact.from.rail", rail);
        self.keys.put("contact.from.wheelset", 1);
    }
}

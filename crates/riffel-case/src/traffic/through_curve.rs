//! All wheels of a vehicle in its curve, each with its own mean state at each speed.

use std::sync::Arc;

use riffel::STANDARD_GRAVITY;
use riffel::curving::VehicleInCurve;
use riffel_keys::CaseError;
use toml::Value;

use super::spreads::{FRICTION, LOAD, PartValues, WHEEL_RADIUS};
use super::{CurveOfVehicle, Traffic};
use crate::curve::CurvingCase;
use crate::curve::Equilibrium;
use crate::file::setting::Setting;
use crate::parts::window::Window;
use crate::text::case_text::CaseText;
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
pub(super) const OF_VEHICLE: [&str; 4] = ["curve.", "bogie.", "body.", "profiles."];

/// A vehicle in its curve, before it is balanced.
pub(super) struct ThroughCurve {
    curving: CurvingCase,
    vehicle: VehicleInCurve,
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
                    None => CurvingCase::of_tables(text, case.keys.folder.as_deref())?,
                }
            }
            Some(CurveOfVehicle::File(file)) => CurvingCase::read(&self.folder.join(file), &[])?,
        };
        if let Some(CurveOfVehicle::File(_)) = &vehicle.curve {
            let own = crate::file::setting::settings(&vehicle.set);
            let of_vehicle = own
                .iter()
                .chain(&variant.settings)
                .filter(|(key, _)| OF_VEHICLE.iter().any(|table| key.starts_with(table)) || key == "contact.friction");
            for (key, value) in of_vehicle {
                curving = curving.with(&format!("{key}={value}"))?;
            }
        }
        if let (Some(load), Some(bogie)) = (values.of(LOAD), &curving.file.bogie) {
            let mass = 2.0 * load / STANDARD_GRAVITY;
            let more = mass - bogie.mass_per_axle.si();
            let body = curving.file.body.as_ref().map(|body| body.mass.si() + 4.0 * more);
            curving = curving.with(&format!("bogie.mass_per_axle={mass:?}"))?;
            if let Some(body) = body {
                curving = curving.with(&format!("body.mass={body:?}"))?;
            }
        }
        for (_, (key, value)) in values.settings() {
            let of_wheel = [FRICTION, WHEEL_RADIUS].contains(&&*key);
            if of_wheel || OF_VEHICLE.iter().any(|table| key.starts_with(table)) {
                curving = curving.with(&format!("{key}={value}"))?;
            }
        }
        curving.shared = case.keys.given.profiles.or_kept();
        let vehicle = curving.vehicle_in_curve()?;
        Ok(Some(ThroughCurve { curving, vehicle }))
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

impl Case {
    /// The case with one wheel of a balanced vehicle on its rail under study, and with settings: the wheel of the wheelset that is
    /// counted from 1.
    pub(crate) fn on_wheelset(
        &self,
        equilibrium: &Arc<Equilibrium>,
        wheelset: usize,
        sets: &[&[Setting]],
        window: Window,
    ) -> Result<Self, CaseError> {
        let mut text = self.text_with(sets)?;
        if !text.keys.has("contact.from") {
            text.asks_for_low_rail();
        }
        text.keys.write("contact.from.wheelset", Value::Integer(wheelset as i64))?;
        let mut given = self.keys.given.clone();
        given.equilibrium = Some(equilibrium.clone());
        let folder = self.keys.folder.as_deref();
        Self::of_text(text, folder, given, window)
    }
}

impl CaseText {
    /// Take the mean state of a case without a curve from a wheel on its rail: that of the wheelset, or else the low one.
    fn asks_for_low_rail(&mut self) {
        for key in MEAN_STATE {
            self.keys.remove(key);
        }
        let rail = self.keys.text_of("wheelset.rail").unwrap_or("low").to_owned();
        self.keys.put("contact.from.rail", rail);
    }
}

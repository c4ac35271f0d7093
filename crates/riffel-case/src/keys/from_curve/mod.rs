//! The mean state of the contact from a bogie in its curve.

mod curve_remarks;
mod fill;
mod loaded_patch;
mod mean_contact;

use std::path::Path;
use std::sync::Arc;

use riffel::Rail;
use riffel_curving::VehicleInCurve;
use riffel_keys::{CaseError, Message, say};
use serde::Deserialize;

use crate::curve::{CurvingCase, Equilibrium};
use crate::file::{CaseFile, ContactDynamics, CreepLawName, FromCurve, OppositeRail, RailSide};
use crate::keys::checked_keys::CheckedKeys;
use crate::keys::mean::{Mean, MeanOfWheel};
use crate::keys::substitutes::Substitutes;
use crate::keys::written_keys::WrittenKeys;
use crate::parts::window::Window;
use crate::text::case_text::CaseText;

/// Keys without which there is no case, and which a wheel of a curve gives.
const GIVEN: [&str; 4] =
    ["contact.normal_load", "contact.transverse_radius", "contact.friction", "wheel.rolling_radius"];
/// Also where the contact moves across the profiles.
const RAIL_RADIUS: &str = "contact.conformity.rail_radius";

/// A case as far as it says where its mean state comes from.
#[derive(Deserialize)]
struct Asking {
    contact: AskingContact,
}

#[derive(Deserialize)]
struct AskingContact {
    from: FromCurve,
}

/// Keys of a case while a wheel of a vehicle in its curve gives them their mean state.
///
/// A lone wheel is always on the right rail: one on the left is turned over, with lateral creepage and spin of the other sign.
struct Placing<'a> {
    text: &'a CaseText,
    file: CaseFile,
    remarks: Vec<Message>,
    /// Keys that were given.
    given: Vec<String>,
    /// Keys that have another value of their own.
    instead: Vec<String>,
}

/// Keys that a case may leave out that takes its mean state from a curve, and no other.
pub(crate) fn stand_ins(text: &CaseText) -> Vec<&'static str> {
    if !text.keys.has("contact.from") {
        return Vec::new();
    }
    let moves = text.is_table("contact.conformity").then_some(RAIL_RADIUS);
    GIVEN.into_iter().chain(moves).collect()
}

impl WrittenKeys {
    /// The vehicle that a wheel is taken from, balanced in its curve.
    pub(crate) fn equilibrium(&self, from: &FromCurve, given: &Substitutes) -> Result<Equilibrium, CaseError> {
        let text = &self.text;
        if from.curve.is_some() && self.folder.is_none() {
            return Err(text.names_a_file("contact.from.curve"));
        }
        if from.curve.is_some()
            && let Some(table) = ["curve", "bogie", "body", "profiles"].into_iter().find(|table| text.keys.has(table))
        {
            let rule = "is another file, but the tables of a curve stand in this one";
            let help = format!("leave contact.from.curve out, or [{table}]");
            return Err(text.keys.invalid("contact.from.curve", rule, &help));
        }
        let mut curving = text.curving_case(from, &self.unfilled, self.folder.as_deref())?;
        curving.shared = given.profiles.clone();
        let vehicle = curving.vehicle_in_curve()?;
        // Asked before the vehicle is balanced, which takes a while.
        text.check_wheelset(from, &vehicle)?;
        // The first is the same; others are but told of.
        let states = match given.quick {
            true => vec![curving.equilibrium(&vehicle)?],
            false => curving.equilibria(&vehicle)?,
        };
        Ok(Equilibrium::new(curving, vehicle, states))
    }

    /// The keys with what one contact of a balanced vehicle says in the place of those that are not written: creepages, contact angle,
    /// normal load, radii of the ellipse, place on the rail and friction of the rail under study, those of the opposite rail where
    /// it is not absent, the rail of the wheelset and the rolling radius. Values of presets give way.
    pub(crate) fn on_wheel(
        &self,
        equilibrium: &Arc<Equilibrium>,
        from: &FromCurve,
        given: Substitutes,
        window: Window,
    ) -> Result<CheckedKeys, CaseError> {
        self.text.check_wheelset(from, &equilibrium.vehicle)?;
        let mut placing = Placing {
            text: &self.text,
            file: self.file.clone(),
            remarks: Vec::new(),
            given: Vec::new(),
            instead: Vec::new(),
        };
        let (outward, tractive_ratio) = placing.put_on_wheel(from, equilibrium, given.quick)?;
        let Placing { file, remarks, given: keys, .. } = placing;
        let is_left_out = |key: &&str| !self.text.keys.has(key) && !keys.iter().any(|given| given == key);
        if let Some(key) = stand_ins(&self.text).into_iter().find(is_left_out) {
            return Err(self.text.keys.missing(key, ""));
        }
        let (equilibrium, from) = (equilibrium.clone(), from.clone());
        let mean = MeanOfWheel { equilibrium, from, remarks, tractive_ratio, outward };
        CheckedKeys::complete(self, file, Mean::OfWheel(Arc::new(mean)), given, window)
    }
}

impl Placing<'_> {
    /// The keys of one contact in an equilibrium: where it runs on the rail, and |Q|/μP of it where no key has a value of its own.
    fn put_on_wheel(
        &mut self,
        from: &FromCurve,
        equilibrium: &Equilibrium,
        quick: bool,
    ) -> Result<(Option<f64>, Option<f64>), CaseError> {
        let Equilibrium { curving, vehicle, states, .. } = equilibrium;
        self.remarks.extend(curving.remarks_of_profiles()?);
        let radius = vehicle.curve.radius;
        let rail = from.rail.in_curve(radius);
        if states.len() > 1 {
            let which = match states[0].continuation.is_empty() {
                false => say!(equilibrium_from_straight_track),
                true => say!(equilibrium_found_first),
            };
            self.remarks.push(say!(several_equilibria, count = states.len(), which));
        }
        let mut study = self.contact_of(from, equilibrium, rail)?;
        self.put_rail_of_wheelset(from, rail, radius)?;
        self.put_friction("contact.friction", study.friction, |file| &mut file.contact.friction)?;
        let mirrored = self.file.wheelset.is_none() && rail == Rail::Left;
        let radius_of_wheel = curving.file.wheel.rolling_radius.si();
        self.put("wheel.rolling_radius", radius_of_wheel, |file| &mut file.wheel.rolling_radius)?;
        // A response that is late has the exact law by itself.
        let is_late = self.file.contact.response == ContactDynamics::NonSteady;
        if !is_late {
            self.file.contact.creep_law.get_or_insert(CreepLawName::SHEN_HEDRICK_ELKINS);
        }
        self.take_patch(from.patch.unwrap_or_default(), curving, rail, &mut study, quick)?;
        let at_tractive_ratio = self.text.is_written("contact.tractive_ratio");
        if at_tractive_ratio {
            self.instead.push("contact.tractive_ratio".to_owned());
        }
        let keys = ["contact", RAIL_RADIUS];
        self.put_contact(keys, fill::under_study, rail, &study, mirrored, !at_tractive_ratio)?;
        self.put_opposite(from, equilibrium, quick)?;
        self.tell_where_from(from, rail, &vehicle.curve, &study);
        self.tell_of_second_point(rail, study.elsewhere);
        let outward = study.place.as_ref().map(|place| place.outward);
        if self.instead.is_empty() {
            return Ok((outward, Some(study.tractive_ratio)));
        }
        let instead = self.instead.join(", ");
        self.remarks.push(say!(case_has_own_values, instead));
        Ok((outward, None))
    }

    /// The rail of the wheelset, which may be written if it is that of the curve.
    fn put_rail_of_wheelset(&mut self, from: &FromCurve, rail: Rail, radius: f64) -> Result<(), CaseError> {
        let Some(wheelset) = &mut self.file.wheelset else {
            return Ok(());
        };
        if self.text.keys.has("wheelset.rail") && wheelset.rail.of_track() != rail {
            let rule = say!(
                is_other_rail_in_this_curve,
                name = wheelset.rail.of_track().name(),
                of = from.rail.name(),
                rail = rail.name(),
                radius,
            );
            return Err(self.text.keys.invalid("wheelset.rail", rule, say!(leave_it_out)));
        }
        wheelset.rail = RailSide::of(rail);
        Ok(())
    }

    /// The keys of the contact on the other rail, where that takes part.
    fn put_opposite(&mut self, from: &FromCurve, equilibrium: &Equilibrium, quick: bool) -> Result<(), CaseError> {
        let opposite = self.file.wheelset.as_ref().map(|wheelset| wheelset.opposite_rail);
        let is_smooth = opposite == Some(OppositeRail::Smooth);
        if opposite.is_none_or(|kind| kind == OppositeRail::Absent) {
            return Ok(());
        }
        let Equilibrium { curving, vehicle, .. } = equilibrium;
        let rail = from.rail.in_curve(vehicle.curve.radius).opposite();
        let told = self.remarks.len();
        let on_tread = FromCurve { contact: None, ..from.clone() };
        let mut other = self.contact_of(&on_tread, equilibrium, rail)?;
        // Nothing will be said of a smooth rail.
        self.take_patch(from.patch.unwrap_or_default(), curving, rail, &mut other, quick || is_smooth)?;
        self.put_friction("opposite_contact.friction", other.friction, |file| {
            &mut file.opposite_contact.get_or_insert_default().friction
        })?;
        let keys = ["opposite_contact", "opposite_contact.rail_radius"];
        self.put_contact(keys, fill::opposite, rail, &other, false, true)?;
        self.tell_of_second_point(rail, other.elsewhere);
        if is_smooth {
            // A rail without waves is not asked about.
            self.remarks.truncate(told);
        }
        Ok(())
    }
}

impl CaseText {
    /// `Ok` if a vehicle has the wheelset that is asked for.
    fn check_wheelset(&self, from: &FromCurve, vehicle: &VehicleInCurve) -> Result<(), CaseError> {
        let wheelsets = vehicle.running_gear.wheelsets();
        if !(1..=wheelsets).contains(&usize::from(from.wheelset)) {
            let last = match wheelsets {
                1 => "the only one".to_owned(),
                2 => "which leads, or 2".to_owned(),
                last => format!("which leads, to {last}"),
            };
            let rule = format!("is {}, but must be 1, {last}", from.wheelset);
            return Err(self.keys.invalid("contact.from.wheelset", &rule, ""));
        }
        Ok(())
    }

    /// Which contact of the curve `contact.from` asks for.
    pub(crate) fn asks_for(&self) -> Result<FromCurve, CaseError> {
        let Asking { contact: AskingContact { from } } = self.keys.deserialize()?;
        Ok(from)
    }

    /// The case of the curve: a file, or the tables of this one.
    pub(crate) fn curving_case(
        &self,
        from: &FromCurve,
        unfilled: &Self,
        folder: Option<&Path>,
    ) -> Result<CurvingCase, CaseError> {
        if let (Some(file), Some(folder)) = (&from.curve, folder) {
            return CurvingCase::read(&folder.join(file), &[]);
        }
        CurvingCase::of_tables(unfilled.clone(), folder)
    }
}

#[cfg(test)]
mod tests;

//! The mean state of the contact from a bogie in its curve.

mod curve_remarks;
mod fill;
mod loaded_patch;
mod mean_contact;

#[cfg(test)]
mod tests;

use std::path::Path;

use riffel::Rail;
use riffel::curving::VehicleInCurve;
use riffel_keys::{CaseError, say};
use serde::Deserialize;

use crate::curve::{CurvingCase, Equilibrium};
use crate::file::FromCurve;
use crate::keys::substitutes::Substitutes;
use crate::text::case_text::CaseText;

/// A case as far as it says where its mean state comes from.
#[derive(Deserialize)]
struct Asking {
    contact: AskingContact,
}

#[derive(Deserialize)]
struct AskingContact {
    from: FromCurve,
}

impl CaseText {
    /// Put what the equilibrium of a bogie says of the contacts in the place of keys that are not written, if `contact.from` asks for it:
    /// creepages, contact angle, normal load, radii of the ellipse, place on the rail and friction of the rail under study, those of the opposite rail where
    /// it is not absent, the rail of the wheelset and the rolling radius. `unfilled` are the keys without presets; values of presets give way.
    ///
    /// A lone wheel is always on the right rail: one on the left is turned over, with lateral creepage and spin of the other sign.
    /// An equilibrium that is given takes the place of that of the case.
    pub(crate) fn fill_in_from_curve(
        &mut self,
        unfilled: &Self,
        folder: Option<&Path>,
        given: &Substitutes,
    ) -> Result<(), CaseError> {
        if !self.keys.has("contact.from") {
            return Ok(());
        }
        let from = self.asks_for()?;
        if let Some(known) = &given.equilibrium {
            return self.fill_in_of(&from, known, true);
        }
        if from.curve.is_some() && folder.is_none() {
            return Err(self.names_a_file("contact.from.curve"));
        }
        if from.curve.is_some()
            && let Some(table) = ["curve", "bogie", "body", "profiles"].into_iter().find(|table| self.keys.has(table))
        {
            let rule = "is another file, but the tables of a curve stand in this one";
            let help = format!("leave contact.from.curve out, or [{table}]");
            return Err(self.keys.invalid("contact.from.curve", rule, &help));
        }
        let mut curving = self.curving_case(&from, unfilled, folder)?;
        curving.shared = given.profiles.clone();
        let vehicle = curving.vehicle_in_curve()?;
        // Asked before the vehicle is balanced, which takes a while.
        self.check_wheelset(&from, &vehicle)?;
        // The first is the same; others are but told of.
        let states = match given.quick {
            true => vec![curving.equilibrium(&vehicle)?],
            false => curving.equilibria(&vehicle)?,
        };
        self.fill_in_of(&from, &Equilibrium::new(curving, vehicle, states), given.quick)
    }

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

    /// The keys of one contact in an equilibrium; quickly, one of many, without the remarks that take a contact under load.
    fn fill_in_of(&mut self, from: &FromCurve, equilibrium: &Equilibrium, quick: bool) -> Result<(), CaseError> {
        let Equilibrium { curving, vehicle, states, .. } = equilibrium;
        self.curve_remarks.extend(curving.remarks_of_profiles()?);
        let radius = vehicle.curve.radius;
        let rail = from.rail.in_curve(radius);
        if states.len() > 1 {
            let which = match states[0].continuation.is_empty() {
                false => say!(equilibrium_from_straight_track),
                true => say!(equilibrium_found_first),
            };
            self.curve_remarks.push(say!(several_equilibria, count = states.len(), which));
        }
        let file = &curving.file;
        let mut study = self.contact_of(from, equilibrium, rail)?;
        let has_wheelset = self.keys.has("wheelset");
        if has_wheelset && self.keys.has("wheelset.rail") {
            let written = self.keys.text_of("wheelset.rail").unwrap_or_default();
            if written != rail.name() {
                let rule = say!(
                    is_other_rail_in_this_curve,
                    name = written,
                    of = from.rail.name(),
                    rail = rail.name(),
                    radius,
                );
                return Err(self.keys.invalid("wheelset.rail", rule, say!(leave_it_out)));
            }
        } else if has_wheelset {
            self.fill("wheelset.rail", rail.name());
        }
        let mut instead = Vec::new();
        self.put_friction("contact", study.friction, &mut instead);
        let mirrored = !has_wheelset && rail == Rail::Left;
        let radius_of_wheel = file.wheel.rolling_radius.si();
        self.fill_number("wheel.rolling_radius", radius_of_wheel, &mut instead);
        // A response that is late has the exact law by itself.
        let is_late = self.keys.text_of("contact.response") == Some("non-steady");
        if !is_late && !self.keys.has("contact.creep_law") {
            self.fill("contact.creep_law", "shen-hedrick-elkins");
        }
        let patch = from.patch.unwrap_or_default();
        self.take_patch(patch, curving, rail, &mut study, quick)?;
        self.contact_outward = study.place.as_ref().map(|place| place.outward);
        let at_tractive_ratio = self.is_written("contact.tractive_ratio");
        if at_tractive_ratio {
            instead.push("contact.tractive_ratio".to_owned());
        }
        self.fill_contact("contact", rail, &study, mirrored, !at_tractive_ratio, &mut instead)?;
        self.fill_opposite(from, equilibrium, quick, &mut instead)?;
        self.tell_where_from(from, rail, &vehicle.curve, &study);
        self.tell_of_second_point(rail, study.elsewhere);
        if instead.is_empty() {
            self.curve_tractive_ratio = Some(study.tractive_ratio);
        } else {
            let instead = instead.join(", ");
            self.curve_remarks.push(say!(case_has_own_values, instead));
        }
        Ok(())
    }

    /// The keys of the contact on the other rail, where that takes part; those that were written are named.
    fn fill_opposite(
        &mut self,
        from: &FromCurve,
        equilibrium: &Equilibrium,
        quick: bool,
        instead: &mut Vec<String>,
    ) -> Result<(), CaseError> {
        let opposite = self.keys.text_of("wheelset.opposite_rail");
        let is_smooth = opposite == Some("smooth");
        if opposite.is_none_or(|kind| kind == "absent") {
            return Ok(());
        }
        let Equilibrium { curving, vehicle, .. } = equilibrium;
        let rail = from.rail.in_curve(vehicle.curve.radius).opposite();
        let told = self.curve_remarks.len();
        let on_tread = FromCurve { contact: None, ..from.clone() };
        let mut other = self.contact_of(&on_tread, equilibrium, rail)?;
        // Nothing will be said of a smooth rail.
        self.take_patch(from.patch.unwrap_or_default(), curving, rail, &mut other, quick || is_smooth)?;
        self.put_friction("opposite_contact", other.friction, instead);
        self.fill_contact("opposite_contact", rail, &other, false, true, instead)?;
        self.tell_of_second_point(rail, other.elsewhere);
        if is_smooth {
            // A rail without waves is not asked about.
            self.curve_remarks.truncate(told);
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

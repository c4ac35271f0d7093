//! Keys that are not written take what the equilibrium says of a contact.

use riffel::Rail;
use riffel::contact::Creepages;
use riffel_keys::quantity::{Dimension, Quantity};
use riffel_keys::{CaseError, fixed, number, say};

use super::Placing;
use super::mean_contact::MeanContact;
use crate::file::{CaseFile, CreepLawName, Creepage, VectorCreepage};
use crate::keys::from_profiles::PlaceOnRail;

/// A number among the keys of a case, which may be left out.
pub(super) trait Slot {
    fn number(&self) -> Option<f64>;
    fn put(&mut self, si: f64);
}

impl<D: Dimension> Slot for Quantity<D> {
    fn number(&self) -> Option<f64> {
        Some(self.si())
    }

    fn put(&mut self, si: f64) {
        *self = Self::new(si);
    }
}

impl<D: Dimension> Slot for Option<Quantity<D>> {
    fn number(&self) -> Option<f64> {
        self.map(|quantity| quantity.si())
    }

    fn put(&mut self, si: f64) {
        *self = Some(Quantity::new(si));
    }
}

/// What a contact takes from a curve.
pub(super) struct ContactSlots<'a> {
    creepage: &'a mut Option<Creepage>,
    contact_angle: &'a mut dyn Slot,
    normal_load: &'a mut dyn Slot,
    stiffness: &'a mut dyn Slot,
    longitudinal_radius: &'a mut dyn Slot,
    transverse_radius: &'a mut dyn Slot,
    lateral_offset: &'a mut dyn Slot,
    /// Where the contact moves across the profiles.
    rail_radius: Option<&'a mut dyn Slot>,
}

/// What the contact on the rail under study takes.
pub(super) fn under_study(file: &mut CaseFile) -> ContactSlots<'_> {
    let contact = &mut file.contact;
    ContactSlots {
        creepage: &mut contact.creepage,
        contact_angle: &mut contact.contact_angle,
        normal_load: &mut contact.normal_load,
        stiffness: &mut contact.stiffness,
        longitudinal_radius: &mut contact.longitudinal_radius,
        transverse_radius: &mut contact.transverse_radius,
        lateral_offset: &mut contact.lateral_offset,
        rail_radius: contact.conformity.as_mut().map(|conformity| &mut conformity.rail_radius as _),
    }
}

/// What the contact on the other rail takes.
pub(super) fn opposite(file: &mut CaseFile) -> ContactSlots<'_> {
    let moves = file.contact.conformity.is_some();
    let contact = file.opposite_contact.get_or_insert_default();
    ContactSlots {
        creepage: &mut contact.creepage,
        contact_angle: &mut contact.contact_angle,
        normal_load: &mut contact.normal_load,
        stiffness: &mut contact.stiffness,
        longitudinal_radius: &mut contact.longitudinal_radius,
        transverse_radius: &mut contact.transverse_radius,
        lateral_offset: &mut contact.lateral_offset,
        rail_radius: moves.then_some(&mut contact.rail_radius),
    }
}

/// Slots of a contact in a case.
pub(super) type SlotsOf = for<'a> fn(&'a mut CaseFile) -> ContactSlots<'a>;

/// Components of a creepage; zero where it is left out.
fn components(creepage: &mut Option<Creepage>) -> &mut VectorCreepage {
    let vector = match creepage.take() {
        Some(Creepage::Vector(vector)) => vector,
        _ => VectorCreepage::default(),
    };
    match creepage.insert(Creepage::Vector(vector)) {
        Creepage::Vector(vector) => vector,
        Creepage::Longitudinal(_) => unreachable!("a vector was put there"),
    }
}

impl Placing<'_> {
    /// What is not written of a contact.
    pub(super) fn put_contact(
        &mut self,
        [table, rail_radius]: [&str; 2],
        slots: SlotsOf,
        rail: Rail,
        contact: &MeanContact,
        mirrored: bool,
        creeps: bool,
    ) -> Result<(), CaseError> {
        let key = |name: &str| format!("{table}.{name}");
        self.put_creepages(table, slots, contact.creepages, mirrored, creeps)?;
        self.put(&key("contact_angle"), contact.contact_angle, |file| slots(file).contact_angle)?;
        self.put(&key("normal_load"), contact.normal_force, |file| slots(file).normal_load)?;
        if let Some(stiffness) = contact.stiffness {
            self.put(&key("stiffness"), stiffness, |file| slots(file).stiffness)?;
        }
        self.put(&key("longitudinal_radius"), contact.longitudinal_radius, |file| slots(file).longitudinal_radius)?;
        if let Some(place) = &contact.place {
            let to_the_right = if mirrored { 1.0 } else { rail.sign() };
            self.put(&key("lateral_offset"), to_the_right * place.outward, |file| slots(file).lateral_offset)?;
            self.put_rail_radius(rail_radius, slots, place)?;
        }
        if let Some(radius) = contact.transverse_radius {
            let key = key("transverse_radius");
            if !(radius > 0.0 && radius.is_finite()) {
                let curvature = number(format_args!("{:.2}", radius.recip()));
                let message = say!(the_profiles_do_not_part_across, curvature, key);
                return Err(self.text.keys.refuse("contact.from", &message));
            }
            self.put(&key, radius, |file| slots(file).transverse_radius)?;
        }
        Ok(())
    }

    /// The radius of the rail where the contact moves across the profiles, if the case asks for that.
    fn put_rail_radius(&mut self, key: &str, slots: SlotsOf, place: &PlaceOnRail) -> Result<(), CaseError> {
        let radius = place.rail_curvature.recip();
        let is_convex = radius > 0.0 && radius.is_finite();
        if slots(&mut self.file).rail_radius.is_none() || !is_convex && self.text.is_written(key) {
            return Ok(());
        }
        if !is_convex {
            let curvature = number(format_args!("{:.2}", place.rail_curvature));
            let message = say!(the_rail_is_not_convex_where, curvature, key);
            return Err(self.text.keys.refuse("contact.from", &message));
        }
        self.put(key, radius, |file| match slots(file).rail_radius {
            Some(slot) => slot,
            None => unreachable!("the contact moves"),
        })
    }

    /// Creepages that are not written, if any are to be put; a number is the whole creepage. A wheel that is turned over has lateral
    /// creepage and spin of the other sign.
    fn put_creepages(
        &mut self,
        table: &str,
        slots: SlotsOf,
        Creepages { longitudinal, lateral, spin }: Creepages,
        mirrored: bool,
        creeps: bool,
    ) -> Result<(), CaseError> {
        let key = |name: &str| format!("{table}.creepage{name}");
        let turn = if mirrored { -1.0 } else { 1.0 };
        if let Some(Creepage::Longitudinal(_)) = slots(&mut self.file).creepage {
            self.instead.push(key(""));
            return Ok(());
        }
        if !creeps {
            return Ok(());
        }
        self.put(&key(".longitudinal"), longitudinal, |file| &mut components(slots(file).creepage).longitudinal)?;
        self.put(&key(".lateral"), turn * lateral, |file| &mut components(slots(file).creepage).lateral)?;
        let spin = turn * spin;
        let key = key(".spin");
        // None, with a word, where the creep law of the loop knows none.
        let law = self.file.contact.creep_law.and_then(CreepLawName::entry);
        let Some(law) = law.filter(|law| !law.spin) else {
            return self.put(&key, spin, |file| &mut components(slots(file).creepage).spin);
        };
        if !self.text.is_written(&key) {
            self.remarks.push(say!(creep_law_without_spin, name = law.name, spin = fixed(spin, 3), key));
        }
        Ok(())
    }

    /// Friction of one rail, in the place of a table of both, too.
    pub(super) fn put_friction(
        &mut self,
        key: &str,
        friction: f64,
        slot: impl FnOnce(&mut CaseFile) -> &mut dyn Slot,
    ) -> Result<(), CaseError> {
        match self.text.is_table(key) {
            true => self.give(key, friction, slot),
            false => self.put(key, friction, slot),
        }
    }

    /// Put a number in the place of a key that is not written, or of a preset; one that has another value of its own keeps it.
    pub(super) fn put(
        &mut self,
        key: &str,
        value: f64,
        slot: impl FnOnce(&mut CaseFile) -> &mut dyn Slot,
    ) -> Result<(), CaseError> {
        /// Relative difference that is none.
        const ALIKE: f64 = 1e-3;
        if !self.text.is_written(key) {
            return self.give(key, value, slot);
        }
        let own = slot(&mut self.file).number();
        if own.is_some_and(|own| (own - value).abs() > ALIKE * value.abs()) {
            self.instead.push(key.to_owned());
        }
        Ok(())
    }

    fn give(
        &mut self,
        key: &str,
        value: f64,
        slot: impl FnOnce(&mut CaseFile) -> &mut dyn Slot,
    ) -> Result<(), CaseError> {
        slot(&mut self.file).put(value);
        self.given.push(key.to_owned());
        self.text.keys.judge_number(key, value).map(drop)
    }
}

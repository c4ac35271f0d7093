//! Keys that are not written take what the equilibrium says of a contact.

use riffel::Rail;
use riffel::contact::Creepages;
use riffel_keys::{CaseError, fixed, number, say};
use toml::Value;

use super::mean_contact::MeanContact;
use crate::CaseKey;
use crate::file::CreepLawName;
use crate::keys::from_profiles::PlaceOnRail;
use crate::text::case_text::CaseText;

impl CaseText {
    /// What is not written of a contact.
    pub(super) fn fill_contact(
        &mut self,
        table: &str,
        rail: Rail,
        contact: &MeanContact,
        mirrored: bool,
        creeps: bool,
        instead: &mut Vec<String>,
    ) -> Result<(), CaseError> {
        let key = |name: &str| format!("{table}.{name}");
        let turn = if mirrored { -1.0 } else { 1.0 };
        // A number is the whole creepage.
        let is_number = self
            .keys
            .table()
            .get(table)
            .and_then(|contact| contact.get("creepage"))
            .is_some_and(|creepage| !creepage.is_table());
        if is_number {
            instead.push(key("creepage"));
        } else if creeps {
            let Creepages { longitudinal, lateral, spin } = contact.creepages;
            self.fill_number(&key("creepage.longitudinal"), longitudinal, instead);
            self.fill_number(&key("creepage.lateral"), turn * lateral, instead);
            self.fill_spin(&key("creepage.spin"), turn * spin, instead);
        }
        let angle = key("contact_angle");
        if self.is_written(&angle) {
            self.fill_number(&angle, contact.contact_angle, instead);
        } else {
            self.fill(&angle, format!("{} rad", contact.contact_angle));
        }
        self.fill_number(&key("normal_load"), contact.normal_force, instead);
        if let Some(stiffness) = contact.stiffness {
            self.fill_number(&key("stiffness"), stiffness, instead);
        }
        self.fill_number(&key("longitudinal_radius"), contact.longitudinal_radius, instead);
        if let Some(place) = &contact.place {
            let to_the_right = if mirrored { 1.0 } else { rail.sign() };
            self.fill_number(&key("lateral_offset"), to_the_right * place.outward, instead);
            self.fill_rail_radius(table, place, instead)?;
        }
        if let Some(radius) = contact.transverse_radius {
            if !(radius > 0.0 && radius.is_finite()) {
                let message = say!(
                    the_profiles_do_not_part_across,
                    curvature = number(format_args!("{:.2}", radius.recip())),
                    key = key("transverse_radius")
                );
                return Err(self.keys.refuse("contact.from", &message));
            }
            self.fill_number(&key("transverse_radius"), radius, instead);
        }
        Ok(())
    }

    /// The radius of the rail where the contact moves across the profiles, if the case asks for that.
    fn fill_rail_radius(
        &mut self,
        table: &str,
        place: &PlaceOnRail,
        instead: &mut Vec<String>,
    ) -> Result<(), CaseError> {
        if !self.keys.has("contact.conformity") {
            return Ok(());
        }
        let key = match table {
            "contact" => "contact.conformity.rail_radius",
            _ => "opposite_contact.rail_radius",
        };
        let radius = place.rail_curvature.recip();
        if !(radius > 0.0 && radius.is_finite()) {
            let message = say!(
                the_rail_is_not_convex_where,
                curvature = number(format_args!("{:.2}", place.rail_curvature)),
                key
            );
            return match self.is_written(key) {
                true => Ok(()),
                false => Err(self.keys.refuse("contact.from", &message)),
            };
        }
        self.fill_number(key, radius, instead);
        Ok(())
    }

    /// The spin, or none with a word where the creep law of the loop knows none.
    fn fill_spin(&mut self, key: &str, spin: f64, instead: &mut Vec<String>) {
        let law = self.keys.text_of("contact.creep_law").unwrap_or_default();
        let law = CreepLawName::named(law).and_then(CreepLawName::entry);
        let Some(law) = law.filter(|law| !law.spin) else {
            return self.fill_number(key, spin, instead);
        };
        if !self.is_written(key) {
            let name = law.name;
            self.curve_remarks.push(say!(creep_law_without_spin, name, spin = fixed(spin, 3), key));
        }
    }

    /// Friction of one rail in the place of a table of both.
    pub(super) fn put_friction(&mut self, table: &str, friction: f64, instead: &mut Vec<String>) {
        let key = format!("{table}.friction");
        let of_both =
            self.keys.table().get(table).and_then(|contact| contact.get("friction")).is_some_and(Value::is_table);
        if of_both {
            self.keys.put(&key, friction);
            self.filled_in.insert(key);
        } else {
            self.fill_number(&key, friction, instead);
        }
    }

    /// Put a number in the place of a key that is not written, or of a preset; a key that has another one of its own goes to `instead`.
    pub(super) fn fill_number(&mut self, key: &str, value: f64, instead: &mut Vec<String>) {
        /// Relative difference that is none.
        const ALIKE: f64 = 1e-3;
        if !self.is_written(key) {
            return self.fill(key, value);
        }
        let parts = key.split('.');
        let mut found = Some(Value::Table(self.keys.table().clone()));
        for part in parts {
            found = found.and_then(|value| value.get(part).cloned());
        }
        let own = match found {
            Some(Value::String(text)) => CaseKey::find(key).and_then(|known| known.quantity?.read(&text).ok()),
            Some(Value::Float(number)) => Some(number),
            Some(Value::Integer(number)) => Some(number as f64),
            _ => None,
        };
        if own.is_some_and(|own| (own - value).abs() > ALIKE * value.abs()) {
            instead.push(key.to_owned());
        }
    }

    /// Put a value in the place of a key that is not written, or of a preset.
    pub(super) fn fill(&mut self, key: &str, value: impl Into<Value>) {
        if !self.is_written(key) {
            self.keys.put(key, value);
            self.filled_in.insert(key.to_owned());
        }
    }
}

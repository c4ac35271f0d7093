//! The mean state of the contact from a bogie in its curve.

use std::path::Path;

use riffel::Rail;
use riffel::contact::Creepages;
use riffel::curving::{VehicleState, WheelState};
use riffel_keys::{CaseError, Remark};
use serde::Deserialize;
use toml::Value;

use crate::CaseKey;
use crate::case_text::CaseText;
use crate::checked_keys::CheckedKeys;
use crate::curving::CurvingCase;
use crate::file::{ContactOfWheel, CreepLawName, CurveRail, FromCurve};
use crate::from_profiles::PlaceOnRail;

/// A case as far as it says where its mean state comes from.
#[derive(Deserialize)]
struct Asking {
    contact: AskingContact,
}

#[derive(Deserialize)]
struct AskingContact {
    from: FromCurve,
}

/// What the equilibrium says of one contact.
struct MeanContact {
    creepages: Creepages,
    contact_angle: f64,
    /// r/cos γ: the wheel is a surface of revolution.
    longitudinal_radius: f64,
    normal_force: f64,
    /// None where the case of curving gives no curvature across the track.
    transverse_radius: Option<f64>,
    /// None on cones.
    place: Option<PlaceOnRail>,
    friction: f64,
    tractive_ratio: f64,
    /// Share of the normal forces of the wheel that its other point carries.
    elsewhere: f64,
}

impl CaseText {
    /// Put what the equilibrium of a bogie says of the contacts in the place of keys that are not written, if `contact.from` asks for it:
    /// creepages, contact angle, normal load, radii of the ellipse, place on the rail and friction of the rail under study, those of the opposite rail where
    /// it is not absent, the rail of the wheelset and the rolling radius. `unfilled` are the keys without presets; values of presets give way.
    ///
    /// A lone wheel is always on the right rail: one on the left is turned over, with lateral creepage and spin of the other sign.
    pub(crate) fn fill_in_from_curve(
        &mut self,
        unfilled: &Self,
        folder: Option<&Path>,
    ) -> Result<(), CaseError> {
        if !self.keys.has("contact.from") {
            return Ok(());
        }
        let Asking {
            contact: AskingContact { from },
        } = self.keys.deserialize()?;
        if from.curve.is_some() && folder.is_none() {
            return Err(CheckedKeys::names_a_file(self, "contact.from.curve"));
        }
        if from.curve.is_some()
            && let Some(table) = ["curve", "bogie", "body", "profiles"]
                .into_iter()
                .find(|table| self.keys.has(table))
        {
            let rule = "is another file, but the tables of a curve stand in this one";
            let help = format!("leave contact.from.curve out, or [{table}]");
            return Err(self.keys.invalid("contact.from.curve", rule, &help));
        }
        let curving = self.curving_case(&from, unfilled, folder)?;
        let vehicle = curving.vehicle_in_curve()?;
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
        let states = curving.equilibria(&vehicle)?;
        self.curve_remarks.extend(curving.remarks_of_profiles()?);
        let radius = vehicle.curve.radius;
        let rail = from.rail.in_curve(radius);
        if states.len() > 1 {
            let (which, german) = match states[0].continuation.is_empty() {
                false => (
                    "that which straight track leads to",
                    "der, zu dem gerades Gleis führt",
                ),
                true => (
                    "of the first found, to which straight track does not lead",
                    "aus dem zuerst gefundenen, zu dem gerades Gleis nicht führt",
                ),
            };
            self.curve_remarks.push(Remark::new(
                format!(
                    "the vehicle has {} equilibria in this curve; the contact is {which}",
                    states.len()
                ),
                format!(
                    "das Fahrzeug hat {} Gleichgewichte in diesem Bogen; der Kontakt ist {german}",
                    states.len()
                ),
            ));
        }
        let file = &curving.file;
        let study = self.contact_of(&from, &curving, &states[0], rail)?;
        let has_wheelset = self.keys.has("wheelset");
        if has_wheelset && self.keys.has("wheelset.rail") {
            let written = self.keys.text_of("wheelset.rail").unwrap_or_default();
            if written != rail.name() {
                let rule = format!(
                    "is \"{written}\", but contact.from.rail = \"{}\" is the {} rail in a curve of {radius} m",
                    from.rail.name(),
                    rail.name()
                );
                return Err(self.keys.invalid("wheelset.rail", &rule, "leave it out"));
            }
        } else if has_wheelset {
            self.fill("wheelset.rail", rail.name());
        }
        let mut instead = Vec::new();
        self.put_friction("contact", study.friction, &mut instead);
        let mirrored = !has_wheelset && rail == Rail::Left;
        let radius_of_wheel = file.wheel.rolling_radius.si();
        self.fill_number("wheel.rolling_radius", radius_of_wheel, &mut instead);
        if !self.keys.has("contact.creep_law") {
            self.fill("contact.creep_law", "shen-hedrick-elkins");
        }
        let at_tractive_ratio = self.is_written("contact.tractive_ratio");
        if at_tractive_ratio {
            instead.push("contact.tractive_ratio".to_owned());
        }
        self.fill_contact(
            "contact",
            rail,
            &study,
            mirrored,
            !at_tractive_ratio,
            &mut instead,
        )?;
        let opposite = self.keys.text_of("wheelset.opposite_rail");
        if opposite.is_some_and(|kind| kind != "absent") {
            let on_tread = FromCurve {
                contact: None,
                ..from.clone()
            };
            let other = self.contact_of(&on_tread, &curving, &states[0], rail.opposite())?;
            self.put_friction("opposite_contact", other.friction, &mut instead);
            self.fill_contact(
                "opposite_contact",
                rail.opposite(),
                &other,
                false,
                true,
                &mut instead,
            )?;
            self.tell_of_second_point(rail.opposite(), other.elsewhere);
        }
        self.tell_where_from(&from, rail, &vehicle.curve, &study);
        self.tell_of_second_point(rail, study.elsewhere);
        if instead.is_empty() {
            self.curve_tractive_ratio = Some(study.tractive_ratio);
        } else {
            let instead = instead.join(", ");
            self.curve_remarks.push(Remark::new(
                format!("in place of what that curve says the case has its own {instead}"),
                format!("statt dessen, was der Bogen sagt, hat der Fall eigene Werte: {instead}"),
            ));
        }
        Ok(())
    }

    /// The case of the curve: a file, or the tables of this one.
    fn curving_case(
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

    fn contact_of(
        &self,
        from: &FromCurve,
        curving: &CurvingCase,
        state: &VehicleState,
        rail: Rail,
    ) -> Result<MeanContact, CaseError> {
        let is_it = |wheel: &&WheelState| {
            wheel.wheelset == usize::from(from.wheelset) && wheel.rail == rail
        };
        let Some(wheel) = state.wheels.iter().find(is_it) else {
            unreachable!("every wheelset has a wheel on either rail")
        };
        let file = &curving.file;
        let friction = file.contact.as_ref().map_or(0.0, |contact| {
            contact.friction.of_rails()[usize::from(rail == Rail::Right)]
        });
        let across = file
            .contact
            .as_ref()
            .and_then(|contact| contact.transverse_radius);
        let radius_of = |curvature: Option<f64>| match curvature {
            Some(curvature) => Some(curvature.recip()),
            None => across.map(|radius| radius.si()),
        };
        let wheelset = usize::from(from.wheelset) - 1;
        let shift = state.wheelsets[wheelset].lateral_shift;
        let place = |angle: f64| curving.place_on_rail(rail, shift, angle);
        match (from.contact.unwrap_or_default(), wheel.second_contact) {
            (ContactOfWheel::Flange, Some(second)) => Ok(MeanContact {
                creepages: second.creepages,
                contact_angle: second.contact_angle,
                longitudinal_radius: second.rolling_radius / second.contact_angle.cos(),
                place: place(second.contact_angle)?,
                normal_force: second.normal_force,
                transverse_radius: radius_of(second.lateral_curvature),
                friction,
                tractive_ratio: second.tractive_ratio,
                elsewhere: wheel.normal_force / (wheel.normal_force + second.normal_force),
            }),
            (ContactOfWheel::Flange, None) => Err(self.keys.invalid(
                "contact.from.contact",
                &format!(
                    "is \"flange\", but the wheel stands on one point, at a contact angle of {:.1}°",
                    wheel.contact_angle.to_degrees()
                ),
                "leave it out",
            )),
            (ContactOfWheel::Tread, _) => Ok(MeanContact {
                creepages: wheel.creepages,
                contact_angle: wheel.contact_angle,
                longitudinal_radius: wheel.rolling_radius / wheel.contact_angle.cos(),
                place: place(wheel.contact_angle)?,
                normal_force: wheel.normal_force,
                transverse_radius: radius_of(wheel.lateral_curvature),
                friction,
                tractive_ratio: wheel.tractive_ratio,
                elsewhere: wheel.second_contact.map_or(0.0, |second| {
                    second.normal_force / (wheel.normal_force + second.normal_force)
                }),
            }),
        }
    }

    /// What is not written of a contact.
    fn fill_contact(
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
            let Creepages {
                longitudinal,
                lateral,
                spin,
            } = contact.creepages;
            self.fill_number(&key("creepage.longitudinal"), longitudinal, instead);
            self.fill_number(&key("creepage.lateral"), turn * lateral, instead);
            self.fill_spin(&key("creepage.spin"), turn * spin, instead);
        }
        let angle = key("contact_angle");
        if self.is_written(&angle) {
            self.fill_number(&angle, contact.contact_angle, instead);
        } else {
            let of_loop = self.not_below_zero(&angle, contact.contact_angle);
            self.fill(&angle, format!("{of_loop} rad"));
        }
        self.fill_number(&key("normal_load"), contact.normal_force, instead);
        self.fill_number(
            &key("longitudinal_radius"),
            contact.longitudinal_radius,
            instead,
        );
        if let Some(place) = &contact.place {
            let to_the_right = if mirrored { 1.0 } else { rail.sign() };
            self.fill_number(
                &key("lateral_offset"),
                to_the_right * place.outward,
                instead,
            );
            self.fill_rail_radius(table, place, instead)?;
        }
        if let Some(radius) = contact.transverse_radius {
            if !(radius > 0.0 && radius.is_finite()) {
                let message = format!(
                    "the profiles do not part across the track where they touch (curvature {:.2} 1/m), so that there is no ellipse; \
                     give {}",
                    radius.recip(),
                    key("transverse_radius")
                );
                return Err(self.keys.refuse("contact.from", &message));
            }
            self.fill_number(&key("transverse_radius"), radius, instead);
        }
        Ok(())
    }

    /// A contact angle \[rad\] of the loop, which knows none below zero: a wheel past the crown of its rail stands inclined the other way by a little,
    /// which is told.
    fn not_below_zero(&mut self, key: &str, angle: f64) -> f64 {
        /// \[rad\], of which the sine is 2 % of the normal force; steeper ones are refused as values of the key.
        const SMALL: f64 = 0.02;
        if !(-SMALL..0.0).contains(&angle) {
            return angle;
        }
        let degrees = angle.to_degrees();
        self.curve_remarks.push(Remark::new(
            format!("the wheel stands past the crown of its rail, at {degrees:.2}°: {key} is 0"),
            format!("das Rad steht jenseits der höchsten Stelle der Schiene, bei {degrees:.2}°: {key} ist 0"),
        ));
        0.0
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
            let message = format!(
                "the rail is not convex where the wheel stands (curvature {:.2} 1/m), so that no contact of a head moves there; \
                 leave contact.conformity out, or give {key}",
                place.rail_curvature
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
            self.curve_remarks.push(Remark::new(
                format!("contact.creep_law = \"{name}\" knows no spin: the {spin:.3} 1/m of the curve are left out ({key})"),
                format!("contact.creep_law = \"{name}\" kennt keinen Bohrschlupf: die {spin:.3} 1/m des Bogens bleiben weg ({key})"),
            ));
        }
    }

    /// Friction of one rail in the place of a table of both.
    fn put_friction(&mut self, table: &str, friction: f64, instead: &mut Vec<String>) {
        let key = format!("{table}.friction");
        let of_both = self
            .keys
            .table()
            .get(table)
            .and_then(|contact| contact.get("friction"))
            .is_some_and(Value::is_table);
        if of_both {
            self.keys.put(&key, friction);
            self.filled_in.insert(key);
        } else {
            self.fill_number(&key, friction, instead);
        }
    }

    /// Put a number in the place of a key that is not written, or of a preset; a key that has another one of its own goes to `instead`.
    fn fill_number(&mut self, key: &str, value: f64, instead: &mut Vec<String>) {
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
            Some(Value::String(text)) => {
                CaseKey::find(key).and_then(|known| known.quantity?.read(&text).ok())
            }
            Some(Value::Float(number)) => Some(number),
            Some(Value::Integer(number)) => Some(number as f64),
            _ => None,
        };
        if own.is_some_and(|own| (own - value).abs() > ALIKE * value.abs()) {
            instead.push(key.to_owned());
        }
    }

    /// That a wheel stands on another point as well, which the loop leaves out.
    fn tell_of_second_point(&mut self, rail: Rail, share: f64) {
        if share == 0.0 {
            return;
        }
        let percent = 100.0 * share;
        let german = match rail {
            Rail::Left => "linken",
            Rail::Right => "rechten",
        };
        self.curve_remarks.push(Remark::new(
            format!(
                "on the {} rail the wheel stands on two points; the other one, with {percent:.0} % of its normal forces, is left out of the loop",
                rail.name()
            ),
            format!(
                "auf der {german} Schiene steht das Rad auf zwei Punkten; der andere, mit {percent:.0} % seiner Normalkräfte, fehlt im Kreis"
            ),
        ));
    }

    /// Put a value in the place of a key that is not written, or of a preset.
    fn fill(&mut self, key: &str, value: impl Into<Value>) {
        if !self.is_written(key) {
            self.keys.put(key, value);
            self.filled_in.insert(key.to_owned());
        }
    }

    fn tell_where_from(
        &mut self,
        from: &FromCurve,
        rail: Rail,
        curve: &riffel::curving::Curve,
        contact: &MeanContact,
    ) {
        let Creepages {
            longitudinal,
            lateral,
            spin,
        } = contact.creepages;
        let (radius, speed) = (curve.radius.abs(), 3.6 * curve.speed);
        let (along, across) = (100.0 * longitudinal, 100.0 * lateral);
        let angle = contact.contact_angle.to_degrees();
        let load = 1e-3 * contact.normal_force;
        let low = rail == CurveRail::Low.in_curve(curve.radius);
        let (name, german) = match (low, rail) {
            (true, Rail::Left) => ("low, left", "inneren, linken"),
            (true, Rail::Right) => ("low, right", "inneren, rechten"),
            (false, Rail::Left) => ("high, left", "äußeren, linken"),
            (false, Rail::Right) => ("high, right", "äußeren, rechten"),
        };
        let wheelset = from.wheelset;
        self.curve_remarks.push(Remark::new(
            format!(
                "mean state from the curve of {radius:.0} m at {speed:.0} km/h: wheelset {wheelset} on the {name} rail creeps {along:.3} % along, \
                 {across:.3} % across, spin {spin:.3} 1/m, under {load:.1} kN at {angle:.1}°"
            ),
            format!(
                "mittlerer Zustand aus dem Bogen von {radius:.0} m bei {speed:.0} km/h: Radsatz {wheelset} auf der {german} Schiene schlüpft \
                 {along:.3} % längs, {across:.3} % quer, Bohrschlupf {spin:.3} 1/m, unter {load:.1} kN bei {angle:.1}°"
            ),
        ));
    }
}

#[cfg(test)]
mod tests {
    use rstest::rstest;

    use super::*;
    use crate::Case;

    const CURVE: &str = include_str!("../cases/metro-curve.toml");

    fn case(overrides: &[&str]) -> Result<Case, CaseError> {
        let overrides: Vec<String> = overrides.iter().map(|&key| key.to_owned()).collect();
        Case::parse("curve.toml", CURVE, &overrides)
    }

    fn growth(case: &Case) -> f64 {
        case.point(0.06, 12.5).unwrap().growth_rate()
    }

    /// Growth is that of the numbers of the curve typed by hand, on every wheel.
    #[rstest]
    #[case(1, "low")]
    #[case(1, "high")]
    #[case(2, "left")]
    #[case(2, "right")]
    fn numbers_are_those_of_the_curve(#[case] wheelset: usize, #[case] rail: &str) {
        let from = format!("contact.from={{wheelset={wheelset}, rail=\"{rail}\"}}");
        let asked = case(&[&from]).unwrap();
        let curving = CurvingCase::parse("curve.toml", CURVE, &[]).unwrap();
        let vehicle = curving.vehicle_in_curve().unwrap();
        let state = &curving.equilibria(&vehicle).unwrap()[0];
        // To the right: the right rail is the low one.
        let index = 2 * (wheelset - 1) + usize::from(matches!(rail, "low" | "right"));
        let typed = |table: &str, wheel: &WheelState| {
            let creepages = wheel.creepages;
            vec![
                format!(
                    "{table}.creepage={{longitudinal={:e}, lateral={:e}, spin={:e}}}",
                    creepages.longitudinal, creepages.lateral, creepages.spin
                ),
                format!("{table}.contact_angle={:e} rad", wheel.contact_angle),
                format!("{table}.normal_load={:e}", wheel.normal_force),
                format!(
                    "{table}.longitudinal_radius={:e}",
                    wheel.rolling_radius / wheel.contact_angle.cos()
                ),
                format!(
                    "{table}.transverse_radius={:e}",
                    wheel.lateral_curvature.unwrap().recip()
                ),
            ]
        };
        let mut keys = typed("contact", &state.wheels[index]);
        keys.extend(typed("opposite_contact", &state.wheels[index ^ 1]));
        keys.push(format!("wheelset.rail={}", state.wheels[index].rail.name()));
        let without = CURVE
            .replace("from = { wheelset = 1, rail = \"low\" }\n", "")
            .replace("{ left = 0.4, right = 0.4 }", "0.4");
        let by_hand = Case::parse("typed.toml", &without, &keys).unwrap();
        let (got, expected) = (growth(&asked), growth(&by_hand));
        assert!((got / expected - 1.0).abs() < 1e-9, "{got:e} {expected:e}");
    }

    /// The place on the rail is where the upright profile, turned by the inclination, has the contact angle; its curvature goes where the
    /// contact moves across the profiles, and what is written wins.
    #[test]
    fn the_place_on_the_rail_is_filled_in() {
        use riffel::profile::NominalProfile;

        let moving = "contact.conformity={cross_slope=\"10 1/m\"}";
        let rail = NominalProfile::named("60E1").unwrap().profile();
        for (wheelset, side) in [(1, "low"), (1, "high"), (2, "left"), (2, "right")] {
            let from = format!("contact.from={{wheelset={wheelset}, rail=\"{side}\"}}");
            let case = case(&[&from, moving]).unwrap();
            let contact = &case.file.contact;
            let offset = contact.lateral_offset.unwrap().si();
            let is_left = matches!(side, "high" | "left");
            let outward = if is_left { -offset } else { offset };
            let there = rail.at(outward).unwrap();
            let angle = there.slope.atan() + (1.0f64 / 40.0).atan();
            // Rows of the table are interpolated.
            let off = angle - contact.contact_angle.unwrap().si();
            assert!(off.abs() < 2e-3, "{side}: {off:e}");
            let radius = contact.conformity.unwrap().rail_radius.si();
            assert!(
                (radius + there.curvature.recip()).abs() < 1e-6,
                "{side}: {radius}"
            );
            let opposite = case.file.opposite_contact.as_ref().unwrap();
            assert!(opposite.lateral_offset.is_some() && opposite.rail_radius.is_some());
        }
        let written = case(&["contact.lateral_offset=12 mm"]).unwrap();
        assert_eq!(written.file.contact.lateral_offset.unwrap().si(), 0.012);
        let told: Vec<String> = written.remarks.iter().map(ToString::to_string).collect();
        assert!(
            told.iter()
                .any(|remark| remark.contains("contact.lateral_offset")),
            "{told:?}"
        );
    }

    /// A curve to the left is its mirror image, with a wheelset and with a lone wheel.
    #[test]
    fn a_mirrored_curve_grows_alike() {
        const LONE: &str = "wheel.mass=600 kg";
        let (right, left) = ("curve.radius=180 m", "curve.radius=-180 m");
        let pair = [right, left].map(|radius| growth(&case(&[radius]).unwrap()));
        assert!((pair[0] / pair[1] - 1.0).abs() < 1e-6, "{pair:?}");
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
        let lone = |radius: &str| {
            let text = CURVE.replace("radius = \"180 m\"", radius);
            let place = tempfile::tempdir().unwrap();
            std::fs::write(place.path().join("curve.toml"), text).unwrap();
            let nominal = std::fs::read_to_string(folder.join("nominal.toml")).unwrap();
            std::fs::write(place.path().join("lone.toml"), nominal).unwrap();
            let keys = [
                "contact.from={curve=\"curve.toml\", wheelset=1, rail=\"high\"}",
                "contact.creep_law=fastsim",
                LONE,
            ];
            let case =
                Case::read(&place.path().join("lone.toml"), &keys.map(str::to_owned)).unwrap();
            // What is written wins: the nominal case has a load and a radius of its own.
            assert_eq!(case.file.contact.normal_load.si(), 50e3);
            growth(&case)
        };
        let pair = ["radius = \"180 m\"", "radius = \"-180 m\""].map(lone);
        assert!((pair[0] / pair[1] - 1.0).abs() < 1e-6, "{pair:?}");
    }

    /// A law without spin takes creepages alone, and says so.
    #[test]
    fn spin_is_left_out_of_laws_that_know_none() {
        let case = case(&["contact.creep_law=full-sliding"]).unwrap();
        assert_eq!(case.file.contact.creepage.unwrap().components().spin, 0.0);
        let told = case.remarks.iter().map(ToString::to_string);
        assert!(
            told.filter(|remark| remark.contains("knows no spin"))
                .count()
                == 2
        );
    }

    #[test]
    fn what_is_written_wins() {
        let case = case(&[
            // Wide enough that the contact sticks without the spin.
            "curve.radius=900 m",
            "contact.normal_load=40 kN",
            "contact.creepage.spin=0",
            "contact.friction={left=0.2, right=0.3}",
        ])
        .unwrap();
        let contact = &case.file.contact;
        assert_eq!(contact.normal_load.si(), 40e3);
        let creepages = contact.creepage.unwrap().components();
        assert!(creepages.spin == 0.0 && creepages.lateral != 0.0);
        assert_eq!(contact.friction.si(), 0.3);
        let opposite = case.file.opposite_contact.as_ref().unwrap();
        assert_eq!(opposite.friction.unwrap().si(), 0.2);
        let told: Vec<String> = case.remarks.iter().map(ToString::to_string).collect();
        let own = "the case has its own contact.creepage.spin, contact.normal_load";
        assert!(told.iter().any(|remark| remark.contains(own)), "{told:?}");
    }

    /// On the high rail: the flange that is left out, and the forces that the law of growth does not have.
    #[test]
    fn what_the_loop_leaves_out_is_told() {
        let case = case(&["contact.from.rail=high"]).unwrap();
        let told: Vec<String> = case.remarks.iter().map(ToString::to_string).collect();
        for words in [
            "with 27 % of its normal forces",
            "at which the equilibrium of the curve has 1.00",
            "no profile has one curvature",
        ] {
            assert!(told.iter().any(|remark| remark.contains(words)), "{told:?}");
        }
    }

    /// Loads of a traffic are not those of the bogie.
    #[test]
    fn vehicles_of_a_traffic_have_no_loads_of_their_own() {
        use riffel::roughness::ThirdOctave;

        use crate::Variant;
        use crate::traffic::Traffic;

        let case = case(&[]).unwrap();
        for (key, taken) in [
            ("axle_load = \"13 t\"", false),
            ("traction_share = 0.5", true),
        ] {
            let text = format!(
                "[[vehicle]]\nname = \"metro\"\nshare = 1\n{key}\nspeed = {{ mean = \"45 km/h\" }}\n"
            );
            let traffic = Traffic::parse("traffic.toml", &text).unwrap();
            let bands = [ThirdOctave::containing(0.05).unwrap()];
            let growth = traffic.on(&case, &bands, &Variant::none("as it is"), &|_| ());
            assert_eq!(growth.is_ok(), taken, "{key}: {:?}", growth.err());
        }
    }

    #[rstest]
    #[case(
        "contact.from={wheelset=3, rail=\"low\"}",
        "must be 1, which leads, or 2"
    )]
    #[case("contact.from={wheelset=1, rail=\"inner\"}", "inner")]
    #[case("contact.from={rail=\"low\"}", "wheelset")]
    #[case("contact.from.contact=flange", "stands on one point")]
    #[case("wheelset.rail=left", "is the right rail in a curve of 180 m")]
    #[case("contact.from.curve=bogie.toml", "stand in this one")]
    #[case("curve.radius=1 m", "larger than the wheelbase")]
    #[case("profiles.wheel=no-such.csv", "no-such.csv")]
    fn refused(#[case] key: &str, #[case] words: &str) {
        let Err(error) = case(&[key]) else {
            panic!("{key} was taken");
        };
        assert!(error.to_string().contains(words), "{error}");
    }

    /// A case that somebody has sent opens no file, be it of the curve or of its profiles.
    #[test]
    fn sealed_cases_open_nothing() {
        assert!(Case::parse_sealed("sent.toml", CURVE).is_ok());
        let file = CURVE.replace("wheelset = 1,", "curve = \"/etc/hostname\", wheelset = 1,");
        let profile = CURVE.replace("\"S1002\"", "\"/etc/hostname\"");
        for (text, key) in [(file, "contact.from.curve"), (profile, "profiles.wheel")] {
            let Err(error) = Case::parse_sealed("sent.toml", &text) else {
                panic!("{key} was taken");
            };
            assert!(error.to_string().contains(key), "{error}");
            assert!(error.to_string().contains("may not name any"), "{error}");
        }
    }
}

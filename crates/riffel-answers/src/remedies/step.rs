//! One key changed, and what becomes of growth under a traffic.

use riffel::forecast::SpeedDistribution;
use riffel_case::traffic::Traffic;
use riffel_case::{Case, CaseKey, Hold, Variant, idle_because};
use riffel_keys::quantity::{Kind, Speed};
use riffel_keys::{Message, number, say, significant_digits};
use serde::Serialize;

use crate::LineGrowth;

/// Friction of a treated rail: chosen, that of a friction modifier which works well.
const TREATED_FRICTION: f64 = 0.25;
/// What rail dampers add to the loss factor of the rail: chosen.
const RAIL_DAMPERS: f64 = 0.1;
/// How much more widely speeds are spread: chosen.
const WIDER: f64 = 1.5;
/// Standard deviation of a speed as a share of the mean, at most: a normal distribution with more reaches standstill.
const WIDEST: f64 = 0.24;

/// A key with its value.
#[derive(Clone, Serialize)]
pub struct Change {
    pub(super) key: &'static str,
    pub(super) value: f64,
}

/// One key changed, or why it cannot be.
pub(super) struct Step {
    pub(super) title: Message,
    pub(super) key: &'static str,
    value: Result<f64, Message>,
}

impl Step {
    /// What it changes, and what becomes of growth.
    pub(super) fn taken(&self, case: &Case, traffic: &Traffic) -> Result<(Vec<Change>, LineGrowth), Message> {
        let (key, value) = (self.key, self.value.clone()?);
        if idle_because(case, key).is_some() {
            return Err(say!(remedy_has_no_effect, key));
        }
        let mut changes = vec![Change { key, value }];
        let variant = Variant::parse("remedy", &format!("{key} = {value:?}\n"));
        let growth = variant.and_then(|mut variant| {
            if key == "contact.friction" && keeps_force(case) {
                variant.hold = Some(Hold::Force);
                changes.extend(kept_ratio(case, traffic, value));
            }
            LineGrowth::under(case, traffic, &variant)
        });
        match growth {
            Ok(growth) => Ok((changes, growth)),
            Err(_) => Err(say!(remedy_is_refused)),
        }
    }
}

/// The tractive ratio with which trains pull as before on another friction, where they all have one.
fn kept_ratio(case: &Case, traffic: &Traffic, treated: f64) -> Option<Change> {
    let common = |key, of_case| traffic.common_value(key, Some(of_case)).ok().flatten();
    let key = "contact.tractive_ratio";
    let friction = common("contact.friction", case.file.contact.friction.si())?;
    let ratio = common(key, case.steady.tractive_ratio())?;
    let value = ratio * friction / treated;
    Some(Change { key, value })
}

/// Trains pull and brake as before on another friction, unless a curve or the case itself sets the creepage.
fn keeps_force(case: &Case) -> bool {
    case.file.contact.creepage.is_none() && case.file.contact.from.is_none()
}

/// Keys and values, to four digits: "track.pad.stiffness = 30 MN/m".
pub(super) fn in_words(changes: &[Change]) -> String {
    let words = changes.iter().map(|Change { key, value }| {
        let kind = match *key {
            "speed.standard_deviation" => Some(Kind::of::<Speed>()),
            key => CaseKey::find(key).and_then(|known| known.quantity),
        };
        let (number, unit) = kind.map_or((*value, ""), |kind| kind.in_engineers_unit(*value));
        // Without zeros at the end.
        let rounded: f64 = significant_digits(number, 4).parse().unwrap_or(number);
        format!("{key} = {rounded} {unit}").trim_end().to_owned()
    });
    words.collect::<Vec<_>>().join(", ")
}

/// What is changed, one key at a time.
pub(super) fn steps(case: &Case, traffic: &Traffic) -> Vec<Step> {
    let file = &case.file;
    let common = |key: &'static str, of_case: Option<f64>| {
        let value = traffic.common_value(key, of_case)?;
        value.ok_or_else(|| say!(remedy_lacks_key, key))
    };
    let times = |title: Message, key: &'static str, of_case: Option<f64>, factor: f64| Step {
        title,
        key,
        value: common(key, of_case).map(|value| factor * value),
    };
    let stiffness =
        |support: &Option<riffel_case::file::Support>| support.as_ref()?.stiffness.map(|stiffness| stiffness.si());
    let pad = stiffness(&file.track.pad);
    let (mass_key, mass) = match &file.wheelset {
        Some(wheelset) => ("wheelset.mass", wheelset.mass),
        None => ("wheel.mass", file.wheel.mass),
    };
    let loss = file.rail.loss_factor.map_or(0.0, |loss| loss.si());
    let friction = common("contact.friction", Some(file.contact.friction.si()));
    vec![
        times(say!(softer_pads), "track.pad.stiffness", pad, 0.5),
        times(say!(stiffer_pads), "track.pad.stiffness", pad, 2.0),
        times(say!(softer_ballast), "track.ballast.stiffness", stiffness(&file.track.ballast), 0.5),
        Step {
            title: say!(more_rail_loss, loss = number(RAIL_DAMPERS)),
            key: "rail.loss_factor",
            value: common("rail.loss_factor", Some(loss)).map(|loss| loss + RAIL_DAMPERS),
        },
        Step {
            title: say!(friction_treatment, friction = number(TREATED_FRICTION)),
            key: "contact.friction",
            value: friction.and_then(|friction| match friction > TREATED_FRICTION {
                true => Ok(TREATED_FRICTION),
                false => Err(say!(friction_is_low, friction = number(friction))),
            }),
        },
        times(say!(lighter_wheel), mass_key, mass.map(|mass| mass.si()), 0.8),
        wider_speeds(traffic),
        Step { title: say!(slower_trains), key: "speed.factor", value: Ok(0.8) },
    ]
}

/// All speeds spread by one factor, as far as the widest can be; where none are spread, by one deviation.
fn wider_speeds(traffic: &Traffic) -> Step {
    let speeds = traffic.speeds();
    let slowest = speeds.iter().map(SpeedDistribution::mean);
    let slowest = slowest.fold(f64::INFINITY, f64::min);
    let widths = speeds.iter().map(|it| it.deviation() / it.mean());
    let factor = WIDER.min(WIDEST / widths.fold(0.0, f64::max));
    let deviation = speeds[0].deviation();
    let all_alike = speeds.iter().all(|it| it.deviation() == deviation);
    let (key, value) = match all_alike {
        true if deviation == 0.0 => ("speed.standard_deviation", 0.1 * slowest),
        true => ("speed.standard_deviation", factor * deviation),
        false => ("speed.standard_deviation_factor", factor),
    };
    Step {
        title: say!(wider_speeds),
        key,
        value: match factor > 1.05 {
            true => Ok(value),
            false => Err(say!(speeds_are_wide)),
        },
    }
}

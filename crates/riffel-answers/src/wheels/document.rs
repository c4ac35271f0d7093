//! The wheels of a curve as data.

use riffel_case::Case;
use riffel_case::file::CaseFile;
use riffel_keys::Message;
use serde::Serialize;

use super::{WheelAnswer, WheelsAnswer};
use crate::WearLimitDocument;
use crate::highest::HighestDocument;
use crate::ridge::BranchDocument;

/// What `riffel map --wheels --json` prints.
#[derive(Serialize)]
pub struct WheelsDocument<'a> {
    riffel_version: &'static str,
    /// The case as it is, with its own wheel.
    inputs: &'a CaseFile,
    /// Above zero to the right.
    radius_m: f64,
    /// That of the curve, at which the vehicle is balanced.
    speed_m_per_s: f64,
    /// Slowest and fastest trains of the usual traffic, over which `highest` and `growth_rate_per_passage` are the mean.
    speeds_m_per_s: [f64; 2],
    wavelength_m: &'a [f64],
    /// Wheelset by wheelset from the front, the low rail first.
    wheels: Vec<WheelDocument<'a>>,
}

#[derive(Serialize)]
struct WheelDocument<'a> {
    wheelset: usize,
    /// `low` or `high`.
    rail: &'static str,
    /// `left` or `right`.
    side: &'static str,
    /// `tread` or `flange`.
    contact: &'static str,
    /// Those of the equilibrium; what the case gives itself is named in `remarks`.
    longitudinal_creepage: f64,
    lateral_creepage: f64,
    spin_1_per_m: f64,
    normal_force_n: f64,
    contact_angle_rad: f64,
    tractive_ratio: f64,
    /// Of the normal forces of the wheel, on its other contact, which the loop leaves out.
    share_of_second_contact: f64,
    /// Why the loop has no mean state there; null where it has.
    not_in_loop: Option<&'a Message>,
    /// Null where the wheel is not in the loop.
    growth_rate_per_passage: Option<&'a [f64]>,
    /// Null where nothing grows.
    highest: Option<HighestDocument>,
    /// For that growth; left out where the wheel is not in the loop.
    #[serde(flatten)]
    wear_limit: Option<WearLimitDocument>,
    /// Branches of its map, the strongest first.
    branches: &'a [BranchDocument],
    /// At which it oscillates without any profile at the speed of the curve; null where it does not.
    unstable_frequency_hz: Option<f64>,
    remarks: &'a [Message],
}

pub(super) fn document<'a>(answer: &'a WheelsAnswer, case: &'a Case) -> WheelsDocument<'a> {
    WheelsDocument {
        riffel_version: env!("CARGO_PKG_VERSION"),
        inputs: &case.file,
        radius_m: answer.curve.radius,
        speed_m_per_s: answer.curve.speed,
        speeds_m_per_s: answer.traffic.speeds,
        wavelength_m: &answer.wavelengths,
        wheels: answer.wheels.iter().map(of).collect(),
    }
}

fn of(wheel: &WheelAnswer) -> WheelDocument<'_> {
    let WheelAnswer { state, growth, .. } = wheel;
    let known = growth.as_ref().ok();
    WheelDocument {
        wheelset: state.wheelset,
        rail: wheel.rail.name(),
        side: state.rail.name(),
        contact: wheel.contact.name(),
        longitudinal_creepage: state.creepages.longitudinal,
        lateral_creepage: state.creepages.lateral,
        spin_1_per_m: state.creepages.spin,
        normal_force_n: state.normal_force,
        contact_angle_rad: state.contact_angle,
        tractive_ratio: state.tractive_ratio,
        share_of_second_contact: state.share_of_second_contact(),
        not_in_loop: growth.as_ref().err(),
        growth_rate_per_passage: known.map(|growth| growth.rates.as_slice()),
        highest: known.and_then(|growth| growth.highest).map(Into::into),
        wear_limit: known.map(|growth| {
            let rate = growth.highest.map(|highest| highest.rate);
            WearLimitDocument::new(&growth.case, rate)
        }),
        branches: known.map_or(&[], |growth| &growth.map.branches),
        unstable_frequency_hz: known.and_then(|growth| growth.unstable),
        remarks: known.map_or(&[], |growth| &growth.remarks),
    }
}

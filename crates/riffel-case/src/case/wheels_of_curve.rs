//! The wheels of a vehicle in its curve, each as the wheel of the loop.

use std::sync::Arc;

use riffel_curving::{Curve, VehicleState, WheelState};
use riffel_keys::{CaseError, Message, number, say};

use crate::Case;
use crate::curve::Equilibrium;
use crate::file::{ContactOfWheel, CurveRail, FromCurve, RailSide};
use crate::keys::mean::MeanOfWheel;
use crate::keys::written_keys::WrittenKeys;
use crate::parts::window::Window;

/// The key of the rail of a wheelset.
const RAIL: &str = "wheelset.rail";

/// The equilibrium of a vehicle, and its wheels one after the other in the loop of a case.
pub struct WheelsOfCurve {
    /// The curve.
    pub curve: Curve,
    /// Wheelset by wheelset from the front, the low rail first; of a wheel that stands on two points both, the tread first.
    pub wheels: Vec<WheelOfCurve>,
}

/// A contact of a wheel of a vehicle in its curve.
pub struct WheelOfCurve {
    /// State of the wheel in the equilibrium, described from this contact.
    pub state: WheelState,
    /// Low or high.
    pub rail: CurveRail,
    /// Tread, or the flange of a wheel that stands on two points.
    pub contact: ContactOfWheel,
    /// The case with this wheel under study, or why the loop has no mean state on it.
    pub case: Result<Case, CaseError>,
}

impl WheelOfCurve {
    /// Name of the wheel, "wheelset 1, low rail", or "wheelset 1, high rail, flange".
    pub fn in_words(&self) -> Message {
        let number = number(self.state.wheelset);
        let wheel = match self.rail {
            CurveRail::Low => say!(wheel_on_low_rail, number),
            CurveRail::High => say!(wheel_on_high_rail, number),
            CurveRail::Left => say!(wheel_on_left_rail, number),
            CurveRail::Right => say!(wheel_on_right_rail, number),
        };
        match self.contact {
            ContactOfWheel::Tread => wheel,
            ContactOfWheel::Flange => say!(flange_of_wheel, wheel),
        }
    }

    /// Name of the wheel in English.
    pub fn name(&self) -> String {
        self.in_words().to_string()
    }
}

/// Every wheel of the vehicle that `contact.from` names, as if it were asked for; `None` if the case takes its mean state from
/// no curve. All keys but `contact.from.wheelset`, `contact.from.rail`, `contact.from.contact` and `wheelset.rail` stay.
///
/// # Errors
/// [`CaseError`] for a vehicle that has no equilibrium.
pub fn wheels_of_curve(case: &Case) -> Result<Option<WheelsOfCurve>, CaseError> {
    let Some(MeanOfWheel { equilibrium, from, .. }) = case.keys.mean.wheel() else {
        return Ok(None);
    };
    let written = WrittenKeys::read(case.unfilled.clone(), case.keys.folder.as_deref())?;
    let Equilibrium { vehicle, states, .. } = &**equilibrium;
    let VehicleState { wheels, .. } = &states[0];
    let low = CurveRail::Low.in_curve(vehicle.curve.radius);
    let mut wheels: Vec<WheelOfCurve> = (wheels.iter())
        .flat_map(|state| {
            let rail = match state.rail == low {
                true => CurveRail::Low,
                false => CurveRail::High,
            };
            let contacts =
                [(ContactOfWheel::Tread, Some(*state)), (ContactOfWheel::Flange, state.from_second_contact())];
            contacts.map(|(contact, state)| {
                let state = state?;
                let named = from.contact.is_some() || contact == ContactOfWheel::Flange;
                let from = FromCurve {
                    wheelset: state.wheelset as u8,
                    rail,
                    contact: named.then_some(contact),
                    ..from.clone()
                };
                Some(WheelOfCurve { state, rail, contact, case: on_wheel(case, &written, equilibrium, &from, &state) })
            })
        })
        .flatten()
        .collect();
    wheels.sort_by_key(|wheel| (wheel.state.wheelset, wheel.rail == CurveRail::High));
    Ok(Some(WheelsOfCurve { curve: vehicle.curve, wheels }))
}

/// The case with another wheel under study.
fn on_wheel(
    case: &Case,
    written: &WrittenKeys,
    equilibrium: &Arc<Equilibrium>,
    from: &FromCurve,
    state: &WheelState,
) -> Result<Case, CaseError> {
    let mut written = written.clone();
    if let Some(wheelset) = &mut written.file.wheelset
        && written.unfilled.keys.has(RAIL)
    {
        wheelset.rail = RailSide::of(state.rail);
        written.unfilled.write(&[(RAIL.to_owned(), state.rail.name().into())])?;
    }
    Case::placed(&written, equilibrium, from, case.keys.given.clone(), Window::Map)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::METRO_CURVE_CASE as CURVE;
    use crate::fixtures::case;

    fn growth(case: &Case) -> f64 {
        case.point(0.06, 12.5).unwrap().growth_rate
    }

    /// Each wheel grows as if it had been asked for by its keys, whichever wheel the case has.
    // Long: finds the equilibrium of a bogie in its curve.
    #[test]
    fn wheels_are_those_that_keys_ask_for() {
        // A law in closed form.
        let law = "contact.creep_law=polach";
        let found = case(CURVE, &["contact.from.wheelset=2", "contact.from.rail=right", law]);
        let found = wheels_of_curve(&found).unwrap().unwrap();
        let names: Vec<String> = found.wheels.iter().map(WheelOfCurve::name).collect();
        assert_eq!(
            names,
            [
                "wheelset 1, low rail",
                "wheelset 1, high rail",
                "wheelset 1, high rail, flange",
                "wheelset 2, low rail",
                "wheelset 2, high rail"
            ]
        );
        for wheel in &found.wheels {
            let keys = [
                format!("contact.from.wheelset={}", wheel.state.wheelset),
                format!("contact.from.rail={}", wheel.rail.name()),
                format!("contact.from.contact={}", wheel.contact.name()),
                law.to_owned(),
            ];
            let asked = case(CURVE, &keys.each_ref().map(String::as_str));
            let got = growth(wheel.case.as_ref().unwrap_or_else(|error| panic!("{error}")));
            assert_eq!(got, growth(&asked));
        }
    }

    /// To the left the low rail is the left one, and the wheels are those of the mirror image; the rail of the wheelset goes along.
    #[test]
    fn a_mirrored_curve_has_the_same_wheels() {
        let right = case(CURVE, &["wheelset.rail=right"]);
        let left = case(CURVE, &["curve.radius=-180 m", "contact.from.rail=left"]);
        let [right, left] = [right, left].map(|case| wheels_of_curve(&case).unwrap().unwrap());
        assert_eq!(left.curve.radius, -180.0);
        for (one, other) in right.wheels.iter().zip(&left.wheels) {
            assert_eq!(one.name(), other.name());
            assert_ne!(one.state.rail, other.state.rail);
            let [one, other] = [one, other].map(|wheel| growth(wheel.case.as_ref().unwrap()));
            // The jump onto the flange is found to 1e-9 m, and wheels that hardly stick make more of that.
            assert!((one / other - 1.0).abs() < 1e-5, "{one:e} {other:e}");
        }
    }

    /// The leading wheels slide as a whole; a law that ends in sliding has a loop on them and on those behind.
    #[test]
    fn every_wheel_has_a_loop_in_full_sliding() {
        let keys = ["contact.creep_law=shen-hedrick-elkins", "contact.from.wheelset=2"];
        let found = wheels_of_curve(&case(CURVE, &keys)).unwrap().unwrap();
        let wheels: Vec<_> = found.wheels.iter().map(|wheel| &wheel.case).collect();
        assert!(wheels.iter().all(|case| case.is_ok()));
        let slides = wheels[0].as_ref().unwrap().steady.tractive_ratio();
        assert!(slides > 1.0 - 1e-6, "{slides}");
    }

    #[test]
    fn a_case_without_a_curve_has_no_wheels() {
        let nominal = case(crate::NOMINAL_CASE, &[]);
        assert!(wheels_of_curve(&nominal).unwrap().is_none());
    }
}

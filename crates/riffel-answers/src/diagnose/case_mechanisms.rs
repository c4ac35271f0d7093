//! What a case knows of the causes of a wavelength: its wheels and its wheelset.

use riffel::diagnosis::{GrowthDensity, Mechanism, MechanismKind, TrafficSpeeds};
use riffel_case::file::CurveRail;
use riffel_case::{Case, WheelsOfCurve, wheels_of_curve};
use riffel_keys::{Message, fixed, say, shown_speeds};

use crate::ridge::modes_of_axle;

/// The wheels whose growth is held against a wavelength, with the rail of a curve that each runs on: those of the vehicle in its
/// curve, or the one of the case, which has no name.
pub(super) struct Wheels(Vec<Wheel>);

struct Wheel {
    name: Option<Message>,
    rail: Option<CurveRail>,
    case: Case,
}

impl Wheels {
    /// Of a case. The contacts that carry less than half of their wheel, and wheels on which the loop has no mean state, are left out.
    pub(super) fn of(case: &Case) -> Self {
        let alone = || Wheel { name: None, rail: None, case: case.clone() };
        // A vehicle without an equilibrium has no case either.
        let Ok(Some(WheelsOfCurve { wheels, .. })) = wheels_of_curve(&case.sharing_parts()) else {
            return Self(vec![alone()]);
        };
        let wheels = wheels.into_iter().filter_map(|wheel| {
            let carries = wheel.state.share_of_second_contact() <= 0.5;
            Some(Wheel {
                name: Some(wheel.in_words()),
                rail: Some(wheel.rail),
                case: wheel.case.ok().filter(|_| carries)?,
            })
        });
        let wheels: Vec<Wheel> = wheels.collect();
        match wheels.is_empty() {
            true => Self(vec![alone()]),
            false => Self(wheels),
        }
    }

    /// What the wheels are called.
    pub(super) fn names(&self) -> Vec<Message> {
        self.0.iter().filter_map(|wheel| wheel.name.clone()).collect()
    }

    /// Growth under each wheel that may have made a wavelength \[m\] on a rail of this name: where that says low or high, under
    /// the wheels on it. With sentences on those of which it is not known.
    pub(super) fn growth(
        &self,
        rail: Option<&str>,
        wavelength: f64,
        speeds: &TrafficSpeeds,
    ) -> (Vec<Mechanism>, Vec<Message>) {
        let named = rail.and_then(rail_in_words);
        let mut mechanisms = Vec::new();
        let mut unknown = Vec::new();
        for wheel in &self.0 {
            if let (Some(named), Some(own)) = (named, wheel.rail)
                && named != own
            {
                continue;
            }
            match density(&wheel.case, wavelength, speeds) {
                Ok(density) => {
                    let mechanism = Mechanism::growth_ridge(density);
                    mechanisms.push(match &wheel.name {
                        Some(name) => mechanism.of(name.to_string()),
                        None => mechanism,
                    });
                }
                Err(reason) => unknown.push(say!(growth_ridge_is_no_candidate, reason)),
            }
        }
        unknown.dedup();
        (mechanisms, unknown)
    }
}

/// Low or high, where the name of a rail says so.
fn rail_in_words(name: &str) -> Option<CurveRail> {
    let lower = name.to_lowercase();
    let mut words = lower.split(|c: char| !c.is_alphanumeric());
    words.find_map(|word| match word {
        "low" | "inner" => Some(CurveRail::Low),
        "high" | "outer" => Some(CurveRail::High),
        _ => None,
    })
}

/// Torsion and bending of the wheelset of a case, as `map` and `wheelset` name them.
pub(super) fn wheelset_modes(case: &Case) -> Vec<(MechanismKind, f64)> {
    /// Up to where axles are seen to make corrugation \[Hz\]: above, wheels are no rigid discs.
    const HIGHEST: f64 = 2000.0;
    let mut named = modes_of_axle(case, HIGHEST);
    // Bending in both planes of an axle without much of a suspension is one candidate.
    named.dedup_by(|later, earlier| later.0 == earlier.0 && later.1 < 1.02 * earlier.1);
    named
}

/// Of the modes of each kind those that may make a wavelength \[m\] at the speeds of the traffic, at least the nearest: an axle has
/// many, and those far away are no candidates.
pub(super) fn near(modes: &[(MechanismKind, f64)], wavelength: f64, speeds: &TrafficSpeeds) -> Vec<Mechanism> {
    /// Of a frequency: twice what stiffness and mass of an axle leave open, and more.
    const WITHIN: f64 = 1.3;
    let (lowest, highest) = (speeds.slowest() / wavelength, speeds.fastest() / wavelength);
    let distance = |frequency: f64| (lowest / frequency).max(frequency / highest).max(1.0);
    let mut mechanisms = Vec::new();
    for kind in [MechanismKind::WheelsetTorsion, MechanismKind::WheelsetBending] {
        let of_kind = || modes.iter().filter(|mode| mode.0 == kind).map(|mode| mode.1);
        let nearest = of_kind().map(distance).fold(f64::INFINITY, f64::min);
        let kept = of_kind().filter(|&frequency| distance(frequency) <= nearest.max(WITHIN));
        mechanisms.extend(kept.map(|frequency| Mechanism::of_frequency(kind, frequency)));
    }
    mechanisms
}

/// Growth of the case over every wavelength that the other candidates are compared over, but for those that the patch
/// does not let through or at which the track is not known at all speeds. The window of the map has no part in it: a
/// prediction that ends where the user's window ends would explain any wavelength within a narrow one.
fn density(case: &Case, measured: f64, speeds: &TrafficSpeeds) -> Result<GrowthDensity, Message> {
    /// Wavelengths \[m\] that a cause not listed may have.
    const ANY: (f64, f64) = (5e-3, 2.0);
    /// Shortest wavelength in semi-axes: 1.5 contact lengths (Frederick 1987, in Afferrante & Ciavarella
    /// 2009).
    const SHORTEST: f64 = 3.0;
    let (slowest, fastest) = (speeds.slowest(), speeds.fastest());
    case.check_frequencies(slowest / measured, fastest / measured)
        .map_err(|error| Message::verbatim(error.to_string()))?;
    let (lowest, highest) = case.known_frequencies();
    let shortest = SHORTEST * case.hertz.semi_axis_longitudinal();
    let from = ANY.0.max(shortest).max(fastest / highest);
    let to = ANY.1.min(slowest / lowest);
    if from >= to {
        return Err(say!(
            track_known_up_to,
            speeds = shown_speeds([slowest, fastest]),
            longest = fixed(1e3 * to, 0),
            shortest = fixed(1e3 * shortest, 0)
        ));
    }
    let covered = case.covering(from, to).map_err(|error| error.without_key())?;
    Ok(GrowthDensity::new(&covered.feedback, from, to, speeds))
}

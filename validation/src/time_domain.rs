//! A wheel in time.

use std::sync::OnceLock;

use riffel::Complex64;
use riffel::passage::{Harmonic, Sinusoid};
use riffel_case::{Case, ask};
use serde::Deserialize;

use crate::Row;
use crate::ground::{WorstError, nominal, on_track};
use crate::reference_file::reference_cases;

const FILE: &str = include_str!("../reference/time-domain/harmonic_balance.json");

/// Steps to a wave.
const STEPS: usize = 256;

#[derive(Deserialize)]
struct ReferencePoint {
    wavelength_m: f64,
    speed_m_per_s: f64,
    amplitude_m: f64,
    expect: Expected,
}

#[derive(Deserialize)]
struct Expected {
    harmonics: Vec<ExpectedHarmonic>,
    contact_loss_fraction: f64,
    minimum_normal_force_n: f64,
    maximum_normal_force_n: f64,
}

#[derive(Deserialize)]
struct ExpectedHarmonic {
    normal_force_n: [f64; 2],
    tangential_force_n: [f64; 2],
    creepage: [f64; 2],
    dissipation_j_per_m: [f64; 2],
}

impl ExpectedHarmonic {
    fn values(&self) -> [Complex64; 4] {
        [self.normal_force_n, self.tangential_force_n, self.creepage, self.dissipation_j_per_m]
            .map(|[re, im]| Complex64::new(re, im))
    }
}

fn values(harmonic: &Harmonic) -> [Complex64; 4] {
    [harmonic.normal_force, harmonic.tangential_force, harmonic.creepage, harmonic.dissipation]
}

/// Errors of harmonics over the first, of extremes over the first harmonic of the force, and of the share without contact.
fn against_harmonic_balance() -> &'static [WorstError; 3] {
    static ERRORS: OnceLock<[WorstError; 3]> = OnceLock::new();
    ERRORS.get_or_init(errors_against_harmonic_balance)
}

fn errors_against_harmonic_balance() -> [WorstError; 3] {
    let mut errors: [WorstError; 3] = Default::default();
    for reference in reference_cases::<ReferencePoint>(FILE) {
        let case = Case::parse(&reference.name, &reference.case_toml, &[]).expect("a case");
        for point in reference.points {
            let model = ask::in_time(&case, point.speed_m_per_s).expect("a model");
            let profile = Sinusoid { amplitude: point.amplitude_m, wavelength: point.wavelength_m };
            let settled = model.settle(profile, STEPS).expect("a settled state").swap_remove(0);
            let expected = &point.expect;
            let first = expected.harmonics[1].values();
            for (harmonic, expected) in settled.harmonics.iter().zip(&expected.harmonics) {
                let both = values(harmonic).into_iter().zip(expected.values());
                for ((got, expected), first) in both.zip(first) {
                    errors[0].compare_beside(first.norm(), got, expected);
                }
            }
            let [least, largest] = settled.normal_force;
            let size = first[0].norm();
            errors[1].compare_beside(size, least.into(), expected.minimum_normal_force_n.into());
            errors[1].compare_beside(size, largest.into(), expected.maximum_normal_force_n.into());
            errors[2].compare_beside(1.0, settled.contact_loss.into(), expected.contact_loss_fraction.into());
        }
    }
    errors
}

pub(crate) fn settled_harmonics() -> Row {
    const LIMIT: f64 = 5e-4;
    let [error, _, _] = against_harmonic_balance();
    Row {
        statement: "Normal force, creep force, creepage and dissipation of a wheel over a sinusoid of 0.1–100 µm, up to 46 % without contact, harmonics 0–5 at 18 points",
        source: "`time-domain/harmonic_balance.json`, written apart from Riffel in Python",
        expected: format!("{} complex values", error.compared),
        got: error.describe(LIMIT),
        tolerance: "5e-4 of the first harmonic: 256 steps to a wave take 1e-4",
        holds: error.within(LIMIT) && error.compared == 18 * 6 * 4,
    }
}

pub(crate) fn loss_of_contact() -> Row {
    const LIMIT: f64 = 1e-3;
    let [_, extremes, share] = against_harmonic_balance();
    Row {
        statement: "Largest and least normal force there, and the share of time without contact",
        source: "`time-domain/harmonic_balance.json`, 512 harmonics",
        expected: format!("{} forces and {} shares", extremes.compared, share.compared),
        got: format!("forces: {}; shares: {}", extremes.describe(LIMIT), share.describe(LIMIT)),
        tolerance: "1e-3 of the first harmonic of the force, and of a wave: steps of 0.004 of a wave, linear between",
        holds: extremes.within(LIMIT) && share.within(LIMIT) && share.compared == 18,
    }
}

pub(crate) fn small_amplitudes() -> Row {
    const LIMIT: f64 = 1e-3;
    const AMPLITUDE: f64 = 1e-7;
    let mut error = WorstError::default();
    let amplitude = "corrugation.amplitude=1e-7";
    for (case, wavelength, speed) in [
        (nominal(&[amplitude]), 0.055, 30.0),
        (nominal(&[amplitude, "contact.tractive_ratio=0.6"]), 0.03, 20.0),
        (nominal(&[amplitude, "contact.creep_law=shen-hedrick-elkins"]), 0.04, 33.0),
        (on_track(&[amplitude]), 0.05, 25.0),
        (on_track(&[amplitude, "contact.creep_law=polach", "rail.beam=euler-bernoulli"]), 0.08, 15.0),
    ] {
        let linear = case.feedback.at(wavelength, speed);
        let profile = Sinusoid { amplitude: AMPLITUDE, wavelength };
        let model = ask::in_time(&case, speed).expect("a model");
        let settled = model.settle(profile, STEPS).expect("a settled state").swap_remove(0);
        let linear = [linear.normal_force(), linear.tangential_force(), linear.creepage(), linear.dissipation / speed];
        for (got, linear) in values(&settled.harmonics[1]).into_iter().zip(linear) {
            error.compare(got, linear);
        }
    }
    Row {
        statement: "First harmonics over 0.1 µm in time, on a free beam and on two layers, three creep laws",
        source: "the linear loop",
        expected: format!("{} complex values", error.compared),
        got: error.describe(LIMIT),
        tolerance: "1e-3: 256 steps to a wave take 1e-4",
        holds: error.within(LIMIT) && error.compared == 20,
    }
}

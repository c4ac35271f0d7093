//! The cases that the statements of the paper are about.

use riffel::growth::RidgePoint;
use riffel::{Axis, Complex64, LoopState, Ridge};
use riffel_case::{BHASKAR_TRACK_CASE, Case, NOMINAL_CASE};

/// The nominal case with overrides.
pub(crate) fn nominal(overrides: &[&str]) -> Case {
    case("nominal.toml", NOMINAL_CASE, overrides)
}

/// The nominal wheel on the track of Bhaskar et al., with overrides.
pub(crate) fn on_track(overrides: &[&str]) -> Case {
    case("bhaskar-track.toml", BHASKAR_TRACK_CASE, overrides)
}

fn case(name: &str, text: &str, overrides: &[&str]) -> Case {
    let overrides: Vec<String> = overrides.iter().map(|&text| text.to_owned()).collect();
    Case::parse(name, text, &overrides).expect("the case files of the repository are valid")
}

/// The ridge in the paper's window of 20–80 mm between two speeds \[m/s\], every half metre per second.
pub(crate) fn ridge(case: &Case, from: f64, to: f64) -> Ridge {
    let points = ((to - from) * 2.0) as usize + 1;
    let speed = Axis::new(from, to, points).expect("an increasing range");
    let wavelength = Axis::new(0.020, 0.080, 601).expect("an increasing range");
    Ridge::search(&case.feedback, wavelength, speed)
}

/// The ridge at one speed \[m/s\].
pub(crate) fn ridge_at(case: &Case, speed: f64) -> RidgePoint {
    ridge(case, speed, speed + 1.0).points[0]
}

/// Every line of growth in the paper's window at one speed \[m/s\].
pub(crate) fn lines(case: &Case, speed: f64) -> Vec<RidgePoint> {
    let wavelength = Axis::new(0.020, 0.080, 601).expect("an increasing range");
    Ridge::lines_at(&case.feedback, wavelength, speed)
}

/// Smallest and largest of some values.
pub(crate) fn extent(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    values.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// The loop at a frequency \[Hz\] and speed \[m/s\].
pub(crate) fn at_frequency(case: &Case, frequency: f64, speed: f64) -> LoopState {
    case.feedback.at(speed / frequency, speed)
}

/// The largest relative error of a series of comparisons.
#[derive(Default)]
pub(crate) struct WorstError {
    worst: f64,
    /// How many values were compared.
    pub(crate) compared: usize,
}

impl WorstError {
    pub(crate) fn compare(&mut self, got: Complex64, expected: Complex64) {
        self.compare_beside(expected.norm(), got, expected);
    }

    /// Compare relative to a size of the caller's.
    pub(crate) fn compare_beside(&mut self, size: f64, got: Complex64, expected: Complex64) {
        let error = (got - expected).norm() / size;
        // NaN must not pass for small.
        self.worst = if error <= self.worst { self.worst } else { error };
        self.compared += 1;
    }

    pub(crate) fn within(&self, limit: f64) -> bool {
        self.worst <= limit
    }

    /// In words that are the same on every machine.
    pub(crate) fn describe(&self, limit: f64) -> String {
        let relation = if self.within(limit) { "≤" } else { "above" };
        format!("relative error {relation} {limit:e}")
    }
}

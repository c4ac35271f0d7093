//! Which keys of a case the growth at one point answers to, and how much.

use rayon::prelude::*;
use riffel_keys::CaseError;
use serde::Serialize;
use serde_json::Value;

use crate::{Case, CaseKey};

/// Derivative of the growth rate by one parameter, all that the case derives from it following.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sensitivity {
    /// Key of the case, or `wavelength` or `speed`.
    pub key: String,
    /// SI unit of the parameter, empty for a ratio.
    pub unit: &'static str,
    /// Value of the parameter in SI.
    pub value: f64,
    /// Derivative of the growth rate per passage by the parameter \[1 per unit\].
    pub derivative: f64,
    /// Relative change of the growth rate for a relative change of the parameter, (p/g) dg/dp \[-\].
    pub elasticity: f64,
    /// Estimate of the error of the elasticity \[-\].
    pub error: f64,
}

/// First step relative to the value, and how often it is halved.
const STEP: f64 = 4e-3;
const HALVINGS: usize = 10;

impl Case {
    /// The derivatives of the growth rate at a wavelength \[m\] and a speed \[m/s\] by every quantity of the case that
    /// is not zero and moves it, and by wavelength and speed themselves; the strongest first.
    ///
    /// A derivative is that of setting one key with all others as they are written: what the case leaves to follow from
    /// it follows, as the inertia of a wheel from its mass where only the mass is given.
    ///
    /// Method: central differences of the whole case, extrapolated to no step (Ridders 1982) from steps that are halved
    /// ten times, with the estimate of the error that belongs to the best. Differences reach every model of track and
    /// contact alike, those that iterate among them. Accuracy: 1e-9 of the largest elasticity and better for closed
    /// forms, see `sensitivities_match_closed_forms`; what an iteration leaves shows in the estimate. Cost: some twenty
    /// cases for each key: a tenth of a second in all, minutes with a non-steady contact, whose table is made anew.
    ///
    /// # Errors
    /// [`CaseError`] as of [`point`](Self::point).
    pub fn sensitivities(
        &self,
        wavelength: f64,
        speed: f64,
    ) -> Result<Vec<Sensitivity>, CaseError> {
        let growth = self.point(wavelength, speed)?.growth_rate();
        // A contact that is tabulated is tabulated where it is asked.
        let window = [
            format!("map.wavelength.min={wavelength:e}"),
            format!("map.wavelength.max={:e}", 1.001 * wavelength),
        ];
        let by_key = |key: &(&'static CaseKey, f64)| {
            let (key, value) = *key;
            let at = |value: f64| -> Option<f64> {
                let mut overrides = vec![format!("{}={value:e}", key.key)];
                overrides.extend_from_slice(&window);
                let case = self.with(&[&overrides]).ok()?;
                Some(case.point(wavelength, speed).ok()?.growth_rate())
            };
            let unit = key.quantity.map_or("", |kind| kind.unit);
            relative(&key.key, unit, value, growth, at)
        };
        let keys = self.quantities();
        let mut all: Vec<Sensitivity> = keys.par_iter().filter_map(by_key).collect();
        let at_wavelength = |wavelength| Some(self.point(wavelength, speed).ok()?.growth_rate());
        let at_speed = |speed| Some(self.point(wavelength, speed).ok()?.growth_rate());
        all.extend(relative(
            "wavelength",
            "m",
            wavelength,
            growth,
            at_wavelength,
        ));
        all.extend(relative("speed", "m/s", speed, growth, at_speed));
        all.sort_by(|a, b| b.elasticity.abs().total_cmp(&a.elasticity.abs()));
        Ok(all)
    }

    /// Every quantity of the case but those of the window, with its value in SI where it is not zero.
    fn quantities(&self) -> Vec<(&'static CaseKey, f64)> {
        let file = serde_json::to_value(&self.file).unwrap_or_default();
        let value = |key: &CaseKey| {
            let mut parts = key.key.split('.');
            let found = parts.try_fold(&file, |table, part| table.get(part))?;
            let si = match found {
                Value::String(text) => key.quantity?.read(text).ok()?,
                number => number.as_f64()?,
            };
            (si != 0.0).then_some(si)
        };
        let keys = CaseKey::all().iter();
        keys.filter(|key| key.quantity.is_some() && !key.key.starts_with("map."))
            .filter_map(|key| Some((key, value(key)?)))
            .collect()
    }
}

/// The derivative by a parameter; none where it cannot be moved, or moves nothing.
fn relative(
    key: &str,
    unit: &'static str,
    value: f64,
    growth: f64,
    at: impl Fn(f64) -> Option<f64>,
) -> Option<Sensitivity> {
    let (derivative, error) = extrapolated(value, at)?;
    let elasticity = derivative * value / growth;
    let error = (error * value / growth).abs();
    // What differs by roundings alone is not moved.
    const ROUNDING: f64 = 1e-12;
    (elasticity.abs() > error.max(ROUNDING)).then(|| Sensitivity {
        key: key.to_owned(),
        unit,
        value,
        derivative,
        elasticity,
        error,
    })
}

/// Derivative and its error by central differences, extrapolated; none where the function is not known
/// about the value.
fn extrapolated(value: f64, at: impl Fn(f64) -> Option<f64>) -> Option<(f64, f64)> {
    let mut best = (0.0, f64::INFINITY);
    let mut last: Vec<f64> = Vec::new();
    for halving in 0..=HALVINGS {
        let step = value.abs() * STEP * 0.5f64.powi(halving as i32);
        let (high, low) = (value + step, value - step);
        let (Some(above), Some(below)) = (at(high), at(low)) else {
            // A value near the end of its range: smaller steps stay inside.
            last.clear();
            continue;
        };
        let mut row = vec![(above - below) / (high - low)];
        let mut factor = 4.0;
        for (order, coarse) in last.iter().enumerate() {
            let fine = row[order];
            let next = fine + (fine - coarse) / (factor - 1.0);
            let error = (next - fine).abs().max((next - coarse).abs());
            if error < best.1 {
                best = (next, error);
            }
            row.push(next);
            factor *= 4.0;
        }
        last = row;
    }
    best.1.is_finite().then_some(best)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NOMINAL_CASE;

    fn case(overrides: &[&str]) -> Case {
        let overrides: Vec<String> = overrides.iter().map(|text| (*text).to_owned()).collect();
        Case::parse("nominal", NOMINAL_CASE, &overrides).unwrap()
    }

    fn of<'a>(all: &'a [Sensitivity], key: &str) -> &'a Sensitivity {
        all.iter()
            .find(|sensitivity| sensitivity.key == key)
            .unwrap()
    }

    /// Growth is proportional to the wear coefficient and inversely to the density; at constant creepage the mass of
    /// the wheel enters by the normal force alone, dP₁/dm = −P₁²/(Δ m²ω²). The parameters are none at which the steps
    /// were chosen.
    #[test]
    fn sensitivities_match_closed_forms() {
        for (wavelength, speed) in [(0.031, 17.0), (0.12, 41.0), (0.25, 60.0)] {
            let case = case(&[
                "wheel.rotation=constant-creepage",
                "wheel.mass=612 kg",
                "contact.tractive_ratio=0.37",
            ]);
            let all = case.sensitivities(wavelength, speed).unwrap();
            assert!((of(&all, "wear.coefficient").elasticity - 1.0).abs() < 1e-10);
            assert!((of(&all, "wear.density").elasticity + 1.0).abs() < 1e-10);
            let state = case.point(wavelength, speed).unwrap();
            let m = 612.0;
            let relative = -state.normal_force()
                / case.feedback.amplitude()
                / (m * state.angular_frequency()).powi(2);
            let dissipation = state.dissipation_at_rail();
            let expected = state.growth_rate() * (dissipation * relative).re / dissipation.re;
            let got = of(&all, "wheel.mass");
            assert!(
                (got.derivative / expected - 1.0).abs() < 1e-9,
                "{got:?} {expected}"
            );
            assert!(got.error < 1e-9, "{got:?}");
            assert!(
                all.iter()
                    .all(|sensitivity| sensitivity.key != "wheel.inertia")
            );
            assert!(
                all.iter()
                    .all(|sensitivity| sensitivity.key != "corrugation.amplitude")
            );
        }
    }

    /// Every derivative is that of a plain central difference, of cases with presets, supports, another law and a
    /// contact that answers late. 1e-5 is the second derivative's part in a step of 1e-4.
    #[test]
    fn sensitivities_are_those_of_differences() {
        for overrides in [
            &["track.preset=br-stiff", "track.model=two-layer-periodic"][..],
            &[
                "contact.creep_law=polach",
                "contact.response=spring-dashpot",
            ][..],
        ] {
            let case = case(overrides);
            let all = case.sensitivities(0.06, 25.0).unwrap();
            assert!(all.len() > 8, "{}", all.len());
            let largest = all[0].elasticity.abs();
            for sensitivity in all.iter().filter(|one| CaseKey::find(&one.key).is_some()) {
                let at = |factor: f64| {
                    let value = format!("{}={:e}", sensitivity.key, factor * sensitivity.value);
                    case.with(&[&[value]])
                        .unwrap()
                        .point(0.06, 25.0)
                        .unwrap()
                        .growth_rate()
                };
                let difference = (at(1.0001) - at(0.9999)) / (2e-4 * at(1.0));
                let error = (sensitivity.elasticity - difference).abs();
                assert!(error < 1e-5 * largest, "{sensitivity:?} {difference}");
            }
        }
    }
}

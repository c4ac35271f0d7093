//! Which keys of a case the growth at one point answers to, and how much.

use rayon::prelude::*;
use riffel_keys::{CaseError, PhysicalRange};
use serde::Serialize;
use toml::{Table, Value};

use crate::case::on_curve::wider_than_its_band;
use crate::file::setting::Setting;
use crate::parts::window::Window;
use crate::text::case_text::CaseText;
use crate::{Case, CaseKey};

/// Derivative of the growth rate by one parameter, all others held.
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

/// The derivatives of the growth rate at a wavelength \[m\] and a speed \[m/s\] by every quantity of the case that
/// is not zero and moves it, and by wavelength and speed themselves; the strongest first.
///
/// A derivative is a partial one: every other key holds its value, those that presets and defaults fill in among
/// them. So the inertia of a wheel stays where its mass is moved, also where it was left out, and a mean state that came from a
/// curve stays whatever is moved.
///
/// Method: central differences of the whole case, extrapolated to no step (Ridders 1982) from steps that are halved
/// ten times, with the estimate of the error that belongs to the best. Differences reach every model of track and
/// contact alike, those that iterate among them. Accuracy: 1e-9 of the largest elasticity and better for closed
/// forms, see `sensitivities_match_closed_forms`; what an iteration leaves shows in the estimate. Cost: some twenty
/// cases for each key: a tenth of a second in all, minutes with a non-steady contact, whose table is made anew.
/// A parameter at the end of its range cannot be moved to both sides and is left out.
///
/// # Errors
/// [`CaseError`] as of [`Case::point`].
pub fn sensitivities(case: &Case, wavelength: f64, speed: f64) -> Result<Vec<Sensitivity>, CaseError> {
    let at_point = case.point(wavelength, speed)?.growth_rate;
    let whole = written_out(case)?;
    let window = window(wavelength);
    let changed = |change: Option<(&str, f64)>| -> Result<f64, CaseError> {
        let mut text = whole.clone();
        text.write(&window)?;
        if let Some((key, value)) = change {
            text.write(&[(key.to_owned(), Value::Float(value))])?;
        }
        let case = case.rebuilt(text, Window::Map)?;
        Ok(case.point(wavelength, speed)?.growth_rate)
    };
    let growth = changed(None)?;
    let by_key = |key: &(&'static CaseKey, f64)| {
        let (key, value) = *key;
        let at = |value: f64| changed(Some((&key.key, value))).ok();
        let unit = key.quantity.map_or("", |kind| kind.unit);
        relative(&key.key, unit, value, growth, at)
    };
    let keys = quantities(whole.keys.table());
    let mut all: Vec<Sensitivity> = keys.par_iter().filter_map(by_key).collect();
    let at_wavelength = |wavelength| Some(case.point(wavelength, speed).ok()?.growth_rate);
    let at_speed = |speed| Some(case.point(wavelength, speed).ok()?.growth_rate);
    all.extend(relative("wavelength", "m", wavelength, at_point, at_wavelength));
    all.extend(relative("speed", "m/s", speed, at_point, at_speed));
    all.sort_by(|a, b| b.elasticity.abs().total_cmp(&a.elasticity.abs()));
    Ok(all)
}

/// The keys of the case with every value written that presets, defaults and other keys fill in.
fn written_out(case: &Case) -> Result<CaseText, CaseError> {
    let whole = Table::try_from(&case.file);
    let whole = whole.map_err(|error| case.refuse("", error.to_string()))?;
    let mut text = case.unfilled.clone();
    for (key, value) in whole {
        text.keys.put(&key, value);
    }
    // What a curve said is written now, and is held as all else is; a band that it leaves to the contact's own width stays so.
    if wider_than_its_band(case).is_some() {
        text.keys.remove("wear.band_width");
    }
    text.keys.remove("contact.from");
    Ok(text)
}

/// A narrow window of the map at a wavelength \[m\]: a contact that is tabulated is tabulated where it is
/// asked.
fn window(wavelength: f64) -> [Setting; 2] {
    const WIDTH: f64 = 1.001;
    let range = PhysicalRange::of("map.wavelength.max");
    let longest = range.map_or(f64::INFINITY, |range| range.hard[1]);
    let (min, max) =
        if WIDTH * wavelength <= longest { (wavelength, WIDTH * wavelength) } else { (wavelength / WIDTH, wavelength) };
    [("map.wavelength.min".to_owned(), Value::Float(min)), ("map.wavelength.max".to_owned(), Value::Float(max))]
}

/// Every quantity among the keys of a case but those of the window, with its value in SI where it is not zero.
fn quantities(keys: &Table) -> Vec<(&'static CaseKey, f64)> {
    let value = |key: &CaseKey| {
        let (first, rest) = key.key.split_once('.')?;
        let found = rest.split('.').try_fold(keys.get(first)?, |table, part| table.get(part))?;
        let si = match found {
            Value::String(text) => key.quantity?.read(text).ok()?,
            Value::Float(number) => *number,
            Value::Integer(number) => *number as f64,
            _ => return None,
        };
        (si != 0.0).then_some(si)
    };
    let known = CaseKey::all().iter();
    known
        .filter(|key| key.quantity.is_some() && !key.key.starts_with("map."))
        .filter_map(|key| Some((key, value(key)?)))
        .collect()
}

/// The derivative by a parameter; `None` if it cannot be moved, or moves nothing.
fn relative(
    key: &str,
    unit: &'static str,
    value: f64,
    growth: f64,
    at: impl Fn(f64) -> Option<f64>,
) -> Option<Sensitivity> {
    let (derivative, error) = extrapolated(value, growth, at)?;
    let elasticity = derivative * value / growth;
    let error = (error * value / growth).abs();
    // What differs by roundings alone is not moved.
    (elasticity.abs() > error).then(|| Sensitivity { key: key.to_owned(), unit, value, derivative, elasticity, error })
}

/// Derivative of a function of a size and its error by central differences, extrapolated; `None` if the function is not
/// known about the value.
///
/// The error is no less than what the roundings of the function make of a difference over the smallest step used.
fn extrapolated(value: f64, size: f64, at: impl Fn(f64) -> Option<f64>) -> Option<(f64, f64)> {
    /// Of a growth rate: some dozen operations on every way from a parameter to it.
    const ROUNDINGS: f64 = 16.0;
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
            let error = error.max(ROUNDINGS * f64::EPSILON * size.abs() / step);
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
    use crate::fixtures::case;
    use crate::{METRO_CASE, NOMINAL_CASE};

    fn of<'a>(all: &'a [Sensitivity], key: &str) -> &'a Sensitivity {
        all.iter().find(|sensitivity| sensitivity.key == key).unwrap()
    }

    /// Growth is proportional to the wear coefficient and inversely to the density; at constant creepage the mass of
    /// the wheel enters by the normal force alone, dP₁/dm = −P₁²/(Δ m²ω²). The parameters are none at which the steps
    /// were chosen.
    // Long: computes the sensitivities to all keys at three points.
    #[test]
    fn sensitivities_match_closed_forms() {
        for (wavelength, speed) in [(0.031, 17.0), (0.12, 41.0), (0.25, 60.0)] {
            let overrides = ["wheel.rotation=constant-creepage", "wheel.mass=612 kg", "contact.tractive_ratio=0.37"];
            let case = case(NOMINAL_CASE, &overrides);
            let all = sensitivities(&case, wavelength, speed).unwrap();
            assert!((of(&all, "wear.coefficient").elasticity - 1.0).abs() < 1e-10);
            assert!((of(&all, "wear.density").elasticity + 1.0).abs() < 1e-10);
            let state = case.point(wavelength, speed).unwrap();
            let m = 612.0;
            let relative = -state.normal_force() / case.feedback.amplitude() / (m * state.angular_frequency).powi(2);
            let dissipation = state.dissipation_at_rail;
            let expected = state.growth_rate * (dissipation * relative).re / dissipation.re;
            let got = of(&all, "wheel.mass");
            assert!((got.derivative / expected - 1.0).abs() < 1e-9, "{got:?} {expected}");
            assert!(got.error < 1e-9, "{got:?}");
            assert!(all.iter().all(|sensitivity| sensitivity.key != "wheel.inertia"));
            assert!(all.iter().all(|sensitivity| sensitivity.key != "corrugation.amplitude"));
        }
    }

    /// Every derivative is that of a plain central difference with all other keys written out, of cases with presets,
    /// supports, another law and a contact that answers late. 1e-5 is the third derivative's part in a step of 1e-4.
    // Long: computes each case anew for every key and difference, the independent side of the comparison.
    #[test]
    fn sensitivities_are_those_of_differences() {
        let stiff = ["track.preset=br-stiff", "track.model=two-layer-periodic"];
        let late = ["contact.creep_law=polach", "contact.response=spring-dashpot"];
        for (text, overrides, wavelength, speed) in [
            (NOMINAL_CASE, &stiff[..], 0.06, 25.0),
            (NOMINAL_CASE, &late[..], 0.06, 25.0),
            // Mass and inertia of the wheel are those of a preset.
            (METRO_CASE, &[][..], 0.05, 60.0 / 3.6),
        ] {
            let case = case(text, overrides);
            let all = sensitivities(&case, wavelength, speed).unwrap();
            assert!(all.len() > 8, "{}", all.len());
            assert!(all.iter().any(|one| one.key == "wheel.inertia"));
            let largest = all[0].elasticity.abs();
            let written = toml::to_string(&case.file).unwrap();
            for sensitivity in all.iter().filter(|one| CaseKey::find(&one.key).is_some()) {
                let at = |factor: f64| {
                    let value = format!("{}={:e}", sensitivity.key, factor * sensitivity.value);
                    let case = Case::parse("written", &written, &[value]).unwrap();
                    case.point(wavelength, speed).unwrap().growth_rate
                };
                let difference = (at(1.0001) - at(0.9999)) / (2e-4 * at(1.0));
                let error = (sensitivity.elasticity - difference).abs();
                assert!(error < 1e-5 * largest, "{sensitivity:?} {difference}");
            }
        }
    }

    /// What growth does not depend on is not listed, though roundings move it.
    // Long: computes the sensitivities to all keys at four points.
    #[test]
    fn roundings_are_no_sensitivity() {
        let case = case(NOMINAL_CASE, &[]);
        for (wavelength, speed) in [(0.055, 30.0), (0.03, 20.0), (0.04, 45.0), (0.07, 12.0)] {
            let all = sensitivities(&case, wavelength, speed).unwrap();
            assert_eq!(all.iter().find(|one| one.key == "corrugation.amplitude"), None);
            assert!(all.iter().any(|one| one.key == "wear.density"));
        }
    }

    /// Up to the longest wavelength that is computed the keys are all there; beyond it there is an error.
    #[test]
    fn the_end_of_the_wavelengths_has_sensitivities() {
        let case = case(NOMINAL_CASE, &[]);
        let keys = |wavelength| {
            let all = sensitivities(&case, wavelength, 60.0).unwrap();
            let mut keys: Vec<String> = all.into_iter().map(|one| one.key).collect();
            keys.retain(|key| key != "wavelength");
            keys.sort();
            keys
        };
        assert_eq!(keys(9.999), keys(9.9));
        assert!(sensitivities(&case, 10.1, 60.0).is_err());
    }
}

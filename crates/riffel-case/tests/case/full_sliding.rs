//! The way to full sliding: growth tends to that of a creep force of friction times load, whatever the slip.

use riffel_case::{Case, METRO_CURVE_CASE, NOMINAL_CASE};

use crate::case;

/// A flexible wheelset in a curve, both wheels sliding across.
const CURVE: &str = include_str!("../../cases/curve.toml");

fn rate(case: &Case, wavelength: f64, speed: f64) -> f64 {
    case.feedback.at(wavelength, speed).growth_rate
}

/// Along the rail: no step where the search for the creepage changes, ever nearer to the onset of full slip, and there the growth of
/// the law of full sliding but for the 5·10⁻³ that 32 elements leave of a force.
// Long: tabulates the late response of the exact contact at six ratios of three cases.
#[test]
fn growth_is_continuous_in_the_tractive_ratio_up_to_full_sliding() {
    for (friction, radius) in [(0.2, 0.46), (0.5, 0.46), (0.4, 0.33)] {
        let keys = [
            format!("contact.friction={friction}"),
            format!("wheel.rolling_radius={radius}"),
            "contact.grid=32".to_owned(),
            "map.wavelength=30-90 mm".to_owned(),
            "contact.creep_law=half-space".to_owned(),
        ];
        let of = |more: &[String]| {
            let keys: Vec<&str> = keys.iter().chain(more).map(String::as_str).collect();
            case(NOMINAL_CASE, &keys)
        };
        let at = |ratio: f64, response: &str| {
            of(&[format!("contact.tractive_ratio={ratio}"), format!("contact.response={response}")])
        };
        let ratios = [0.98, 0.9899, 0.9901, 0.995, 0.998, 0.9999];
        let cases = ratios.map(|ratio| at(ratio, "non-steady"));
        let slow = at(0.9999, "quasi-static");
        let creepage = slow.steady.creepages.longitudinal;
        let sliding = of(&["contact.creep_law=full-sliding".to_owned(), format!("contact.creepage={creepage}")]);
        for wavelength in [0.03, 0.0557, 0.09] {
            let rates = cases.each_ref().map(|case| rate(case, wavelength, 30.0));
            let [slow, sliding] = [&slow, &sliding].map(|case| rate(case, wavelength, 30.0));
            let near = |one: f64, other: f64, share: f64| (one / other - 1.0).abs() < share;
            assert!(near(rates[1], rates[2], 5e-3), "{rates:?}");
            assert!(near(slow, sliding, 5e-3), "{slow} {sliding}");
            let left = rates.map(|rate| (rate - rates[5]).abs());
            assert!(left.is_sorted_by(|one, next| one > next), "{rates:?}");
            assert!(near(rates[4], rates[5], 5e-2), "{rates:?}");
        }
    }
}

/// Across it: the greater the slip, the less is left of the spring.
#[test]
fn a_curve_tends_to_full_sliding() {
    for (friction, wavelength) in [(0.3, 0.04), (0.3, 0.1), (0.15, 0.06)] {
        let rates = |law: &str| {
            [1.0, 2.0, 4.0].map(|size| {
                let (along, across) = (0.004 * size, 0.01 * size);
                let keys = [
                    format!("contact.friction={friction}"),
                    format!("contact.creepage={{ longitudinal = {along}, lateral = {across} }}"),
                    "contact.wave_geometry=false".to_owned(),
                    format!("contact.creep_law={law}"),
                    "contact.grid=32".to_owned(),
                ];
                let keys: Vec<&str> = keys.iter().map(String::as_str).collect();
                rate(&case(CURVE, &keys), wavelength, 9.0)
            })
        };
        let sliding = rates("full-sliding");
        let found = rates("half-space");
        let left = [0, 1, 2].map(|step| (found[step] - sliding[step]).abs());
        let falls = left.is_sorted_by(|one, next| *next < 0.5 * one);
        assert!(falls && left[2] < 0.01 * sliding[2].abs(), "{found:?} {sliding:?}");
    }
}

/// A late response has the exact law by itself, in a curve as elsewhere, and its table holds where all slips.
// Long: tabulates the late response of the exact contact in four curves, twice each.
#[test]
fn a_late_response_in_a_curve_has_the_exact_law() {
    for (radius, friction) in [(120, 0.4), (180, 0.4), (180, 0.2), (220, 0.3)] {
        let keys = [
            format!("curve.radius={radius} m"),
            format!("contact.friction={{ left = {friction}, right = {friction} }}"),
            "contact.response=non-steady".to_owned(),
            "contact.grid=32".to_owned(),
        ];
        let mut keys: Vec<&str> = keys.iter().map(String::as_str).collect();
        let left_out = METRO_CURVE_CASE.replace("creep_law = \"fastsim\"", "");
        let exact = case(&left_out, &keys);
        keys.push("contact.creep_law=half-space");
        let named = case(METRO_CURVE_CASE, &keys);
        for wavelength in exact.wavelength.values() {
            let rate = rate(&exact, wavelength, 12.0);
            assert!(rate.is_finite() && rate == self::rate(&named, wavelength, 12.0));
        }
    }
}

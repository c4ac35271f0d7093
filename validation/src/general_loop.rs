//! The loop on all axes.

use riffel::Complex64;
use riffel_case::{Case, Point};
use serde::Deserialize;
use serde_json::Value;

use crate::Row;
use crate::ground::WorstError;
use crate::reference_file::reference_cases;

const ONE_CONTACT: &str = include_str!("../reference/general-loop/loop_on_all_axes.json");
const SEVERAL: &str = include_str!("../reference/general-loop/several_contacts.json");

#[derive(Deserialize)]
struct ReferencePoint {
    wavelength_m: f64,
    speed_m_per_s: f64,
    expect: Value,
    diagnostics: Diagnostics,
}

#[derive(Deserialize)]
struct Diagnostics {
    dissipation_at_rail_point_j_per_m: Vec<[f64; 2]>,
}

/// The numbers of a value in their order: pairs are complex.
fn numbers(value: &Value, found: &mut Vec<Complex64>) {
    match value {
        Value::Number(number) => found.push(number.as_f64().unwrap_or(f64::NAN).into()),
        Value::Array(entries) => match &entries[..] {
            [Value::Number(re), Value::Number(im)] => {
                let part = |number: &serde_json::Number| number.as_f64().unwrap_or(f64::NAN);
                found.push(Complex64::new(part(re), part(im)));
            }
            _ => entries.iter().for_each(|entry| numbers(entry, found)),
        },
        _ => {}
    }
}

/// Every quantity of every contact of the cases whose name is wanted.
fn compare(file: &str, wanted: impl Fn(&str) -> bool) -> WorstError {
    let mut error = WorstError::default();
    for reference in reference_cases::<ReferencePoint>(file) {
        if !wanted(&reference.name) {
            continue;
        }
        let case = Case::parse(&reference.name, &reference.case_toml, &[]).expect("a case");
        for point in reference.points {
            let state = case.point(point.wavelength_m, point.speed_m_per_s).expect("a point");
            let got = serde_json::to_value(Point::new(&case, &state)).expect("a document");
            // Growth is proportional to the real part of the energy at the rail, which may vanish beside the whole.
            let whole = case.feedback.growth_rate_per_dissipation().abs() / case.steady.full_slip_energy_per_metre();
            let energies = point.diagnostics.dissipation_at_rail_point_j_per_m.iter();
            let energy = energies.map(|[re, im]| re.hypot(*im)).fold(0.0, f64::max);
            let normal = |of: &Value| {
                let mut parts = Vec::new();
                numbers(&of["normal_force_n"], &mut parts);
                parts[0].norm()
            };
            let mut compare_all = |got: &Value, expected: &Value| {
                for (key, value) in expected.as_object().expect("a table") {
                    let (mut one, mut other) = (Vec::new(), Vec::new());
                    numbers(&got[key], &mut one);
                    numbers(value, &mut other);
                    assert_eq!(one.len(), other.len(), "{}: {key}", reference.name);
                    let largest = other.iter().map(|value| value.norm()).fold(0.0, f64::max);
                    let size = match key.as_str() {
                        "growth_rate_per_passage" => whole * energy,
                        "tangential_force_n" | "lateral_force_n" => normal(expected),
                        _ => largest,
                    };
                    for (one, other) in one.into_iter().zip(other) {
                        error.compare_beside(size, one, other);
                    }
                }
            };
            let contacts = |of: &Value| of["contacts"].as_array().expect("contacts").clone();
            for (got, expected) in contacts(&got).iter().zip(&contacts(&point.expect)) {
                for key in ["wheel", "rail"] {
                    assert_eq!(got[key], expected[key], "{}", reference.name);
                }
                compare_all(got, expected);
            }
            let mut expected = point.expect;
            expected.as_object_mut().expect("a table").remove("contacts");
            compare_all(&got, &expected);
        }
    }
    error
}

pub(crate) fn loop_on_all_axes() -> Row {
    const LIMIT: f64 = 1e-9;
    let error = compare(ONE_CONTACT, |_| true);
    Row {
        statement: "Loop of a rigid wheelset on one rail, creepage in any direction, spin, contact angle and suspension, 12 cases at 3 points each",
        source: "`general-loop/loop_on_all_axes.json`, written apart from Riffel in Python",
        expected: format!("{} values", error.compared),
        got: error.describe(LIMIT),
        tolerance: "1e-9: the accuracy the reference states",
        holds: error.within(LIMIT) && error.compared > 36 * 30,
    }
}

/// Flexible wheelsets are good to 1e-7 in the reference, which resonances of the loop magnify.
fn is_flexible(name: &str) -> bool {
    ["wheelset", "axle"].iter().any(|word| name.contains(word))
}

pub(crate) fn several_wheels_on_one_rail() -> Row {
    const LIMIT: f64 = 1e-8;
    let error = compare(SEVERAL, |name| !is_flexible(name));
    Row {
        statement: "Loop of two, four and eight wheels on one rail, each growth apart",
        source: "`general-loop/several_contacts.json`, written apart from Riffel in Python",
        expected: format!("{} values", error.compared),
        got: error.describe(LIMIT),
        tolerance: "1e-8: the accuracy the reference states",
        holds: error.within(LIMIT) && error.compared > 0,
    }
}

pub(crate) fn both_rails_and_flexible_wheelsets() -> Row {
    const LIMIT: f64 = 1e-6;
    let error = compare(SEVERAL, is_flexible);
    Row {
        statement: "Loop on both rails through flexible wheelsets, rails smooth, in phase and in antiphase, and of two wheelsets on twisting rails",
        source: "`general-loop/several_contacts.json`, written apart from Riffel in Python",
        expected: format!("{} values", error.compared),
        got: error.describe(LIMIT),
        tolerance: "1e-6: 1e-7 in the wheelsets of the reference, magnified by resonances of the loop",
        holds: error.within(LIMIT) && error.compared > 0,
    }
}

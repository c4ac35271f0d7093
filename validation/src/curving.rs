//! Bogies in curves.

use riffel_answers::curve::CurveAnswer;
use riffel_case::CurvingCase;
use riffel_curving::{LinearWheelset, free_curving_shift};
use serde::Deserialize;
use serde_json::Value;

use crate::Row;
use crate::ground::WorstError;

const CLOSED_FORMS: &str = include_str!("../reference/curving/closed-forms.json");
const LINEAR: &str = include_str!("../reference/curving/linear.json");
const SATURATED: &str = include_str!("../reference/curving/saturated.json");
const TILTED: &str = include_str!("../reference/curving/tilted.json");

#[derive(Deserialize)]
struct ReferenceCase {
    name: String,
    case_toml: String,
    expect: Value,
}

/// Compare every number of the document of each case. The size of a number is that of the largest of its name in the
/// case; where all are zero, the load of a wheel.
fn compare(file: &str, error: &mut WorstError) {
    let cases: Vec<ReferenceCase> = serde_json::from_str(file).expect("valid JSON");
    for reference in cases {
        let case = CurvingCase::parse(&reference.name, &reference.case_toml, &[]).expect("a case");
        let answer = CurveAnswer::new(&case, None).expect("an equilibrium");
        let got = serde_json::to_value(answer).expect("a document");
        assert!(got["residual"].as_f64().expect("a residual") < 1e-10, "{}", reference.name);
        let load = &reference.expect["wheels"][0]["vertical_load_n"];
        let load = load.as_f64().expect("a load");
        let expected = reference.expect.as_object().expect("a table");
        for (key, expected) in expected {
            match expected {
                Value::Array(items) => {
                    for (item, got) in items.iter().zip(got[key].as_array().expect("a list")) {
                        compare_table(item, got, items, load, error);
                    }
                }
                Value::Object(_) => {
                    compare_table(expected, &got[key], std::slice::from_ref(expected), load, error);
                }
                _ => compare_number(expected, &got[key], expected.as_f64(), load, error),
            }
        }
    }
}

fn compare_table(expected: &Value, got: &Value, all: &[Value], load: f64, error: &mut WorstError) {
    for (key, expected) in expected.as_object().expect("a table") {
        if let Value::String(text) = expected {
            assert_eq!(got[key], **text);
            continue;
        }
        let sizes = all.iter().filter_map(|item| item[key].as_f64());
        let size = sizes.fold(0.0, |most: f64, value| most.max(value.abs()));
        compare_number(expected, &got[key], Some(size), load, error);
    }
}

fn compare_number(expected: &Value, got: &Value, size: Option<f64>, load: f64, error: &mut WorstError) {
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    let size = size.map(f64::abs).filter(|size| *size > 0.0).unwrap_or(load);
    error.compare_beside(size, number(got).into(), number(expected).into());
}

fn row(
    file: &str,
    limit: f64,
    least: usize,
    statement: &'static str,
    source: &'static str,
    tolerance: &'static str,
) -> Row {
    let mut error = WorstError::default();
    compare(file, &mut error);
    Row {
        statement,
        source,
        expected: format!("{} values", error.compared),
        got: error.describe(limit),
        tolerance,
        holds: error.within(limit) && error.compared >= least,
    }
}

pub(crate) fn linear_steering() -> Row {
    row(
        LINEAR,
        1e-10,
        600,
        "Two-axle bogie in 10 curves after linear steering theory: every shift, creepage, force and moment",
        "`curving/linear.json`, written apart from Riffel in Python, in 40 digits",
        "1e-10: rounding of creepages of 1e-5 beside rotation",
    )
}

pub(crate) fn saturated_curving() -> Row {
    row(
        SATURATED,
        1e-9,
        600,
        "The same in 10 curves of 166–518 m with saturated creep, flange springs, unlike rails and drive",
        "`curving/saturated.json`, written apart from Riffel in Python, in 40 digits",
        "1e-9: rounding, magnified where all contacts slide",
    )
}

pub(crate) fn curving_on_flanges() -> Row {
    row(
        TILTED,
        1e-9,
        380,
        "The same in 6 curves with contact planes, their normal forces and a smooth flange",
        "`curving/tilted.json`, written apart from Riffel in Python, in 40 digits",
        "1e-9: rounding, magnified by the steep flange",
    )
}

#[derive(Deserialize)]
#[serde(tag = "kind")]
enum ClosedForm {
    #[serde(rename = "free")]
    Free { wheel_radius_m: f64, contact_spacing_m: f64, conicity: f64, radius_m: f64, expect: Value },
    #[serde(rename = "single wheelset, linear")]
    Single(SingleWheelset),
}

#[derive(Deserialize)]
struct SingleWheelset {
    wheel_radius_m: f64,
    half_contact_spacing_m: f64,
    conicity: f64,
    radius_m: f64,
    f11_n: f64,
    f22_n: f64,
    f23_nm: f64,
    lateral_stiffness_n_m: f64,
    yaw_stiffness_nm_rad: f64,
    lateral_force_n: f64,
    frame_yaw_rad: f64,
    expect: Value,
}

pub(crate) fn closed_forms_of_curving() -> Row {
    const LIMIT: f64 = 1e-12;
    let cases: Vec<ClosedForm> = serde_json::from_str(CLOSED_FORMS).expect("valid JSON");
    let mut error = WorstError::default();
    for case in cases {
        let (got, expect) = match case {
            ClosedForm::Free { wheel_radius_m, contact_spacing_m, conicity, radius_m, expect } => {
                let shift = free_curving_shift(wheel_radius_m, contact_spacing_m, conicity, radius_m);
                (vec![("lateral_shift_m", shift)], expect)
            }
            ClosedForm::Single(single) => {
                let state = LinearWheelset {
                    rolling_radius: single.wheel_radius_m,
                    contact_spacing: 2.0 * single.half_contact_spacing_m,
                    conicity: single.conicity,
                    radius: single.radius_m,
                    longitudinal_creep_coefficient: single.f11_n,
                    lateral_creep_coefficient: single.f22_n,
                    spin_creep_coefficient: single.f23_nm,
                    lateral_stiffness: single.lateral_stiffness_n_m,
                    yaw_stiffness: single.yaw_stiffness_nm_rad,
                    lateral_force: single.lateral_force_n,
                    frame_yaw: single.frame_yaw_rad,
                }
                .equilibrium();
                let values = vec![
                    ("lateral_shift_m", state.lateral_shift),
                    ("yaw_rad", state.yaw),
                    ("longitudinal_creepage_right", state.longitudinal_creepage_right),
                    ("longitudinal_creepage_left", -state.longitudinal_creepage_right),
                    ("lateral_creepage", state.lateral_creepage),
                    ("longitudinal_force_right_n", state.longitudinal_force_right),
                    ("lateral_force_sum_n", state.lateral_force_sum),
                ];
                (values, single.expect)
            }
        };
        for (key, value) in got {
            let expected = expect[key].as_f64().expect("a number");
            // A longitudinal creepage is the difference of two, each of the size s/R.
            let size = if key.starts_with("longitudinal") { None } else { Some(expected.abs()) };
            let size = size.unwrap_or_else(|| expected.abs().max(1e-3 * if key.ends_with("_n") { 1e7 } else { 1.0 }));
            error.compare_beside(size, value.into(), expected.into());
        }
    }
    Row {
        statement: "Free curving y = −r₀s/(λR), and a single wheelset after linear steering theory",
        source: "`curving/closed-forms.json`, written apart from Riffel in Python, in 40 digits",
        expected: format!("{} values", error.compared),
        got: error.describe(LIMIT),
        tolerance: "1e-12: rounding; longitudinal creepage beside the 1e-3 of which it is the difference",
        holds: error.within(LIMIT) && error.compared >= 45,
    }
}

//! The closed form in 40-digit arithmetic.

use std::collections::BTreeMap;

use riffel::Complex64;
use riffel_case::{Case, PointQuantity};
use serde::Deserialize;

use crate::Row;
use crate::ground::{WorstError, nominal};

#[derive(Deserialize)]
struct Reference {
    points: Vec<Point>,
}

#[derive(Deserialize)]
struct Point {
    case: Parameters,
    wavelength_m: f64,
    speed_m_per_s: f64,
    expect: BTreeMap<String, Value>,
}

/// What differs between the points; the rest is the nominal case.
#[derive(Deserialize)]
struct Parameters {
    tau: String,
    rail: String,
    kp: Option<f64>,
    cp: Option<f64>,
    ms: Option<f64>,
    kb: Option<f64>,
    cb: Option<f64>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Value {
    Real(f64),
    Complex([f64; 2]),
}

impl From<Value> for Complex64 {
    fn from(value: Value) -> Self {
        match value {
            Value::Real(re) => re.into(),
            Value::Complex([re, im]) => Self::new(re, im),
        }
    }
}

impl Parameters {
    fn case(&self) -> Case {
        let mut overrides = vec![format!("contact.tractive_ratio={}", self.tau)];
        match self.rail.as_str() {
            "free" => {}
            "moving" => overrides.push("track.model=moving-beam".to_owned()),
            _ => {
                // Values of the reference are per metre, those of a case per support: spacing 1 m.
                overrides.push("track.model=two-layer".to_owned());
                overrides.push("track.support_spacing=1".to_owned());
                for (key, value) in [
                    ("pad.stiffness", self.kp),
                    ("pad.damping", self.cp),
                    ("sleeper.mass", self.ms),
                    ("ballast.stiffness", self.kb),
                    ("ballast.damping", self.cb),
                ] {
                    let value = value.expect("a two-layer point gives its track");
                    overrides.push(format!("track.{key}={value:e}"));
                }
            }
        }
        let overrides: Vec<&str> = overrides.iter().map(String::as_str).collect();
        nominal(&overrides)
    }
}

/// Every quantity of the loop under the name it has in the reference.
fn computed(case: &Case, wavelength: f64, speed: f64) -> BTreeMap<&'static str, Complex64> {
    let state = case.feedback.at(wavelength, speed);
    let quantities = PointQuantity::ALL.into_iter();
    quantities.filter_map(|quantity| Some((quantity.key(), quantity.number(case, &state)?))).collect()
}

pub(crate) fn reference_points() -> Row {
    let reference: Reference =
        serde_json::from_str(include_str!("../reference/points.json")).expect("the reference file is valid JSON");
    let mut error = WorstError::default();
    let points = reference.points.len();
    for point in reference.points {
        let case = point.case.case();
        let computed = computed(&case, point.wavelength_m, point.speed_m_per_s);
        for (name, value) in point.expect {
            let expected = Complex64::from(value);
            let got = computed.get(name.as_str()).copied().unwrap_or(Complex64::from(f64::NAN));
            error.compare(got, expected);
        }
    }
    Row {
        statement: "Every quantity of the loop at 28 points",
        source: "40-digit arithmetic, `points.json`",
        expected: format!("{points} points, {} values", error.compared),
        got: error.describe(1e-10),
        tolerance: "1e-10: rounding of some hundred operations, amplified by the cube roots near full slip",
        holds: error.within(1e-10) && error.compared == 28 * 21,
    }
}

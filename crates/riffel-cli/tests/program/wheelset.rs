//! Wheelsets and receptances along all axes, from the command line to the files.

use serde_json::Value;

use crate::sandbox::Sandbox;

const CASE: &str = "cases/curve.toml";

fn complex(value: &Value) -> [f64; 2] {
    serde_json::from_value(value.clone()).unwrap()
}

/// Natural frequencies have names, the receptances are those of the wheel in the matrix of the contact under study, and
/// without a folder nothing is written.
#[test]
fn wheelset_and_matrix_hold_the_same() {
    let sandbox = Sandbox::new();
    let listed = "--frequencies 80,\"0.25 kHz\",900 --json";
    let wheelset = sandbox.json(&format!("wheelset {CASE} {listed}"));
    let matrix = sandbox.json(&format!("receptance {CASE} --matrix {listed}"));
    assert_eq!(sandbox.list("."), ["cases"]);
    for document in [&wheelset, &matrix] {
        let frequencies: Vec<f64> = serde_json::from_value(document["frequency_hz"].clone()).unwrap();
        assert_eq!(frequencies, [80.0, 250.0, 900.0]);
    }
    let first = &wheelset["natural_frequencies"][0];
    assert_eq!(first["name"], "first torsion");
    assert!((first["frequency_hz"].as_f64().unwrap() - 78.57).abs() < 0.01);
    for index in 0..3 {
        // The right wheel is the one under study.
        let both = &wheelset["receptance_m_per_n"][index];
        let one = &matrix["wheel_receptance_matrix_m_per_n"][index];
        let rail = &matrix["track_receptance_matrix_m_per_n"][index];
        for row in 0..3 {
            for column in 0..3 {
                assert_eq!(complex(&both[3 + row][3 + column]), complex(&one[row][column]));
                assert_eq!(complex(&rail[row][column]), complex(&rail[column][row]));
            }
            assert!(complex(&rail[row][row])[1] < 0.0);
        }
    }
}

/// The growth of a case on all axes reaches map and point alike, with the contacts of both rails.
#[test]
fn a_point_of_the_curve_is_that_of_its_map() {
    let sandbox = Sandbox::new();
    let window = "--set map.wavelength.points=5 --set map.speed.points=3";
    let written = sandbox.riffel(&format!("map {CASE} {window} -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    assert!(written.text.contains("the loop is unstable at"), "{}", written.text);
    let table = std::fs::read_to_string(sandbox.path("out/map.csv")).unwrap();
    let row: Vec<f64> = table.lines().nth(1).unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    let point = sandbox.json(&format!("point {CASE} --wavelength {} --speed {} --json", row[0], row[1]));
    let growth = point["growth_rate_per_passage"].as_f64().unwrap();
    assert!(row.iter().any(|value| (value / growth - 1.0).abs() < 1e-9), "{row:?} {growth}");
    let contacts = point["contacts"].as_array().unwrap();
    assert_eq!(contacts.len(), 2);
    assert_eq!((&contacts[0]["rail"], &contacts[1]["rail"]), (&"right".into(), &"left".into()));
    assert_eq!(contacts[1]["growth_rate_per_passage"], Value::Null);
    assert!(point["dq_dp"].is_null() && point["creepage"].is_null());
    let force: [f64; 2] = serde_json::from_value(point["steady_force_n"].clone()).unwrap();
    assert_eq!(force, [0.0, 0.4 * 50e3]);
}

#[test]
fn a_lone_wheel_has_no_wheelset() {
    let sandbox = Sandbox::new();
    for (arguments, words) in [
        ("wheelset cases/nominal.toml", "`wheelset` is missing"),
        (
            "receptance cases/nominal.toml --matrix --set wheel.rotation=constant-tangential-force",
            "a wheel without inertia",
        ),
        ("wheelset cases/curve.toml --frequencies 80,-1", "--frequencies"),
    ] {
        let refused = sandbox.riffel(arguments);
        assert_eq!(refused.status, Some(2), "{}", refused.text);
        assert!(refused.text.contains(words), "{}", refused.text);
        assert_eq!(sandbox.list("."), ["cases"]);
    }
}

/// The receptances that the program writes of a wheelset are a measured wheelset, of which it writes the same again; outside
/// their frequencies nothing is asked of it.
#[test]
fn a_written_wheelset_is_read_as_measured() {
    let sandbox = Sandbox::new();
    let listed = "--frequencies 50,80,120,200,350,600,900";
    let case = "wheelset cases/wheelset-coach.toml";
    assert_eq!(sandbox.riffel(&format!("{case} {listed} -o out")).status, Some(0));
    std::fs::rename(sandbox.path("out/receptance.csv"), sandbox.path("cases/coach.csv")).unwrap();
    let measured = format!("{case} --set wheelset.model=measured --set wheelset.file=coach.csv");
    let [from_model, from_file] = [case, &measured].map(|command| sandbox.json(&format!("{command} {listed} --json")));
    let entries = |document: &Value| -> Vec<f64> {
        let rows: Vec<[[[f64; 2]; 6]; 6]> = serde_json::from_value(document["receptance_m_per_n"].clone()).unwrap();
        rows.as_flattened().as_flattened().as_flattened().to_vec()
    };
    for (got, expected) in entries(&from_file).iter().zip(entries(&from_model)) {
        // Between lines it would be a mean; at a line, of one of its neighbours with a weight of rounding.
        assert!((got - expected).abs() <= 1e-9 * expected.abs().max(1e-9), "{got:e} {expected:e}");
    }
    assert_eq!(from_file["natural_frequencies"].as_array().unwrap().len(), 0);
    let text = sandbox.riffel(&format!("{measured} -o out")).text;
    assert!(text.contains("its natural frequencies are the peaks of its receptances"), "{text}");
    let refused = sandbox.riffel(&format!("{measured} --frequencies 40"));
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    assert!(refused.text.contains("is known from 50.0000 to"), "{}", refused.text);
}

//! Damage beside wear, from the command line to the files.

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

const FLOW: &str = "--set \"damage.laws=[\\\"wear\\\", \\\"flow\\\"]\" --set damage.flow.depth=1e-9 --set damage.shear_yield=230e6";

fn sum(values: &Value) -> f64 {
    let values = values.as_object().unwrap().values();
    values.map(|value| value.as_f64().unwrap()).sum()
}

/// A point tells every law and their sum, and a forecast and a passage say what they make of them.
#[test]
fn a_point_tells_the_laws() {
    let sandbox = Sandbox::new();
    let point = format!("point cases/metro.toml --wavelength 0.2 --speed 14 --json {FLOW}");
    let document = sandbox.json(&point);
    let damage = &document["damage"];
    let told = number(&document["growth_rate_per_passage"]);
    assert!((sum(&damage["growth_by_law"]) - told).abs() < 1e-12 * told.abs());
    assert!(number(&damage["demand"]) > 0.5);
    let plain = sandbox.json("point cases/metro.toml --wavelength 0.2 --speed 14 --json");
    assert!(plain.get("damage").is_none());
    let named = sandbox
        .json("point cases/metro.toml --wavelength 0.2 --speed 14 --json --set wear.law=usfd");
    assert!(named["damage"]["growth_by_law"]["wear"].is_number());
}

/// The map of shakedown, its orbit and its files.
#[test]
fn shakedown_follows_a_wave() {
    let sandbox = Sandbox::new();
    let document = sandbox.json("shakedown cases/metro.toml --utilised-friction 0,0.3,0.5 --json");
    let map = document["map"].as_array().unwrap();
    assert!((number(&map[0]["line"]) - 4.0).abs() < 1e-9 && map[0]["surface"].is_null());
    assert!((number(&map[2]["line"]) - 2.0).abs() < 1e-9);
    let wave = "shakedown cases/metro.toml --wavelength 0.2 --speed 14 --amplitude \"20 um\"";
    let document = sandbox.json(&format!("{wave} --utilised-friction 0.1 --json"));
    let along = document["loop"].as_array().unwrap();
    assert_eq!(along.len(), 36);
    assert!((number(&along[0]["profile_m"]) - 20e-6).abs() < 1e-18);
    let outcome = sandbox.riffel(&format!("{wave} -o out"));
    assert!(
        outcome.text.contains("the demand is largest"),
        "{}",
        outcome.text
    );
}

/// Stress under the contact: the axis of a point that was asked for, and the maxima of both tractions.
#[test]
fn stress_under_the_contact() {
    let sandbox = Sandbox::new();
    let document = sandbox.json(
        "contact cases/metro.toml --stress --stress-at=-0.8,0,0.1 --stress-at=0,0,0.5 --json",
    );
    let stress = &document["stress"];
    assert_eq!(stress["maxima"].as_array().unwrap().len(), 8);
    let points = stress["points"].as_array().unwrap();
    assert_eq!(number(&points[0]["x_over_a"]), -0.8);
    assert!(number(&points[1]["normal_over_p0"][2]) < -0.5);
}

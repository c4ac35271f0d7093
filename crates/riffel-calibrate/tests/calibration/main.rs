//! Calibration against a second implementation and closed forms.

mod columns;
mod decision;
mod drawn;
mod fixtures;
mod likelihood;
mod posterior;
mod profiles;
mod refusals;
mod results;
mod usual;
mod wear;

use fixtures::{copy_set, folder};
use riffel_calibrate::Plan;
use serde_json::Value;

const SETS: [&str; 3] = ["a-hammer-and-decay", "b-three-dates", "c-all-together"];

fn plan(set: &str) -> Plan {
    Plan::read(&folder(set).join("plan.toml")).unwrap()
}

fn json(set: &str, file: &str) -> Value {
    let text = std::fs::read_to_string(folder(set).join(file)).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// Values of the parameters of a plan by the short names of the second implementation.
fn values(plan: &Plan, short: &Value) -> Vec<f64> {
    let names = plan.posterior.parameters().iter();
    names
        .map(|parameter| {
            let key = SHORT.iter().find(|(_, name)| *name == parameter.name).unwrap().0;
            short[key].as_f64().unwrap()
        })
        .collect()
}

const SHORT: [(&str, &str); 16] = [
    ("kp", "track.pad.stiffness"),
    ("ep", "track.pad.loss_factor"),
    ("kb", "track.ballast.stiffness"),
    ("eb", "track.ballast.loss_factor"),
    ("er", "rail.loss_factor"),
    ("mw", "wheel.mass"),
    ("tau", "vehicle.tractive_ratio"),
    ("share", "vehicle.traction_share"),
    ("Vm", "vehicle.speed.mean"),
    ("Vs", "vehicle.speed.standard_deviation"),
    ("kw", "wear.coefficient"),
    ("pre", "preload_stiffening"),
    ("sH", "hammer.discrepancy"),
    ("sD", "decay.discrepancy"),
    ("sG", "growth.discrepancy"),
    ("sA", "axle-box.discrepancy"),
];

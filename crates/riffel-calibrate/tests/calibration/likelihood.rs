//! The likelihood at points, its gradient, and what leaves it alone.

use crate::{SETS, json, plan, values};

/// ln likelihood by kind of data, normalised in full, and what the model says, at three points of each set. The forward models
/// agree to 1e-9 and the likelihood adds rounding: 1e-6 of a ln likelihood down to −9416.
#[test]
fn likelihoods_are_those_of_the_second_implementation() {
    for set in SETS {
        let plan = plan(set);
        let points = json(set, "likelihood_points.json");
        for point in points["points"].as_array().unwrap() {
            let values = values(&plan, &point["values"]);
            let parts = plan.posterior.log_likelihood(&values).unwrap();
            for (name, found) in &parts {
                let key = match &**name {
                    "hammer" | "decay" => name,
                    _ => "levels",
                };
                let expected = point["log_likelihood"][key].as_f64().unwrap();
                let error = (found - expected).abs();
                assert!(error < 1e-6, "{set} {name}: {found}, not {expected}");
            }
            assert_eq!(parts.len(), point["log_likelihood"].as_object().unwrap().len());
        }
    }
}

/// Differences of the density over 1e-4 in z are the gradient, to their error of second order; where decay rates have a part, to
/// that of few frequencies.
#[test]
fn gradients_are_those_of_differences() {
    for set in SETS {
        let plan = plan(set);
        let points = json(set, "likelihood_points.json");
        let values = values(&plan, &points["points"][1]["values"]);
        let place = plan.posterior.place(&values);
        let point = plan.posterior.at(&place).unwrap();
        for index in 0..place.len() {
            const STEP: f64 = 1e-4;
            let moved = |sign: f64| {
                let mut place = place.clone();
                place[index] += sign * STEP;
                plan.posterior.log_density(&place).unwrap()
            };
            let difference = (moved(1.0) - moved(-1.0)) / (2.0 * STEP);
            let error = (difference - point.gradient[index]).abs();
            let name = &plan.posterior.parameters()[index].name;
            // Slopes of decay rates are those of a quarter of their frequencies, 3 % off at most here.
            let data = plan.posterior.data_of(name);
            let is_size = name.ends_with(".discrepancy");
            let coarse = !is_size && data.iter().any(|data| data.contains("decay"));
            let share = if coarse { 0.05 } else { 1e-4 };
            assert!(error < 1e-3 + share * difference.abs(), "{set} {name}: {difference} {error}");
        }
    }
}

/// Decay rates to 1e-9, levels over the first date and those of the axle box to 1e-9 dB.
#[test]
fn predictions_are_those_of_the_second_implementation() {
    let numbers = |value: &serde_json::Value| -> Vec<f64> {
        let list = value.as_array().unwrap().iter();
        list.map(|number| number.as_f64().unwrap()).collect()
    };
    for set in SETS {
        let plan = plan(set);
        let points = json(set, "likelihood_points.json");
        for point in points["points"].as_array().unwrap() {
            let values = values(&plan, &point["values"]);
            let predicted = plan.posterior.predictions(&values).unwrap();
            if point["decay_rate_db_per_m_16_lines"].is_array() {
                let expected = numbers(&point["decay_rate_db_per_m_16_lines"]);
                for (found, expected) in predicted[1].iter().zip(expected) {
                    assert!((found - expected.ln()).abs() < 1e-9, "{set}: {found}");
                }
            }
            if point["level_change_db"].is_array() {
                // Bands of the second implementation fall from date to date; those of a contrast follow the file.
                let dates = point["level_change_db"].as_array().unwrap()[1..].iter();
                let mut expected: Vec<f64> = dates.flat_map(numbers).collect();
                let levels = &point["axle_box_db_re_1_m_per_s2_for_0_db_first_level"];
                if levels.is_array() {
                    expected.extend(numbers(levels));
                }
                let found = predicted.last().unwrap();
                assert_eq!(found.len(), expected.len());
                for (found, expected) in found.iter().zip(expected) {
                    assert!((found - expected).abs() < 1e-9, "{set}: {found}, not {expected}");
                }
            }
        }
    }
}

/// Growth holds only k_w · share, and at given τ only k_w μ²: the likelihood stays the same to rounding.
#[test]
fn what_growth_cannot_tell_leaves_the_likelihood_alone() {
    let plan = plan("b-three-dates");
    let points = json("b-three-dates", "likelihood_points.json");
    let values = values(&plan, &points["points"][0]["values"]);
    let parameters = plan.posterior.parameters();
    let place = |name: &str| parameters.iter().position(|it| it.name == name).unwrap();
    let (wear, share) = (place("wear.coefficient"), place("vehicle.traction_share"));
    let here = plan.posterior.log_likelihood(&values).unwrap();
    for factor in [0.6, 1.7] {
        let mut moved = values.clone();
        moved[wear] *= factor;
        moved[share] /= factor;
        let there = plan.posterior.log_likelihood(&moved).unwrap();
        assert!((there[0].1 - here[0].1).abs() < 1e-10, "{there:?} {here:?}");
    }
    // Friction is no parameter of the set: two cases.
    let text = std::fs::read_to_string(crate::folder("b-three-dates").join("plan.toml")).unwrap();
    let with_friction = |friction: f64| {
        let copy = tempfile::tempdir().unwrap();
        crate::copy_set("b-three-dates", copy.path());
        let set = format!("case = \"case.toml\"\nset = {{ \"contact.friction\" = {friction} }}");
        let text = text.replacen("case = \"case.toml\"", &set, 1);
        std::fs::write(copy.path().join("plan.toml"), text).unwrap();
        riffel_calibrate::Plan::read(&copy.path().join("plan.toml")).unwrap()
    };
    let factor = 1.3;
    let rough = with_friction(0.35 * factor);
    let mut moved = values.clone();
    moved[wear] /= factor * factor;
    let there = rough.posterior.log_likelihood(&moved).unwrap();
    assert!((there[0].1 - here[0].1).abs() < 1e-10, "{there:?} {here:?}");
}

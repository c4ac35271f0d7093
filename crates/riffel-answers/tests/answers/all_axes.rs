//! What the answers tell of a loop on all axes: whether it oscillates by itself, and how its rail moves across the track.

use riffel_answers::map::MapAnswer;
use riffel_answers::point::{PointAnswer, PointRequest};
use riffel_answers::receptance::{ReceptanceAnswer, ReceptanceRequest};
use riffel_case::{Case, NOMINAL_CASE};
use serde_json::{Value, json};

use crate::case;

const CURVE: &str = include_str!("../../../../cases/curve.toml");

fn point(case: &Case, speed: f64) -> Value {
    let request = PointRequest { wavelength: 0.05, speed, sensitivity: false, neighbours: None, irregular: None };
    serde_json::to_value(PointAnswer::new(case, request).unwrap()).unwrap()
}

/// The note of the curve in the book, as data; stable at a quarter of the friction, and not a question for one wheel and one axis.
#[test]
fn stability_is_told_as_data() {
    let curve = case(CURVE, &[]);
    let squeals = &point(&curve, 5.0)["stability"];
    assert!(squeals["unstable_roots"].as_u64() >= Some(2), "{squeals}");
    let frequency = squeals["frequency_hz"].as_f64().unwrap();
    // Where the phase crosses the axis, 79 Hz, is 3 % below the root.
    assert!((frequency - 80.8).abs() < 0.3, "{frequency}");
    let growth = squeals["growth_rate_per_s"].as_f64().unwrap();
    assert!(growth > 0.0 && growth < frequency, "{growth}");
    let calm = case(CURVE, &["contact.friction=0.1", "map.speed.points=5", "map.wavelength.points=9"]);
    let stable = json!({ "unstable_roots": 0, "frequency_hz": null, "growth_rate_per_s": null });
    assert_eq!(point(&calm, 5.0)["stability"], stable);
    let answer = MapAnswer::new(&calm, |_| ());
    let map = serde_json::to_value(answer).unwrap();
    let judged = |speed: f64| json!({ "speed_m_per_s": speed, "unstable_roots": 0, "frequency_hz": null, "growth_rate_per_s": null });
    assert_eq!(map["stability"], json!([judged(5.0), judged(10.0), judged(15.0)]));
    let nominal = case(NOMINAL_CASE, &[]);
    assert_eq!(point(&nominal, 5.0).get("stability"), None);
}

/// UIC60 of the book: the lateral motion cuts on at 102.3 Hz, the roll at 302.4 Hz; on discrete supports with the pinned-pinned
/// mode, here of 0.6 m.
#[test]
fn motion_across_the_track_is_named() {
    let uic60 = ["steel.youngs_modulus=210 GPa", "rail.centroid_height=33 mm"];
    let named = |text: &str, overrides: &[&str]| {
        let case = case(text, overrides);
        let request =
            ReceptanceRequest { direction: riffel::Direction::Vertical, speed: 10.0, frequencies: vec![100.0] };
        let answer = ReceptanceAnswer::new(&case, request).unwrap();
        let document = serde_json::to_value(answer).unwrap();
        let named = document["lateral_resonances"].as_array().cloned();
        let of = |named: &Value| {
            let frequency = named["frequency_hz"].as_f64().unwrap();
            (named["resonance"].as_str().unwrap().to_owned(), (10.0 * frequency).round() / 10.0)
        };
        named.unwrap_or_default().iter().map(of).collect::<Vec<_>>()
    };
    let of = |names: &[(&str, f64)]| -> Vec<(String, f64)> {
        names.iter().map(|&(name, frequency)| (name.to_owned(), frequency)).collect()
    };
    let cut_ons = [("lateral cut-on", 102.3), ("roll cut-on", 302.4)];
    assert_eq!(named(CURVE, &uic60), of(&cut_ons));
    let discrete = [&uic60[..], &["track.model=one-layer-periodic"]].concat();
    let pinned = [cut_ons[0], cut_ons[1], ("lateral pinned-pinned", 555.0)];
    assert_eq!(named(CURVE, &discrete), of(&pinned));
    assert_eq!(named(NOMINAL_CASE, &[]), []);
}

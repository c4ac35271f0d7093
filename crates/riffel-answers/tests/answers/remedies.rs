//! Remedies: each is what the same change of the case does, and the ranking follows.

use riffel_answers::remedies::{RemediesAnswer, Remedy};
use riffel_answers::{Answer, LineGrowth};
use riffel_case::traffic::Traffic;
use riffel_case::{Case, METRO_CASE, METRO_CURVE_CASE, NOMINAL_CASE};
use serde_json::Value;

use crate::coarse;

const TRAFFIC: &str = "line.passages_per_day = 4000\n[[vehicle]]\nname = \"v\"\nshare = 1\nspeed = { mean = 15, standard_deviation = 2 }\n";

fn remedies(case: &Case, traffic: &Traffic) -> RemediesAnswer {
    RemediesAnswer::new(case, Some(traffic), &|_| ()).unwrap()
}

fn rate(case: &Case, traffic: &Traffic) -> f64 {
    let growth = LineGrowth::new(case, Some(traffic)).unwrap();
    growth.fastest.unwrap().growth_rate_per_passage
}

/// The remedy that begins with a key, and that key's value.
fn of<'a>(answer: &'a RemediesAnswer, key: &str, value: f64) -> &'a Remedy {
    let changes = |remedy: &Remedy| serde_json::to_value(&remedy.changes).unwrap();
    let found = answer.remedies.iter().find(|remedy| {
        let first: &Value = &changes(remedy)[0];
        first["key"] == key && (first["value"].as_f64().unwrap() / value - 1.0).abs() < 1e-9
    });
    found.unwrap()
}

/// On the slab of the metro pads decide: half of 60 MN/m does more than all else, as every change computed by itself says.
// Long: computes all remedies of a track on discrete fastenings, and five of them by hand.
#[test]
fn where_pads_decide_pads_lead() {
    let traffic = Traffic::parse("t", TRAFFIC).unwrap();
    let own = coarse(METRO_CASE, &[]);
    let before = rate(&own, &traffic);
    let answer = remedies(&own, &traffic);
    let mut direct = Vec::new();
    for (key, value, overrides) in [
        ("track.pad.stiffness", 30e6, &["track.pad.stiffness=30 MN/m"][..]),
        ("track.pad.stiffness", 120e6, &["track.pad.stiffness=120 MN/m"]),
        ("rail.loss_factor", 0.12, &["rail.loss_factor=0.12"]),
        // The force stays: 0.3 · 0.35/0.25.
        ("contact.friction", 0.25, &["contact.friction=0.25", "contact.tractive_ratio=0.42"]),
        ("wheel.mass", 0.8 * 769.5, &["wheel.mass=615.6 kg"]),
    ] {
        let change = rate(&coarse(METRO_CASE, overrides), &traffic) / before - 1.0;
        let ranked = of(&answer, key, value).change_of_fastest_growth;
        assert!((ranked - change).abs() < 1e-9, "{key}: {ranked} {change}");
        direct.push(change);
    }
    assert!(direct.iter().all(|change| *change >= direct[0]) && direct[0] < -0.3);
    // A file has the rate of 10⁻⁷ with all its digits.
    let mut file = Vec::new();
    answer.tables()[0].csv(&mut file).unwrap();
    let file = String::from_utf8(file).unwrap();
    let first = file.lines().nth(1).unwrap().rsplit(',').next().unwrap();
    let written: f64 = first.parse().unwrap();
    assert!((written / (before * (1.0 + direct[0])) - 1.0).abs() < 1e-9, "{file}");
    assert_eq!(answer.remedies[0].changes.len(), 1);
    assert_eq!(answer.remedies[0].change_of_fastest_growth, direct[0]);
    let changes = answer.remedies.iter().map(|it| it.change_of_fastest_growth);
    assert!(changes.clone().zip(changes.skip(1)).all(|(one, next)| one <= next));
    let words = answer.helps_most().unwrap().to_string();
    assert!(words.starts_with("what helps most is pads of half the stiffness: growth falls by"), "{words}");
}

/// Trains at four fifths of their speeds, and speeds spread one and a half times as widely, are that traffic.
// Long: computes the remedies of two traffics.
#[test]
fn speeds_are_changed_as_a_traffic_file_would() {
    let traffic = |mean: f64, deviation: f64| {
        let speed = format!("{{ mean = {mean}, standard_deviation = {deviation} }}");
        let text = TRAFFIC.replace("{ mean = 15, standard_deviation = 2 }", &speed);
        Traffic::parse("t", &text).unwrap()
    };
    let own = coarse(METRO_CASE, &[]);
    let before = traffic(15.0, 2.0);
    let answer = remedies(&own, &before);
    for (key, value, after) in
        [("speed.factor", 0.8, traffic(12.0, 1.6)), ("speed.standard_deviation", 3.0, traffic(15.0, 3.0))]
    {
        let change = rate(&own, &after) / rate(&own, &before) - 1.0;
        let ranked = of(&answer, key, value).change_of_fastest_growth;
        assert!((ranked - change).abs() < 1e-9, "{key}: {ranked} {change}");
    }
}

/// "A fifth less" is of what the vehicles have, not of the case; where they differ there is no one value.
// Long: computes all remedies of five traffics.
#[test]
fn remedies_change_what_the_vehicles_have() {
    // A free beam: what is asked of the vehicles does not hang on the track.
    let own = coarse(NOMINAL_CASE, &[]);
    let traffic = |masses: [f64; 2], deviations: [f64; 2], friction: f64| {
        let vehicle = |(index, (mass, deviation)): (usize, (f64, f64))| {
            format!(
                "[[vehicle]]\nname = \"{index}\"\nshare = 0.5\nwheel_mass = {mass}\nset = {{ contact.friction = {friction} }}\n\
                 speed = {{ mean = 30{} }}\n",
                if deviation > 0.0 { format!(", standard_deviation = {deviation}") } else { String::new() }
            )
        };
        let vehicles = masses.into_iter().zip(deviations).enumerate();
        let vehicles: String = vehicles.map(vehicle).collect();
        Traffic::parse("t", &format!("line.passages_per_day = 4000\n{vehicles}")).unwrap()
    };
    let change = |before: &Traffic, after: &Traffic| rate(&own, after) / rate(&own, before) - 1.0;
    let light = traffic([500.0; 2], [0.0; 2], 0.35);
    let answer = remedies(&own, &light);
    let ranked = of(&answer, "wheel.mass", 400.0).change_of_fastest_growth;
    let direct = change(&light, &traffic([400.0; 2], [0.0; 2], 0.35));
    assert!((ranked - direct).abs() < 1e-9, "{ranked} {direct}");
    // Each spread by half as much again.
    let spread = traffic([500.0; 2], [1.0, 2.0], 0.35);
    let answer = remedies(&own, &spread);
    let ranked = of(&answer, "speed.standard_deviation_factor", 1.5).change_of_fastest_growth;
    let direct = change(&spread, &traffic([500.0; 2], [1.5, 3.0], 0.35));
    assert!((ranked - direct).abs() < 1e-9, "{ranked} {direct}");
    let reasons = |case: &Case, traffic: &Traffic| {
        let left_out = remedies(case, traffic).left_out.into_iter();
        let reasons = left_out.map(|it| format!("{}: {}", it.title, it.reason));
        reasons.collect::<Vec<_>>().join("\n")
    };
    let mixed = reasons(&own, &traffic([500.0, 700.0], [0.0; 2], 0.35));
    assert!(mixed.contains("wheel.mass differs between the vehicles"), "{mixed}");
    let spread = TRAFFIC.to_owned()
        + "spread = { track.pad.stiffness = { mean = \"60 MN/m\", standard_deviation = \"5 MN/m\" } }\n";
    let pads = reasons(&coarse(METRO_CASE, &[]), &Traffic::parse("t", &spread).unwrap());
    assert!(pads.contains("track.pad.stiffness differs between the vehicles, or is spread"), "{pads}");
    let slippery = reasons(&own, &traffic([500.0; 2], [0.0; 2], 0.15));
    assert!(slippery.contains("friction is 0.15 already"), "{slippery}");
}

/// What a case has no number for is left out with the reason; a curve that sets the creepage leaves it to friction.
// Long: computes all remedies of five cases.
#[test]
fn what_a_case_has_no_key_for_is_left_out() {
    let traffic = Traffic::parse("t", &TRAFFIC.replace("mean = 15", "mean = 30")).unwrap();
    let left_out = |case: &Case, traffic: &Traffic| {
        let reasons = remedies(case, traffic).left_out.into_iter();
        let reasons = reasons.map(|it| format!("{}: {}", it.title, it.reason));
        reasons.collect::<Vec<_>>().join("\n")
    };
    let free = left_out(&coarse(NOMINAL_CASE, &[]), &traffic);
    assert!(free.contains("pads of half the stiffness: the case has no value of track.pad.stiffness"), "{free}");
    assert!(
        free.contains("grinding interval: grinding lowers the level and leaves growth as it is, 6 dB in"),
        "{free}"
    );
    assert!(!free.contains("friction"), "{free}");
    let slippery = coarse(NOMINAL_CASE, &["contact.friction=0.2"]);
    assert!(left_out(&slippery, &traffic).contains("friction is 0.2 already"));
    let wide = TRAFFIC.replace("mean = 15", "mean = 30").replace("deviation = 2", "deviation = 7.2");
    let wide = Traffic::parse("t", &wide).unwrap();
    assert!(left_out(&coarse(NOMINAL_CASE, &[]), &wide).contains("about as widely"));
    let calm = coarse(NOMINAL_CASE, &["map.wavelength.max=30 mm"]);
    let answer = remedies(&calm, &traffic);
    assert!(answer.remedies.is_empty() && answer.helps_most().is_none());
    let curve = coarse(METRO_CURVE_CASE, &["contact.creep_law=polach"]);
    let curve = RemediesAnswer::new(&curve, None, &|_| ()).unwrap();
    assert_eq!(of(&curve, "contact.friction", 0.25).changes.len(), 1);
}

/// A remedy twenty times slower than growth as it is would be told in years: all stand in the unit of the case as it is.
// Long: computes all remedies of a track on discrete fastenings for three coefficients.
#[test]
fn times_stand_in_one_unit() {
    let traffic = Traffic::parse("t", TRAFFIC).unwrap();
    for coefficient in ["2.5e-9 kg/J", "5e-10 kg/J", "5e-11 kg/J"] {
        let own = coarse(METRO_CASE, &[&format!("wear.coefficient={coefficient}")]);
        let answer = remedies(&own, &traffic);
        let unit = |text: String| text.rsplit(' ').next().unwrap().to_owned();
        let before = unit(answer.under_traffic.fastest.unwrap().time().to_string());
        let grows = answer.remedies.iter().filter(|it| it.fastest.is_some());
        let others: Vec<String> = grows.map(|it| unit(it.doubles_in.to_string())).collect();
        assert!(others.iter().all(|it| *it == before), "{before}: {others:?}");
    }
}

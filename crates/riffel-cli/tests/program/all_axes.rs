//! A wheelset in a curve through the commands that were made for a wheel alone.

use std::fs;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

const CASE: &str = "cases/curve.toml";
const TRAFFIC: &str = "[line]\npassages_per_day = 2000\n[[vehicle]]\nname = \"metro\"\nshare = 1\n\
                       speed = { mean = \"30 km/h\" }\n";

fn sandbox(files: &[(&str, &str)]) -> Sandbox {
    let sandbox = Sandbox::new();
    for (name, text) in files {
        fs::write(sandbox.path(name), text).unwrap();
    }
    sandbox
}

fn rates(document: &Value) -> Vec<f64> {
    let rates = document["growth_rate_per_passage"].as_array().unwrap();
    let rate = |wave: &Value| number(&wave["growth_rate_per_passage"]);
    rates.iter().map(rate).collect()
}

/// The traffic runs on the wheelset of the case or brings another; what full sliding cannot take is said in a sentence.
#[test]
fn a_curve_is_forecast() {
    let rigid = "[vehicle.set.wheelset]\nmodel = \"rigid\"\nmass = 1200\nroll_inertia = 620\nspin_inertia = 55\n";
    let attack = "creepage = { lateral = \"0.3 %\", longitudinal = \"0.1 %\" }\n[vehicle.set]\ncontact.creep_law = \"fastsim\"\n";
    let sandbox = sandbox(&[
        ("own.toml", TRAFFIC),
        ("rigid.toml", &format!("{TRAFFIC}{rigid}")),
        ("attack.toml", &format!("{TRAFFIC}{attack}")),
        ("ratio.toml", &format!("{TRAFFIC}tractive_ratio = 0.3\n")),
    ]);
    let forecast =
        |traffic: &str| rates(&sandbox.json(&format!("forecast {CASE} --traffic {traffic} --from-limit=-6dB --json")));
    let own = forecast("own.toml");
    assert_eq!(own.len(), 11);
    for other in ["rigid.toml", "attack.toml"] {
        for (a, b) in own.iter().zip(forecast(other)) {
            assert!(b.is_finite() && (a / b - 1.0).abs() > 1e-3, "{other}: {a} {b}");
        }
    }
    let refused = sandbox.riffel(&format!("forecast {CASE} --traffic ratio.toml --from-limit=-6dB"));
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    let words = "is no mean state of a law of full sliding, whose force is friction times load: give a creepage";
    assert!(refused.sentence().contains(words), "{}", refused.text);
}

/// Keys of the wheelset and components of the creepage vary as any others: the mean of two samples is that of two points.
#[test]
fn a_wheelset_is_studied() {
    let plan = format!(
        "case = \"{CASE}\"\ndesign = {{ method = \"grid\" }}\n\
         [[parameter]]\nkey = \"wheelset.axle.diameter\"\nvalues = [\"150 mm\", \"170 mm\"]\n\
         [[parameter]]\nkey = \"contact.creepage.longitudinal\"\nvalues = [\"0.8 %\"]\n\
         [[outputs.point]]\nname = \"p\"\nwavelength = \"60 mm\"\nspeed = \"10 m/s\"\n\
         quantities = [\"growth_rate_per_passage\"]\n"
    );
    let sandbox = sandbox(&[("plan.toml", &plan)]);
    let outcome = sandbox.riffel("study plan.toml -o results");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let row = outcome.text.lines().find_map(|line| line.trim().strip_prefix("p_growth_rate_per_passage"));
    let mean: f64 =
        row.and_then(|row| row.split_whitespace().next()?.parse().ok()).unwrap_or_else(|| panic!("{}", outcome.text));
    let [thin, thick] = [150, 170].map(|diameter| {
        let point = sandbox.json(&format!(
            "point {CASE} --wavelength 0.06 --speed 10 --json --set 'wheelset.axle.diameter={diameter} mm' \
             --set 'contact.creepage.longitudinal=0.8 %'"
        ));
        number(&point["growth_rate_per_passage"])
    });
    assert!((thin / thick - 1.0).abs() > 0.01, "{thin} {thick}");
    // Four digits are printed.
    let expected = 0.5 * (thin + thick);
    assert!((mean / expected - 1.0).abs() < 1e-3, "{mean} {expected}");
}

/// Variants of the wheelset and of the creepage; a force along the rail cannot be held where the wheel slides across it.
// Long: maps four flexible wheelsets.
#[test]
fn variants_of_a_wheelset_are_compared() {
    let sandbox = sandbox(&[
        ("axle.toml", "title = \"thin axle\"\nwheelset.axle.diameter = \"130 mm\"\n"),
        ("attack.toml", "title = \"attack\"\ncontact.creepage = { lateral = \"0.8 %\" }\n"),
        ("friction.toml", "title = \"friction\"\ncontact.friction = 0.2\n"),
    ]);
    let variants = "--with axle.toml --with attack.toml --with friction.toml";
    let outcome = sandbox
        .riffel(&format!("compare {CASE} {variants} --set map.wavelength.points=21 --set map.speed.points=5 -o out"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let text = fs::read_to_string(sandbox.path("out/growth.csv")).unwrap();
    assert!(!text.contains("NaN"), "{text}");
    let last: Vec<&str> = text.lines().last().unwrap().split(',').collect();
    let values: Vec<&str> = last[1..].to_vec();
    for (index, value) in values.iter().enumerate() {
        assert!(!values[..index].contains(value), "{last:?}");
    }
    let refused = sandbox.riffel(&format!("compare {CASE} --with friction.toml --hold force -o again"));
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    assert!(refused.sentence().contains("choose --hold creepage"), "{}", refused.text);
}

/// A report of the case alone, in numbers.
#[test]
fn a_wheelset_is_reported() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.riffel(&format!("report {CASE} -o report.html"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let page = fs::read_to_string(sandbox.path("report.html")).unwrap();
    let words = page.split("<script").next().unwrap();
    for expected in ["Leading wheelset in a curve", "flexible", "(0.000, 1.700) %"] {
        assert!(words.contains(expected), "{expected}");
    }
    assert!(!words.contains("NaN"));
}

/// A long train has as many equations as it needs, and each wheel a growth rate.
// Long: solves the equations of 36 wheels for all that a point tells.
#[test]
fn a_long_train_has_an_answer() {
    let places: Vec<String> = (0..36).map(|wheel| format!("{}", 2.5 * f64::from(wheel))).collect();
    let point = Sandbox::new().json(&format!(
        "point cases/nominal.toml --wavelength 0.05 --speed 20 --json --set 'train.wheels=[{}]'",
        places.join(", ")
    ));
    let contacts = point["contacts"].as_array().unwrap();
    assert_eq!(contacts.len(), 36);
    let rates = contacts.iter().map(|contact| number(&contact["growth_rate_per_passage"]));
    let mean = rates.sum::<f64>() / 36.0;
    let whole = number(&point["growth_rate_per_passage"]);
    assert!((whole / mean - 1.0).abs() < 1e-9, "{whole} {mean}");
}

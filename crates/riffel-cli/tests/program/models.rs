//! `riffel compare --models`, from the command line to the files.

use crate::sandbox::{Sandbox, number};

/// Fewer waves, of fewer octaves of the exact contact.
const FEW: &str = "--set map.wavelength.min=0.04 --set map.wavelength.max=0.06 --set map.wavelength.points=5";

/// Models that fit, and what the others need; the document is that of the folder.
// Long: computes all models that fit twice, the exact contact among them.
#[test]
fn models_stand_side_by_side() {
    let sandbox = Sandbox::new();
    let command = format!("compare cases/nominal.toml --models --speed \"30 m/s\" {FEW}");
    let written = sandbox.riffel(&format!("{command} -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    for shown in [
        "Afferrante & Ciavarella 2009",
        "not on this case: Both, Hong & Kurtze 2001: needs wheelset.suspension with a vertical_stiffness",
        "what moves it most: the one joint",
    ] {
        assert!(written.text.contains(shown), "{}", written.text);
    }
    assert_eq!(sandbox.list("out"), ["growth.csv", "models.html", "models.png", "models.svg", "summary.json"]);
    let document = sandbox.json(&format!("{command} --json"));
    let summary = std::fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(document, summary);
    let models = document["models"].as_array().unwrap();
    assert_eq!(models.len(), 13);
    let model = |name: &str| models.iter().find(|model| model["name"] == name).unwrap();
    for model in models {
        let applies = model["applies"].as_bool().unwrap();
        assert_eq!(applies, model["not_on_this_case"].is_null());
        assert_eq!(applies, model["growth_rate_per_passage"].is_array());
        assert!(model["joints"]["contact"].is_string());
    }
    // Ours is the case with the exact contact.
    let ours = model("riffel");
    assert_eq!(ours["differs_by"], serde_json::json!([]));
    // In the midst of the window, whose ends are exact.
    let wavelengths = document["wavelength_m"].as_array().unwrap();
    let middle = wavelengths.len() / 2;
    let wavelength = number(&wavelengths[middle]);
    let point = sandbox.json(&format!(
        "point cases/nominal.toml --wavelength {wavelength} --speed 30 --json {FEW} \
         --set contact.response=non-steady --set contact.creep_law=half-space"
    ));
    assert_eq!(ours["growth_rate_per_passage"][middle], point["growth_rate_per_passage"]);
    // The joint that moves growth most comes first.
    let seed = model("afferrante-ciavarella-2009");
    let changes: Vec<f64> = seed["differs_by"]
        .as_array()
        .unwrap()
        .iter()
        .map(|by| number(&by["largest_change_of_growth_rate_per_passage"]))
        .collect();
    assert!(changes.is_sorted_by(|a, b| a >= b) && changes[0] > 0.0, "{changes:?}");
    // A wheel of mass and inertia on a free beam is what the case has.
    assert!(seed["differs_by"].as_array().unwrap().iter().all(|by| by["joint"] != "track"));
}

/// On discrete supports Frederick's curves are drawn over a support and in mid-span.
#[test]
fn wear_is_drawn_in_the_complex_plane() {
    let sandbox = Sandbox::new();
    let command = format!("compare cases/discrete-supports.toml --models frederick-1987 --speed \"110 km/h\" {FEW}");
    let written = sandbox.riffel(&format!("{command} -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    assert!(sandbox.path("out/complex-plane.svg").exists());
    let document = std::fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let document: serde_json::Value = serde_json::from_str(&document).unwrap();
    let plane = &document["models"][0]["complex_plane"];
    let frequencies = plane["frequency_hz"].as_array().unwrap();
    let wear = plane["over_support_j_per_m2"].as_array().unwrap();
    assert_eq!(frequencies.len(), wear.len());
    // The point of the plane and the growth of the longest wave, which is that of the lowest frequency.
    let rate = number(&document["models"][0]["growth_rate_per_passage"][4]);
    assert_eq!(number(&wear[0][0]) < 0.0, rate > 0.0);
}

/// What cannot be compared is told in a sentence, and nothing is written.
#[test]
fn what_cannot_be_compared_is_told() {
    let sandbox = Sandbox::new();
    for (arguments, sentence) in [
        ("--models nobody", "no model has the name \"nobody\"; models: carson-johnson-1971, "),
        (
            "--models tassilly-vincent-1991",
            "tassilly-vincent-1991 is not on this case: needs a wheelset with an elastic axle",
        ),
        ("--models --with cases/soft-pads.toml", "--models cannot be used with --with"),
        ("--models --limit grassie-1999", "--models cannot be used with --limit"),
        ("--models --speed \"5000 m/s\"", "--speed is 5000 m/s"),
        ("--speed 30", "--with or --models or --remedies is missing"),
    ] {
        let outcome = sandbox.riffel(&format!("compare cases/nominal.toml {arguments} -o out"));
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        assert!(outcome.sentence().contains(sentence), "{arguments}: {}", outcome.text);
        assert!(!sandbox.path("out").exists());
    }
}

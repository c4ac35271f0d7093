//! `riffel compare`: what would change the growth.

use std::fs;

use serde_json::Value;

use super::{MEASURED, sandbox};
use crate::sandbox::{Sandbox, number};

#[test]
fn variants_are_compared() {
    let sandbox = sandbox();
    fs::write(sandbox.path("dry.toml"), "title = \"dry\"\n[contact]\nfriction = 0.6\ntractive_ratio = 0.2\n").unwrap();
    fs::write(sandbox.path("slow.toml"), "[speed]\nfactor = 0.7\n").unwrap();
    let command = "compare cases/nominal.toml --with dry.toml --with slow.toml";
    let alone = sandbox.json(&format!("{command} --speed \"108 km/h\" --json"));
    let outcomes = alone["outcomes"].as_array().unwrap();
    let titles: Vec<&str> = outcomes.iter().filter_map(|o| o["title"].as_str()).collect();
    assert_eq!(titles, ["as it is", "dry", "slow"]);
    // The ridge of the nominal case: 537 Hz, at 70 % of the speed 70 % of the wavelength.
    let wavelength = |index: usize| number(&outcomes[index]["fastest_wavelength_m"]);
    assert!((30.0 / wavelength(0) - 537.0).abs() < 15.0);
    assert!((wavelength(2) / wavelength(0) - 0.7).abs() < 0.02);
    assert!(number(&outcomes[1]["change_of_fastest_growth"]) > 0.5);
    assert_eq!(outcomes[0]["fastest_at_edge"], false);
    assert!(alone["spectrum_now"].is_null() && outcomes[0]["passages_to_limit"].is_null());
    let measured = "--where campaign=4 --traffic cases/traffic.toml -o out";
    let outcome = sandbox.riffel(&format!("{command} {MEASURED} {measured}"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let text = fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let document: Value = serde_json::from_str(&text).unwrap();
    let to_limit = |index: usize| number(&document["outcomes"][index]["passages_to_limit"]);
    assert!(to_limit(1) < to_limit(0));
    assert!(sandbox.list("out").contains(&"compare.png".to_owned()));
}

#[test]
fn what_cannot_act_is_not_given_as_no_change() {
    let sandbox = sandbox();
    let compare = "compare cases/nominal.toml --with cases/soft-pads.toml";
    let compared = sandbox.json(&format!("{compare} --json"));
    let pads = &compared["outcomes"][1];
    assert_eq!(pads["acts"], false);
    assert!(pads["change_of_fastest_growth"].is_null());
    let text = sandbox.riffel(compare).text;
    assert!(text.contains("cannot act") && !text.contains("+0 %") && !text.contains("-0 %"), "{text}");
    let sentence = "track.model = \"free-beam\" is a rail without supports";
    assert!(text.contains(sentence) && pads["no_effect"].to_string().contains("rail without supports"), "{text}");
    // The values of the case itself, and one key of two.
    fs::write(sandbox.path("same.toml"), "title = \"same\"\n[contact]\nfriction = 0.4\n").unwrap();
    fs::write(
        sandbox.path("both.toml"),
        "title = \"both\"\n[wheel]\nmass = \"300 kg\"\n[track]\npad = { stiffness = \"80 MN/m\", damping = \"9 kNs/m\" }\n",
    )
    .unwrap();
    let compare = "compare cases/nominal.toml --with same.toml --with both.toml";
    let compared = sandbox.json(&format!("{compare} --json"));
    assert_eq!(compared["outcomes"][1]["acts"], false);
    assert_eq!(compared["outcomes"][2]["acts"], true);
    assert!(compared["outcomes"][2]["change_of_fastest_growth"].is_number());
    let text = sandbox.riffel(compare).text;
    assert!(text.contains("changes nothing"), "{text}");
    assert!(text.contains("`track.pad.stiffness`") && text.contains("` have no effect, for"), "{text}");
    // On a track with pads they act.
    let pads = "compare cases/discrete-supports.toml --with cases/soft-pads.toml --json";
    let acts = sandbox.json(pads);
    assert!(acts["outcomes"][1]["acts"] == true && acts["outcomes"][1]["no_effect"].is_null());
}

/// The three mean states that less friction can leave as it was, each held against a file that gives it by number.
#[test]
fn what_friction_leaves_as_it_was_is_said() {
    let sandbox = sandbox();
    let write = |name: &str, rest: &str| {
        let text = format!("title = \"{name}\"\n[contact]\nfriction = 0.25\n{rest}");
        fs::write(sandbox.path(&format!("{name}.toml")), text).unwrap();
    };
    write("less", "");
    // Q₀ = 0.1 · 0.4 P₀ = 0.16 · 0.25 P₀.
    write("force", "tractive_ratio = 0.16\n");
    write("ratio", "tractive_ratio = 0.1\n");
    let point = sandbox.json("point cases/nominal.toml --wavelength 0.05 --speed 30 --json");
    write("creepage", &format!("creepage = {}\n", point["creepage"]));
    let rate = |arguments: &str| {
        let compared = sandbox.json(&format!("compare cases/nominal.toml {arguments} --json"));
        let outcome = &compared["outcomes"][1];
        (number(&outcome["fastest_growth_rate_per_passage"]), outcome["hold"].clone())
    };
    let mut rates = Vec::new();
    for hold in ["force", "ratio", "creepage"] {
        let (held, name) = rate(&format!("--with less.toml --hold {hold}"));
        let (given, of_file) = rate(&format!("--with {hold}.toml"));
        assert_eq!(name, hold);
        assert!(of_file.is_null());
        assert!((held / given - 1.0).abs() < 1e-9, "{hold}: {held} {given}");
        rates.push(held);
    }
    assert!(rates[0] > 1.2 * rates[1], "{rates:?}");
    assert_eq!(rate("--with less.toml"), (rates[1], "ratio".into()));
    // The case gives the creepage: that is what stays.
    let by_creepage = format!("--with less.toml --set contact.creepage={}", point["creepage"]);
    assert_eq!(rate(&by_creepage).1, "creepage");
    let text = sandbox.riffel("compare cases/nominal.toml --with less.toml").text;
    assert!(text.contains("held") && text.contains("ratio"), "{text}");
    assert!(text.contains("\"less\" keeps the tractive ratio"), "{text}");
    let asked = sandbox.riffel("compare cases/nominal.toml --with less.toml --hold ratio");
    assert!(!asked.text.contains("keeps the tractive ratio"));
    // Wet leaves: the force asked for is more than friction can carry.
    fs::write(sandbox.path("wet.toml"), "title = \"wet\"\n[contact]\nfriction = 0.03\n").unwrap();
    let outcome = sandbox.riffel("compare cases/nominal.toml --with wet.toml --hold force");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    let text = outcome.text.replace("\n  │ ", " ");
    assert!(text.contains("2.000 kN on a wheel is 1.33 times"), "{text}");
    assert!(text.contains("--hold ratio"), "{text}");
    // Where all of the contact slides, the creepage alone can be held.
    let sliding = "cases/nominal.toml --set contact.creepage=0.02 --set contact.creep_law=full-sliding";
    for hold in ["force", "ratio"] {
        let told = sandbox.riffel(&format!("compare {sliding} --with less.toml --hold {hold}")).sentence();
        assert!(told.contains("choose --hold creepage, or give contact.creepage with the change"), "{told}");
        assert!(!told.contains("contact.tractive_ratio"), "{told}");
    }
    let growth = sandbox.json(&format!("point {sliding} --wavelength 0.05 --speed 30 --json"));
    let growth = growth["reported_growth"].to_string();
    assert!(growth.contains("check creepage, traction_share"), "{growth}");
    let wet = sandbox.riffel("compare cases/nominal.toml --with wet.toml");
    assert_eq!(wet.status, Some(0), "{}", wet.text);
}

/// Without a speed and a traffic a comparison is under the usual traffic of the line, as the map is.
// Long: maps a metro and compares it, each under its usual traffic.
#[test]
fn a_comparison_is_under_the_traffic_that_the_map_names() {
    let sandbox = Sandbox::new();
    let map = sandbox.json("map cases/metro.toml --json");
    let compared = sandbox.json("compare cases/metro.toml --with cases/soft-pads.toml --json");
    let [fastest, own] = [&map["under_traffic"]["fastest"], &compared["outcomes"][0]];
    assert_eq!(own["fastest_wavelength_m"], fastest["wavelength_m"]);
    assert_eq!(own["fastest_growth_rate_per_passage"], fastest["growth_rate_per_passage"]);
    let words = "under the usual traffic of a metro (40–70 km/h, 6000 axles a day)";
    assert_eq!(compared["speeds"], words);
    // Numbers between zero and minus one keep their sign in German.
    let printed = |language: &str| {
        let compare = "compare cases/metro.toml --with cases/soft-pads.toml";
        sandbox.riffel(&format!("--language {language} {compare}")).text
    };
    let minus = |text: &str| text.matches(" -0").count();
    assert!(minus(&printed("en")) > 0);
    assert_eq!(minus(&printed("en")), minus(&printed("de")));
}

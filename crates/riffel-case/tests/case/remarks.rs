//! What the reader of a case is told, in both languages.

use riffel_case::ask;
use riffel_keys::{Language, Message};

fn remarks(overrides: &[&str]) -> Vec<Message> {
    crate::nominal(overrides).remarks
}

/// The numbers of a sentence, smallest first, with a decimal point.
fn numbers(sentence: &str) -> Vec<String> {
    let digits = |c: char| !(c.is_ascii_digit() || ".,".contains(c));
    let mut numbers: Vec<String> = sentence
        .split(digits)
        .map(|number| number.trim_matches(['.', ',']).replace(',', "."))
        .filter(|number| !number.is_empty())
        .collect();
    numbers.sort();
    numbers
}

/// Two wordings of one remark can differ in everything but what they say: its numbers stand in both.
#[test]
fn every_remark_says_the_same_in_german() {
    let even = ["track.preset=br-stiff", "rail.section=60E1"];
    let cases = [
        &["corrugation.amplitude=100 µm", "map.wavelength.min=10 mm"][..],
        &["vehicle=locomotive", "contact.transverse_radius=30 m"],
        &[
            "contact.creep_law=polach",
            "contact.polach.limit_friction_ratio=0.4",
            "contact.polach.friction_decay=0.6 s/m",
            "contact.polach.speed=20.5 m/s",
        ],
        &[even[0], even[1], "track.model=two-layer"],
        &[even[0], even[1], "track.model=two-layer-periodic", "rail.beam=euler-bernoulli"],
    ];
    let mut seen: Vec<Message> = Vec::new();
    for remark in cases.into_iter().flat_map(remarks) {
        let english = remark.text(Language::English);
        let german = remark.text(Language::German);
        assert_eq!(english, remark.to_string());
        assert_eq!(numbers(&english), numbers(&german), "{german}");
        for word in [" the ", " of ", " is "] {
            assert!(!german.contains(word), "{german}");
        }
        if !seen.contains(&remark) {
            seen.push(remark);
        }
    }
    let told = |words: &str| seen.iter().any(|remark| remark.to_string().contains(words));
    for words in [
        "changes nothing",
        "has no support",
        "24° and 14 %",
        "not named",
        "spread evenly",
        "average over its patch",
        "radii of wheel and rail",
        "falling friction",
        "wheel and rail part",
    ] {
        assert!(told(words), "{words}");
    }
}

/// An axle almost without loss makes the phase of the loop jump: the check of stability ends, and says so.
#[test]
fn a_loop_whose_stability_cannot_be_told_says_so() {
    let text = include_str!("../../cases/curve.toml");
    let case = crate::case(text, &["wheelset.axle.loss_factor=1e-9"]);
    let mut told = case.remarks.iter().map(|remark| remark.text(Language::English));
    assert!(told.any(|text| text.contains("whether the loop is stable")));
    assert_eq!(ask::stability(&case, 20.0), None);
}

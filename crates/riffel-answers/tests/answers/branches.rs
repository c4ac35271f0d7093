//! The branches of the ridge on tracks with supports: the strongest leads, whatever the number of its points.

use std::ops::Range;

use riffel::Ridge;
use riffel::growth::RidgeBranch;
use riffel_answers::map::MapAnswer;
use riffel_answers::ridge::{BranchDocument, best_fit_frequency};
use riffel_case::{Case, NOMINAL_CASE, traffic};
use riffel_keys::Language;

use crate::case;

/// The case of the guide on discrete supports.
const DISCRETE_SUPPORTS: &str = include_str!("../../../../cases/discrete-supports.toml");

fn ridge(case: &Case) -> Ridge {
    Ridge::search(&case.feedback, case.wavelength, case.speed)
}

/// The case of each class of corrugation by wear is named by what fixes its wavelength; on a soft slab that is no resonance.
#[test]
fn classes_are_named_by_their_mechanism() {
    for (text, mechanism) in [
        (include_str!("../../../../cases/class-roaring-rails.toml"), Some("pinned-pinned, vertical")),
        (include_str!("../../../../cases/class-rutting.toml"), Some("wheelset torsion")),
        (include_str!("../../../../cases/class-contact-fatigue.toml"), Some("P2 resonance")),
        (include_str!("../../../../cases/class-booted-sleeper.toml"), Some("sleeper antiresonance")),
        (include_str!("../../../../cases/class-soft-slab.toml"), None),
        (include_str!("../../../../cases/curve.toml"), Some("wheelset bending")),
    ] {
        let case = case(text, &["map.speed.points=16"]);
        let branches = BranchDocument::all(&case, &ridge(&case));
        assert_eq!(branches[0].mechanism, mechanism, "{} Hz", branches[0].frequency_hz);
    }
}

/// Without the wave's own geometry short waves grow, too.
const FLAT: &str = "contact.wave_geometry=false";

/// The branch of most points inside the window was once called the frequency of the ridge: 591, 596 and 473 Hz.
#[test]
fn the_strongest_branch_leads() {
    type Row<'a> = (&'a str, &'a [&'a str], Range<f64>, Range<f64>);
    let cases: [Row<'_>; 3] = [
        (DISCRETE_SUPPORTS, &[FLAT], 225.0..226.0, 590.0..592.0),
        (
            NOMINAL_CASE,
            &["track.model=two-layer-periodic", "track.preset=br-stiff", "map.speed.min=10"],
            322.0..329.0,
            594.0..597.0,
        ),
        (
            DISCRETE_SUPPORTS,
            &[FLAT, "vehicle=metro-trailer-car", "track.preset=ballasted-soft-pads"],
            176.0..179.0,
            472.0..474.0,
        ),
    ];
    for (text, overrides, strongest, most_numerous) in cases {
        let ridge = ridge(&case(text, overrides));
        let frequency = ridge.best_fit_frequency().unwrap();
        assert!(strongest.contains(&frequency), "{frequency}");
        let first = &ridge.branches[0];
        assert!(first.points().contains(ridge.highest().unwrap()));
        let weaker = ridge.branches[1..]
            .iter()
            .find(|branch| most_numerous.contains(&branch.frequency()))
            .expect("the branch of most points");
        assert!(weaker.highest().growth_rate < 0.7 * first.highest().growth_rate);
        let inside = |branch: &RidgeBranch| {
            let points = branch.points().iter();
            points.filter(|point| !point.at_edge).count()
        };
        assert!(inside(weaker) > inside(first));
    }
}

/// The branch at 590 Hz goes on below 110 km/h, where that at 225 Hz hides it.
#[test]
fn a_branch_goes_on_under_a_stronger_one() {
    let ridge = ridge(&case(DISCRETE_SUPPORTS, &[FLAT]));
    let [strongest, weaker] = [225.0, 590.0].map(|frequency| {
        let near = |branch: &&RidgeBranch| (branch.frequency() - frequency).abs() < 3.0;
        ridge.branches.iter().find(near).unwrap()
    });
    assert!(weaker.speeds().0 < 15.0, "{:?}", weaker.speeds());
    assert!(strongest.speeds().1 > 25.0, "{:?}", strongest.speeds());
    for point in weaker.points().iter().filter(|point| point.speed < 25.0) {
        assert!(!ridge.points.contains(point));
    }
}

/// The shape of waves takes a quarter of the highest growth, and all of that near 590 Hz.
#[test]
fn the_shape_of_waves_leaves_the_longer_branch() {
    let [with, without] = [&[][..], &[FLAT]].map(|keys| ridge(&case(DISCRETE_SUPPORTS, keys)));
    let frequency = with.best_fit_frequency().unwrap();
    assert!((222.0..224.0).contains(&frequency), "{frequency}");
    let near_590 = |branch: &RidgeBranch| (branch.frequency() - 590.0).abs() < 60.0;
    assert!(without.branches.iter().any(near_590));
    assert!(!with.branches.iter().any(near_590));
    let [rate, flat] = [&with, &without].map(|ridge| ridge.highest().unwrap().growth_rate);
    assert!((0.65..0.8).contains(&(rate / flat)), "{}", rate / flat);
}

/// The nominal case has one branch, at the 537 Hz of the paper, with speeds and wavelengths that belong to it.
#[test]
fn the_nominal_ridge_is_one_branch() {
    let case = case(NOMINAL_CASE, &[]);
    let branches = BranchDocument::all(&case, &ridge(&case));
    assert_eq!(branches.len(), 1);
    let BranchDocument {
        frequency_hz,
        speed_m_per_s: [slowest, fastest],
        wavelength_m: [shortest, longest],
        mechanism,
        ..
    } = branches[0];
    assert!((537.0..538.0).contains(&frequency_hz), "{frequency_hz}");
    // The branch is a ray, but bends to 480 Hz at its slow end, where waves are nearly as short as the contact.
    assert!((slowest / shortest / frequency_hz - 1.0).abs() < 0.12);
    assert!((fastest / longest / frequency_hz - 1.0).abs() < 0.02);
    assert_eq!(mechanism, None);
    let sentence = BranchDocument::sentence(&branches);
    assert_eq!(
        sentence.text(Language::English),
        "the ridge is one branch, which grows at 537 Hz (35–154 km/h, 20–80 mm)"
    );
}

#[test]
fn a_branch_is_named_by_a_resonance_near_its_frequency() {
    let case = case(DISCRETE_SUPPORTS, &["rail.loss_factor=0.001", "track.position=0.3 m"]);
    let branches = BranchDocument::all(&case, &ridge(&case));
    let (mechanisms, _) = traffic::mechanisms(&case);
    let names = mechanisms.iter().map(|mechanism| mechanism.kind.name());
    assert_eq!(branches[0].mechanism, Some("pinned-pinned, vertical"));
    for branch in &branches {
        let Some(name) = branch.mechanism else {
            continue;
        };
        let place = names.clone().position(|other| other == name).unwrap();
        let frequency = mechanisms[place].frequency().unwrap();
        assert!((frequency / branch.frequency_hz - 1.0).abs() <= 0.10, "{name}");
    }
    let sentence = BranchDocument::sentence(&branches);
    let german = sentence.text(Language::German);
    assert!(german.starts_with("der stärkste Ast wächst bei 11"), "{german}");
    assert!(german.contains("schwächere Äste"), "{german}");
}

#[test]
fn nothing_grows_in_words() {
    let case = case(NOMINAL_CASE, &["map.wavelength={ min = 1.0, max = 2.0, points = 41 }"]);
    let branches = BranchDocument::all(&case, &ridge(&case));
    assert!(branches.is_empty());
    let sentence = BranchDocument::sentence(&branches);
    assert_eq!(sentence.to_string(), "nothing grows in this window");
}

/// A window beside the crest has a flank of it, and no frequency of its own.
#[test]
fn a_window_without_a_crest_has_no_frequency() {
    let case = case(
        NOMINAL_CASE,
        &[
            "map.wavelength={ min = \"60 mm\", max = \"62 mm\", points = 41 }",
            "map.speed={ min = \"80 km/h\", max = \"82 km/h\", points = 11 }",
        ],
    );
    let ridge = ridge(&case);
    assert!(ridge.best_fit_frequency().is_some());
    assert_eq!(best_fit_frequency(&ridge), None);
    let sentence = BranchDocument::sentence(&BranchDocument::all(&case, &ridge));
    assert_eq!(sentence.to_string(), "no crest lies in this window: growth rises towards 60 mm");
    let answer = MapAnswer::new(&case, |_| ());
    let document = serde_json::to_value(&answer).unwrap();
    assert!(document["ridge"]["best_fit_frequency_hz"].is_null());
    let figure = answer.map_figure();
    assert_eq!(figure.panels[0].best_fit_frequency_hz, None);
}

//! Presets of wheelsets, and values that go before theirs.

use riffel_case::{Case, CaseWheelset, PresetKind, presets};
use riffel_keys::Language;

/// A case whose wheelset is that of a preset, with overrides.
fn case(overrides: &[&str]) -> Result<Case, riffel_keys::CaseError> {
    let text = include_str!("../../cases/wheelset-metro-trailer.toml");
    crate::parsed(text, overrides)
}

/// Mass \[kg\] of the wheelset.
fn mass(case: &Case) -> f64 {
    match case.wheelset.as_deref() {
        Some(CaseWheelset::Flexible(flexible)) => flexible.rigid_body().mass,
        Some(CaseWheelset::Rigid(rigid)) => rigid.body().mass,
        _ => panic!("another wheelset"),
    }
}

/// Mass \[kg\] of an axle of 2.2 m and a diameter \[m\].
fn axle(diameter: f64) -> f64 {
    7850.0 * 2.2 * std::f64::consts::PI * diameter * diameter / 4.0
}

#[test]
fn every_wheelset_computes() {
    let wheelsets = presets().iter();
    let wheelsets: Vec<_> = wheelsets.filter(|preset| preset.kind == PresetKind::Wheelset).collect();
    assert_eq!(wheelsets.len(), 5);
    for preset in wheelsets {
        let case = case(&[&format!("wheelset.preset={}", preset.name)]).unwrap();
        let title = preset.title.text(Language::English);
        // The title says the mass; of a driven one without the rotor, which does not move with the axle.
        let said = title.split(['(', ' ']).find_map(|word| word.parse::<f64>().ok());
        let said = said.expect("a mass in the title");
        assert!((mass(&case) / said - 1.0).abs() < 2e-3, "{title} {}", mass(&case));
        let growth = case.feedback.at(0.05, 15.0).growth_rate;
        assert!(growth.is_finite(), "{title}");
    }
}

/// One value of a table goes before that of the preset, the others stay.
#[test]
fn a_written_value_goes_before_that_of_the_preset() {
    let all = mass(&case(&[]).unwrap());
    let thick = case(&["wheelset.axle.diameter=180 mm"]).unwrap();
    assert!((mass(&thick) - all - axle(0.18) + axle(0.16)).abs() < 1e-9);
    let wheelset = thick.file.wheelset.as_ref().unwrap();
    assert_eq!(wheelset.axle.as_ref().unwrap().loss_factor.si(), 0.002);
    assert_eq!(wheelset.suspension.as_ref().unwrap().vertical_stiffness.si(), 1.7e6);
    assert_eq!(wheelset.discs.len(), 6);
}

/// A list is one value: discs that are written are all there are.
#[test]
fn written_discs_replace_the_whole_list() {
    let wheel = |place| format!(r#"{{ position = {place}, mass = 300, polar_inertia = 30, diametral_inertia = 16 }}"#);
    let discs = format!("wheelset.discs=[{}, {}]", wheel(-0.75), wheel(0.75));
    let case = case(&[&discs]).unwrap();
    assert!((mass(&case) - 600.0 - axle(0.16)).abs() < 1e-9, "{}", mass(&case));
}

/// Segments are in the place of length and diameter.
#[test]
fn written_segments_replace_length_and_diameter() {
    let case =
        case(&[r#"wheelset.axle.segments=[{ length = 1.1, diameter = 0.16 }, { length = 1.1, diameter = 0.18 }]"#]);
    let all = mass(&self::case(&[]).unwrap());
    let more = 0.5 * (axle(0.18) - axle(0.16));
    assert!((mass(&case.unwrap()) - all - more).abs() < 1e-9);
}

/// A list that is written is all there is: nothing of a disc of the preset comes into one of the case.
#[test]
fn written_discs_take_nothing_from_those_of_a_preset() {
    let discs = |coupled: &str| {
        let wheel =
            |place: f64| format!("{{ position = {place}, mass = 346, polar_inertia = 42, diametral_inertia = 21.5 }}");
        let gear = format!("{{ position = 0.4, mass = 340, polar_inertia = 19, diametral_inertia = 10{coupled} }}");
        let list = format!("wheelset.discs=[{}, {}, {gear}]", wheel(-0.75), wheel(0.75));
        let case = case(&["wheelset.preset=metro-motor", &list]).unwrap();
        case.file.wheelset.unwrap().discs
    };
    let coupled = discs(", coupled = { polar_inertia = 30, stiffness = 5e5 }");
    assert_eq!(coupled[2].coupled.as_ref().unwrap().damping.si(), 0.0);
    assert!(discs("")[2].coupled.is_none());
}

/// A preset of all that a case says itself is worth a remark; one with another model gives what that takes.
#[test]
fn a_rigid_wheelset_takes_the_suspension_of_a_preset() {
    let rigid = case(&[
        "wheelset.model=rigid",
        "wheelset.mass=1400 kg",
        "wheelset.roll_inertia=700 kg m2",
        "wheelset.spin_inertia=96 kg m2",
    ])
    .unwrap();
    assert_eq!(mass(&rigid), 1400.0);
    assert!(matches!(rigid.wheelset.as_deref(), Some(CaseWheelset::Rigid(_))));
}

/// A rigid wheelset has mass and inertias of the axle and discs of its preset, each where it is not written; and so has the wheelset of
/// a curve.
#[test]
fn a_rigid_wheelset_weighs_as_its_preset() {
    let flexible = case(&[]).unwrap();
    let Some(CaseWheelset::Flexible(flexible)) = flexible.wheelset.as_deref() else {
        panic!("not flexible");
    };
    let expected = flexible.rigid_body();
    let body = |overrides: &[&str]| match case(overrides).unwrap().wheelset.as_deref() {
        Some(CaseWheelset::Rigid(rigid)) => rigid.body(),
        _ => panic!("not rigid"),
    };
    assert_eq!(body(&["wheelset.model=rigid"]), expected);
    let heavier = body(&["wheelset.model=rigid", "wheelset.mass=2000 kg"]);
    assert_eq!((heavier.mass, heavier.roll_inertia), (2000.0, expected.roll_inertia));
    let curve = include_str!("../../cases/metro-curve.toml").replace("mass = \"1150 kg\"", "");
    let curve = riffel_case::CurvingCase::parse("case.toml", &curve, &[]).unwrap();
    let mass = curve.file.wheelset.mass.unwrap().si();
    // Axle, two wheels, brake discs and boxes of the preset metro-trailer, 1419 kg.
    let trailer = case(&["wheelset.preset=metro-trailer"]).unwrap();
    let Some(CaseWheelset::Flexible(trailer)) = trailer.wheelset.as_deref() else {
        panic!("not flexible");
    };
    assert!((mass / trailer.rigid_body().mass - 1.0).abs() < 1e-9, "{mass}");
}

#[test]
fn mistakes_name_the_key() {
    for row in [
        "wheelset.preset=metro => is \"metro\", but no wheelset preset has that name; allowed: coach, electric-locomotive, metro-motor, metro-trailer, tram",
        "wheelset.preset=locomotive => no wheelset preset has that name",
        "wheelset.preset=3 => is \"3\", but no wheelset preset",
        "wheelset.discs=3 => `wheelset.discs` is not a list",
    ] {
        let (change, says) = row.split_once(" => ").unwrap();
        let message = case(&[change]).err().unwrap().to_string();
        assert!(message.contains(says), "{message}");
    }
}

//! Mistakes in the keys of the loop on all axes.

use miette::Diagnostic;
use riffel_case::{Case, Hold, NOMINAL_CASE, Variant};
use riffel_keys::CaseError;

/// A wheelset on a stepped axle of 2.2 m, both rails and two creepages.
const STEPPED_AXLE: &str = include_str!("../general-loop/stepped-axle.toml");
/// A rigid wheelset on one rail.
const RIGID: &str = include_str!("../general-loop/rigid-spin.toml");
/// A rail that twists.
const TWIST: &str = include_str!("../general-loop/twist.toml");
/// Eight wheels on one rail.
const TRAIN: &str = include_str!("../general-loop/eight-wheels.toml");

fn error(text: &str, overrides: &[&str]) -> CaseError {
    let error = crate::parsed(text, overrides).err();
    error.expect("this case must be refused")
}

/// Two flexible wheelsets on twisting rails.
const TWO_WHEELSETS: &str = include_str!("../general-loop/two-wheelsets.toml");

/// What a case writes after defaults and presets reads back as the same case, here and in another process.
#[test]
fn a_completed_case_reads_back() -> Result<(), CaseError> {
    const SUSPENDED: &str = include_str!("../general-loop/rigid-suspended.toml");
    const ANTIPHASE: &str = include_str!("../general-loop/flexible-antiphase.toml");
    for text in [RIGID, SUSPENDED, TWIST, STEPPED_AXLE, ANTIPHASE, TRAIN, TWO_WHEELSETS] {
        let case = crate::parsed(text, &["contact.contact_angle=2°"])?;
        let printed = toml::to_string(&case.file).unwrap_or_default();
        let read = crate::parsed(&printed, &[])?;
        let restored = riffel_case::PortableCase::of(&case).restore(None, None)?;
        let as_json = serde_json::to_value(&case.file).unwrap();
        assert_eq!(serde_json::from_value::<riffel_case::file::CaseFile>(as_json).unwrap(), case.file);
        for again in [read, restored] {
            assert_eq!(again.file, case.file, "{printed}");
            let growth = |case: &Case| case.feedback.at(0.05, 20.0).growth_rate;
            assert_eq!(growth(&again), growth(&case));
        }
    }
    Ok(())
}

/// Each names the key, the value and the rule.
#[test]
fn mistakes_are_named() {
    for (text, set, message) in [
        (
            RIGID,
            "contact.creepage={ longitudinal = 0, lateral = 0, spin = 0 }",
            "`contact.creepage` is longitudinal 0, lateral 0 and spin 0 rad/m, but one of them must be at least 1e-9",
        ),
        (RIGID, "contact.creepage={}", "`contact.creepage` is longitudinal 0"),
        (
            STEPPED_AXLE,
            "opposite_contact.creepage={ lateral = 1e-300 }",
            "`opposite_contact.creepage` is longitudinal 0, lateral 0.000",
        ),
        (RIGID, "contact.creepage=0", "`contact.creepage` is 0, but must be between 1e-9 and 1"),
        (
            RIGID,
            "contact.creepage.lateral=-3",
            "`contact.creepage.lateral` is -3, but must be between -1 and 1; did you mean \"-3 %\"?",
        ),
        (
            RIGID,
            "contact.creepage.lateral=3 deg",
            "`contact.creepage.lateral`: \"3 deg\" is in rad, not a ratio; write it as in \"0.4 %\"",
        ),
        (RIGID, "contact.creepage.spin=3 deg", "`contact.creepage.spin`: \"3 deg\" is in rad, not a spin in rad/m"),
        (
            RIGID,
            "contact.creepage.latral=0.1",
            "`contact.creepage.latral` is not a key Riffel knows; did you mean lateral?",
        ),
        (
            RIGID,
            "contact.creepage=[0.1]",
            "is a list, but must be a ratio such as 0.004 or \"0.4 %\", or a table of longitudinal, lateral and spin",
        ),
        (
            RIGID,
            "contact.creep_law=carter-2d",
            "`contact.creepage.lateral` is 0.0015, but contact.creep_law = \"carter-2d\" does not know it",
        ),
        (
            RIGID,
            "contact.creep_law=polach",
            "`contact.creepage.spin` is 0.35 rad/m, but contact.creep_law = \"polach\" does not know it",
        ),
        (
            RIGID,
            "contact.contact_angle=90 deg",
            "`contact.contact_angle` is 90 deg, but must be between -89.999 deg and 89.999 deg",
        ),
        (
            RIGID,
            "contact.contact_angle=3",
            "`contact.contact_angle` is 3 rad, but must be between -89.999 deg and 89.999 deg; did you mean \"3 deg\"?",
        ),
        (
            STEPPED_AXLE,
            "opposite_contact.contact_angle=-91 deg",
            "`opposite_contact.contact_angle` is -91 deg, but must be between -89.999 deg",
        ),
        (RIGID, "contact.contact_angle=5 %", "`contact.contact_angle`: \"5 %\" is a plain number, not an angle in rad"),
        (
            RIGID,
            "contact.lateral_offset=10",
            "`contact.lateral_offset` is 10 m, but must be between -1 m and 1 m; did you mean \"10 mm\"",
        ),
        (RIGID, "wheel.mass=350 kg", "`wheel.mass` and `wheelset` exclude each other; leave wheel.mass out"),
        (RIGID, "wheel.inertia=27", "`wheel.inertia` and `wheelset` exclude"),
        (RIGID, "wheel.rotation=inertia", "`wheel.rotation` and `wheelset` exclude each other"),
        (
            RIGID,
            "wheelset.model=flexble",
            "`wheelset.model`: \"flexble\" is not one of its choices; did you mean flexible?",
        ),
        (
            RIGID,
            "wheelset.spin_inertial=85",
            "`wheelset.spin_inertial` is not a key Riffel knows; did you mean spin_inertia?",
        ),
        (RIGID, "wheelset.mass=-1", "`wheelset.mass` is -1 kg, but must be between"),
        (
            RIGID,
            "wheelset.suspension.lateral_damping=-1 N s/m",
            "`wheelset.suspension.lateral_damping` is -1 N s/m, but must be between 0 N s/m",
        ),
        (RIGID, "wheelset.model=flexible", "`wheelset.axle` is missing"),
        (RIGID, "wheelset.model=modal", "`wheelset.file` is missing"),
        (RIGID, "wheelset.model=measured", "`wheelset.file` is missing"),
        (
            STEPPED_AXLE,
            "wheelset.axle.diameter=160 mm",
            "`wheelset.axle.segments` and `wheelset.axle.diameter` exclude each other",
        ),
        (
            STEPPED_AXLE,
            "wheelset.axle.segments=[]",
            "`wheelset.axle.segments` is an empty list, an axle of 0 m, but the sum of the lengths must be above 0",
        ),
        (STEPPED_AXLE, "wheelset.axle={ length = 2.2 }", "`wheelset.axle.diameter` is missing"),
        (
            STEPPED_AXLE,
            "wheelset.axle.segments=[{ length = -1, diameter = 0.16 }]",
            "`wheelset.axle.segments[0].length` is -1 m, but must be between 1 mm and 10 m",
        ),
        (
            STEPPED_AXLE,
            "wheelset.axle.segments=[{ length = \"1.4 m\", diameter = \"160 mm\" }]",
            "`wheelset.contact_spacing` is 1.5 m, but must be at most the length of the axle, 1.4 m",
        ),
        (
            STEPPED_AXLE,
            "wheelset.contact_spacing=2.3 m",
            "`wheelset.contact_spacing` is 2.3 m, but must be at most the length of the axle, 2.2",
        ),
        (
            STEPPED_AXLE,
            "wheelset.suspension={ spacing = \"2.4 m\" }",
            "`wheelset.suspension.spacing` is 2.4 m, but must be at most the length of the axle, 2.2",
        ),
        (
            STEPPED_AXLE,
            "wheelset.discs=[{ position = -1.2, mass = 330, polar_inertia = 38, diametral_inertia = 20 }]",
            "`wheelset.discs[0].position` is -1.2 m, but must be between -1.1",
        ),
        (
            STEPPED_AXLE,
            "wheelset.discs=[{ position = 0, mass = \"330 kg m2\", polar_inertia = 38, diametral_inertia = 20 }]",
            "`wheelset.discs[0].mass`: \"330 kg m2\" is in kg m2, not a mass in kg",
        ),
        (
            STEPPED_AXLE,
            "wheelset.discs=[{ position = 0, polar_inertia = 38, diametral_inertia = 20 }]",
            "`wheelset.discs[0].mass` is missing",
        ),
        (
            STEPPED_AXLE,
            "wheelset.opposite_rail=absent",
            "`opposite_contact` is given, but wheelset.opposite_rail is \"absent\"",
        ),
        (NOMINAL_CASE, "opposite_contact.normal_load=40 kN", "`opposite_contact` is given, but there is no [wheelset]"),
        (
            TRAIN,
            "train.wheels=[\"0 m\", \"2.5 m\", \"2500 mm\"]",
            "`train.wheels[2]` is 2.5 m, where wheel 2 stands: two wheels must not be at one place",
        ),
        (TRAIN, "train.wheels=[\"1 m\", \"2.5 m\"]", "`train.wheels[0]` is 1 m, but must be 0 m"),
        (TRAIN, "train.wheels=[]", "`train.wheels` is a list of 0, but must be one to 400 distances"),
        (TRAIN, "train.wheels=[0, -2.5]", "`train.wheels[1]` is -2.5 m, but must be between 0 m and 10000 m"),
        (TRAIN, "train.wheels=[0, \"2 s\"]", "`train.wheels[1]`: \"2 s\" is in s, not a length in m"),
        (TRAIN, "train.wheels=2.5 m", "`train.wheels` is not a list, as it must be"),
        (TRAIN, "train.comb=meen", "`train.comb`: \"meen\" is not one of its choices"),
        (TWIST, "rail.torsion_constant=-1", "`rail.torsion_constant` is -1 m4, but must be between"),
        (
            TWIST,
            "rail.warping_constant=1 m4",
            "`rail.warping_constant`: \"1 m4\" is in m4, not a warping constant in m6",
        ),
    ] {
        let error = error(text, &[set]).in_words();
        let head = format!("--set {set}: ");
        // What is missing and what does not go together may stand in the file.
        let rest = error.strip_prefix(&head).unwrap_or(&error);
        assert!(rest.contains(message), "{error}");
    }
}

#[test]
fn what_a_rail_needs_to_twist() {
    for row in [
        "polar_second_moment = 3.55e-05 => `rail.polar_second_moment` is missing",
        "head_height = 0.095 => `rail.head_height` is missing",
        "foot_depth = 0.045 => `rail.foot_depth` is missing",
        "foot_width = 0.15 => `rail.foot_width` is missing",
    ] {
        let (line, message) = row.split_once(" => ").unwrap();
        let text = TWIST.replacen(line, "", 1);
        let error = error(&text, &[]);
        assert_eq!(error.to_string(), message);
        let help = error.help().map(|help| help.to_string());
        assert!(help.is_some_and(|help| help.starts_with("a rail with torsion_constant needs it")));
    }
}

#[test]
fn laws_that_know_spin_are_named() {
    let error = error(RIGID, &["contact.creep_law=carter-3d"]);
    let help = error.help().map(|help| help.to_string());
    assert_eq!(help.as_deref(), Some("laws that do: shen-hedrick-elkins, fastsim, half-space"));
}

/// An override of a list is named with what is wrong in it, not the line of the file that it replaces.
#[test]
fn overrides_of_lists_are_named() {
    for (text, set) in [
        (TRAIN, "train.wheels=[0, 2.5, 2.5]"),
        (TRAIN, "train.wheels=[0, true]"),
        (STEPPED_AXLE, "wheelset.discs=[{ position = 2 }]"),
        (STEPPED_AXLE, "wheelset.discs=[{ position = 2, mass = 1, polar_inertia = 1, diametral_inertia = 1 }]"),
        (STEPPED_AXLE, "wheelset.axle.segments=[{ length = 0, diameter = 0.16 }]"),
    ] {
        let error = error(text, &[set]);
        assert!(error.to_string().starts_with(&format!("--set {set}: ")), "{error}");
    }
}

/// A table that only overrides make is theirs.
#[test]
fn overrides_that_make_a_table_are_named() {
    let cases: [(&str, &[&str]); 2] = [
        (NOMINAL_CASE, &["opposite_contact.friction=0.3"]),
        (NOMINAL_CASE, &["contact.creepage.lateral=0", "contact.creepage.spin=0"]),
    ];
    for (text, sets) in cases {
        let error = error(text, sets).to_string();
        assert!(error.starts_with(&format!("--set {}: ", sets[0])), "{error}");
    }
}

/// With less friction a creepage in any direction stays; no tractive ratio brings it back.
#[test]
fn a_creepage_in_any_direction_is_held() -> Result<(), CaseError> {
    let case = crate::parsed(RIGID, &[])?;
    let mut variant = Variant::parse("less.toml", "[contact]\nfriction = 0.38")?;
    for hold in [None, Some(Hold::Creepage)] {
        variant.hold = hold;
        let changed = variant.applied_to(&case)?;
        assert_eq!(changed.steady.creepages, case.steady.creepages);
        assert_eq!(changed.steady.friction, 0.38);
    }
    for (hold, word) in [(Hold::Force, "force"), (Hold::Ratio, "ratio")] {
        variant.hold = Some(hold);
        let error = variant.applied_to(&case).err().map(|error| error.to_string());
        let error = error.unwrap_or_default();
        assert!(error.contains(&format!("holds the {word} of longitudinal creepage alone")), "{error}");
    }
    Ok(())
}

/// Values of lists are shown where they stand.
#[test]
fn mistakes_in_lists_are_shown() {
    let text = TRAIN.replacen("9.0", "1.8", 1);
    let error = error(&text, &[]);
    let label = error.labels().and_then(|mut labels| labels.next());
    let label = label.map(|label| &text[label.offset()..label.offset() + label.len()]);
    assert_eq!(label, Some("1.8"), "{error}");
}

/// A tractive ratio in an override takes the place of the table, and the other way round.
#[test]
fn tractive_ratio_and_table_exclude_each_other() {
    let both = RIGID.replacen("creepage = {", "tractive_ratio = 0.3\ncreepage = {", 1);
    assert_eq!(error(&both, &[]).to_string(), "`contact.creepage` and `contact.tractive_ratio` exclude each other");
    let set = ["contact.tractive_ratio=0.3", "contact.creepage.lateral=0.1 %"];
    assert!(error(NOMINAL_CASE, &set).in_words().contains("exclude each other"));
}

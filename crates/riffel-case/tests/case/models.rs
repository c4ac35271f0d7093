//! Models of the field on one case.

use riffel::Complex64;
use riffel_case::model::{FieldModel, Joint, Joints, ModelOnCase, NotOnCase};
use riffel_case::{BHASKAR_TRACK_CASE, Case, MAIN_LINE_CASE, NOMINAL_CASE};

use crate::case;

/// A flexible wheelset in a curve, both wheels sliding across.
const CURVE: &str = include_str!("../../cases/curve.toml");

/// A wheelset whose preset brings the rolling radius.
const TRAM: &str = include_str!("../../cases/wheelset-tram.toml");

fn on(case: &Case, name: &str) -> Result<ModelOnCase, NotOnCase> {
    ModelOnCase::new(case, FieldModel::find(name).unwrap().joints)
}

fn normalized(case: &Case) -> Complex64 {
    assert!(case.feedback.is_along_one_axis());
    case.feedback.at(55.7e-3, 30.0).normalized_dissipation
}

fn close(got: Complex64, re: f64, im: f64) {
    let expected = Complex64::new(re, im);
    // Seven digits after the point are given.
    assert!((got - expected).norm() < 1e-7, "{got} is not {expected}");
}

/// The seed paper's model on its own case is the case.
#[test]
fn the_seed_model_is_the_nominal_case() {
    let nominal = case(NOMINAL_CASE, &[]);
    let seed = on(&nominal, "afferrante-ciavarella-2009").unwrap();
    let wavelengths: Vec<f64> = nominal.wavelength.values();
    for speed in [5.0, 30.0, 60.0] {
        let rates = seed.growth_rates(&wavelengths, speed);
        for (&wavelength, rate) in wavelengths.iter().zip(rates) {
            let own = nominal.feedback.at(wavelength, speed).growth_rate;
            assert!((rate - own).abs() <= 1e-12 * own.abs());
        }
    }
    // On a track with supports it is the same, for it leaves them out.
    let supported = on(&case(BHASKAR_TRACK_CASE, &[]), "afferrante-ciavarella-2009").unwrap();
    assert_eq!(supported.growth_rates(&wavelengths, 30.0), seed.growth_rates(&wavelengths, 30.0));
}

/// Ours is the case with the exact contact, point by point.
#[test]
fn ours_is_the_case_with_the_exact_contact() {
    let window = "map.wavelength=40-60 mm";
    let ours = on(&case(NOMINAL_CASE, &[window]), "riffel").unwrap();
    let exact = case(NOMINAL_CASE, &[window, "contact.response=non-steady", "contact.creep_law=half-space"]);
    let wavelengths = [0.041, 0.05, 0.0557, 0.06];
    let rates = ours.growth_rates(&wavelengths, 30.0);
    for (&wavelength, rate) in wavelengths.iter().zip(rates) {
        assert_eq!(rate, exact.feedback.at(wavelength, 30.0).growth_rate);
    }
}

/// Numbers of the nominal case and of both limits of the inertia.
#[test]
fn the_limits_of_the_inertia_have_their_numbers() {
    let with = |rotation: &str| normalized(&case(NOMINAL_CASE, &[rotation]));
    close(with("wheel.rotation=inertia"), -0.0230688, 0.0181446);
    close(with("wheel.rotation=constant-tangential-force"), -0.0056052, -0.0295953);
    close(with("wheel.rotation=constant-creepage"), 0.0054095, 0.0285622);
}

/// Constant creepage: wear follows the normal force, two thirds of it under a linear law, so that waves grow exactly
/// where the force is smallest on the crests.
#[test]
fn constant_creepage_wears_by_the_normal_force() {
    const RATIO: f64 = 1e-5;
    let ratio = format!("contact.tractive_ratio={RATIO}");
    let linear = case(NOMINAL_CASE, &[&ratio, "wheel.rotation=constant-creepage", "contact.dissipation_phase=none"]);
    for wavelength in [0.02, 0.04, 0.08, 0.3, 1.0] {
        let state = linear.feedback.at(wavelength, 30.0);
        let wear = state.dissipation_at_rail / state.mean_dissipation;
        let load = state.normal_force() / 50e3;
        // Carter's law bends away from the line by a share of the tractive ratio.
        assert!((wear - 2.0 / 3.0 * load).norm() < RATIO * load.norm());
        assert_eq!(state.growth_rate > 0.0, state.normal_force().re < 0.0);
    }
}

/// The control: with constant creepage most waves of the window are levelled at speeds of corrugated track.
#[test]
fn constant_creepage_levels_most_waves() {
    let nominal = case(NOMINAL_CASE, &[]);
    let control = on(&nominal, "grassie-johnson-1985").unwrap();
    let wavelengths: Vec<f64> = nominal.wavelength.values();
    let mut growing = 0;
    for speed in [20.0, 30.0, 40.0, 50.0] {
        let rates = control.growth_rates(&wavelengths, speed);
        growing += rates.iter().filter(|&&rate| rate > 0.0).count();
    }
    assert!(growing * 2 < 4 * wavelengths.len(), "{growing}");
}

/// A model that lacks something says what.
#[test]
fn what_a_case_lacks_is_told() {
    let lacks = |case: &Case, name: &str| on(case, name).err().unwrap().0;
    let nominal = case(NOMINAL_CASE, &[]);
    for name in ["hempelmann-knothe-1996", "frederick-1987", "bhaskar-1997"] {
        assert_eq!(
            lacks(&nominal, name),
            "needs supports of the rail: track.support_spacing, track.pad or a track.preset"
        );
    }
    for name in ["tassilly-vincent-1991", "elkins-1998"] {
        assert!(lacks(&nominal, name).starts_with("needs a wheelset with an elastic axle"));
    }
    assert_eq!(lacks(&nominal, "both-2001"), "needs wheelset.suspension with a vertical_stiffness");
    assert_eq!(
        lacks(&case(MAIN_LINE_CASE, &[]), "hempelmann-knothe-1996"),
        "needs a rail that moves across the track: track.pad.lateral_stiffness, track.ballast.lateral_stiffness"
    );
    // Full sliding has no slope: Carter's law ends where it begins.
    let sliding = lacks(&case(CURVE, &[]), "grassie-johnson-1985");
    assert!(sliding.contains("creepage"), "{sliding}");
    for name in ["tassilly-vincent-1991", "elkins-1998"] {
        let model = on(&case(CURVE, &[]), name);
        assert!(model.is_ok() || name == "elkins-1998", "{:?}", model.err());
    }
}

/// The contact of Bhaskar's model moves across the profiles where the case says how, and that of no other model does.
#[test]
fn conformity_is_bhaskars() {
    let wheelset = [
        "contact.creepage={ longitudinal = \"0.1 %\" }",
        "contact.contact_angle=\"3 deg\"",
        "track.pad.lateral_stiffness=\"40 MN/m\"",
        "track.ballast.lateral_stiffness=\"40 MN/m\"",
    ];
    let conformal =
        [&wheelset[..], &["contact.conformity={ rail_radius = \"200 mm\", cross_slope = \"20 1/m\" }"]].concat();
    let [stays, moves] = [&wheelset[..], &conformal].map(|set| case(MAIN_LINE_CASE, set));
    let growth = |case: &Case, name: &str| on(case, name).unwrap().growth_rates(&[0.05], 30.0)[0];
    for (name, acts) in [("bhaskar-1997", true), ("grassie-johnson-1985", false)] {
        let [stays, moves] = [&stays, &moves].map(|case| growth(case, name));
        assert_eq!(stays != moves, acts, "{name}: {stays} {moves}");
    }
    // Turning evenly and held along the rail, it creeps by the ripple alone: twice the slope, twice the difference.
    let sloping = |slope: &str| {
        let set = format!("contact.conformity={{ rail_radius = \"300 mm\", cross_slope = \"{slope}\" }}");
        let set = [&wheelset[..], &[&set]].concat();
        growth(&case(MAIN_LINE_CASE, &set), "bhaskar-1997")
    };
    let [none, once, twice] = ["0", "10 1/m", "20 1/m"].map(sloping);
    assert!((once - none).abs() > 1e-3 * none.abs());
    assert!(((twice - none) / (once - none) - 2.0).abs() < 1e-9);
}

#[test]
fn a_rail_flatter_than_both_together_is_refused() {
    let set = "contact.conformity.rail_radius=\"310 mm\"".to_owned();
    let refused = Case::parse("case.toml", NOMINAL_CASE, &[set]).err().unwrap();
    let sentence = refused.in_words();
    assert!(
        sentence.contains("`contact.conformity.rail_radius` is 0.31 m, but must be at most the transverse radius"),
        "{sentence}"
    );
}

/// Two wheels on a rigid axle without mass move downward as each did alone.
#[test]
fn a_lone_wheel_becomes_one_of_two() {
    let supported = case(
        MAIN_LINE_CASE,
        &["track.pad.lateral_stiffness=\"40 MN/m\"", "track.ballast.lateral_stiffness=\"40 MN/m\""],
    );
    let pair = on(&supported, "frederick-1987").unwrap();
    assert!(!pair.case.feedback.is_along_one_axis());
    for frequency in [50.0, 500.0, 1500.0] {
        let w = 2.0 * std::f64::consts::PI * frequency;
        let [track, wheel] = supported.feedback.normal_receptances(w, 30.0);
        let [paired_track, paired_wheel] = pair.case.feedback.normal_receptances(w, 30.0);
        assert!((wheel - paired_wheel).norm() < 1e-12 * wheel.norm());
        assert!((track - paired_track).norm() < 1e-9 * track.norm());
    }
}

/// A wheelset becomes a lone wheel of half its mass and half its inertia.
#[test]
fn a_wheelset_becomes_a_lone_wheel() {
    let curve = case(CURVE, &["contact.creepage={ lateral = 0.0005 }", "contact.creep_law=carter-3d"]);
    let alone = on(&curve, "afferrante-ciavarella-2009").unwrap().case.file;
    let axle = 7850.0 * 2.0 * 0.25 * std::f64::consts::PI * 0.16f64.powi(2);
    let mass = alone.wheel.mass.unwrap().si();
    assert!((mass - (350.0 + 80.0 + 0.5 * axle)).abs() < 1e-9);
    let inertia = alone.wheel.inertia.unwrap().si();
    assert!((inertia - (27.77 + 0.5 * axle * 0.16f64.powi(2) / 8.0)).abs() < 1e-9);
    let creepage = alone.contact.creepage.unwrap().components();
    assert_eq!((creepage.longitudinal, creepage.lateral), (0.0005, 0.0));
}

/// Names are told apart, and each says what it takes, what it leaves out, and where it is from.
#[test]
fn a_lone_wheel_keeps_the_radius_of_the_wheelset() {
    let tram = case(TRAM, &[]);
    let alone = on(&tram, "afferrante-ciavarella-2009").unwrap().case;
    assert!(alone.file.wheelset.is_none());
    assert_eq!(alone.hertz.rolling_radius(), tram.hertz.rolling_radius());
}

#[test]
fn models_are_described() {
    assert_eq!(FieldModel::all().len(), 13);
    for model in FieldModel::all() {
        assert!(std::ptr::eq(FieldModel::find(&model.name).unwrap(), model));
        assert!(!model.source.is_empty() && !model.assumptions.is_empty());
        assert!(!model.leaves_out.is_empty());
        let ours = Joints::OURS;
        let differences: Vec<Joint> = model.joints.differences(ours).collect();
        let changed = differences.iter().fold(model.joints, |joints, &joint| joints.with(joint, ours));
        assert_eq!(changed, ours);
        assert_eq!(differences.is_empty(), model.name == "riffel");
    }
    assert!(FieldModel::find("nobody-1900").is_none());
}

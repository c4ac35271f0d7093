//! Every track model from keys to receptance.

use riffel::Direction;
use riffel::receptance::ResonanceKind;
use riffel_case::{Case, NOMINAL_CASE};
use riffel_keys::CaseError;

fn case(overrides: &[&str]) -> Result<Case, CaseError> {
    crate::parsed(NOMINAL_CASE, overrides)
}

fn message(overrides: &[&str]) -> String {
    let error = case(overrides).err().expect("a case with a mistake");
    error.to_string()
}

const PERIODIC: [&str; 3] =
    ["rail.section=60E1", "track.preset=ballasted-stiff-pads", "track.model=two-layer-periodic"];

#[test]
fn every_model_computes_with_either_beam() {
    for model in ["free-beam", "moving-beam", "one-layer", "two-layer", "one-layer-periodic", "two-layer-periodic"] {
        let model = format!("track.model={model}");
        for beam in ["rail.beam=euler-bernoulli", "rail.beam=timoshenko"] {
            let case = case(&["rail.section=60E1", "track.preset=br-stiff", &model, beam]).unwrap();
            let h = case.track.receptance.receptance(3000.0, 20.0);
            assert!(h.is_finite() && h.im < 0.0, "{model} {beam}: {h}");
        }
    }
}

/// Shear comes by itself where pinned-pinned resonances need it, and nowhere else.
#[test]
fn default_beam() {
    let plain = case(&["track.preset=br-stiff", "track.model=two-layer"]).unwrap();
    assert!(plain.track.pinned_pinned.is_none());
    let periodic = case(&PERIODIC).unwrap();
    let hertz = periodic.track.pinned_pinned.unwrap() / std::f64::consts::TAU;
    assert!((1000.0..1150.0).contains(&hertz), "{hertz}");
    let names: Vec<_> = periodic.track.resonances().iter().map(|r| r.kind).collect();
    assert!(names.contains(&ResonanceKind::PinnedPinned));
}

/// An Euler–Bernoulli rail overstates the pinned-pinned frequency, so it is not named.
#[test]
fn pinned_pinned_is_named_from_timoshenko_only() {
    let euler = [&PERIODIC[..], &["rail.beam=euler-bernoulli"]].concat();
    let case = case(&euler).unwrap();
    assert!(case.track.pinned_pinned.is_none());
    assert!(case.track.resonances().iter().all(|r| r.kind != ResonanceKind::PinnedPinned));
    assert!(case.remarks.iter().any(|remark| remark.to_string().contains("overstated")));
}

/// Damping and loss factor are one choice: a written one keeps the preset's other one out.
#[test]
fn a_written_damping_replaces_the_loss_factor_of_the_preset() {
    let viscous = [&PERIODIC[..], &["track.pad.damping=30 kNs/m"]].concat();
    let pad = case(&viscous).unwrap().file.track.pad.unwrap();
    assert_eq!(pad.damping.unwrap().si(), 30e3);
    assert!(pad.loss_factor.is_none());
    assert_eq!(pad.stiffness.unwrap().si(), 300e6);
}

/// A pad preset goes before the pads of the track preset.
#[test]
fn presets_of_parts_go_before_those_of_the_track() {
    let soft = [&PERIODIC[..], &["track.pad.preset=pad-soft", "track.sleeper.preset=wooden"]].concat();
    let track = case(&soft).unwrap().file.track;
    assert_eq!(track.pad.unwrap().stiffness.unwrap().si(), 120e6);
    assert_eq!(track.sleeper.unwrap().mass.unwrap().si(), 40.0);
    assert_eq!(track.ballast.unwrap().stiffness.unwrap().si(), 50e6);
}

/// A vehicle gives wheel and load; where the case writes them all, the preset has nothing to say.
#[test]
fn a_vehicle_fills_in_wheel_and_load() {
    let text = NOMINAL_CASE
        .replace("rolling_radius = \"460 mm\"", "")
        .replace("mass = \"350 kg\"", "")
        .replace("normal_load = \"50 kN\"", "");
    let case = crate::case(&text, &["vehicle=locomotive"]);
    assert_eq!(case.hertz.normal_force(), 104.2e3);
    assert_eq!(case.file.wheel.rolling_radius.si(), 0.625);
    let idle = self::case(&["vehicle=locomotive"]).unwrap();
    assert!(idle.remarks.iter().any(|remark| remark.to_string().contains("changes nothing")));
    assert_eq!(idle.hertz.normal_force(), 50e3);
}

/// A moving load takes the layers that are given.
#[test]
fn moving_load_on_a_foundation() {
    let moving = |overrides: &[&str]| {
        let overrides = [&["track.model=moving-beam"], overrides].concat();
        case(&overrides).unwrap().track.receptance
    };
    let still = |overrides: &[&str]| case(overrides).unwrap().track.receptance;
    let preset = "track.preset=br-stiff";
    let pairs = [
        (moving(&[]), still(&["track.model=free-beam"])),
        (moving(&[preset]), still(&[preset, "track.model=two-layer"])),
    ];
    for (moving, still) in pairs {
        let (h, limit) = (moving.receptance(800.0, 0.01), still.receptance(800.0, 0.0));
        assert!((h - limit).norm() < 1e-4 * limit.norm(), "{h} {limit}");
        let fast = moving.receptance(800.0, 60.0);
        assert!((fast - limit).norm() > 1e-3 * limit.norm());
    }
}

#[test]
fn lateral_and_longitudinal_directions() {
    let keys = [
        "track.pad.lateral_stiffness=40 MN/m",
        "track.ballast.lateral_stiffness=30 MN/m",
        "track.pad.longitudinal_stiffness=40 MN/m",
        "track.ballast.longitudinal_stiffness=30 MN/m",
    ];
    let case = case(&[&PERIODIC[..], &keys].concat()).unwrap();
    let at = |direction| {
        let track = case.track_in(direction).unwrap();
        track.receptance.receptance(100.0, 0.0).norm()
    };
    // Nearly at rest a rail is softer sideways than downward, and much stiffer along itself.
    assert!(at(Direction::Lateral) > at(Direction::Vertical));
    assert!(at(Direction::Longitudinal) < at(Direction::Vertical));
}

#[test]
fn lateral_needs_its_keys() {
    let case = case(&PERIODIC).unwrap();
    let error = case.track_in(Direction::Lateral).err().unwrap().to_string();
    assert!(error.contains("`track.pad.lateral_stiffness` is missing"), "{error}");
    let moving = self::case(&["track.model=moving-beam"]).unwrap();
    assert!(moving.track_in(Direction::Lateral).is_err());
}

/// The whole window, first at the mean, then at its edges.
#[test]
fn bad_tracks() {
    for row in [
        "track.model=one-layer => `track.support_spacing` is missing",
        "track.model=one-layer; track.support_spacing=0.6 => `track.pad` is missing",
        "track.model=two-layer-periodic; track.preset=slab-direct => `track.sleeper.mass` is missing",
        "track.model=measured => `track.measurement` is missing",
        "track.model=one-layer; track.support_spacing=0.6; track.pad.stiffness=1e8 => `track.pad.damping` is missing",
        "rail.beam=timoshenko; rail.section=60E1; rail.shear_coefficient=1.2 => `rail.shear_coefficient` is 1.2",
        "rail.loss_factor=-0.1 => `rail.loss_factor` is -0.1",
        "track.pad.loss_factor=-0.1 => `track.pad.loss_factor` is -0.1",
        "track.preset=br-stiff; track.model=two-layer-periodic; track.position=0.8 m => `track.position` is 0.8 m, but must be at most the support spacing, 0.7 m",
        "track.preset=br-stiff; track.model=two-layer-periodic; track.support_spacing=0 => `track.support_spacing` is 0 m",
        "track.preset=br-stiff; track.model=two-layer-periodic; track.support_spacing=20 m => `track.support_spacing` is 20 m, but must be between 10 mm and 10 m",
        "track.preset=br-stiff; track.model=two-layer-periodic; track.pad.damping=-1 => `track.pad.damping` is -1 N s/m",
        "track.preset=br-stiff; track.model=two-layer; track.sleeper.mass=0; track.ballast.stiffness=0 => `track.ballast.stiffness` is 0 N/m",
        "track.preset=pad-soft => `track.preset` is \"pad-soft\", but no track preset has that name",
        "vehicle=bicycle => `vehicle` is \"bicycle\", but no vehicle preset has that name",
    ] {
        let (overrides, sentence) = row.split_once(" => ").unwrap();
        let overrides: Vec<&str> = overrides.split("; ").collect();
        let message = message(&overrides);
        assert!(message.contains(sentence), "{message}");
    }
}

/// A rail without its section's area has no shear to compute.
#[test]
fn timoshenko_needs_area_and_shear_coefficient() {
    let text =
        NOMINAL_CASE.replace("section = \"BS113A\"", "mass_per_length = \"56 kg/m\"\nsecond_moment = \"2350 cm4\"");
    for (given, missing) in [
        ("rail.beam=timoshenko", "`rail.area` is missing"),
        ("rail.area=71 cm2", "`rail.shear_coefficient` is missing"),
    ] {
        let overrides = ["rail.beam=timoshenko", given].map(str::to_owned);
        let error = Case::parse("case.toml", &text, &overrides).err().unwrap();
        assert!(error.to_string().contains(missing), "{error}");
    }
}

/// Every preset of a kind makes a case; wheelsets, in the place of the wheel of this one, do in `wheelset_presets.rs`.
#[test]
fn every_preset_computes() {
    let presets = riffel_case::presets().iter();
    for preset in presets.filter(|preset| preset.kind != riffel_case::PresetKind::Wheelset) {
        let name = format!("{}={}", preset.kind.key(), preset.name);
        let model = if preset.values.iter().any(|value| value.key == "track.support_spacing")
            && preset.values.iter().all(|value| value.key != "track.sleeper.mass")
        {
            "track.model=one-layer-periodic"
        } else {
            "track.model=two-layer-periodic"
        };
        let mut overrides = vec![name.as_str(), model, "rail.beam=timoshenko"];
        if preset.kind != riffel_case::PresetKind::Track {
            overrides.push("track.preset=br-stiff");
        }
        if preset.name == "pad-stiff" {
            overrides.push("track.pad.loss_factor=0.2");
        }
        let case = case(&overrides).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(case.feedback.at(0.05, 20.0).normal_force().is_finite(), "{name}");
    }
}

/// Every rail of the presets stands in a curve: it bends and shears both ways, on discrete supports under a wheelset.
#[test]
fn every_rail_stands_in_a_curve() {
    let curve = include_str!("../../cases/metro-curve.toml");
    let rails = riffel_case::presets();
    let rails = rails.iter().filter(|preset| preset.kind == riffel_case::PresetKind::Rail);
    let mut names = Vec::new();
    for rail in rails {
        let overrides = [format!("rail.section={}", rail.name), "track.model=one-layer-periodic".to_owned()];
        let case = Case::parse("case.toml", curve, &overrides).unwrap();
        let rigid = |remark: &&riffel_keys::Message| remark.id().contains("rigid");
        assert_eq!(case.remarks.iter().find(rigid), None, "{}", rail.name);
        names.push(rail.name.clone());
    }
    assert!(names.len() >= 6, "{names:?}");
}

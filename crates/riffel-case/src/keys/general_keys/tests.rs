//! Cases of the loop on all axes as they are read; the reference cases are in `tests/general-loop`.

use std::path::Path;

use proptest::prelude::*;
use riffel_keys::KeyFile;

use super::wheelset::{RigidBodyKeys, WheelsetModelKeys};
use super::*;
use crate::NOMINAL_CASE;
use crate::file::{Comb, WheelsetModel};
use crate::fixtures::{edits, mutated};
use crate::keys::substitutes::Substitutes;
use crate::parts::window::Window;
use crate::text::case_text::CaseText;

fn keys(text: &str, overrides: &[&str]) -> Result<CheckedKeys, CaseError> {
    let overrides: Vec<String> = overrides.iter().map(|&text| text.to_owned()).collect();
    let mut text = CaseText::parse("case.toml", text)?;
    text.apply(&overrides)?;
    let given = Substitutes::default();
    CheckedKeys::of_text(text, Some(Path::new("")), given, Window::Map)
}

fn reference(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/general-loop");
    std::fs::read_to_string(folder.join(name)).unwrap()
}

fn general(text: &str, overrides: &[&str]) -> GeneralKeys {
    keys(text, overrides).unwrap().general().unwrap().unwrap()
}

/// Keys with their overrides go to another process as text, and make the same case there.
#[test]
fn keys_go_to_another_process() {
    let sets =
        ["opposite_contact.creepage.spin=0.1 1/m", "train.wheels=[\"0 m\", \"2.5 m\"]", "contact.contact_angle=2°"];
    let text = reference("stepped-axle.toml");
    let mut written = CaseText::parse("case.toml", &text).unwrap();
    written.apply(&sets.map(str::to_owned)).unwrap();
    let keys = &written.keys;
    let again = KeyFile::restore(keys.name(), keys.text(), &keys.table().to_string(), &keys.overrides());
    let [here, there] = [written, CaseText::of(again.unwrap())]
        .map(|text| CheckedKeys::of_text(text, None, Substitutes::default(), Window::Map).unwrap());
    assert_eq!(there.file, here.file);
    let general = there.general().unwrap().unwrap();
    assert_eq!(general.wheels, [0.0, 2.5]);
    assert_eq!(general.opposite.unwrap().creepages.map(|c| c.spin), Some(0.1));
}

#[test]
fn the_case_of_one_axis_is_not_general() {
    for text in [NOMINAL_CASE, crate::BHASKAR_TRACK_CASE, crate::METRO_CASE] {
        let keys = keys(text, &[]).unwrap();
        assert_eq!(keys.general_key(), None);
        assert_eq!(keys.general().unwrap(), None);
    }
}

#[test]
fn keys_that_make_a_case_general() {
    for row in [
        "train.wheels=[0] => train",
        "contact.creepage={ lateral = \"0.5 %\" } => contact.creepage",
        "contact.contact_angle=0 => contact.contact_angle",
        "contact.lateral_offset=\"-5 mm\" => contact.lateral_offset",
        "contact.conformity.rail_radius=\"250 mm\" => contact.conformity",
    ] {
        let (set, key) = row.split_once(" => ").unwrap();
        let keys = keys(NOMINAL_CASE, &[set]).unwrap();
        assert_eq!(keys.general_key(), Some(key));
    }
}

/// Everything of the contact in units, and the signs that the opposite rail turns.
#[test]
fn contacts_of_both_rails() {
    let wheelset = [
        "contact.creepage={ longitudinal = \"0.1 %\", lateral = \"-0.5 %\", spin = \"0.3 1/m\" }",
        "contact.contact_angle=3 deg",
        "contact.lateral_offset=10 mm",
        "wheelset.opposite_rail=antiphase",
    ];
    let text = reference("rigid-spin.toml");
    let found = general(&text, &wheelset);
    let here = Creepages { longitudinal: 0.001, lateral: -0.005, spin: 0.3 };
    assert_eq!(found.mean, MeanState::Creepages(here));
    assert_eq!(found.contact.contact_angle, 3.0_f64.to_radians());
    assert_eq!(found.contact.lateral_offset, 0.01);
    let opposite = found.opposite.unwrap();
    assert_eq!(opposite.profile, -1.0);
    let mirrored = Creepages { spin: -0.3, ..here };
    assert_eq!(opposite.creepages, Some(mirrored));
    let contact = ContactKeys { lateral_offset: -0.01, ..found.contact };
    assert_eq!(opposite.contact, contact);

    // A table replaces the whole table, and what is written is not mirrored.
    let own = [
        "opposite_contact.creepage={ longitudinal = -0.001 }",
        "opposite_contact.normal_load=40 kN",
        "opposite_contact.lateral_offset=2 mm",
    ];
    let opposite = general(&text, &[&wheelset[..], &own].concat()).opposite.unwrap();
    assert_eq!(opposite.creepages, Some(Creepages::longitudinal(-0.001)));
    assert_eq!(opposite.contact.normal_load, 40e3);
    assert_eq!(opposite.contact.lateral_offset, 0.002);

    // At a tractive ratio the creepage follows from the contact under study.
    let ratio = ["contact.tractive_ratio=0.3", "wheelset.opposite_rail=smooth"];
    let found = general(&text, &ratio);
    assert_eq!(found.mean, MeanState::TractiveRatio(0.3));
    let opposite = found.opposite.unwrap();
    assert_eq!((opposite.profile, opposite.creepages), (0.0, None));
}

#[test]
fn defaults_of_a_wheelset() {
    let text = NOMINAL_CASE.replacen("mass = \"350 kg\"", "", 1);
    let sets =
        ["wheelset.model=rigid", "wheelset.mass=1.1 t", "wheelset.roll_inertia=620 kg m2", "wheelset.spin_inertia=85"];
    let found = general(&text, &sets);
    let wheelset = found.wheelset.unwrap();
    assert_eq!(wheelset.contact_spacing, 1.5);
    assert_eq!(wheelset.suspension, None);
    let body = RigidBodyKeys { mass: 1100.0, roll_inertia: 620.0, spin_inertia: 85.0 };
    assert_eq!(wheelset.model, WheelsetModelKeys::Rigid(body));
    assert_eq!(found.rail, riffel::Rail::Right);
    assert_eq!(found.opposite, None);
    assert_eq!((found.wheels, found.comb), (vec![0.0], Comb::Resolved));
    assert_eq!(found.twist, None);
}

#[test]
fn the_axle_takes_the_steel_of_the_case() {
    let text = reference("flexible-antiphase.toml");
    let axle = |overrides: &[&str]| {
        let wheelset = general(&text, overrides).wheelset.unwrap();
        let WheelsetModelKeys::Flexible { axle, discs } = wheelset.model else {
            panic!("{wheelset:?}");
        };
        assert_eq!(discs.len(), 2);
        axle
    };
    let own = axle(&[]);
    assert_eq!(own.segments, [[2.2, 0.16]]);
    assert_eq!((own.youngs_modulus, own.poisson_ratio), (207e9, 0.3));
    let sets = ["wheelset.axle={ length = \"2.2 m\", diameter = \"160 mm\" }"];
    let own = axle(&sets);
    assert_eq!(own.shear_coefficient, 6.0 * 1.3 / (7.0 + 6.0 * 0.3));
    assert_eq!((own.density, own.loss_factor), (7850.0, 0.0));
    let sets = [sets[0], "wheelset.axle.youngs_modulus=210 GPa"];
    assert_eq!(axle(&sets).youngs_modulus, 210e9);
}

#[test]
fn a_wheelset_takes_the_place_of_the_wheel_of_a_preset() {
    let text = reference("rigid-spin.toml");
    let text = format!("vehicle = \"metro-trailer-car\"\n{text}");
    let read = keys(&text, &[]).unwrap();
    assert_eq!((read.file.wheel.mass, read.file.wheel.rotation), (None, None));
}

#[test]
fn files_are_relative_to_the_case() {
    let text = reference("rigid-spin.toml");
    let sets = ["wheelset.model=modal", "wheelset.file=modes.csv"];
    let folder = Some(Path::new("cases"));
    let mut text = CaseText::parse("case.toml", &text).unwrap();
    text.apply(&sets.map(str::to_owned)).unwrap();
    let read = |folder| CheckedKeys::of_text(text.clone(), folder, Substitutes::default(), Window::Map);
    let keys = read(folder).unwrap();
    assert_eq!(keys.file.wheelset.as_ref().unwrap().model, WheelsetModel::Modal);
    let model = keys.general().unwrap().unwrap().wheelset.unwrap().model;
    let WheelsetModelKeys::Modal { file, .. } = model else {
        panic!("{model:?}");
    };
    assert_eq!(file, Path::new("cases/modes.csv"));
    let error = read(None).err().unwrap().to_string();
    assert!(error.contains("`wheelset.file` is a file"), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// Whatever is cut from or put into a valid file, the reader answers with keys, every number of which is finite, or
    /// with an error, and never panics.
    #[test]
    fn fuzz_general_case(
        edits in edits(),
        stepped in any::<bool>(),
    ) {
        let name = if stepped { "stepped-axle.toml" } else { "rigid-suspended.toml" };
        let text = mutated(&reference(name), &edits);
        match keys(&text, &[]).map(|keys| keys.general()) {
            Ok(general) => {
                let words = format!("{:?}", general.unwrap());
                prop_assert!(!words.contains("NaN") && !words.contains("inf"), "{}", words);
            }
            Err(error) => prop_assert!(!error.to_string().is_empty()),
        }
    }
}

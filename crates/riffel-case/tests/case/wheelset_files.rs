//! Wheelsets from files: modes, measured receptances.

use std::f64::consts::TAU;
use std::fs;

use riffel::wheelset::Wheelset;
use riffel_case::{Case, CaseWheelset, ask};
use riffel_keys::CaseError;
use tempfile::TempDir;

/// A rigid wheelset of 1100 kg on its suspension, creeping along and across the rail under a contact angle.
const RIGID: &str = include_str!("../general-loop/rigid-suspended.toml");

const PORTS: [&str; 6] = ["left_x", "left_y", "left_z", "right_x", "right_y", "right_z"];

/// A flexible wheelset with two brake discs.
const FLEXIBLE: &str = r#"model = "flexible"
axle = { length = "2.2 m", diameter = "160 mm", loss_factor = 0.01 }
discs = [
    { position = "-0.75 m", mass = 330, polar_inertia = 38, diametral_inertia = 20 },
    { position = "-0.35 m", mass = 110, polar_inertia = 5.5, diametral_inertia = 2.8 },
    { position = "0.35 m", mass = 110, polar_inertia = 5.5, diametral_inertia = 2.8 },
    { position = "0.75 m", mass = 330, polar_inertia = 38, diametral_inertia = 20 },
]
suspension = { longitudinal_stiffness = 12e6, lateral_stiffness = 6e6, vertical_stiffness = 1.1e6, vertical_damping = 20e3 }
"#;

const MODAL: &str = r#"model = "modal"
mass = 1100
roll_inertia = 620
spin_inertia = 85
file = "wheelset.csv"
"#;

const MEASURED: &str = "model = \"measured\"\nfile = \"wheelset.csv\"\n";

/// The case on another wheelset, with a file beside it; its map lies within 50 to 500 Hz.
fn case(wheelset: &str, file: &str) -> Result<Case, CaseError> {
    let start = RIGID.find("[wheelset]").unwrap();
    let end = RIGID.find("[corrugation]").unwrap();
    let text = format!(
        "{}[wheelset]\n{wheelset}\n{}\n[map]\nwavelength = {{ min = 0.04, max = 0.1, points = 3 }}\nspeed = {{ min = 5, max = 20, points = 3 }}\n",
        &RIGID[..start],
        &RIGID[end..]
    );
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("wheelset.csv"), file).unwrap();
    let path = folder.path().join("case.toml");
    fs::write(&path, text).unwrap();
    Case::read(&path, &[])
}

fn error(wheelset: &str, file: &str) -> String {
    case(wheelset, file).err().expect("must be refused").to_string()
}

fn wheelset(case: &Case) -> &CaseWheelset {
    case.wheelset.as_deref().unwrap()
}

/// 40 frequencies from 20 to 600 Hz \[Hz\].
fn lines() -> impl Iterator<Item = f64> {
    (0..40).map(|step| 20.0 * 30f64.powf(f64::from(step) / 39.0))
}

/// Receptances of the flexible wheelset as it would be measured, with the entries on and above the diagonal.
fn table(flexible: &Case) -> String {
    let entries = || (0..6).flat_map(|row| (row..6).map(move |column| (row, column)));
    let mut text = "frequency_hz".to_owned();
    for (row, column) in entries() {
        for part in ["re", "im"] {
            text += &format!(",{}_{}_m_per_n_{part}", PORTS[row], PORTS[column]);
        }
    }
    text += "\n";
    for frequency in lines() {
        let h = wheelset(flexible).receptances(TAU * frequency);
        text += &frequency.to_string();
        for (row, column) in entries() {
            let h = h[row][column];
            text += &format!(",{:e},{:e}", h.re, h.im);
        }
        text += "\n";
    }
    text
}

/// A wheelset that is measured at every entry is the one it was measured on, in its receptances to rounding and in the
/// growth at a frequency of the table to that of the loop.
#[test]
fn a_measured_wheelset_is_the_one_that_was_measured() {
    let flexible = case(FLEXIBLE, "").unwrap();
    let measured = case(MEASURED, &table(&flexible)).unwrap();
    let of_measurement = |remark: &&riffel_keys::Message| remark.id().contains("wheelset");
    assert_eq!(measured.remarks.iter().find(of_measurement), None);
    for frequency in lines() {
        let [got, expected] = [&measured, &flexible].map(|case| wheelset(case).receptances(TAU * frequency));
        for (got, expected) in got.iter().flatten().zip(expected.iter().flatten()) {
            assert!((got - expected).norm() < 1e-12 * expected.norm().max(1e-12), "{got} {expected}");
        }
        let growth = |case: &Case| case.feedback.at(15.0 / frequency, 15.0).growth_rate;
        let (got, expected) = (growth(&measured), growth(&flexible));
        assert!((got / expected - 1.0).abs() < 1e-8, "{frequency}: {got:e} {expected:e}");
    }
    assert!(case(FLEXIBLE, "").unwrap().feedback.at(0.05, 10.0).growth_rate != 0.0);
}

#[test]
fn a_measured_wheelset_is_not_extrapolated() {
    let flexible = case(FLEXIBLE, "").unwrap();
    let measured = case(MEASURED, &table(&flexible)).unwrap();
    measured.check_window().unwrap();
    let (lowest, highest) = measured.known_frequencies();
    assert!((lowest - 20.0).abs() < 1e-9 && (highest - 600.0).abs() < 1e-9);
    let error = measured.check_frequencies(100.0, 700.0).unwrap_err().to_string();
    assert!(
        error.contains("`wheelset.file` is known from 20.0000 to 600.0000 Hz and is not extrapolated, but 100.0000–700.0000 Hz is asked for"),
        "{error}"
    );
    assert!(measured.check_wheelset_frequencies(10.0, 10.0).is_err());
    assert!(flexible.check_frequencies(1.0, 1e4).is_ok());
    assert!(ask::wheelset_modes(&measured, wheelset(&measured), 2000.0).unwrap().is_empty());
}

#[test]
fn files_that_are_not_there_are_named() {
    for wheelset in [MODAL, MEASURED] {
        let error = error(&wheelset.replace("wheelset.csv", "nowhere.csv"), "");
        assert!(error.starts_with("`wheelset.file`") && error.contains("nowhere.csv"), "{error}");
    }
}

/// Modes of a file have their names, and are said to end where a half of the highest is, or all of it with a residual compliance.
#[test]
fn modes_of_a_file_are_named() {
    let modes = "frequency_hz,damping_ratio,generalised_mass_kg,left_x,left_y,left_z,right_x,right_y,right_z\n\
                 78.6,0.002,55,1,0,0,-1,0,0\n97.2,0.003,300,0,0.4,1,0,-0.4,1\n";
    for (residual, up_to) in [("", "49 Hz"), ("residual,,,3e-10,3e-10,3e-10,3e-10,3e-10,3e-10\n", "97 Hz")] {
        let case = case(MODAL, &format!("{modes}{residual}")).unwrap();
        let modes = ask::wheelset_modes(&case, wheelset(&case), 90.0).unwrap();
        assert_eq!(modes.len(), 1);
        assert!((modes[0].frequency - 78.6).abs() < 1e-6);
        assert_eq!(modes[0].name.to_string(), "first torsion");
        let ends = format!("up to some {up_to}, and the window reaches 500 Hz");
        assert!(case.remarks.iter().any(|remark| remark.to_string().contains(&ends)), "{:?}", case.remarks);
    }
}

/// An inertia on a spring: rigidly coupled it is part of the disc, and free of it at high frequency.
#[test]
fn discs_carry_coupled_inertias() {
    let with = |keys: &str| {
        let text = FLEXIBLE.replacen("diametral_inertia = 2.8", &format!("diametral_inertia = 2.8{keys}"), 1);
        case(&text, "")
    };
    let spring = |stiffness: &str| {
        format!(
            ", coupled = {{ polar_inertia = \"20 kg m2\", stiffness = \"{stiffness}\", damping = \"5 N m s/rad\" }}"
        )
    };
    let heavy = case(&FLEXIBLE.replacen("polar_inertia = 5.5", "polar_inertia = 25.5", 1), "").unwrap();
    let (stiff, soft) = (with(&spring("1e12 N m/rad")).unwrap(), with(&spring("1 Nm/rad")).unwrap());
    let plain = case(FLEXIBLE, "").unwrap();
    for frequency in [50.0, 230.0, 400.0] {
        let along = |case: &Case| wheelset(case).receptances(TAU * frequency)[0][3];
        let differ = |one: &Case, other: &Case| (along(one) / along(other) - 1.0).norm();
        // ω²I/k of the stiff spring is 1e-4 at most; the damper has c/ωI of the disc, 3e-3 at most.
        assert!(differ(&stiff, &heavy) < 1e-2, "{frequency}: {}", differ(&stiff, &heavy));
        assert!(differ(&soft, &plain) < 1e-2, "{frequency}: {}", differ(&soft, &plain));
        assert!(differ(&plain, &heavy) > 0.05, "{frequency}");
    }
    let printed = toml::to_string(&stiff.file).unwrap();
    assert_eq!(crate::case(&printed, &[]).file, stiff.file);
    let refused = with(&spring("0 N m/rad")).err().unwrap().to_string();
    assert!(refused.contains("`wheelset.discs[1].coupled.stiffness` is 0 N m/rad, but must be"), "{refused}");
    let refused = with(&spring("3 kN/m")).err().unwrap().to_string();
    assert!(refused.contains("not a torsional stiffness in N m/rad"), "{refused}");
}

//! `riffel calibrate`: what a plan asks for, and what is refused before anything is written.

use std::fs;

use crate::sandbox::Sandbox;

const SET: &str = "validation/calibration/c-all-together";

#[test]
fn a_dry_run_says_which_data_tell_a_key() {
    let sandbox = Sandbox::new();
    sandbox.copy(SET);
    let plan = format!("{SET}/plan.toml");
    let outcome = sandbox.riffel(&format!("calibrate {plan} -o out --dry-run"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    for line in [
        "track.pad.stiffness: hammer, decay, growth + axle-box",
        "preload_stiffening: growth + axle-box",
        "hammer.discrepancy: hammer",
    ] {
        assert!(outcome.text.contains(line), "{}", outcome.text);
    }
    assert!(!sandbox.path("out").exists());
}

#[test]
fn what_is_wrong_is_said_and_other_files_stay() {
    let sandbox = Sandbox::new();
    sandbox.copy(SET);
    let plan = format!("{SET}/plan.toml");
    fs::create_dir(sandbox.path("mine")).unwrap();
    fs::write(sandbox.path("mine/notes.txt"), "keep").unwrap();
    let outcome = sandbox.riffel(&format!("calibrate {plan} -o mine"));
    assert_eq!(outcome.status, Some(2));
    assert!(
        outcome
            .sentence()
            .contains("mine is not empty and holds no calibration")
    );
    let text = fs::read_to_string(sandbox.path(&plan)).unwrap();
    fs::write(sandbox.path(&plan), text.replacen("300 MN/m", "300 kg", 1)).unwrap();
    let outcome = sandbox.riffel(&format!("calibrate {plan} -o out"));
    assert_eq!(outcome.status, Some(2));
    assert!(outcome.sentence().contains("300 kg"), "{}", outcome.text);
    assert!(!sandbox.path("out").exists());
}

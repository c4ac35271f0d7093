//! `riffel map --wheels`, from the command line to the files.

use crate::sandbox::{Sandbox, number};

/// A coarse map: growth under the traffic has wavelengths of its own.
const FEW: &str = "--set map.wavelength.points=7 --set map.speed.points=3";

/// Four wheels of a bogie, one of them on two points, with their files; the document is that of the folder, and each wheel grows as
/// the map of its case says.
// Long: finds the equilibrium of a bogie for seven maps.
#[test]
fn wheels_stand_side_by_side() {
    let sandbox = Sandbox::new();
    let command = format!("map cases/metro-curve.toml --wheels {FEW}");
    let written = sandbox.riffel(&format!("{command} -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    for shown in [
        "all wheels in the curve of 180 m at 45 km/h",
        "it grows fastest at wheelset 2, low rail",
        "wheelset 1, high rail: on the left rail the wheel stands on two points",
    ] {
        assert!(written.text.contains(shown), "{}", written.text);
    }
    assert_eq!(
        sandbox.list("out"),
        [
            "growth.csv",
            "growth.html",
            "growth.png",
            "growth.svg",
            "map.html",
            "map.nc",
            "map.png",
            "map.svg",
            "summary.json",
            "wheels.csv"
        ]
    );
    let document = sandbox.json(&format!("{command} --json"));
    let summary = std::fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(document, summary);
    let wheels = document["wheels"].as_array().unwrap();
    let names: Vec<String> = wheels
        .iter()
        .map(|wheel| {
            let word = |key: &str| wheel[key].as_str().unwrap();
            format!("{} {} {} {}", wheel["wheelset"], word("rail"), word("side"), word("contact"))
        })
        .collect();
    assert_eq!(
        names,
        ["1 low right tread", "1 high left tread", "1 high left flange", "2 low right tread", "2 high left tread"]
    );
    for (wheel, keys) in wheels.iter().zip([
        "",
        "--set contact.from.rail=high",
        "--set contact.from.rail=high --set contact.from.contact=flange",
        "--set contact.from.wheelset=2",
        "--set contact.from.wheelset=2 --set contact.from.rail=high",
    ]) {
        let highest = &wheel["highest"];
        let map = sandbox.json(&format!("map cases/metro-curve.toml {FEW} --json {keys}"));
        let fastest = &map["under_traffic"]["fastest"];
        assert_eq!(fastest["wavelength_m"], highest["wavelength_m"]);
        let [here, there] = [highest, fastest].map(|of| number(&of["growth_rate_per_passage"]));
        assert!((here / there - 1.0).abs() < 1e-9, "{here:e} {there:e}");
        let rates = wheel["growth_rate_per_passage"].as_array().unwrap();
        assert!(rates.iter().all(|rate| number(rate) <= here));
    }
}

/// A wheel that slides as a whole has its loop by every law: the force keeps its direction, and a band narrower than its contact is told.
// Long: maps five wheels of a bogie in its curve.
#[test]
fn a_wheel_that_slides_as_a_whole_has_a_loop() {
    let sandbox = Sandbox::new();
    let command = format!(
        "map cases/metro-curve.toml --wheels {FEW} --set contact.creep_law=shen-hedrick-elkins \
         --set contact.from.wheelset=2"
    );
    let written = sandbox.riffel(&format!("{command} -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    assert!(!written.text.contains("not in the loop"), "{}", written.text);
    let words = "wheelset 1, high rail: wear.band_width is 40 mm, but the contact is";
    assert!(written.text.contains(words), "{}", written.text);
    let document = std::fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let document: serde_json::Value = serde_json::from_str(&document).unwrap();
    let wheels = document["wheels"].as_array().unwrap();
    assert_eq!(wheels.len(), 5);
    for wheel in wheels {
        assert!(wheel["not_in_loop"].is_null(), "{wheel}");
        assert!(wheel["growth_rate_per_passage"].is_array());
    }
}

#[test]
fn a_case_without_a_curve_is_refused() {
    let sandbox = Sandbox::new();
    let refused = sandbox.riffel("map cases/nominal.toml --wheels -o out");
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    assert!(refused.text.contains("contact.from"), "{}", refused.text);
    assert!(!sandbox.path("out").exists());
    let both = sandbox.riffel("map cases/nominal.toml --wheels --bay -o out");
    assert_eq!(both.status, Some(2), "{}", both.text);
}

/// With the patch of the profiles the stiffness is that of `riffel profile --load` under the same load at the same shift.
// Long: asks several commands for the equilibrium of a bogie in its curve.
#[test]
fn the_patch_is_that_of_the_profiles_under_load() {
    let sandbox = Sandbox::new();
    let curve = sandbox.json("curve cases/metro-curve.toml --json");
    let wheel = &curve["wheels"][3];
    assert_eq!((&wheel["wheelset"], &wheel["rail"]), (&2.into(), &"right".into()));
    let load = number(&wheel["normal_force_n"]);
    let shift = number(&curve["wheelsets"][1]["lateral_shift_m"]);
    let under = sandbox
        .json(&format!("profile cases/metro-curve.toml --wheelset --load {load} --lateral-shift={shift} --json"));
    let right = &under["contacts"][1];
    let keys = "--set contact.from.wheelset=2 --set contact.from.patch=non-elliptic";
    let map = sandbox.json(&format!("map cases/metro-curve.toml --json {FEW} {keys} -o out"));
    let derived = &map["derived"];
    let [stiffness, of_profiles] = [&derived["contact_stiffness_n_per_m"], &right["stiffness_n_per_m"]].map(number);
    // The shift passes through text.
    assert!((stiffness / of_profiles - 1.0).abs() < 1e-6, "{stiffness:e} {of_profiles:e}");
    let axes = ["semi_axis_longitudinal_m", "semi_axis_lateral_m"].map(|key| number(&derived[key]));
    let moments = [0, 1].map(|axis| number(&right["equivalent_semi_axes_m"][axis]));
    let area = number(&right["area_m2"]);
    assert!((std::f64::consts::PI * axes[0] * axes[1] / area - 1.0).abs() < 1e-6);
    assert!((axes[0] / axes[1] / (moments[0] / moments[1]) - 1.0).abs() < 1e-6);
    // On the curved rail the stiffness of the conformal contact beside it, which is another one.
    let keys = keys.replace("non-elliptic", "conformal");
    let map = sandbox.json(&format!("map cases/metro-curve.toml --json {FEW} {keys} -o conformal"));
    let conformal = number(&map["derived"]["contact_stiffness_n_per_m"]);
    let of_profiles = number(&right["conformal"]["stiffness_n_per_m"]);
    assert!((conformal / of_profiles - 1.0).abs() < 1e-6);
    assert!((conformal / stiffness - 1.0).abs() > 1e-5);
}

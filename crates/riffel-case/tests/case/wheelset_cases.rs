//! The example cases of wheelsets.

use riffel_case::{CaseWheelset, ask, preset};

/// Value of a preset \[SI\].
fn of_preset(name: &str, key: &str) -> f64 {
    let document = preset(name).unwrap().document();
    document["values"][key]["value_si"].as_f64().unwrap()
}

/// Each moves along all axes, weighs and spins as its preset where it says so, to the kilogram and the digit it is rounded to, and has
/// its first bending where wheelsets have it.
#[test]
fn example_wheelsets_are_what_they_say() {
    for (text, of) in [
        (include_str!("../../cases/wheelset-metro-trailer.toml"), Some(("metro-trailer-car", true))),
        (include_str!("../../cases/wheelset-metro-motor.toml"), Some(("metro-motor-car", true))),
        (include_str!("../../cases/wheelset-coach.toml"), Some(("passenger-coach", false))),
        (include_str!("../../cases/wheelset-locomotive.toml"), None),
        (include_str!("../../cases/wheelset-tram.toml"), None),
    ] {
        let case = crate::case(text, &[]);
        let said: Vec<String> = case.remarks.iter().map(ToString::to_string).collect();
        let wanted = |remark: &&String| remark.contains("usual") || remark.contains("taken as rigid");
        assert_eq!(said.iter().find(wanted), None);
        let wheelset = case.wheelset.clone().unwrap();
        let CaseWheelset::Flexible(flexible) = &*wheelset else {
            panic!("not flexible");
        };
        let body = flexible.rigid_body();
        if let Some((name, spins)) = of {
            let mass = 2.0 * of_preset(name, "wheel.mass");
            assert!((body.mass / mass - 1.0).abs() < 2e-3, "{} {mass}", body.mass);
            if spins {
                let discs = &case.file.wheelset.as_ref().unwrap().discs;
                let coupled = discs.iter().filter_map(|disc| disc.coupled);
                let coupled: f64 = coupled.map(|coupled| coupled.polar_inertia.si()).sum();
                let inertia = 2.0 * of_preset(name, "wheel.inertia") + coupled;
                assert!((body.spin_inertia / inertia - 1.0).abs() < 1e-2, "{} {inertia}", body.spin_inertia);
            }
        }
        let modes = ask::wheelset_modes(&case, &wheelset, 200.0).unwrap();
        let bends = |name: &str| name.starts_with("first symmetric bending");
        let bending = modes.iter().find(|mode| bends(&mode.name.to_string()));
        let frequency = bending.unwrap().frequency;
        assert!((50.0..110.0).contains(&frequency), "{frequency}");
    }
}

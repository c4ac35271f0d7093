//! A wheel in time, from the command line to the files.

use serde_json::Value;

use crate::sandbox::Sandbox;

const CASE: &str = "cases/nominal.toml";

fn complex(value: &Value) -> [f64; 2] {
    serde_json::from_value(value.clone()).unwrap()
}

/// First harmonics over 0.1 µm are those of the point, to 10⁻³; the document has its keys, and nothing is written.
#[test]
fn small_amplitudes_are_those_of_the_point() {
    let sandbox = Sandbox::new();
    let point = sandbox.json(&format!(
        "point {CASE} --wavelength \"55 mm\" --speed 30 --set corrugation.amplitude=1e-7 --json"
    ));
    let settled = sandbox.json(&format!(
        "simulate {CASE} --speed 30 --sinusoid 0.1um,55mm --json"
    ));
    assert_eq!(sandbox.list("."), ["cases"]);
    let harmonics = settled["harmonics"].as_array().unwrap();
    assert_eq!(harmonics.len(), 6);
    for (key, of_point, scale) in [
        ("normal_force_n", "normal_force_n", 1.0),
        ("tangential_force_n", "tangential_force_n", 1.0),
        ("dissipation_j_per_m", "dissipation_w", 30.0),
    ] {
        let (got, exact) = (complex(&harmonics[1][key]), complex(&point[of_point]));
        let error = (scale * got[0] - exact[0]).hypot(scale * got[1] - exact[1]);
        assert!(
            error < 1e-3 * exact[0].hypot(exact[1]),
            "{key}: {got:?} {exact:?}"
        );
    }
    assert_eq!(complex(&harmonics[0]["creepage"])[1], 0.0);
    assert_eq!(settled["contact_loss_fraction"], 0.0);
    let [least, largest] = ["minimum_normal_force_n", "maximum_normal_force_n"]
        .map(|key| settled[key].as_f64().unwrap());
    assert!(least < 50e3 && 50e3 < largest);
}

/// Files of a wave that lifts the wheel, and the note on troughs that it does not reach.
#[test]
fn a_high_wave_is_drawn() {
    let sandbox = Sandbox::new();
    let written = sandbox.riffel(&format!(
        "simulate {CASE} --speed 30 --sinusoid 200um,55mm -o out"
    ));
    assert_eq!(written.status, Some(0), "{}", written.text);
    assert!(written.text.contains("no contact for"), "{}", written.text);
    assert!(written.text.contains("troughs"), "{}", written.text);
    let table = std::fs::read_to_string(sandbox.path("out/wave.csv")).unwrap();
    assert_eq!(table.lines().count(), 1 + 257);
    assert!(table.starts_with("position_m,height_m,normal_force_n,"));
}

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
    let point = sandbox
        .json(&format!("point {CASE} --wavelength \"55 mm\" --speed 30 --set corrugation.amplitude=1e-7 --json"));
    let settled = sandbox.json(&format!("simulate {CASE} --speed 30 --sinusoid 0.1um,55mm --json"));
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
        assert!(error < 1e-3 * exact[0].hypot(exact[1]), "{key}: {got:?} {exact:?}");
    }
    assert_eq!(complex(&harmonics[0]["creepage"])[1], 0.0);
    assert_eq!(settled["contact_loss_fraction"], 0.0);
    let [least, largest] =
        ["minimum_normal_force_n", "maximum_normal_force_n"].map(|key| settled[key].as_f64().unwrap());
    assert!(least < 50e3 && 50e3 < largest);
}

/// A contact that answers late, over a wave of three semi-axes and one of ten: forces of the point to 10⁻³, and growth over passages
/// its rate to 1 %. About the same state a contact that answers at once has another force.
// Long: tabulates a contact that answers late for each of five commands.
#[test]
fn a_late_contact_is_that_of_the_point() {
    const LATE: &str = "--set contact.response=non-steady --set contact.grid=24 --set map.wavelength.min=\"15 mm\"";
    let sandbox = Sandbox::new();
    for millimetres in [18, 55] {
        let point = sandbox.json(&format!(
            "point {CASE} {LATE} --wavelength {millimetres}mm --speed 30 --set corrugation.amplitude=1e-7 --json"
        ));
        let simulate =
            |keys: &str| format!("simulate {CASE} {keys} --speed 30 --sinusoid 0.1um,{millimetres}mm --json");
        let settled = sandbox.json(&simulate(LATE));
        let exact = complex(&point["tangential_force_n"]);
        let miss = |settled: &Value| {
            let got = complex(&settled["harmonics"][1]["tangential_force_n"]);
            (got[0] - exact[0]).hypot(got[1] - exact[1]) / exact[0].hypot(exact[1])
        };
        assert!(miss(&settled) < 1e-3, "{millimetres}: {}", miss(&settled));
        if millimetres > 20 {
            continue;
        }
        let at_once = sandbox.json(&simulate("--set contact.creep_law=half-space --set contact.grid=24"));
        assert!(miss(&at_once) > 0.1, "{millimetres}: {}", miss(&at_once));
        let worn = sandbox.json(&format!("{} --passages 1e5", simulate(LATE)));
        let rate = point["growth_rate_per_passage"].as_f64().unwrap();
        let bands = worn["bands"].as_array().unwrap().iter();
        let rates = bands.filter_map(|band| band["first_growth_per_passage"].as_f64());
        // The others are harmonics, of nothing before.
        let nearest = rates.map(|own| (own / rate - 1.0).abs()).fold(1.0, f64::min);
        assert!(nearest < 1e-2, "{millimetres}: {nearest}");
    }
}

/// sin(ka)/(ka) of a wave of 25 mm is left, of a sinusoid and of a profile with its heights.
#[test]
fn the_patch_takes_the_mean_of_the_profile() {
    let sandbox = Sandbox::new();
    let wave: String = (0..8000)
        .map(|index| f64::from(index) * 1e-3)
        .map(|x| format!("{x:.3},{:e}\n", (std::f64::consts::TAU * x / 0.025).cos()))
        .collect();
    std::fs::write(sandbox.path("wave.csv"), format!("position_m,height_um\n{wave}")).unwrap();
    let point = sandbox.json(&format!("point {CASE} --wavelength 25mm --speed 30 --json"));
    let angle = std::f64::consts::TAU / 0.025 * point["semi_axis_longitudinal_m"].as_f64().unwrap();
    for surface in ["--sinusoid 1um,25mm", "--profile wave.csv"] {
        let largest = |more: &str| {
            let run = sandbox.json(&format!("simulate {CASE} --speed 30 {surface} {more} --json"));
            let largest = match run["normal_force_n"].as_array() {
                // Far from where the wave begins.
                Some(forces) => forces[4000..].iter().filter_map(Value::as_f64).fold(0.0, f64::max),
                None => run["maximum_normal_force_n"].as_f64().unwrap(),
            };
            largest - 50e3
        };
        let left = largest("--contact-filter") / largest("");
        // Forces of 3 % of the load are linear to 2 % of themselves.
        assert!((left / (angle.sin() / angle) - 1.0).abs() < 3e-2, "{surface}: {left}");
    }
}

/// Files of a wave that lifts the wheel, and the note on troughs that it does not reach.
#[test]
fn a_high_wave_is_drawn() {
    let sandbox = Sandbox::new();
    let written = sandbox.riffel(&format!("simulate {CASE} --speed 30 --sinusoid 200um,55mm -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    assert!(written.text.contains("no contact for"), "{}", written.text);
    assert!(written.text.contains("troughs"), "{}", written.text);
    let table = std::fs::read_to_string(sandbox.path("out/wave.csv")).unwrap();
    assert_eq!(table.lines().count(), 1 + 257);
    assert!(table.starts_with("position_m,height_m,normal_force_n,"));
}

/// A profile of a sinusoid has the largest force of the sinusoid; what is no profile, too short or too coarse is refused.
// Long: follows a wheel over 35 m of rail in half millimetres.
#[test]
fn a_profile_is_rolled_over() {
    let sandbox = Sandbox::new();
    let write = |name: &str, spacing: f64, length: f64| {
        let mut text = String::from("position_m,height_um\n");
        for index in 0..(length / spacing) as usize {
            let x = spacing * index as f64;
            text += &format!("{x:.4},{:.6}\n", 20.0 * (std::f64::consts::TAU * x / 0.055).cos());
        }
        std::fs::write(sandbox.path(name), text).unwrap();
    };
    write("long.csv", 1e-3, 20.0);
    write("short.csv", 1e-3, 1.2);
    write("coarse.csv", 8e-3, 20.0);
    let settled = sandbox.json(&format!("simulate {CASE} --speed 30 --sinusoid 20um,55mm --json"));
    let passage = sandbox.json(&format!("simulate {CASE} --speed 30 --profile long.csv --length \"15 m\" --json"));
    assert_eq!(passage["position_m"].as_array().unwrap().len(), 15_000);
    let forces = passage["normal_force_n"].as_array().unwrap();
    // The second half, since the beginning is still remembered.
    let largest = forces[7_500..].iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    let expected = settled["maximum_normal_force_n"].as_f64().unwrap();
    assert!((largest / expected - 1.0).abs() < 2e-3, "{largest} {expected}");
    let written = sandbox.riffel(&format!("simulate {CASE} --speed 30 --profile long.csv -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    let table = std::fs::read_to_string(sandbox.path("out/passage.csv")).unwrap();
    assert_eq!(table.lines().count(), 1 + 20_000);
    for (arguments, words) in [
        ("--speed 80 --profile short.csv", "remembers"),
        ("--speed 30 --profile coarse.csv", "sampled every 8.000 mm"),
        ("--speed 30 --profile long.csv --length 0", "greater than zero"),
        ("--speed 30 --sinusoid 20um,55mm --spacing 1mm", "--spacing needs --profile"),
        ("--speed 30 --sinusoid 20um,55mm --length 1", "--profile"),
    ] {
        let refused = sandbox.riffel(&format!("simulate {CASE} {arguments}"));
        assert_eq!(refused.status, Some(2), "{arguments}: {}", refused.text);
        let text = refused.text.split_whitespace().collect::<Vec<_>>().join(" ").replace("│ ", "");
        assert!(text.contains(words), "{arguments}: {text}");
    }
}

/// A rail of a spectrum follows its seed, a weld is as deep as asked for, and what cannot be made is refused.
#[test]
fn rails_are_made() {
    let sandbox = Sandbox::new();
    let heights = |surface: &str| -> Vec<f64> {
        let passage = sandbox.json(&format!("simulate {CASE} --speed 30 {surface} --step 1mm --json"));
        assert!(passage["maximum_normal_force_n"].as_f64().unwrap() > 50e3);
        serde_json::from_value(passage["height_m"].clone()).unwrap()
    };
    let drawn = |seed: u64| heights(&format!("--spectrum iso-3095-2013 --length 5.5 --seed {seed}"));
    let one = drawn(1);
    assert_eq!(one.len(), 5500);
    assert!(one != drawn(2));
    let weld = heights("--weld 0.2mm,0.4m --length \"3 m\"");
    let depth = weld.iter().copied().fold(0.0, f64::min);
    assert!((depth + 0.2e-3).abs() < 1e-12 && weld[0] == 0.0);
    for (arguments, words) in [
        ("--spectrum iso-3095-2013 --length 2", "thirteen of the longest waves"),
        ("--spectrum iso-3095-2013 --length 1e9", "at most 1000 m"),
        ("--spectrum grassie-1999", "limits of the RMS"),
        ("--weld 0,1", "greater than zero"),
        ("--weld 1mm,15m", "twice the length of the weld"),
        ("--weld 1mm,1m --seed 2", "--seed needs --spectrum"),
        ("--weld 1mm,1m --rail left", "--rail needs --profile"),
        ("--weld 1mm,1m --step 1e-9", "between 0.05 and 100 mm"),
        ("--weld 1mm,1m --step 1e-300", "between 1e-12 and 1e12 in SI"),
        ("--weld 1mm,1m --length 1e300", "between 1e-12 and 1e12 in SI"),
    ] {
        let refused = sandbox.riffel(&format!("simulate {CASE} --speed 30 {arguments}"));
        assert_eq!(refused.status, Some(2), "{arguments}: {}", refused.text);
        assert!(refused.sentence().contains(words), "{arguments}: {}", refused.text);
    }
}

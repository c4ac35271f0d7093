//! `riffel contact`, from the command line to the files.

use std::collections::HashMap;
use std::fs;

use serde_json::Value;

use crate::sandbox::{Sandbox, root};

/// The ellipse of Hertz and the exact creep law, as in CONTACT.
const EXACT: &str = "contact cases/nominal.toml --set contact.hertz=exact \
                     --set contact.creep_law=half-space";
/// A grid for what needs no accuracy.
const COARSE: &str = "--set contact.grid=24";

const LAWS: [&str; 8] = [
    "carter-3d",
    "carter-2d",
    "johnson-vermeulen",
    "shen-hedrick-elkins",
    "polach",
    "fastsim",
    "full-sliding",
    "half-space",
];
const OUTPUTS: [&str; 3] = ["force", "dissipation", "rail_dissipation"];

fn numbers(value: &Value) -> Vec<f64> {
    serde_json::from_value(value.clone()).unwrap()
}

/// Header and rows of a CSV.
fn table(sandbox: &Sandbox, name: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let text = fs::read_to_string(sandbox.path(name)).unwrap();
    let cells = |line: &str| line.split(',').map(str::to_owned).collect();
    let mut lines = text.lines();
    let header = cells(lines.next().unwrap());
    (header, lines.map(cells).collect())
}

/// Every key has as many values as were asked for, in the order asked for; the tables hold the same;
/// without a folder nothing is written.
#[test]
fn contact_document_and_tables() {
    let sandbox = Sandbox::new();
    let arguments = format!("{EXACT} {COARSE} --creepage 0.002,0.05% --ratio 4,40 --json");
    let document = sandbox.json(&arguments);
    assert_eq!(sandbox.list("."), ["cases"]);
    for key in
        ["semi_axis_longitudinal_m", "semi_axis_lateral_m", "approach_m", "peak_pressure_pa", "stiffness_n_per_m"]
    {
        assert!(document[key].as_f64().unwrap() > 0.0, "{key}");
    }
    // The exact ellipse of the nominal contact, see the validation.
    let a = document["semi_axis_longitudinal_m"].as_f64().unwrap();
    assert!((a / 5.94369e-3 - 1.0).abs() < 1e-5);
    for key in ["c11", "c22", "c23", "c33"] {
        assert!(document["kalker"][key].as_f64().unwrap() > 0.0, "{key}");
    }

    let curve = &document["creep_curve"];
    assert_eq!(numbers(&curve["creepage"]), [0.002, 0.0005]);
    let by_law = curve["tractive_ratio"].as_object().unwrap();
    assert_eq!(by_law.keys().collect::<Vec<_>>(), LAWS);
    for (law, ratios) in by_law {
        let ratios = numbers(ratios);
        match law.as_str() {
            "full-sliding" => assert_eq!(ratios, [1.0, 1.0]),
            _ => assert!(
                ratios.len() == 2 && ratios[0] > ratios[1] && ratios[1] > 0.0 && ratios[0] < 1.0,
                "{law}: {ratios:?}"
            ),
        }
    }
    let response = &document["frequency_response"];
    assert_eq!(numbers(&response["wavelength_over_semi_axis"]), [4.0, 40.0]);
    for input in ["creepage", "load"] {
        let outputs = response[input].as_object().unwrap();
        assert_eq!(outputs.keys().collect::<Vec<_>>(), OUTPUTS);
        for values in outputs.values() {
            let values: Vec<[f64; 2]> = serde_json::from_value(values.clone()).unwrap();
            assert_eq!(values.len(), 2);
            // Long waves are nearer to quasi-static ones.
            let distance = |value: [f64; 2]| (value[0] - 1.0).hypot(value[1]);
            assert!(distance(values[1]) < distance(values[0]));
        }
    }

    let written = sandbox.riffel(&format!("{arguments} -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    let mut files: Vec<String> = ["contact", "patch"]
        .iter()
        .flat_map(|name| ["html", "png", "svg"].map(|kind| format!("{name}.{kind}")))
        .chain(["creep-curve.csv", "frequency-response.csv", "patch.csv", "summary.json"].map(str::to_owned))
        .collect();
    files.sort();
    assert_eq!(sandbox.list("out"), files);
    let (header, rows) = table(&sandbox, "out/creep-curve.csv");
    assert_eq!((header.len(), rows.len()), (1 + LAWS.len(), 2));
    assert_eq!(rows[1][0], "0.0005");
    let (header, rows) = table(&sandbox, "out/frequency-response.csv");
    assert_eq!(header[1..3], ["creepage_force_re", "creepage_force_im"]);
    assert_eq!((header.len(), rows.len()), (18, 2));
    let force: f64 = rows[0][1].parse().unwrap();
    let expected = response["creepage"]["force"][0][0].as_f64().unwrap();
    assert!((force / expected - 1.0).abs() < 1e-12);

    let (header, rows) = table(&sandbox, "out/patch.csv");
    assert_eq!(header, ["x_m", "y_m", "traction_longitudinal_pa", "traction_lateral_pa", "bound_pa", "slips"]);
    // A circle of 24 elements over its diameter.
    assert!((rows.len() as f64 - 144.0 * std::f64::consts::PI).abs() < 20.0);
    for row in &rows {
        let [along, across, bound]: [f64; 3] = [2, 3, 4].map(|cell| row[cell].parse().unwrap());
        assert!(along.hypot(across) <= bound * (1.0 + 1e-4));
        assert!(row[5] == "true" || row[5] == "false");
    }
}

/// CONTACT at τ = 0.1: at λ = 8a the force answers a creepage with 0.500 − 0.546i; the nominal creep
/// curve at 0.1 % is at 0.37718, and the paper's law up to 3 % below.
#[test]
fn contact_agrees_with_the_exact_theory() {
    let sandbox = Sandbox::new();
    let document = sandbox.json(&format!("{EXACT} --creepage 0.001 --ratio 8 --json"));
    let force = &document["frequency_response"]["creepage"]["force"][0];
    let (re, im) = (force[0].as_f64().unwrap(), force[1].as_f64().unwrap());
    let (modulus, phase) = (0.500f64.hypot(0.546), (-0.546f64).atan2(0.500));
    assert!((re.hypot(im) / modulus - 1.0).abs() < 0.03, "{re} {im}");
    assert!((im.atan2(re) - phase).abs() < 0.04, "{re} {im}");

    let distance = |document: &Value, law: &str| {
        let ratio = &document["creep_curve"]["tractive_ratio"][law][0];
        ratio.as_f64().unwrap() / 0.37718 - 1.0
    };
    assert!(distance(&document, "half-space").abs() < 0.007);
    // The paper's law goes with the paper's ellipse.
    let paper = sandbox.json(&format!("contact cases/nominal.toml {COARSE} --creepage 0.001 --ratio 8 --json"));
    let below = -distance(&paper, "carter-3d");
    assert!((0.01..0.03).contains(&below), "{below}");
}

/// Without --json the contact is printed, and the files lie in a folder named after the case.
#[test]
fn contact_is_readable() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.riffel(&format!("contact cases/nominal.toml {COARSE} --creepage 0.001 --ratio 8"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    for words in ["BR main line", "peak pressure", "C₁₁", "half-space"] {
        assert!(outcome.text.contains(words), "{words}\n{}", outcome.text);
    }
    assert!(sandbox.path("nominal-contact/contact.png").exists());
}

/// What the exact theory cannot answer is refused in words by every command, and nothing is written.
// Long: starts the program for every bad contact.
#[test]
fn non_steady_contacts_refuse_bad_input() {
    let sandbox = Sandbox::new();
    let case = format!("cases/nominal.toml {COARSE} --set contact.response=non-steady");
    for (command, arguments, words) in [
        ("map", "--set contact.tractive_ratio=1 -o out", "must be between 1e-6 and 0.999999"),
        ("map", "--set contact.normal_load=0 -o out", "`contact.normal_load` is 0 N, but must be between 1 N and 2 MN"),
        (
            "contact",
            "--set contact.normal_load=-1 -o out",
            "`contact.normal_load` is -1 N, but must be between 1 N and 2 MN",
        ),
        (
            "map",
            "--set contact.transverse_radius=-0.3 -o out",
            "`contact.transverse_radius` is -0.3 m, but must be between 1 mm and 10000 m",
        ),
        ("contact", "--set contact.transverse_radius=10km -o out", "beyond that the contact is a line contact"),
        (
            "map",
            "--set map.wavelength.min=0.002 -o out",
            "`map.wavelength.min`: wavelength is 0.002 m, but must be at least six elements",
        ),
        (
            "point",
            "--wavelength 2mm --speed 20",
            "--wavelength: wavelength is 0.002 m, but must be at least six elements",
        ),
        ("map", "--set contact.grid=17 -o out", "`contact.grid` is 17, but must be an even number"),
        ("map", "--set contact.grid=14 -o out", "`contact.grid` is 14, but must be an even number"),
    ] {
        let outcome = sandbox.riffel(&format!("{command} {case} {arguments}"));
        // Lines are broken at the width of a terminal.
        let text = outcome.text.replace("\n  │ ", " ");
        assert_eq!(outcome.status, Some(2), "{arguments}\n{text}");
        assert!(text.contains(words), "{arguments}\n{text}");
        assert_eq!(sandbox.list("."), ["cases"], "{arguments}");
    }
    // A wavelength outside the window of the map has an answer.
    let outcome = sandbox.riffel(&format!("point {case} --wavelength 0.2 --speed 20"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(!outcome.text.contains("NaN"), "{}", outcome.text);
}

/// Bad input is refused in words, and nothing is written.
#[test]
fn contact_refuses_bad_input() {
    let sandbox = Sandbox::new();
    let case = format!("contact cases/nominal.toml {COARSE} -o out");
    for (arguments, words) in [
        ("--creepage 0.001,0", "--creepage is 0, but must be greater than zero"),
        ("--creepage=-0.001", "--creepage is -0.001"),
        ("--creepage inf", "inf is not finite"),
        ("--creepage NaN", "NaN is not finite"),
        ("--ratio 8,0", "--ratio is 0, but must be greater than zero"),
        ("--ratio inf", "inf is not finite"),
        ("--ratio 0.2", "--ratio 0.2: wavelength is"),
        ("--set contact.tractive_ratio=1", "must be between 1e-6 and 0.999999"),
        ("--set contact.grid=17", "contact.grid"),
    ] {
        let outcome = sandbox.riffel(&format!("{case} {arguments}"));
        // Lines are broken at the width of a terminal.
        let text = outcome.text.replace("\n  │ ", " ");
        assert_eq!(outcome.status, Some(2), "{arguments}\n{text}");
        assert!(text.contains(words), "{arguments}\n{text}");
        assert_eq!(sandbox.list("."), ["cases"], "{arguments}");
    }
}

/// The nominal contact by the exact theory, as CONTACT has it; what is not asked for is asked for once.
const NON_STEADY: &str = "contact cases/nominal.toml --set contact.hertz=exact \
                          --set contact.response=non-steady --creepage 0.001 --json";

fn complex(value: &Value) -> [f64; 2] {
    serde_json::from_value(value.clone()).unwrap()
}

/// The document of a contact that creeps by a table.
fn creeping(sandbox: &Sandbox, arguments: &str, table: &str) -> Value {
    sandbox.json(&format!("{arguments} --set 'contact.creepage={table}'"))
}

/// Rows of a table of reference numbers, by the names of the columns.
fn reference(name: &str) -> Vec<HashMap<String, String>> {
    let path = root().join("validation/reference/contact").join(name);
    let text = fs::read_to_string(path).unwrap();
    let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    let mut lines = text.lines().map(cells);
    let header = lines.next().unwrap();
    let row = |cells: Vec<String>| header.iter().cloned().zip(cells).collect();
    lines.map(row).collect()
}

/// Creep forces, spin moment and energy per metre of CONTACT: 1 % of Q, the error of its extrapolation.
// Long: rolls the exact contact until it is steady, for four creepages.
#[test]
fn steady_state_in_any_direction() {
    let sandbox = Sandbox::new();
    let rows = reference("creep_forces_vector.csv");
    assert_eq!(rows.len(), 22);
    // The table of validation has them all.
    for row in rows.iter().step_by(7) {
        let number = |key: &str| -> f64 { row[key].parse().unwrap() };
        let table =
            format!("{{ longitudinal = {}, lateral = {}, spin = {} }}", row["xi"], row["eta"], row["phi_per_m"]);
        let document = creeping(&sandbox, &format!("{NON_STEADY} --ratio 50"), &table);
        let steady = &document["steady"];
        let [along, across] = complex(&steady["force_n"]).map(|force| force / 20e3);
        let error = (along - number("Fx_over_muP")).hypot(across - number("Fy_over_muP"));
        assert!(error < 0.01 * number("Q_over_muP"), "{table}: {error}");
        let moment = steady["spin_moment_nm"].as_f64().unwrap();
        let error = moment - number("Mz_Nm");
        assert!(error.abs() < 0.01 * moment.abs().max(5.0), "{table}: {error} Nm");
        let energy = steady["dissipation_j_per_m"].as_f64().unwrap();
        let error = energy / number("power_per_distance_N") - 1.0;
        assert!(error.abs() < 0.01, "{table}: {error}");
        assert!(document["frequency_response"]["spin"].is_object(), "{table}");
    }
}

/// Responses to both creepages about a lateral one as CONTACT has them over time, and the slow one to load as similarity
/// asks for it. Every response has an estimate of its error.
#[test]
fn responses_about_lateral_creepage() {
    let sandbox = Sandbox::new();
    let ratios = ["3", "4", "6", "8", "12", "20", "1e6"];
    let asked = format!("{NON_STEADY} --ratio {}", ratios.join(","));
    let document = creeping(&sandbox, &asked, "{ lateral = 0.00083 }");
    let response = &document["frequency_response"];
    let (slow, creepage, load) = (ratios.len() - 1, 0.00083, 50e3);
    let mut compared = 0;
    for row in reference("frequency_response_lateral.csv") {
        let (input, outputs): (&str, &[_]) = match &*row["input"] {
            "xi" => ("longitudinal_creepage", &[("HFx", "longitudinal_force")]),
            "eta" => ("lateral_creepage", &[("HFy", "lateral_force"), ("HW", "dissipation")]),
            // They contradict themselves, see the README of the validation.
            _ => continue,
        };
        let index = ratios.iter().position(|ratio| *ratio == row["L_over_a"]).unwrap();
        for (column, output) in outputs {
            let values = &response[input][output];
            let [re, im] = complex(&values[index]);
            let [quasi_static, _] = complex(&values[slow]);
            let expected = ["re", "im"].map(|part| -> f64 { row[&format!("{column}_{part}")].parse().unwrap() });
            let error = (re / quasi_static - expected[0]).hypot(im / quasi_static - expected[1]);
            assert!(error < 0.01, "{input} {output} {}: {error}", ratios[index]);
            let estimate = response["error"][input][output][index].as_f64().unwrap();
            assert!((1e-4..0.05).contains(&(estimate / quasi_static)), "{estimate}");
            compared += 1;
        }
    }
    assert_eq!(compared, 18);
    let [_, force] = complex(&document["steady"]["force_n"]);
    let [slope, _] = complex(&response["lateral_creepage"]["lateral_force"][slow]);
    let [by_load, _] = complex(&response["load"]["lateral_force"][slow]);
    let expected = (force - creepage * slope / 3.0) / load;
    assert!((by_load / expected - 1.0).abs() < 0.01, "{by_load} {expected}");
    // Slowly, what a point of the rail receives is what is dissipated.
    for input in ["lateral_creepage", "load"] {
        let [here, _] = complex(&response[input]["dissipation"][slow]);
        let [there, _] = complex(&response[input]["rail_dissipation"][slow]);
        assert!((here / there - 1.0).abs() < 1e-3, "{input}: {here} {there}");
    }
}

/// A contact that only spins has creep forces and responses, but closes no loop.
#[test]
fn spin_alone_is_a_contact_but_no_loop() {
    let sandbox = Sandbox::new();
    let table = "{ spin = 0.15 }";
    let coarse = "contact cases/nominal.toml --set contact.grid=24 --set contact.hertz=exact --ratio 8 --creepage 0.001 \
                  --json";
    let exact = creeping(&sandbox, &format!("{coarse} --set contact.creep_law=half-space"), table);
    let [along, across] = complex(&exact["steady"]["force_n"]);
    assert!((across / 20e3 / 0.13568 - 1.0).abs() < 0.02, "{across}");
    assert!(along.abs() < 1.0, "{along}");
    // A law that does not tell the moment does not tell what it dissipates.
    let by_fastsim = creeping(&sandbox, &format!("{coarse} --set contact.creep_law=fastsim"), table);
    let steady = &by_fastsim["steady"];
    assert!((complex(&steady["force_n"])[1] / across - 1.0).abs() < 0.1);
    assert_eq!(steady["spin_moment_nm"], Value::Null);
    assert_eq!(steady["dissipation_j_per_m"], Value::Null);
    assert_eq!(
        by_fastsim["frequency_response"], exact["frequency_response"],
        "that of the exact theory at the same creepages"
    );
    let outcome = sandbox.riffel(
        "point cases/nominal.toml --wavelength 0.05 --speed 20 --set contact.creep_law=fastsim \
         --set 'contact.creepage={ spin = 0.15 }'",
    );
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(outcome.text.contains("is spin alone"), "{}", outcome.text);
}

/// Every law says how it rolls; where the whole patch slips there is no response, and files without one are written.
#[test]
fn every_law_rolls_steadily() {
    let sandbox = Sandbox::new();
    let coarse = "contact cases/nominal.toml --set contact.grid=24 --ratio 8 --creepage 0.001 --json";
    for law in LAWS.into_iter().filter(|&law| law != "carter-2d") {
        let arguments = format!("{coarse} --set contact.creep_law={law}");
        let table = "{ longitudinal = 0.0005, lateral = -0.0005 }";
        let document = creeping(&sandbox, &arguments, table);
        let steady = &document["steady"];
        let [along, across] = complex(&steady["force_n"]);
        assert!(along > 0.0 && across < 0.0, "{law}: {along} {across}");
        let energy = steady["dissipation_j_per_m"].as_f64().unwrap();
        let work = 0.0005 * (along - across);
        assert!((energy / work - 1.0).abs() < 1e-9, "{law}: {energy} {work}");
        assert_eq!(steady["spin_moment_nm"].is_null(), law != "half-space", "{law}");
        assert!(document["frequency_response"]["load"].is_object(), "{law}");
    }
    // Where all slips the exact theory has its response too.
    let outcome = sandbox.riffel("contact cases/curve.toml --set contact.grid=24 --creepage 0.001 --ratio 8 -o out");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let files = sandbox.list("out");
    assert!(files.contains(&"frequency-response.csv".to_owned()));
}

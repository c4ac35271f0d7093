//! `riffel contact`, from the command line to the files.

use std::fs;

use serde_json::Value;

use crate::sandbox::Sandbox;

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
    for key in [
        "semi_axis_longitudinal_m",
        "semi_axis_lateral_m",
        "approach_m",
        "peak_pressure_pa",
        "stiffness_n_per_m",
    ] {
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
        .chain(["creep-curve.csv", "frequency-response.csv", "patch.csv"].map(str::to_owned))
        .collect();
    files.sort();
    assert_eq!(sandbox.list("out"), files);
    let (header, rows) = table(&sandbox, "out/creep-curve.csv");
    assert_eq!((header.len(), rows.len()), (1 + LAWS.len(), 2));
    assert_eq!(rows[1][0], "0.0005");
    let (header, rows) = table(&sandbox, "out/frequency-response.csv");
    assert_eq!(header[1..3], ["creepage_force_re", "creepage_force_im"]);
    assert_eq!((header.len(), rows.len()), (13, 2));
    let force: f64 = rows[0][1].parse().unwrap();
    let expected = response["creepage"]["force"][0][0].as_f64().unwrap();
    assert!((force / expected - 1.0).abs() < 1e-12);

    let (header, rows) = table(&sandbox, "out/patch.csv");
    assert_eq!(
        header,
        [
            "x_m",
            "y_m",
            "traction_longitudinal_pa",
            "traction_lateral_pa",
            "bound_pa",
            "slips"
        ]
    );
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
    let paper = sandbox.json(&format!(
        "contact cases/nominal.toml {COARSE} --creepage 0.001 --ratio 8 --json"
    ));
    let below = -distance(&paper, "carter-3d");
    assert!((0.01..0.03).contains(&below), "{below}");
}

/// Without --json the contact is printed, and the files lie in a folder named after the case.
#[test]
fn contact_is_readable() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.riffel(&format!(
        "contact cases/nominal.toml {COARSE} --creepage 0.001 --ratio 8"
    ));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    for words in ["BR main line", "peak pressure", "C₁₁", "half-space"] {
        assert!(outcome.text.contains(words), "{words}\n{}", outcome.text);
    }
    assert!(sandbox.path("nominal-contact/contact.png").exists());
}

/// What the exact theory cannot answer is refused in words by every command, and nothing is written.
#[test]
fn non_steady_contacts_refuse_bad_input() {
    let sandbox = Sandbox::new();
    let case = format!("cases/nominal.toml {COARSE} --set contact.response=non-steady");
    for (command, arguments, words) in [
        (
            "map",
            "--set contact.creepage=2% -o out",
            "but must be so small that the tractive ratio",
        ),
        (
            "map",
            "--set contact.tractive_ratio=0.995 -o out",
            "nearer to full slip there is no slope",
        ),
        (
            "map",
            "--set contact.normal_load=0 -o out",
            "`contact.normal_load` is 0 N, but must be between 1 N and 2 MN",
        ),
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
        (
            "contact",
            "--set contact.transverse_radius=10km -o out",
            "beyond that the contact is a line contact",
        ),
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
        (
            "map",
            "--set contact.grid=17 -o out",
            "`contact.grid` is 17, but must be an even number",
        ),
        (
            "map",
            "--set contact.grid=14 -o out",
            "`contact.grid` is 14, but must be an even number",
        ),
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
        (
            "--creepage 0.001,0",
            "--creepage is 0, but must be greater than zero",
        ),
        ("--creepage=-0.001", "--creepage is -0.001"),
        ("--creepage inf", "inf is not finite"),
        ("--creepage NaN", "NaN is not finite"),
        ("--ratio 8,0", "--ratio is 0, but must be greater than zero"),
        ("--ratio inf", "inf is not finite"),
        ("--ratio 0.2", "--ratio 0.2: wavelength is"),
        (
            "--set contact.tractive_ratio=0.995",
            "the tractive ratio of the case is 0.9950",
        ),
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

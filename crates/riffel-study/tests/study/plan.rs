//! Plans, good and bad.

use proptest::prelude::*;

use crate::{PLAN, folder_with, read, study_of};

/// The sentence of a plan that is refused.
fn sentence(plan: &str) -> String {
    let folder = folder_with(plan);
    match read(folder.path()) {
        Ok(_) => panic!("the plan is accepted:\n{plan}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn the_example_reads() {
    let study = study_of(riffel_study::STUDY);
    assert_eq!(study.samples(), 1024);
    assert_eq!(study.parameters().len(), 4);
}

#[test]
fn a_bad_plan_is_refused_with_a_sentence() {
    for row in [
        "seed = 4 => sed = 4 => `design.sed` is not a key Riffel knows",
        "contact.friction => contact.frction => `parameter[0].key` is \"contact.frction\", but the case file has no such key",
        "wheel.mass => contact.friction => `parameter[1].key` is \"contact.friction\" a second time",
        "min = 0.2 => min = -0.2 => `contact.friction` is -0.2, but must be between 0.001 and 1.5",
        "min = 0.2 => min = 0.6 => `parameter[0].uniform.max` is 0.5, but must be above the min of 0.6",
        "\"200 kg\" => \"200 kN\" => `parameter[1].normal.min`: \"200 kN\" is in kg m s-2, not a mass in kg; write it as in \"350 kg\"",
        "\"40 kg\" => 0 => `parameter[1].normal.standard_deviation` is 0, but must be greater than zero",
        "\"200 kg\" => \"20 t\" => `parameter[1].normal`: leaves nothing between its ends: they are more than 30 standard deviations away",
        "\"54E1\" => \"54E9\" => `rail.section` is \"54E9\", but no rail preset has that name",
        "\"54E1\" => \"60E1\" => `parameter[2].values`: holds 60E1 twice",
        "values = [\"60E1\", \"BS113A\", \"54E1\"] => values = [] => `parameter[2].values` is empty, but must hold a value",
        "values = [\"60E1\", \"BS113A\", \"54E1\"] => uniform = { min = 1, max = 2 } => `parameter[2].uniform` is for quantities, but `rail.section` takes a choice, a name or a whole number",
        "uniform = { min = 0.2, max = 0.5 } =>  => `parameter[0].values` is missing",
        "uniform = { min = 0.2, max = 0.5 } => values = [0.2]\nuniform = { min = 0.2, max = 0.5 } => `parameter[0].uniform` and `parameter[0].values` exclude each other",
        "\"latin-hypercube\" => \"latin\" => `design.method`: \"latin\" is not one of its choices",
        "\"latin-hypercube\" => \"grid\" => `design.samples` is given, but a grid has as many samples as its parameters have combinations",
        "\"latin-hypercube\"\nsamples = 23 => \"grid\" => `parameter[0]`: `contact.friction` has a distribution, but a grid takes values or a range",
        "samples = 23 =>  => `design.samples` is missing",
        "samples = 23 => samples = 0 => `design.samples` is 0, but must be at least 1",
        "samples = 23 => samples = 1000000000000 => `design.samples` is 1000000000000: they are more than the 100000000 of the largest study",
        "samples = 23 => samples = 90000000 => `outputs`: 90000000 samples of 4152 bytes make 373.7 GB",
        "samples_per_chunk = 4 => samples_per_chunk = 0 => `results.samples_per_chunk` is 0, but must be between 1 and 1000000",
        "\"nominal.toml\" => \"other.toml\" => `case`: cannot read ",
        "points = 31 => points = 1 => `map.wavelength.points` is 1, but must be between 2 and 100000",
        "key = \"wheel.mass\"\nnormal = { mean = \"350 kg\", standard_deviation = \"40 kg\", min = \"200 kg\" } => key = \"map.speed.max\"\nvalues = [40] => `parameter[1].key` is \"map.speed.max\", but the window of the map gives the results their axes and cannot vary",
        "quantities = [\"normal_force_n\" => quantities = [\"normal_force\" => `outputs.point[0].quantities[0]`: \"normal_force\" is not one of its choices",
        "\"55 mm\" => \"-55 mm\" => `outputs.point[0].wavelength` is -55 mm, but must be between 100 µm and 10 m",
        "[results] => [[outputs.wave]]\nwavelength = \"55 mm\"\namplitude = \"60 um\"\nspeed = 30\nquantities = [\"amplitude_m\"]\n[results] => `outputs.wave[0].quantities`: asks for amplitude_m, but no passages are given",
        "[results] => [[outputs.wave]]\nwavelength = \"55 mm\"\namplitude = \"60 m\"\nspeed = 30\nquantities = [\"mean_creepage\"]\n[results] => `outputs.wave[0].amplitude` is 60 m, but must be between",
    ] {
        let [good, bad, expected] = row.split(" => ").collect::<Vec<_>>()[..] else { panic!("{row}") };
        assert!(PLAN.contains(good), "{good}");
        if expected.contains("373.7 GB") {
            // Large, and still within bounds.
            study_of(&PLAN.replace(good, bad));
            continue;
        }
        let sentence = sentence(&PLAN.replace(good, bad));
        assert!(sentence.starts_with(expected), "{sentence}");
    }
}

#[test]
fn a_terabyte_is_too_much() {
    let large = PLAN.replace("samples = 23", "samples = 90000000").replace("points = 31", "points = 241");
    let sentence = sentence(&large);
    assert!(sentence.contains("TB, more than the terabyte of the largest study"), "{sentence}");
}

#[test]
fn a_grid_of_a_million_million_points_is_refused_with_its_size() {
    let plan = r#"
case = "nominal.toml"
design.method = "grid"
outputs.ridge = true
[[parameter]]
key = "contact.friction"
range = { min = 0.2, max = 0.5, points = 1000000 }
[[parameter]]
key = "wheel.mass"
range = { min = "200 kg", max = "500 kg", points = 1000000 }
"#;
    assert_eq!(
        sentence(plan),
        "`parameter`: 1000000 of contact.friction × 1000000 of wheel.mass make a grid of 1 000 000 000 000 samples, \
         more than the 100000000 of the largest study"
    );
}

#[test]
fn a_bad_correlation_is_refused() {
    for row in [
        "coefficient = 1.5 => `correlation[0].coefficient` is 1.5, but must be between -1 and 1, both excluded",
        "between = [\"contact.friction\", \"wheel.radius\"] => `correlation[0].between`: names \"wheel.radius\", which is not the key of a parameter",
        "between = [\"contact.friction\", \"rail.section\"] => `correlation[0].between`: names \"rail.section\", but only parameters with a distribution vary together",
        "between = [\"contact.friction\", \"contact.friction\"] => `correlation[0].between`: names the same key twice",
    ] {
        let (line, expected) = row.split_once(" => ").unwrap();
        let good = ["between = [\"contact.friction\", \"wheel.mass\"]", "coefficient = 0.5"];
        let other = if line.starts_with("between") { good[1] } else { good[0] };
        let plan = format!("{PLAN}\n[[correlation]]\n{other}\n{line}\n");
        assert_eq!(sentence(&plan), expected);
    }
}

#[test]
fn correlations_are_not_for_grids_and_saltelli() {
    let correlation = "\n[[correlation]]\nbetween = [\"contact.friction\", \"wheel.mass\"]\ncoefficient = 0.5\n";
    let plan = PLAN.replace("latin-hypercube", "saltelli") + correlation;
    assert!(sentence(&plan).contains("Sobol indices are those of independent parameters"));
}

#[test]
fn a_matrix_that_is_none_is_refused() {
    let plan = PLAN.replace(
        "key = \"rail.section\"\nvalues = [\"60E1\", \"BS113A\", \"54E1\"]",
        "key = \"contact.tractive_ratio\"\nuniform = { min = 0.1, max = 0.4 }",
    ) + r#"
[[correlation]]
between = ["contact.friction", "wheel.mass"]
coefficient = 0.9
[[correlation]]
between = ["wheel.mass", "contact.tractive_ratio"]
coefficient = 0.9
[[correlation]]
between = ["contact.tractive_ratio", "contact.friction"]
coefficient = -0.9
"#;
    let sentence = sentence(&plan);
    assert!(sentence.contains("the matrix of the coefficients is not positive definite"), "{sentence}");
}

#[test]
fn a_tail_that_the_case_refuses_is_a_remark() {
    let plan = PLAN.replace("min = \"200 kg\"", "max = \"900 kg\"").replace("\"40 kg\"", "\"150 kg\"");
    let remarks = study_of(&plan).plan.remarks;
    let about = |remark: &String| remark.starts_with("one value of wheel.mass in a thousand is beyond -");
    assert!(remarks.iter().any(about), "{remarks:?}");
}

/// The fingerprint follows the keys: not comments, titles or the place of the case.
#[test]
fn fingerprints_tell_plans_apart() {
    let plain = study_of(PLAN).fingerprint;
    assert_eq!(plain, study_of(&format!("title = \"x\" # and a comment\n{PLAN}")).fingerprint);
    assert_ne!(plain, study_of(&PLAN.replace("seed = 4", "seed = 5")).fingerprint);
    let folder = folder_with(PLAN);
    let case = riffel_case::NOMINAL_CASE.replace("normal_load = \"50 kN\"", "normal_load = \"51 kN\"");
    std::fs::write(folder.path().join("nominal.toml"), case).unwrap();
    assert_ne!(plain, read(folder.path()).unwrap().fingerprint);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Whatever stands in the place of a value: an answer, no panic.
    #[test]
    fn no_value_makes_a_plan_panic(value in "-?[0-9]{1,3}(e-?[0-9]{1,3})?|\"[a-z0-9 /%]{0,8}\"|true|nan|-?inf|\\[\\]|\\{\\}", place in 0usize..9) {
        let places = ["0.2", "0.5", "\"350 kg\"", "\"40 kg\"", "\"200 kg\"", "\"54E1\"", "\"55 mm\"", "\"108 km/h\"", "23"];
        let folder = folder_with(&PLAN.replacen(places[place], &value, 1));
        let _ = read(folder.path());
    }
}

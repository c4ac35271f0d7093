//! Whether chains by the default settings end with a conclusion, on problems that are drawn.

use std::fs;
use std::path::Path;

use riffel_study::Stop;

use crate::folder::Folder;
use crate::plan::Plan;
use crate::simulated::simulate;

const PROBLEMS: u64 = 20;
const SEEDS: u64 = 4;
/// What may be uncertain, beside the size of what the model misses.
const VALUES: [&str; 8] = [
    "key = \"wear.coefficient\"\nlognormal = { median = 2.5e-9, factor = 2.0 }",
    "key = \"track.pad.stiffness\"\nlognormal = { median = \"300 MN/m\", factor = 2.0 }",
    "key = \"vehicle.traction_share\"\nuniform = { min = 0.05, max = 0.95 }",
    "key = \"vehicle.speed.mean\"\nnormal = { mean = \"110 km/h\", standard_deviation = \"8 km/h\" }",
    "key = \"vehicle.tractive_ratio\"\nlognormal = { median = 0.15, factor = 1.5 }",
    "key = \"wheel.mass\"\nlognormal = { median = \"450 kg\", factor = 1.15 }",
    "key = \"track.pad.loss_factor\"\nlognormal = { median = 0.2, factor = 1.6 }",
    "key = \"track.ballast.stiffness\"\nlognormal = { median = \"60 MN/m\", factor = 1.8 }",
];

/// The plan of a problem: two to nine values, begun at another one each time, the levels of three bands at two to four dates, and
/// one speed.
pub(crate) fn plan(folder: &Path, problem: u64) -> Plan {
    let set = crate::fixtures::folder("b-three-dates");
    fs::copy(set.join("case.toml"), folder.join("case.toml")).unwrap();
    let traffic = fs::read_to_string(set.join("traffic.toml")).unwrap();
    let one_speed = traffic.replace("standard_deviation = \"8 km/h\"", "standard_deviation = \"0 km/h\"");
    fs::write(folder.join("traffic.toml"), one_speed).unwrap();
    let mut table = "passages,wavelength_mm,level_db,standard_error_db\n".to_owned();
    for date in 0..2 + problem % 3 {
        for wavelength in [160, 80, 50] {
            table += &format!("{},{wavelength},0,0.5\n", 1_000_000 * date);
        }
    }
    fs::write(folder.join("levels.csv"), table).unwrap();
    let mut text = "case = \"case.toml\"\ntraffic = \"traffic.toml\"\n".to_owned();
    let first = problem / 8;
    for value in first..first + 1 + problem % 8 {
        text += &format!("[[parameter]]\n{}\n", VALUES[value as usize % VALUES.len()]);
    }
    text += "[[data]]\nname = \"growth\"\nkind = \"dated-levels\"\nfile = \"levels.csv\"\n\
        discrepancy = { kind = \"gaussian-process\", standard_deviation = { half_normal = 1.0 } }\n";
    fs::write(folder.join("plan.toml"), text).unwrap();
    Plan::read(&folder.join("plan.toml")).unwrap()
}

/// Truth and data of 20 problems are drawn from their priors, and each is calibrated by the default settings with four seeds: of the
/// 80 calibrations 76 and more end with a conclusion, after having gone on by themselves where need be.
#[test]
#[ignore = "80 calibrations take minutes"]
fn drawn_problems_end_with_a_conclusion() {
    let mut doubted = Vec::new();
    for seed in 1..=SEEDS {
        for problem in 0..PROBLEMS {
            let there = tempfile::tempdir().unwrap();
            let mut plan = plan(there.path(), problem);
            (_, plan.posterior) = simulate(&plan.posterior, 1, problem).unwrap();
            plan.file.sampler.seed = seed;
            let folder = Folder::begin(&plan, &there.path().join("out"), false).unwrap();
            let chains = folder.run(&|_| (), &Stop::default()).unwrap().unwrap();
            let summary = chains.summary(&plan);
            let doubts: Vec<String> = summary.doubts().iter().map(ToString::to_string).collect();
            if !doubts.is_empty() {
                doubted.push((problem, seed, doubts));
            }
        }
    }
    assert!(20 * doubted.len() as u64 <= PROBLEMS * SEEDS, "{doubted:?}");
}

//! Profiles of the same place at several dates.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};
use riffel::Complex64;
use riffel_calibrate::Plan;
use riffel_case::Case;
use tempfile::TempDir;

use crate::folder;

const SPACING: f64 = 3e-3;
const LENGTH: f64 = 60.0;
const PASSAGES: [f64; 3] = [0.0, 2e6, 3.5e6];
/// Waves beyond the window of the set, 36 to 220 mm, at both ends.
const WAVES: [f64; 2] = [0.03, 0.3];
/// Of the traffic of the set.
const SPEEDS: (f64, f64) = (110.0 / 3.6, 8.0 / 3.6);
const TRACTION_SHARE: f64 = 0.5;

/// Growth of the complex amplitude per axle in the mean over a normal distribution of speeds.
fn growth(case: &Case, wavelength: f64) -> Complex64 {
    let nodes = (0..17).map(|k| 0.5 * f64::from(k) - 4.0);
    let weight = |t: f64| if t.abs() == 4.0 { 0.5 } else { 1.0 } * (-0.5 * t * t).exp();
    let all: f64 = nodes.clone().map(weight).sum();
    let rates = nodes.map(|t| {
        let rate = |speed: f64| case.feedback.complex_growth_rate(wavelength, speed);
        weight(t) / all * rate(SPEEDS.0 + SPEEDS.1 * t)
    });
    TRACTION_SHARE * rates.sum::<Complex64>()
}

/// Wavelengths of a rail \[m\], and how they grow under the case of the truth.
static WAVES_THAT_GROW: LazyLock<Vec<(f64, Complex64)>> = LazyLock::new(|| {
    let case = truth();
    let [most, fewest] = WAVES.map(|wavelength| (LENGTH / wavelength) as usize);
    let wavelengths = (fewest..=most).map(|line| LENGTH / line as f64);
    wavelengths.map(|wavelength| (wavelength, growth(&case, wavelength))).collect()
});

/// Heights \[µm\] at all dates of one rail whose waves grow as the case of the truth says, each date with noise of its own.
fn rail(seed: u64, noise: f64) -> Vec<Vec<f64>> {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
    let mut uniform = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
    let mut normal = || (-2.0 * uniform().max(1e-300).ln()).sqrt() * (TAU * uniform()).cos();
    let count = (LENGTH / SPACING) as usize;
    let mut dates = vec![vec![0.0; count]; PASSAGES.len()];
    for &(wavelength, grows) in WAVES_THAT_GROW.iter() {
        let first = Complex64::new(normal(), normal());
        let step = Complex64::from_polar(1.0, TAU * SPACING / wavelength);
        for (heights, passages) in dates.iter_mut().zip(PASSAGES) {
            let own = noise * Complex64::new(normal(), normal());
            let mut wave = 0.2 * (first * (passages * grows).exp() + own);
            for height in heights {
                *height += wave.re;
                wave *= step;
            }
        }
    }
    dates
}

/// A plan of set b with these profiles in place of its levels.
fn plan(to: &Path, rails: &[Vec<f64>], keys: &str) -> Result<Plan, String> {
    crate::copy_set("b-three-dates", to);
    let mut table = "passages,profile\n".to_owned();
    for ((date, heights), passages) in rails.iter().enumerate().zip(PASSAGES) {
        // Counted since the line was opened.
        _ = writeln!(table, "{},profile-{date}.csv", 1e6 + passages);
        let rows = heights.iter().enumerate();
        let rows = rows.map(|(row, height)| format!("{:.4},{height:.5}\n", SPACING * row as f64));
        let text = format!("position_m,height_um\n{}", rows.collect::<String>());
        fs::write(to.join(format!("profile-{date}.csv")), text).unwrap();
    }
    fs::write(to.join("profiles.csv"), table).unwrap();
    let plan = format!(
        "case = \"case.toml\"\ntraffic = \"traffic.toml\"\n\
         [[parameter]]\nkey = \"track.pad.stiffness\"\nlognormal = {{ median = \"300 MN/m\", factor = 2 }}\n\
         [[parameter]]\nkey = \"wear.coefficient\"\nlognormal = {{ median = 2.5e-9, factor = 2 }}\n\
         [[data]]\nkind = \"dated-profiles\"\nfile = \"profiles.csv\"\n{keys}\
         discrepancy = {{ kind = \"gaussian-process\", standard_deviation = {{ half_normal = 1.0 }} }}\n"
    );
    fs::write(to.join("plan.toml"), plan).unwrap();
    Plan::read(&to.join("plan.toml")).map_err(|error| error.to_string())
}

fn truth() -> Case {
    let path = folder("b-three-dates").join("case.toml");
    let overrides = ["contact.tractive_ratio=0.15", "track.pad.stiffness=240e6"];
    Case::read(&path, &overrides.map(str::to_owned)).unwrap()
}

/// ln likelihood at a pad stiffness, the wear coefficient as it is, no discrepancy.
fn at(plan: &Plan, stiffness: f64) -> f64 {
    let likelihood = plan.posterior.log_likelihood(&[stiffness, 2.5e-9, 1e-6]);
    likelihood.unwrap()[0].1
}

/// What is predicted of waves that grew by the same case lies off by as much as noise makes it; another pad is far less likely. What
/// is left is windows and the noise of the first date, which tells growth low by half its variance.
// Long: reads profiles of 60 m of six rails at three dates, as many as its bounds are of.
#[test]
fn profiles_that_grew_by_the_case_are_those_it_expects() {
    let (mut squares, mut count) = (0.0, 0.0);
    for seed in 0..6 {
        let to = TempDir::new().unwrap();
        let plan = plan(to.path(), &rail(seed, 0.1), "travel = \"rising\"\n").unwrap();
        let values = [240e6, 2.5e-9, 1e-6];
        let predicted = &plan.posterior.predictions(&values).unwrap()[0];
        let observed = &plan.posterior.observed()[0];
        // Growth; drift is known up to a shift of the record.
        let growth = predicted.iter().zip(observed).take(observed.len() / 2);
        for (predicted, observed) in growth {
            squares += (predicted - observed).powi(2);
            count += 1.0;
        }
        let best = at(&plan, 240e6);
        for other in [180e6, 320e6] {
            assert!(best > at(&plan, other) + 5.0, "{seed}: {other}");
        }
    }
    // Noise of a tenth in some 50 segments: 0.1·√2/√100 = 0.014 Np before growth makes it less.
    let off = (squares / count).sqrt();
    assert!(off > 2e-3 && off < 0.03, "{off} of {count}");
}

/// A rail measured against the direction of travel says the same, and without a direction only how waves grow.
// Long: reads profiles of 60 m at three dates, four times.
#[test]
fn the_direction_of_travel_turns_the_drift() {
    let rails = rail(11, 0.1);
    let to = TempDir::new().unwrap();
    let rising = plan(to.path(), &rails, "travel = \"rising\"\n").unwrap();
    let turned: Vec<Vec<f64>> = (rails.iter()).map(|heights| heights.iter().rev().copied().collect()).collect();
    let back = TempDir::new().unwrap();
    let falling = plan(back.path(), &turned, "travel = \"falling\"\n").unwrap();
    let wrong = plan(back.path(), &turned, "travel = \"rising\"\n").unwrap();
    let [expected, same, other] = [&rising, &falling, &wrong].map(|plan| at(plan, 240e6));
    // Segments begin at the other end, and see other parts of the noise.
    let wrong = expected - other;
    assert!(wrong > 20.0, "{expected} {other}");
    assert!((expected - same).abs() < 0.1 * wrong, "{expected} {same} {other}");
    let alone = plan(to.path(), &rails, "").unwrap();
    let count = |plan: &Plan| plan.posterior.observed()[0].len();
    assert_eq!(2 * count(&alone), count(&rising));
}

/// A rail that was ground before the second date, to a third: growth is that since then; before the third nothing is known of it.
// Long: reads nine profiles of 21 m.
#[test]
fn growth_of_profiles_begins_anew_where_the_rail_was_ground() {
    // A third of its length is as much as tells.
    let grown: Vec<Vec<f64>> = rail(3, 0.1).into_iter().map(|heights| heights[..7000].to_vec()).collect();
    let ground = |from: usize| -> Vec<Vec<f64>> {
        let cut = |(date, heights): (usize, &Vec<f64>)| {
            let factor = if date >= from { 1.0 / 3.0 } else { 1.0 };
            heights.iter().map(|height| factor * height).collect()
        };
        grown.iter().enumerate().map(cut).collect()
    };
    let to = TempDir::new().unwrap();
    let since = plan(to.path(), &ground(1), "").unwrap();
    let told: Vec<String> = since.remarks.iter().map(ToString::to_string).collect();
    let told = told.join("\n");
    assert!(told.contains("before the date of 3000000 passages") && told.contains("was ground"), "{told}");
    let all = plan(to.path(), &grown, "").unwrap();
    let count = |plan: &Plan| plan.posterior.observed()[0].len();
    assert!(3 * count(&since) < 2 * count(&all), "{} {}", count(&since), count(&all));
    // A wear coefficient of the truth is likelier than none.
    let at = |coefficient: f64| {
        let likelihood = since.posterior.log_likelihood(&[240e6, coefficient, 1e-6]);
        likelihood.unwrap()[0].1
    };
    assert!(at(2.5e-9) > at(2.5e-12) + 5.0);
    let refusal = plan(to.path(), &ground(2), "").map(|_| ()).unwrap_err();
    assert!(refusal.contains("no later date tells of growth"), "{refusal}");
}

// Long: writes and reads profiles of 60 m for nine plans.
#[test]
fn profiles_that_cannot_be_used_are_said() {
    let rails = rail(5, 0.1);
    let refusal = |rails: &[Vec<f64>], keys: &str| {
        let to = TempDir::new().unwrap();
        plan(to.path(), rails, keys).map(|_| ()).unwrap_err()
    };
    for (rails, keys, parts) in [
        (&rails[..1], "", &["profiles.csv", "one date"][..]),
        (&rails[..], "travel = \"north\"\n", &["data[0].travel", "north", "rising"]),
        (&rails[..], "rail = \"left\"\n", &["profile-0.csv", "rails", "`rail`"]),
        (&rails[..], "averages = 3\n", &["data[0].averages", "dated-profiles"]),
    ] {
        let refusal = refusal(rails, keys);
        for part in parts {
            assert!(refusal.contains(part), "{part} not in: {refusal}");
        }
    }
    let short: Vec<Vec<f64>> = rails.iter().map(|heights| heights[..2000].to_vec()).collect();
    let short = refusal(&short, "");
    assert!(short.contains("36 longest waves"), "{short}");
    let another = [rails[0].clone(), rail(6, 0.1).swap_remove(1)];
    let another = refusal(&another, "");
    assert!(another.contains("no wave in common"), "{another}");
    // A table that names files elsewhere, as one that was sent to a server might.
    for elsewhere in ["/etc/hostname", "../profile-1.csv"] {
        let to = TempDir::new().unwrap();
        plan(to.path(), &rails, "").unwrap();
        let table = format!("passages,profile\n0,profile-0.csv\n2e6,{elsewhere}\n");
        fs::write(to.path().join("profiles.csv"), table).unwrap();
        let refusal = Plan::read(&to.path().join("plan.toml")).map(|_| ()).unwrap_err();
        assert!(refusal.to_string().contains("beside the table"), "{refusal}");
    }
}

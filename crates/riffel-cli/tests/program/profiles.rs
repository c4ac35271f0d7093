//! Files of profiles, their wear, and what follows from them.

use serde_json::Value;

use crate::sandbox::{Sandbox, root};

/// Files of the formats of devices and programs.
const FORMATS: &str = "crates/riffel-rail/tests/profiles";

fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    for name in ["rail.ban", "rail.rai", "wheel.whl", "wheel.prw"] {
        std::fs::copy(root().join(FORMATS).join(name), sandbox.path(name)).unwrap();
    }
    sandbox
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// A worn wheel and rail by program: areas and dimensions of their polygons, which were computed by hand (shoelace formula, 62.36 and
/// 107.48 mm²). The tolerance of 1 % is that of straight chords a millimetre long, and of the end of the flank.
#[test]
fn wear_is_that_of_the_polygons() {
    let sandbox = sandbox();
    let document = sandbox.json("profile cases/worn-wheel.csv --against S1002 --json");
    assert_eq!(document["alignment"], "flange");
    let worn = &document["profiles"][0];
    let off = |key: &str, expected: f64| number(&worn[key]) / expected - 1.0;
    assert!(off("area_m2", 62.36e-6).abs() < 0.01, "{worn}");
    assert!(off("flange_height_m", 29.5e-3).abs() < 1e-3);
    assert!(off("tread_wear_m", 1.5e-3).abs() < 1e-2);
    assert!(off("flange_thickness_m", 31.556e-3).abs() < 1e-3);
    let document = sandbox.json("profile cases/worn-rail.csv --against 60E1 --json");
    assert_eq!(document["alignment"], "field-side");
    let rail = &document["profiles"][0];
    assert!((number(&rail["shift_x_m"]) + 3e-3).abs() < 5e-6, "{}", rail["shift_x_m"]);
    assert!((number(&rail["area_m2"]) / 107.48e-6 - 1.0).abs() < 0.01);
    assert!((number(&rail["w2_m"]) - 3e-3).abs() < 5e-6);
    // The table has what the document has.
    let written = sandbox.riffel("profile cases/worn-wheel.csv --against S1002 -o out");
    assert_eq!(written.status, Some(0), "{}", written.text);
    assert!(written.text.contains("31.55"), "{}", written.text);
    let table = std::fs::read_to_string(sandbox.path("out/wear.csv")).unwrap();
    let deepest =
        table.lines().skip(1).filter_map(|line| line.rsplit(',').next()?.parse::<f64>().ok()).fold(0.0, f64::max);
    assert!((1e-3 * deepest - number(&worn["greatest_depth_m"])).abs() < 1e-12);
}

/// A rail without points from 10 to 26 mm below its crown has no W2, and says so; W1 and W3 are those of the whole.
#[test]
fn measures_over_a_gap_are_not_told() {
    let sandbox = sandbox();
    let text = std::fs::read_to_string(sandbox.path("cases/worn-rail.csv")).unwrap();
    let is_kept = |line: &&str| {
        let point = line.split_once(',').map(|(x, y)| (x.parse::<f64>(), y.parse::<f64>()));
        !matches!(point, Some((Ok(x), Ok(y))) if x < 0.0 && (-24.5..-8.0).contains(&y))
    };
    let kept: Vec<&str> = text.lines().filter(is_kept).collect();
    std::fs::write(sandbox.path("gap.csv"), kept.join("\n")).unwrap();
    let of = |file: &str| sandbox.json(&format!("profile {file} --against 60E1 --json"));
    let (whole, gap) = (of("cases/worn-rail.csv"), of("gap.csv"));
    let measure = |document: &Value, key: &str| document["profiles"][0][key].as_f64();
    assert_eq!(measure(&gap, "w2_m"), None);
    for key in ["w1_m", "w3_m"] {
        let [whole, gap] = [&whole, &gap].map(|document| measure(document, key).unwrap());
        // The curve bends beside the gap.
        assert!((whole - gap).abs() < 2e-5, "{key}: {whole} {gap}");
    }
    let told = gap["remarks"].to_string();
    assert!(told.contains("W2 is not told: the points have a gap"), "{told}");
}

/// Measured points end before the nominal flange does: the shifts that nobody listed go as far as both wheels touch, in one piece;
/// one that was listed is refused.
#[test]
fn the_usual_shifts_go_as_far_as_both_wheels_touch() {
    let sandbox = sandbox();
    let worn = "profile cases/profiles.toml --wheelset --set profiles.wheel=worn-wheel.csv";
    let document = sandbox.json(&format!("{worn} --json"));
    let shifts: Vec<f64> = document["lateral_shift"].as_array().unwrap().iter().map(number).collect();
    assert!((100..201).contains(&shifts.len()), "{}", shifts.len());
    let steps = shifts.windows(2).map(|pair| pair[1] - pair[0]);
    assert!(steps.into_iter().all(|step| (step - 1e-4).abs() < 1e-12));
    let refused = sandbox.riffel(&format!("{worn} --lateral-shift=-9.4mm"));
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    assert!(refused.text.contains("does not touch its rail"), "{}", refused.text);
}

/// A wheel in the format of a device runs on a rail in another, as the nominal ones do.
#[test]
fn files_of_devices_run_in_a_curve() {
    let sandbox = sandbox();
    let shift = |profiles: &str| {
        let document =
            sandbox.json(&format!("profile cases/profiles.toml --wheelset --lateral-shift \"2 mm\" {profiles} --json"));
        number(&document["rolling_radius_difference"][0])
    };
    let of_files = shift("--set profiles.wheel=../wheel.prw --set profiles.rail=../rail.rai");
    // Points have tenths of a micrometre and contacts lie where profiles are nearly parallel.
    assert!((of_files / shift("") - 1.0).abs() < 0.02, "{of_files}");
}

/// Sentences of what cannot run, with key or file and line.
#[test]
fn what_cannot_run_is_refused() {
    let sandbox = sandbox();
    let rail = std::fs::read_to_string(sandbox.path("rail.ban")).unwrap();
    let mut lines: Vec<&str> = rail.lines().collect();
    lines.swap(20, 40);
    std::fs::write(sandbox.path("swapped.ban"), lines.join("\n")).unwrap();
    let first = lines.iter().find(|line| line.starts_with("  ")).unwrap();
    lines.push(first);
    std::fs::write(sandbox.path("closed.ban"), lines.join("\n")).unwrap();
    let wheelset = "profile cases/profiles.toml --wheelset";
    for (command, sentence) in [
        ("profile swapped.ban".to_owned(), "swapped.ban, line"),
        ("profile closed.ban".to_owned(), "closed.ban, line"),
        (format!("{wheelset} --set profiles.gauge=1400mm"), "the wheelset is 1425.0 mm wide over its flanges"),
        (format!("{wheelset} --set profiles.gauge=3m"), "do not stand on both rails"),
        (format!("{wheelset} --set profiles.flange_back_distance=1600mm"), "does not go between such rails"),
        (format!("{wheelset} --set profiles.wheel=60E1"), "is \"60E1\", which is a rail"),
        (
            format!("{wheelset} --set profiles.wheel=../rail.rai"),
            "is the profile of a rail by what it says, but a wheel is asked for",
        ),
        (
            format!("{wheelset} --set profiles.wheel=../wheel.prw --set profiles.wheel_orientation=mirrored"),
            "it is mirrored",
        ),
        ("profile 60E1 --against S1002".to_owned(), "is a rail, but S1002 is a wheel"),
        ("profile S1002 --against S1002 --align field-side".to_owned(), "not laid by \"field-side\""),
        ("profile S1002 --against S1002 --inclination 1:2".to_owned(), "1:5 at the steepest"),
        ("profile 60E1 --against 60E1 --gauge-height -3mm".to_owned(), "--gauge-height"),
    ] {
        let refused = sandbox.riffel(&command);
        assert_eq!(refused.status, Some(2), "{command}: {}", refused.text);
        assert!(refused.sentence().contains(sentence), "{command}: {}", refused.text);
    }
}

/// A study over radius and worn profiles is the cases one by one.
#[test]
fn a_study_goes_over_radii_and_worn_wheels() {
    let sandbox = sandbox();
    std::fs::write(
        sandbox.path("cases/plan.toml"),
        "case = \"metro-curve.toml\"\n\
         [set]\nmap.speed = { min = \"45 km/h\", max = \"46 km/h\", points = 2 }\n\
         map.wavelength = { min = \"60 mm\", max = \"120 mm\", points = 3 }\n\
         contact.creep_law = \"full-sliding\"\n\
         [design]\nmethod = \"grid\"\n\
         [[parameter]]\nkey = \"curve.radius\"\nvalues = [\"180 m\", \"400 m\"]\n\
         [[parameter]]\nkey = \"profiles.wheel\"\nvalues = [\"S1002\", \"worn-wheel.csv\"]\n\
         [outputs]\nridge = true\n",
    )
    .unwrap();
    let study = sandbox.riffel("study cases/plan.toml");
    assert_eq!(study.status, Some(0), "{}", study.text);
    assert!(study.text.contains("4 cases") || study.text.contains("4 samples"), "{}", study.text);
}

/// Bhaskar's mechanism: a contact that moves across close profiles, with the inertia of the wheel and without. Without conformity nothing
/// depends on the ripple's slope; with it and no inertia a free wheel takes any radius, and what is left are the turn of the plane of
/// contact and its spin.
#[test]
fn conformity_and_inertia_are_switches() {
    let sandbox = Sandbox::new();
    let case = "point cases/bhaskar-track.toml --wavelength 0.05 --speed 20 --json --set contact.contact_angle=3deg \
                --set contact.transverse_radius=750mm --set contact.creep_law=shen-hedrick-elkins \
                --set contact.tractive_ratio=0.1";
    let growth = |more: &str| {
        let document = sandbox.json(&format!("{case} {more}"));
        number(&document["growth_rate_per_passage"])
    };
    let moving = "--set contact.conformity.rail_radius=300mm --set \"contact.conformity.cross_slope=20 1/m\"";
    let free = "--set wheel.rotation=constant-tangential-force";
    let (plain, moved) = (growth(""), growth(moving));
    assert!((moved - plain).abs() > 1e-3 * plain.abs(), "{plain} {moved}");
    let still = "--set contact.conformity.contact_angle=false --set contact.conformity.spin=false";
    let (without, moved_without) = (growth(free), growth(&format!("{free} {moving} {still}")));
    assert!((without - plain).abs() > 1e-3 * plain.abs());
    assert!((moved_without - without).abs() < 1e-9 * without.abs(), "{without} {moved_without}");
    let turned = growth(&format!("{free} {moving}"));
    assert!((turned - without).abs() > 1e-5 * without.abs(), "{without} {turned}");
    let refused = sandbox.riffel(&format!("{case} --set contact.conformity.rail_radius=800mm"));
    assert_eq!(refused.status, Some(2));
}

/// Both wheels under load: a symmetric wheelset has two equal contacts, and the pressure carries the load. Hertz is beside it where
/// curvatures are those of a single place. The patch is of 48 elements: an element in size, 3·10⁻³ in pressure.
#[test]
fn wheels_are_pressed_on_their_rails() {
    let sandbox = sandbox();
    let document =
        sandbox.json("profile cases/profiles.toml --wheelset --load 60kN --lateral-shift=0mm,-2mm --json -o out");
    let [left, right, _, aside] = [0, 1, 2, 3].map(|index| document["contacts"][index].clone());
    assert_eq!([&left["rail"], &right["rail"]], ["left", "right"]);
    for key in ["approach_m", "peak_pressure_pa", "stiffness_n_per_m", "area_m2"] {
        let (left, right) = (number(&left[key]), number(&right[key]));
        assert!((left / right - 1.0).abs() < 1e-2, "{key}: {left} {right}");
    }
    // Two millimetres to the left the patch of the right wheel stays on one radius of either profile.
    let peak = |of: &Value| number(&of["peak_pressure_pa"]);
    let ratio = peak(&aside) / peak(&aside["hertz"]);
    assert!((ratio - 1.0).abs() < 5e-3, "{ratio}");
    let stiffness = number(&aside["stiffness_n_per_m"]);
    let secant = 60e3 / number(&aside["approach_m"]);
    // Hertz: dP/dδ = 3/2 P/δ; the wheel's radius changes a little over the patch.
    assert!((stiffness / secant - 1.5).abs() < 0.02, "{stiffness} {secant}");
    // The elements of the table carry the load.
    let table = std::fs::read_to_string(sandbox.path("out/contact.csv")).unwrap();
    let mut places: Vec<[f64; 3]> = Vec::new();
    for line in table.lines().filter(|line| line.starts_with("0.0,right,")) {
        let cells: Vec<f64> = line.split(',').filter_map(|cell| cell.parse().ok()).collect();
        places.push([cells[1], cells[2], cells[3]]);
    }
    let step = |axis: usize| {
        let mut values: Vec<f64> = places.iter().map(|place| place[axis]).collect();
        values.sort_by(f64::total_cmp);
        let steps = values.windows(2).map(|pair| pair[1] - pair[0]);
        steps.filter(|step| *step > 1e-7).fold(f64::INFINITY, f64::min)
    };
    let carried: f64 = places.iter().map(|place| place[2]).sum::<f64>() * step(0) * step(1);
    assert!((carried / 60e3 - 1.0).abs() < 1e-3, "{carried}");
}

#[test]
fn loads_that_press_nothing_are_refused() {
    let sandbox = sandbox();
    for (asked, words) in [
        ("--wheelset --load=-5kN", "--load"),
        ("--wheelset --load 60kg", "60kg"),
        ("--wheelset --load 60kN --lateral-shift=90mm", "touch"),
        ("--load 60kN", "--wheelset"),
    ] {
        let run = sandbox.riffel(&format!("profile cases/profiles.toml {asked}"));
        assert_eq!(run.status, Some(2), "{asked}: {}", run.text);
        assert!(run.text.contains(words), "{asked}: {}", run.text);
    }
}

//! What every case says, to the last bit, for changes of structure that must not change results.
//!
//! `RIFFEL_CAPTURE=/somewhere cargo test --release -p riffel-case --test case capture -- --ignored` writes one file for each case in some
//! seven minutes on two cores; two such folders, from before and after a change, are compared by `diff --recursive`.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use riffel::growth::Axis;
use riffel_case::model::{FieldModel, ModelOnCase};
use riffel_case::traffic::{Traffic, UsualTraffic, bands_of};
use riffel_case::{Case, Variant, wheels_of_curve};

/// Traffic on every case: one wheel, all wheels of a curve, and wheels that are spread.
const TRAFFICS: [(&str, &str); 5] = [
    ("one speed", "speeds = [{ speed = \"60 km/h\", share = 1 }]"),
    ("normal speed", "speed = { mean = \"50 km/h\", standard_deviation = \"4 km/h\" }\ntractive_ratio = 0.2"),
    ("curve", "curve = true\nspeeds = [{ speed = \"45 km/h\", share = 0.5 }, { speed = \"52 km/h\", share = 0.5 }]"),
    (
        "curve, spread",
        "curve = true\nspeed = { mean = \"45 km/h\", standard_deviation = \"2 km/h\" }\n\
         wheel_radius = { mean = \"0.44 m\", standard_deviation = \"8 mm\" }\n\
         [vehicle.spread]\nprofiles.gauge = { min = \"1433 mm\", max = \"1439 mm\" }",
    ),
    (
        "loads",
        "speed = { mean = \"70 km/h\", standard_deviation = \"5 km/h\" }\n\
         load = { mean = \"50 kN\", standard_deviation = \"6 kN\" }\nfriction = { min = 0.2, max = 0.4 }",
    ),
];

/// Changes of every case, and some that no case takes.
const VARIANTS: [(&str, &str); 8] = [
    ("soft pads", "[track.pad]\nstiffness = \"60 MN/m\""),
    ("friction", "[contact]\nfriction = 0.2"),
    ("load", "[contact]\nnormal_load = \"70 kN\""),
    ("slower", "[speed]\nfactor = 0.8"),
    ("yaw", "[bogie]\nprimary_longitudinal_stiffness = \"2 MN/m\""),
    ("gauge", "[profiles]\ngauge = \"1440 mm\""),
    ("wheel", "[wheel]\nmass = \"700 kg\""),
    ("no mass", "[wheel]\nmass = \"-1 kg\""),
];

/// Values of keys that many cases refuse, each in its own words.
const OVERRIDES: [&str; 24] = [
    "contact.friction=-0.1",
    "contact.friction=2",
    "contact.tractive_ratio=1.5",
    "contact.tractive_ratio=0.5",
    "contact.creepage=0.4 %",
    "contact.creepage.lateral=0.5 %",
    "contact.creep_law=polach",
    "contact.creep_law=full-sliding",
    "contact.creep_law=nonsense",
    "contact.response=non-steady",
    "contact.from.wheelset=2",
    "contact.from.wheelset=9",
    "contact.from.rail=high",
    "contact.from.contact=flange",
    "contact.contact_angle=3 deg",
    "curve.radius=250 m",
    "curve.speed=20 m/s",
    "curve.speed=90 m/s",
    "wheelset.rail=left",
    "wheel.rotation=constant-creepage",
    "track.model=free-beam",
    "track.support_spacing=0.7 m",
    "wear.band_width=30 mm",
    "map.speed=1-2 km/h",
];

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    found.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    found.sort();
    found
}

/// Growth over the window, with all that the loop says at one point of it.
fn growth(text: &mut String, case: &Case) {
    let within = |axis: &Axis, share: f64| axis.min() + share * (axis.max() - axis.min());
    for share in [0.05, 0.4, 0.9] {
        let speed = within(&case.speed, share);
        for share in [0.1, 0.35, 0.8] {
            let wavelength = within(&case.wavelength, share);
            match case.point(wavelength, speed) {
                Ok(point) => {
                    writeln!(text, "{wavelength} {speed}: {:016x} {:e}", point.growth_rate.to_bits(), point.growth_rate)
                }
                Err(error) => writeln!(text, "{wavelength} {speed}: {error}"),
            }
            .unwrap();
        }
    }
    let state = case.feedback.at(within(&case.wavelength, 0.5), within(&case.speed, 0.5));
    writeln!(text, "{state:?}\n{:?}", case.steady).unwrap();
    case.remarks.iter().for_each(|remark| writeln!(text, "note: {remark}").unwrap());
}

fn under_traffic(text: &mut String, case: &Case) {
    let bands = bands_of(case);
    let on = |traffic: &Traffic, variant: &Variant| match traffic.on(case, &bands, variant, &|_| ()) {
        Ok(on) => format!("{on:?}"),
        Err(error) => error.to_string(),
    };
    let none = Variant::none("");
    match UsualTraffic::of(case).traffic() {
        Ok(usual) => {
            writeln!(text, "usual traffic: {}", on(&usual, &none)).unwrap();
            for (title, change) in VARIANTS {
                let variant = Variant::parse(title, change).unwrap();
                writeln!(text, "{title}: {}", on(&usual, &variant)).unwrap();
            }
        }
        Err(error) => writeln!(text, "usual traffic: {error}").unwrap(),
    }
    for (title, vehicle) in TRAFFICS {
        let parsed = Traffic::parse("t.toml", &format!("[[vehicle]]\nname = \"unit\"\nshare = 1\n{vehicle}\n"));
        let told = parsed.map_or_else(|error| error.to_string(), |traffic| on(&traffic, &none));
        writeln!(text, "traffic, {title}: {told}").unwrap();
    }
}

fn told(path: &Path) -> String {
    let mut text = String::new();
    let case = match Case::read(path, &[]) {
        Ok(case) => case,
        Err(error) => return format!("{error}\n"),
    };
    growth(&mut text, &case);
    for change in OVERRIDES {
        let changed = case.with(&[change.to_owned()][..]);
        writeln!(text, "== {change}").unwrap();
        match changed {
            Ok(changed) => growth(&mut text, &changed),
            Err(error) => writeln!(text, "{error}").unwrap(),
        }
    }
    for model in FieldModel::all() {
        writeln!(text, "== {}", model.name).unwrap();
        match ModelOnCase::new(&case, model.joints) {
            Ok(on) => {
                let rates = on.growth_rates(&[0.03, 0.06, 0.15], 15.0);
                writeln!(text, "{rates:?}").unwrap();
                on.case.remarks.iter().for_each(|remark| writeln!(text, "note: {remark}").unwrap());
            }
            Err(error) => writeln!(text, "{}", error.0).unwrap(),
        }
    }
    match wheels_of_curve(&case) {
        Ok(Some(wheels)) => wheels.wheels.iter().for_each(|wheel| {
            writeln!(text, "== {}: {:?}", wheel.name(), wheel.state).unwrap();
            match &wheel.case {
                Ok(case) => growth(&mut text, case),
                Err(error) => writeln!(text, "{error}").unwrap(),
            }
        }),
        Ok(None) => {}
        Err(error) => writeln!(text, "{error}").unwrap(),
    }
    under_traffic(&mut text, &case);
    text
}

/// Every case of the project, with overrides, models, wheels of a curve, traffic and variants.
#[test]
#[ignore = "writes what is compared by hand before and after a move"]
fn every_case_is_captured() {
    let into = PathBuf::from(std::env::var_os("RIFFEL_CAPTURE").expect("RIFFEL_CAPTURE names a folder"));
    fs::create_dir_all(&into).unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders =
        [root.join("cases"), root.join("tests/general-loop"), root.join("../riffel-rail/tests/measured-tables")];
    let cases: Vec<PathBuf> = folders.iter().flat_map(|folder| files(folder)).collect();
    assert!(cases.len() > 30);
    cases.par_iter().for_each(|path| {
        let name = path.file_stem().unwrap().to_string_lossy();
        fs::write(into.join(format!("{name}.txt")), told(path)).unwrap();
    });
}
